#!/usr/bin/env bash
# Shows that the kernel in the page is what the sources make: compiles it anew, and compares it byte by byte where the compiler is
# the one that made the file. Another compiler's is compared by the digests of its drops alone (test_page.py).
set -euo pipefail
cd "$(dirname "$0")/../.."
kept=tools/assets/page/softanvil.wasm.gz
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
version=$(rustc --version | cut -d ' ' -f 2)
if ! zcat $kept | grep -aq "$version"; then
    echo "$kept was made by another compiler than rustc $version: not compared"
    exit 0
fi
tools/page/build.sh "$work/softanvil.wasm.gz"
cmp <(zcat $kept) <(zcat "$work/softanvil.wasm.gz") || {
    echo "$kept is not what the sources make: tools/page/build.sh makes it anew" >&2
    exit 1
}
