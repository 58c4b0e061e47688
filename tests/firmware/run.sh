#!/usr/bin/env bash
# Builds the firmware in C and in Rust for a Cortex-M7 and runs the 14.7 J drop on it in QEMU, which counts instructions.
# Needs rustup, gcc-arm-none-eabi and qemu-system-arm.
#
#     tests/firmware/run.sh
set -euo pipefail
cd "$(dirname "$0")/../.."
target=thumbv7em-none-eabihf
out=target/firmware
mkdir -p "$out"
rustup target add "$target" >/dev/null 2>&1
export CARGO_TARGET_THUMBV7EM_NONE_EABIHF_RUSTFLAGS='-C target-cpu=cortex-m7'

# In C: the static library of the C ABI, without the solid, which takes more than a board has, and a program that links it.
cargo rustc -q --profile library -p softanvil-ffi --no-default-features --features c-abi,pads --crate-type staticlib --target "$target" --target-dir "$out"
awk '!/^#/ { printf "    { %su, %s, %s, 0x%su },\n", $1, $2, $3, $4 }' tests/golden/traces/drop-14.7-J.txt >"$out/golden.inc"
arm-none-eabi-gcc -std=c11 -Wall -Wextra -Werror -O2 -ffp-contract=off -ffreestanding -ffunction-sections -fdata-sections \
    -mcpu=cortex-m7 -mthumb -mfpu=fpv5-d16 -mfloat-abi=hard -I include -I "$out" tests/firmware/c/*.c \
    -nostdlib -T tests/firmware/c/board.ld -Wl,--gc-sections -Wl,--no-warn-rwx-segments \
    "$out/$target/library/libsoftanvil.a" -lgcc -o "$out/drop-c.elf"

# program NAME FOLDER: keeps a copy of what FOLDER builds. All build in one folder, in which what they share is compiled once.
program() {
    (cd "$2" && cargo build -q --release --bin drop --target "$target" --target-dir "$OLDPWD/$out")
    cp "$out/$target/release/drop" "$out/$1.elf"
}
# In Rust: the kernel itself.
program rust tests/firmware/rust
# And as a task among others.
(cd tests/firmware/embassy && cargo build -q --locked --release --target "$target" --target-dir "$OLDPWD/$out")
cp "$out/$target/release/embassy" "$out/embassy.elf"
# And in either precision, on the same processor as if its floating-point unit knew single precision alone.
export CARGO_TARGET_THUMBV7EM_NONE_EABIHF_RUSTFLAGS=
program double tests/firmware/rust
program single tests/firmware/rust/single

# board ELF [STEPS]: QEMU prints what SYS_WRITE0 gives it to its standard error.
board() {
    timeout 300 qemu-system-arm -M mps2-an500 -nographic -semihosting-config "enable=on,arg=drop,arg=${2:-}" \
        -icount shift=0 -kernel "$1" 2>&1
}

echo "-- in C"
board "$out/drop-c.elf" | tee "$out/c.txt"
echo "-- in Rust"
board "$out/rust.elf" | tee "$out/rust.txt"
echo "-- in Rust, single precision"
board "$out/single.elf" | tee "$out/single.txt"
echo "-- a task of Embassy"
board "$out/embassy.elf" | tee "$out/embassy.txt"
[ "$(grep -c '^the bits of the golden trace$' "$out"/{c,rust,single,embassy}.txt | grep -c ':1$')" = 4 ]
# Both have seen the same simulation.
[ "$(grep '^state' "$out/c.txt")" = "$(grep '^state' "$out/rust.txt")" ]
# The stack that a board must have for the deepest call, bytes; README.md states it.
bound=$(awk '$1 == "stack" { print $2 }' tests/footprint/limits.txt)
for program in c rust single; do
    stack=$(sed -n 's/^stack \([0-9]*\) bytes.*/\1/p' "$out/$program.txt")
    [ -n "$stack" ] && [ "$stack" -le "$bound" ] || { echo "FAILED: $program uses $stack bytes of stack of $bound"; exit 1; }
done
grep -q "$bound bytes of stack" tests/firmware/README.md

# Both precisions over the same first steps, the last third of them in contact: of double precision in software, more would
# take QEMU a minute.
steps=240 table=$out/precision.txt
printf '%-10s %-17s %22s %13s %20s\n' kernel FPU 'instructions per step' 'flash, bytes' 'model, state, bytes' >"$table"
while read -r kernel fpu elf; do
    # Without the input, which QEMU would take the rest of the rows from.
    printed=$(board "$elf" $steps </dev/null)
    grep -q '^the bits of the golden trace$' <<<"$printed" || { echo "FAILED: $kernel, $fpu FPU: $printed"; exit 1; }
    instructions=$(sed -n 's/^instructions per step \([0-9]*\),.*/\1/p' <<<"$printed")
    flash=$(sed -n 's/^flash \([0-9]*\) bytes,.*/\1/p' <<<"$printed")
    memory=$(sed -n 's/^model \([0-9]*\) bytes, state \([0-9]*\) bytes/\1 + \2/p' <<<"$printed")
    printf '%-10s %-17s %22s %13s %20s\n' "$kernel" "$fpu" "$instructions" "$flash" "$memory" >>"$table"
done <<END
double double-precision $out/rust.elf
double single-precision $out/double.elf
single single-precision $out/single.elf
END
echo "-- both precisions, $steps steps"
cat "$table"
