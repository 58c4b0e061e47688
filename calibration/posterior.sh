#!/usr/bin/env bash
# Infers the posterior of the preset study from all twelve numbers, puts it beside the preset, and prints how often the bands of
# posteriors from two energies hold the numbers of the third. Half an hour on two cores; an interrupted run continues.
#
#     calibration/posterior.sh [FOLDER]
set -euo pipefail
cd "$(dirname "$0")/.."
folder=${1:-target/calibration}
cargo build --release -p softanvil
mkdir -p "$folder"
for name in all without-14.7 without-9.8 without-4.9; do
    echo "== $name"
    target/release/softanvil calibrate "calibration/$name.toml" --uncertainty --out "$folder/$name"
done
cp "$folder/all/posterior.json" tools/assets/posteriors/study.json
python3 calibration/left_out.py "$folder"
