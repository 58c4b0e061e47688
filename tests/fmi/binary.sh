#!/usr/bin/env bash
# Builds the binary of an FMU, LIBRARY, again from nothing in another folder: it has the same bytes. And with its symbols, to
# show from where a panic can be reached: its own functions and the kernel's refer to no failed index, slice, assertion or
# arithmetic. What is left is in the libraries of the language (the printing of numbers and sorting check themselves; they
# are listed) and the end for memory that the heap refuses.
#
#     tests/fmi/binary.sh LIBRARY
set -euo pipefail

root=$(cd "$(dirname "$0")/../.." && pwd)
target=x86_64-unknown-linux-gnu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# build ARGUMENT...: as the packager does (fmu/src/build.rs), with more arguments for the compiler.
build() {
    cargo rustc --quiet --lib --no-default-features --features pads,solid --crate-type cdylib --profile fmu \
        --target "$target" --manifest-path "$root/ffi/Cargo.toml" --target-dir "$work/target" -- \
        -Clink-arg=-Wl,--build-id=none -Clink-arg=-lc "$@"
}
library=$work/target/$target/fmu/libsoftanvil.so
build
cmp "$1" "$library"
build -Cstrip=none

# "caller -> callee" of every jump or call into the panic machinery.
objdump -d -C --no-show-raw-insn "$library" | awk '
    /^[0-9a-f]+ <.*>:$/ { caller = $0; sub(/^[0-9a-f]+ </, "", caller); sub(/>:$/, "", caller); functions++ }
    /<(core::panicking::|core::slice::index::|core::result::unwrap_failed|core::option::(unwrap|expect)_failed|core::str::slice_error)/ {
        callee = $0; sub(/^[^<]*</, "", callee); sub(/>[^>]*$/, "", callee); sub(/\+0x.*/, "", callee)
        if (callee != caller) print caller " -> " callee
    }
    END { print functions > "'"$work"'/functions" }' | sort -u >"$work/calls"
[ -s "$work/calls" ] || { echo "no call of the panic machinery is found: is it named as before?" >&2; exit 1; }
grep -vE '^<*(core|alloc|__rustc)::' "$work/calls" >"$work/own" || true
# A refused or too large allocation ends in these two: the compiler unites with them all functions of the same body, among
# them the failed unwrap, which this does not tell apart.
if grep -vE ' -> (core::result::unwrap_failed|core::panicking::panic_nounwind_fmt)$' "$work/own" >&2; then
    echo "a panic can be reached" >&2
    exit 1
fi
echo "$(cat "$work/functions") functions: none of the library's own fails an index, a slice or an assertion;" \
    "at $(wc -l <"$work/own") places they, or an allocation in them, end by one of the two that may; in the libraries:"
sed 's/ -> .*//' "$work/calls" | grep -E '^<*(core|alloc)::' | grep -vE '^core::(panicking|result::unwrap_failed|slice::index)' | sort -u | sed 's/^/    /'
