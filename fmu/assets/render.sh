#!/usr/bin/env bash
# Renders icon.svg to icon.png (rsvg-convert is in the package librsvg2-bin).
set -euo pipefail
cd "$(dirname "$0")"
rsvg-convert --width 256 --height 256 icon.svg --output icon.png
