#!/usr/bin/env bash
# The files that `softanvil fit` writes, in the hands of others: run.sh BUILD_FOLDER VENV. material.h compiles without a
# warning and sets the scenario, material.ssv holds to the schema, all of them say the same, and the Python program of
# docs/identification.md runs the FMU with them. VENV is the one that tests/fmi/venv.sh has made.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
build=$(cd "${1:?usage: run.sh BUILD_FOLDER VENV}" && pwd)
python=$(cd "${2:?usage: run.sh BUILD_FOLDER VENV}" && pwd)/bin/python
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cd "$work"
"$build/softanvil" fmu --out . >/dev/null
data=$root/data/treloar
# A law of moduli and one of exponents.
for law in yeoh_3 ogden_3; do
    "$build/softanvil" fit --uniaxial "$data/uniaxial.csv" --planar "$data/planar.csv" \
        --equibiaxial "$data/equibiaxial.csv" --law $law --out rubber >/dev/null
    for standard in c99 c11; do
        gcc -std=$standard -Wall -Wextra -Wpedantic -Werror "$here/material.c" -Irubber -I"$root/include" \
            "$build/libsoftanvil.a" -lpthread -ldl -lm -o material
    done
    ./material >material.txt
    "$python" "$here/check.py" rubber softanvil-fmi2.fmu material.txt
done

# The documentation's only block of Python finds the peak force that the command line finds.
sed -n '/^```python$/,/^```$/p' "$root/docs/identification.md" | sed '1d;$d' >example.py
[ -s example.py ]
echo 'print("%.0f N" % result["result.peak_force"][-1])' >>example.py
peak=$("$build/softanvil" run --material rubber/material.toml --energy 4.9 --json |
    "$python" -c 'import json, sys; print("%.0f N" % json.load(sys.stdin)["peak_force"])')
# The importer prints warnings above it: the study's 15 ms end in contact on this soft rubber.
found=$("$python" example.py | tail -1)
printf 'peak force %s, in the FMU %s\n' "$peak" "$found"
[ "$peak" = "$found" ]
