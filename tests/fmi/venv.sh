#!/usr/bin/env bash
# Makes the virtual environment of the tests in Python: venv.sh FOLDER. Packages of all tests at once, so that none changes under
# a test that runs beside.
set -euo pipefail
tests=$(cd "$(dirname "$0")/.." && pwd)
venv=${1:?usage: venv.sh FOLDER}
[ -x "$venv/bin/python" ] || python3 -m venv "$venv"
"$venv/bin/python" -m pip install --quiet --disable-pip-version-check -r "$tests/fmi/requirements.txt" \
    -r "$tests/report/requirements.txt" -r "$tests/page/requirements.txt"
