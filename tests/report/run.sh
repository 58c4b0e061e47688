#!/usr/bin/env bash
# What `softanvil` draws, in the hands of others: run.sh BUILD_FOLDER VENV [TEST...]. The series for ParaView in
# meshio. VENV is the one that tests/fmi/venv.sh has made.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
build=$(cd "${1:?usage: run.sh BUILD_FOLDER VENV [TEST...]}" && pwd)
venv=$(cd "${2:?usage: run.sh BUILD_FOLDER VENV [TEST...]}" && pwd)
shift 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$build/softanvil" run --energy 9.8 --vtu "$work/series" --csv "$work/trace.csv" --json >"$work/run.json"
export SOFTANVIL_WORK=$work
cd "$here"
PYTHONDONTWRITEBYTECODE=1 "$venv/bin/python" -m pytest -p no:cacheprovider -q "${@:-.}"
