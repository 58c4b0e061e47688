#!/usr/bin/env bash
# The tests of the Python package: test.sh [PYTEST ARGUMENTS...]. Builds it into a virtual environment of its own,
# $SOFTANVIL_VENV_PYTHON (default: .venv-python in the root of the repository), with the packages of requirements.txt. Two processes
# share the tests; `-n 0` keeps them in one.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/.." && pwd)
venv=${SOFTANVIL_VENV_PYTHON:-$root/.venv-python}
# A folder of its own: crates of two workspaces in one folder take each other's place, and then do not link.
export CARGO_TARGET_DIR=$root/target/python PYTHONDONTWRITEBYTECODE=1

cd "$here"
cargo fmt --check
[ -x "$venv/bin/python" ] || python3 -m venv "$venv"
"$venv/bin/python" -m pip install --quiet --disable-pip-version-check -r requirements.txt
VIRTUAL_ENV=$venv PATH=$venv/bin:$PATH "$venv/bin/maturin" develop --quiet --release
# As cargo clippy, but over the libraries that were just compiled, which that would all look through once more. Another crate
# type, because what clippy compiles must not take the place of the package.
RUSTC_WORKSPACE_WRAPPER=clippy-driver cargo rustc -q --release --locked --crate-type lib -- -D warnings
"$venv/bin/python" -m pytest -p no:cacheprovider -q -n 2 --dist loadgroup "$@"
