#!/usr/bin/env bash
# Searches once with each mechanism in calibration/mechanisms, and along the front of impacts against material tests: about half
# an hour on two cores. Keeps the best sets beside the problems and writes docs/mechanisms.md. An interrupted run continues.
#
#     calibration/mechanisms.sh [FOLDER]
set -euo pipefail
cd "$(dirname "$0")/.."
folder=${1:-target/mechanisms}
weights=(0 0.03 0.1 0.3 1)
cargo build --release -p softanvil
mkdir -p "$folder" calibration/mechanisms/best calibration/front
for problem in calibration/mechanisms/*.toml; do
    name=$(basename "$problem" .toml)
    echo "== $name"
    target/release/softanvil calibrate "$problem" --out "$folder/$name"
    cp "$folder/$name/best.toml" "calibration/mechanisms/best/$name.toml"
done
target/release/softanvil calibrate calibration/material-tests.toml --evaluations 20000 \
    --material-weights "${weights[@]}" --out "$folder/front"
for weight in "${weights[@]}"; do cp "$folder/front/weight-$weight/best.toml" "calibration/front/weight-$weight.toml"; done
cp "$folder/front/front.svg" docs/front.svg
python3 calibration/mechanisms.py "$folder"
