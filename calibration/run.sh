#!/usr/bin/env bash
# Runs every calibration protocol, about half an hour on two cores, and writes docs/protocols.md. An interrupted run continues.
#
#     calibration/run.sh [FOLDER]
set -euo pipefail
cd "$(dirname "$0")/.."
folder=${1:-target/calibration}
cargo build --release -p softanvil
mkdir -p "$folder"
for problem in calibration/*.toml; do
    name=$(basename "$problem" .toml)
    echo "== $name"
    target/release/softanvil calibrate "$problem" --out "$folder/$name"
done
python3 calibration/table.py target/release/softanvil "$folder"
