#!/usr/bin/env bash
# Runs every benchmark and writes the tables of docs/performance.md from what they measure; some five minutes on a quiet
# machine. The figures stay in target/softanvil-bench and target/criterion. The peers have a command of their own,
# tests/peers/run.sh, whose results this one takes as they are.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
cd "$here/.."
for command in valgrind objdump addr2line python3 cc; do
    command -v "$command" >/dev/null || { echo "$command is missing" >&2; exit 1; }
done
target=${CARGO_TARGET_DIR:-$PWD/target}
results=$target/softanvil-bench
# Nothing of an earlier run, whose benchmarks may have had other names.
rm -rf "$results" "$target/criterion"
mkdir -p "$results"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cargo run -q --release -p softanvil -- fmu --target "$(uname -m)-unknown-linux-gnu" --out "$work"
cargo bench -q -p softanvil-bench
if [ "$(uname -m)" = x86_64 ]; then
    cc -O1 -Wall -Wextra -shared -fPIC "$here/processor.c" -o "$work/processor.so"
    for widest in Avx2 Baseline; do
        SOFTANVIL_WIDEST=$widest LD_PRELOAD=$work/processor.so cargo bench -q -p softanvil-bench --bench drop ||
            echo "skipped: C ABI and FMU with the instruction set $widest" >&2
    done
fi
cargo build -q --profile bench -p softanvil-bench --bin softanvil-bench
SOFTANVIL_INSTRUCTIONS=$results/instructions.csv "$here/instructions.sh" "$target/release"
python3 "$here/anatomy.py" "$target/release/softanvil-bench" "$results/anatomy.csv"
python3 "$here/commands.py" "$target/release/softanvil" "$results/commands.csv"
python3 "$here/report.py" "$target"
