#!/usr/bin/env bash
# The tests of the Python package: test.sh [PYTEST ARGUMENTS...]. Builds it into a virtual environment of its own,
# $SOFTANVIL_VENV_PYTHON (default: .venv-python in the root of the repository), with the packages of requirements.txt. Two processes
# share the tests; `-n 0` keeps them in one.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/.." && pwd)
venv=${SOFTANVIL_VENV_PYTHON:-$root/.venv-python}
export PYTHONDONTWRITEBYTECODE=1

cd "$here"
[ -x "$venv/bin/python" ] || python3 -m venv "$venv"
"$venv/bin/python" -m pip install --quiet --disable-pip-version-check -r requirements.txt
VIRTUAL_ENV=$venv PATH=$venv/bin:$PATH "$venv/bin/maturin" develop --quiet --release --locked
"$venv/bin/python" -m pytest -p no:cacheprovider -q -n 2 --dist loadgroup "$@"
