#!/usr/bin/env bash
# The page that simulates drops, in headless Chromium, from disk and without a network: run.sh BUILD_FOLDER VENV [TEST...]. VENV
# is the one that tests/fmi/venv.sh has made. Screenshots stay in target/page-pictures.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
build=$(cd "${1:?usage: run.sh BUILD_FOLDER VENV [TEST...]}" && pwd)
venv=$(cd "${2:?usage: run.sh BUILD_FOLDER VENV [TEST...]}" && pwd)
shift 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$build/softanvil" page --out "$work/page.html" >/dev/null
"$build/softanvil" --out "$work/report" >/dev/null
export SOFTANVIL_CLI=$build/softanvil SOFTANVIL_WORK=$work
export SOFTANVIL_PICTURES=${SOFTANVIL_PICTURES:-$here/../../target/page-pictures}
mkdir -p "$SOFTANVIL_PICTURES"
cd "$here"
PYTHONDONTWRITEBYTECODE=1 "$venv/bin/python" -m pytest -p no:cacheprovider -q "${@:-.}"
