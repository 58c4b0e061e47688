#!/usr/bin/env bash
# Tests the FMUs with importers and masters that others wrote, and with masters in C: run.sh BUILD_FOLDER [TEST...], where
# cargo put the program `softanvil`; run.sh BUILD_FOLDER matrix prints the table of everything that computes the drops. Builds the FMUs, for every platform whose compiler is there.
# The Python packages go to a virtual environment in $SOFTANVIL_VENV (default: .venv in the root of the repository);
# everything else to a temporary folder that is removed at the end.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
build=$(cd "${1:?usage: run.sh BUILD_FOLDER [TEST...]}" && pwd)
shift
venv=${SOFTANVIL_VENV:-$root/.venv}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

"$here/venv.sh" "$venv"

# The standard library of a target, where rustup can add it, and a linker for it.
have_target() {
    command -v "$2" >/dev/null && { ! command -v rustup >/dev/null || rustup --quiet target add "$1" >/dev/null 2>&1; }
}
targets=()
have_target x86_64-unknown-linux-gnu gcc && targets+=(--target x86_64-unknown-linux-gnu)
have_target aarch64-unknown-linux-gnu aarch64-linux-gnu-gcc && targets+=(--target aarch64-unknown-linux-gnu)
have_target x86_64-pc-windows-gnu x86_64-w64-mingw32-gcc && targets+=(--target x86_64-pc-windows-gnu)
[ ${#targets[@]} != 6 ] || targets=(--target all)

export SOFTANVIL_CLI=$build/softanvil SOFTANVIL_ROOT=$root
export SOFTANVIL_WINE=$scratch/wine
export SOFTANVIL_FMU=$scratch/softanvil-fmi2.fmu SOFTANVIL_FMU3=$scratch/softanvil-fmi3.fmu
export SOFTANVIL_LIBRARY=$root/target/fmu/x86_64-unknown-linux-gnu/fmu/libsoftanvil.so
[ "${targets[*]}" = "--target all" ] || SOFTANVIL_FMI2_TARGETS=(--target x86_64-unknown-linux-gnu)
"$SOFTANVIL_CLI" fmu --fmi 3 --out "$scratch" "${targets[@]}"
"$SOFTANVIL_CLI" fmu --fmi 2 --out "$scratch" "${SOFTANVIL_FMI2_TARGETS[@]:---target=all}"
cd "$here"
export PYTHONDONTWRITEBYTECODE=1 TMPDIR=$scratch
if [ "${1:-}" = matrix ]; then "$venv/bin/python" matrix.py "${@:2}"; exit; fi
if [ $# = 0 ]; then
    "$venv/bin/python" matrix.py --brief
    "$here/binary.sh" "$SOFTANVIL_LIBRARY"
fi
"$venv/bin/python" -m pytest -p no:cacheprovider -q "${@:-.}"
