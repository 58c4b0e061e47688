#!/usr/bin/env bash
# Instructions of a step of the study's drop on aarch64, with NEON and one number at a time, counted by qemu-user:
# aarch64.sh, in any folder. What 10 steps take is the difference of two runs, one of which makes 10 more. Needs rustup's
# target, which it adds, and qemu-aarch64.
set -euo pipefail
cd "$(dirname "$0")/.."
target=aarch64-unknown-linux-musl folder=target/targets/aarch64-bench
program=$folder/$target/library/softanvil-bench
rustup target add $target >/dev/null 2>&1
CARGO_TARGET_AARCH64_UNKNOWN_LINUX_MUSL_RUSTFLAGS='-C linker=rust-lld -C linker-flavor=ld.lld' \
    cargo build -q --profile library -p softanvil-bench --bin softanvil-bench --target $target --target-dir $folder 2>/dev/null

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkfifo "$work/log"

# executed SET STEPS: instructions of a run. The log has every block of code when it is translated, and a line whenever one
# is executed.
executed() {
    qemu-aarch64 -d nochain,exec,in_asm -D "$work/log" "$program" "$1" "$2" >"$work/drop" &
    awk '
        /^IN:/ { block = "" }
        /^0x/ { if (block == "") { block = $1; gsub(/^0x0*|:$/, "", block); size[block] = 0 } size[block]++ }
        /^Trace/ { split($4, place, "/"); sub(/^0*/, "", place[2]); sum += size[place[2]] }
        END { printf "%.0f\n", sum }' "$work/log"
    wait $!
}

for set in Baseline Neon; do
    before=$(executed $set 20)
    after=$(executed $set 30)
    read -r triangles _ <"$work/drop"
    awk -v set=$set -v n=$((after - before)) -v triangles="$triangles" \
        'BEGIN { printf "%s: %.1f instructions per triangle and step\n", set, n / 10 / triangles }'
done
