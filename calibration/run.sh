#!/usr/bin/env bash
# Runs every calibration protocol, about half an hour on two cores, writes docs/protocols.md and keeps the best sets in
# calibration/best. An interrupted run continues.
#
#     calibration/run.sh [FOLDER]
set -euo pipefail
cd "$(dirname "$0")/.."
folder=${1:-target/calibration}
cargo build --release -p softanvil
mkdir -p "$folder" calibration/best
for problem in calibration/*.toml; do
    name=$(basename "$problem" .toml)
    echo "== $name"
    target/release/softanvil calibrate "$problem" --out "$folder/$name"
    cp "$folder/$name/best.toml" "calibration/best/$name.toml"
done
python3 calibration/table.py target/release/softanvil "$folder"
