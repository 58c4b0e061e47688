#!/usr/bin/env bash
# Tests the FMU with FMPy: run.sh BUILD_FOLDER [TEST...], where cargo put the program `softanvil` and its library.
# The Python packages go to a virtual environment in $SOFTANVIL_VENV (default: .venv in the root of the repository);
# everything else to a temporary folder that is removed at the end.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
build=$(cd "${1:?usage: run.sh BUILD_FOLDER [TEST...]}" && pwd)
shift
venv=${SOFTANVIL_VENV:-$here/../../.venv}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

[ -x "$venv/bin/python" ] || python3 -m venv "$venv"
"$venv/bin/python" -m pip install --quiet --disable-pip-version-check -r "$here/requirements.txt"

export SOFTANVIL_CLI=$build/softanvil SOFTANVIL_LIBRARY=$build/libsoftanvil.so
export SOFTANVIL_FMU=${SOFTANVIL_FMU:-$scratch/softanvil-fmi2.fmu}
[ -e "$SOFTANVIL_FMU" ] || "$SOFTANVIL_CLI" fmu --out "$scratch" --library "$SOFTANVIL_LIBRARY"
cd "$here"
PYTHONDONTWRITEBYTECODE=1 TMPDIR=$scratch "$venv/bin/python" -m pytest -p no:cacheprovider -q "${@:-.}"
