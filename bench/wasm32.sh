#!/usr/bin/env bash
# Time of the golden scenes on wasm32 in Node, with vectors of simd128 and one number at a time, by turns in one process:
# wasm32.sh, in any folder. Needs rustup's target, which it adds, and Node.
set -euo pipefail
cd "$(dirname "$0")/.."
target=wasm32-wasip1 folder=target/targets/wasm32-bench
rustup target add $target >/dev/null 2>&1
RUSTFLAGS='-C target-feature=+simd128' cargo build -q --profile library -p softanvil-golden \
    --features softanvil-kernel/alloc,softanvil-kernel/dispatch --target $target --target-dir $folder
exec node --no-warnings bench/wasm32.mjs $folder/$target/library/softanvil-golden.wasm
