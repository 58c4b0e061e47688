#!/usr/bin/env bash
# The programs of docs/first-drop.md and the pictures of the README: readme.sh BUILD_FOLDER VENV. The C, the Python and the Rust
# program must print the peak force that the command line finds, and the page states; the pictures must be those that the main job
# draws (docs/pictures.sh).
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
build=$(cd "$1" && pwd)
python=$(cd "$2" && pwd)/bin/python
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# block LANGUAGE [SECTION]: the page's only block in this language, or the only one from this section on.
page=$root/docs/first-drop.md
block() { sed -n "/^## ${2:-}/,\$p" "$page" | sed -n "/^\`\`\`$1\$/,/^\`\`\`\$/p" | sed '1d;$d'; }

block c >"$work/drop.c"
block python "In an FMI tool" >"$work/drop.py"
gcc -Wall -Wextra -Werror "$work/drop.c" -I"$root/include" -L"$build" -l:libsoftanvil.a -lm -lpthread -ldl -o "$work/drop"
# A new package, as cargo makes it, with the page's dependencies and program, beside a clone of this repository. Its
# dependencies have the versions that are tested, and their build is kept for the next time; nothing is optimised, which takes
# the drop a few seconds and spares many times that.
cargo new --quiet --vcs none --name drop "$work/rust"
sed -i '/^\[dependencies\]$/d' "$work/rust/Cargo.toml"
block toml "From Rust" | sed "s|\"softanvil/|\"$root/|" >>"$work/rust/Cargo.toml"
block rust >"$work/rust/src/main.rs"
cp "$root/Cargo.lock" "$work/rust"
rust_drop() {
    CARGO_PROFILE_DEV_DEBUG=0 CARGO_INCREMENTAL=0 \
        cargo run --quiet --manifest-path "$work/rust/Cargo.toml" --target-dir "$root/target/readme"
}
"$build/softanvil" fmu --out "$work" >/dev/null
"$build/softanvil" --out "$work/report" >/dev/null 2>&1
# peak ENERGY: the peak force that the command line finds.
peak() {
    "$build/softanvil" run --energy "$1" --json |
        "$python" -c 'import json, sys; print("%.0f N" % json.load(sys.stdin)["peak_force"])'
}
printf 'expected %s and %s\n' "$(peak 14.7)" "$(peak 9.8)"
grep -q "14.7 J has a peak of \`$(peak 14.7)\`, the drop of 9.8 J one of \`$(peak 9.8)\`" "$page"
[ "$("$work/drop")" = "$(peak 14.7)" ]
[ "$(cd "$work" && "$python" drop.py)" = "$(peak 9.8)" ]
[ "$(rust_drop)" = "$(peak 9.8)" ]
for picture in force-time von-mises; do cmp "$root/docs/$picture.svg" "$work/report/$picture.svg"; done
