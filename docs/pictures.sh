#!/usr/bin/env bash
# Draws the README's pictures anew, from the report of the drops: docs/pictures.sh
set -euo pipefail
cd "$(dirname "$0")/.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cargo run -q --release -p softanvil -- --out "$work/report" >/dev/null
for picture in force-time von-mises; do cp "$work/report/$picture.svg" docs/; done
