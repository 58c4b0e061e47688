#!/usr/bin/env bash
# Shows that the kernel in the page, and docs/drop.html, are what the sources make: rebuilt.sh BUILD_FOLDER. It compiles the kernel
# anew and compares it byte by byte where the compiler is the one that made the file; another compiler's is compared by the
# results of its drops alone (test_page.py).
set -euo pipefail
build=$(cd "${1:?usage: rebuilt.sh BUILD_FOLDER}" && pwd)
cd "$(dirname "$0")/../.."
kept=tools/assets/page/softanvil.wasm.gz
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$build/softanvil" page --out "$work/drop.html" >/dev/null
cmp docs/drop.html "$work/drop.html" || {
    echo "docs/drop.html is not what softanvil page writes: tools/page/build.sh makes it anew" >&2
    exit 1
}
compiler=$(cat tools/assets/page/compiler.txt)
if [ "$(rustc --version)" != "$compiler" ]; then
    echo "$kept was made by $compiler, and here is another compiler: not compared"
    exit 0
fi
tools/page/build.sh "$work/softanvil.wasm.gz"
cmp <(zcat $kept) <(zcat "$work/softanvil.wasm.gz") || {
    echo "$kept is not what the sources make: tools/page/build.sh makes it anew" >&2
    exit 1
}
