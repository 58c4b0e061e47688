#!/usr/bin/env bash
# Shows that the kernel in the page, and docs/drop.html, are of the sources as they are: rebuilt.sh BUILD_FOLDER. The kernel by the
# digests of the files that it was made of; that it computes what the command line does is what test_page.py shows. With a second word,
# `compile`, it is compiled anew as well and compared byte by byte, for which it takes the compiler that made the file.
set -euo pipefail
build=$(cd "${1:?usage: rebuilt.sh BUILD_FOLDER [compile]}" && pwd)
cd "$(dirname "$0")/../.."
kept=tools/assets/page/softanvil.wasm.gz
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$build/softanvil" page --out "$work/drop.html" >/dev/null
cmp docs/drop.html "$work/drop.html" || {
    echo "docs/drop.html is not what softanvil page writes: tools/page/build.sh makes it anew" >&2
    exit 1
}
sha256sum --check --quiet tools/assets/page/sources.sha256 || {
    echo "$kept is older than its sources: tools/page/build.sh makes it anew" >&2
    exit 1
}
[ "${2:-}" = compile ] || exit 0
compiler=$(cat tools/assets/page/compiler.txt)
[ "$(rustc --version)" = "$compiler" ] || {
    echo "$kept was made by $compiler, and here is another compiler" >&2
    exit 1
}
tools/page/build.sh "$work/softanvil.wasm.gz"
cmp <(zcat $kept) <(zcat "$work/softanvil.wasm.gz") || {
    echo "$kept is not what the sources make: tools/page/build.sh makes it anew" >&2
    exit 1
}
