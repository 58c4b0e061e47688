#!/usr/bin/env bash
# The programs and the pictures of the README: readme.sh BUILD_FOLDER VENV. The C and the Python program must print the peak
# force that the command line finds; the pictures must be those that the main job draws (docs/pictures.sh).
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
build=$(cd "$1" && pwd)
python=$(cd "$2" && pwd)/bin/python
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# block LANGUAGE: the README's only block in this language.
block() { sed -n "/^\`\`\`$1\$/,/^\`\`\`\$/p" "$root/README.md" | sed '1d;$d'; }

block c >"$work/drop.c"
block python >"$work/drop.py"
gcc -Wall -Wextra -Werror "$work/drop.c" -I"$root/include" -L"$build" -l:libsoftanvil.a -lm -lpthread -ldl -o "$work/drop"
"$build/softanvil" fmu --out "$work" >/dev/null
"$build/softanvil" --out "$work/report" >/dev/null 2>&1
# peak ENERGY: the peak force that the command line finds.
peak() {
    "$build/softanvil" run --energy "$1" --json |
        "$python" -c 'import json, sys; print("%.0f N" % json.load(sys.stdin)["peak_force"])'
}
printf 'expected %s and %s\n' "$(peak 14.7)" "$(peak 9.8)"
[ "$("$work/drop")" = "$(peak 14.7)" ]
[ "$(cd "$work" && "$python" drop.py)" = "$(peak 9.8)" ]
for picture in force-time von-mises; do cmp "$root/docs/$picture.svg" "$work/report/$picture.svg"; done
