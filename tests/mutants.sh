#!/usr/bin/env bash
# mutants.sh PACKAGE SHARD [ARGUMENT...]: one shard of the mutants of softanvil-kernel or softanvil-ffi, such as 3/100, by
# cargo-mutants (docs/mutation.md). Shards take every hundredth mutant, so that each is spread over all files. What it finds is
# added to target/mutation/PACKAGE-SHARD.
set -euo pipefail
cd "$(dirname "$0")/.."
package=$1 shard=$2
shift 2
case $package in
    softanvil-kernel) tests=softanvil-kernel,softanvil-verification ;;
    softanvil-ffi) tests=softanvil-ffi ;;
    *) echo "mutants.sh softanvil-kernel|softanvil-ffi SHARD" >&2; exit 2 ;;
esac
mkdir -p target/mutation
# A mutant that runs on without an end is one that the tests see: 300 s are four times what they take.
cargo mutants --package "$package" --test-package "$tests" --sharding round-robin --shard "$shard" --timeout 300 \
    --shuffle --output "target/mutation/$package-${shard/\//-of-}" "$@"
