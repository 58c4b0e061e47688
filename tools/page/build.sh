#!/usr/bin/env bash
# Compiles the kernel for the page in a browser and keeps it, compressed, where the command line takes it from, and writes
# docs/drop.html with it: build.sh. Or the kernel alone, to another file: build.sh FILE. The command line has the kernel in the
# repository, so that it builds where the target is missing; beside it stand the digests of the sources that it was made of, by which
# tests/page/rebuilt.sh sees that it is out of date.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
kept=$(realpath "${1:-$root/tools/assets/page/softanvil.wasm.gz}")
cd "$root"
# Where there is no rustup, cargo says what is missing.
! command -v rustup >/dev/null || rustup --quiet target add wasm32-wasip1
# Paths of this machine have no place in the file.
flags="-C target-feature=+simd128 -C strip=symbols --remap-path-prefix=$root=. --remap-path-prefix=${CARGO_HOME:-$HOME/.cargo}=cargo"
flags+=" --remap-path-prefix=$(rustc --print sysroot)=rust"
# A folder of its own: what is compiled there has those flags, and nothing else.
target=target/page
RUSTFLAGS=$flags cargo build -q --profile page --target wasm32-wasip1 -p softanvil-page --target-dir $target
gzip -9nc $target/wasm32-wasip1/page/softanvil_page.wasm >"$kept"
printf '%s: %d bytes\n' "$kept" "$(stat -c %s "$kept")"
[ $# = 0 ] || exit 0
# By which compiler, and from which files, its bytes are what they are.
rustc --version >tools/assets/page/compiler.txt
{
    sed 's/^[^:]*: //' $target/wasm32-wasip1/page/softanvil_page.d | tr ' ' '\n' | sed "s#^$root/##"
    printf '%s\n' Cargo.toml Cargo.lock {kernel,tools,tools/page,tools/records}/Cargo.toml tools/page/build.sh
} | LC_ALL=C sort -u | xargs sha256sum >tools/assets/page/sources.sha256
cargo run -q --release -p softanvil -- page --out docs/drop.html --overwrite
