#!/usr/bin/env bash
# The same impacts in Softanvil and in codes that others wrote, one after another on one core: run.sh. Writes peers.csv
# beside this file and the tables of docs/performance.md; takes some minutes. Python packages go to a virtual environment in
# $SOFTANVIL_PEERS_VENV (default: target/peers-venv); CalculiX is Debian's, installed if it is missing and we may.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
. "$root/tests/need.sh"
target=$(realpath -m "${CARGO_TARGET_DIR:-$root/target}")
venv=$(realpath -m "${SOFTANVIL_PEERS_VENV:-$target/peers-venv}")

need ccx calculix-ccx || { echo "ccx is missing and cannot be installed" >&2; exit 1; }
[ -x "$venv/bin/python" ] || python3 -m venv "$venv"
"$venv/bin/python" -m pip install --quiet --disable-pip-version-check -r "$here/requirements.txt"
cd "$root"
cargo build -q --profile library -p softanvil-ffi

export OMP_NUM_THREADS=1 PYTHONDONTWRITEBYTECODE=1
results=$(mktemp -d)
trap 'rm -rf "$results"' EXIT
# MuJoCo writes its log where it runs.
cd "$results"
for problem in section solid; do
    python3 "$here/softanvil_peer.py" "$results/peers.csv" "$problem" "$target/library/libsoftanvil.so"
    for peer in akantu mujoco kratos calculix; do
        "$venv/bin/python" "$here/${peer}_peer.py" "$results/peers.csv" "$problem" >log 2>&1 || { cat log >&2; exit 1; }
        tail -n 1 log
    done
done
mv "$results/peers.csv" "$here/peers.csv"
python3 "$root/bench/report.py" "$target" "peers section" "peers solid"
