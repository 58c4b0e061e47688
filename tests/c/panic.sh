#!/usr/bin/env bash
# Shows on the library as it is installed what the functions of softanvil.h cannot reach: a panic, the heap, files, locale, errno.
# Every function is linked from LIBDIR/libsoftanvil.a into a program, the linker drops what none of them refers to, and
# what is left holds none of these.
#
# Set aside before linking, since they refer to the panic machinery of the standard library whether anything can panic
# or not: the unwinding tables, the initialisers of the process's arguments, and the guard that ends the process if a
# panic tries to leave a function, which only a panic can reach.
#
#     tests/c/panic.sh LIBDIR
set -euo pipefail

libdir=$(cd "$1" && pwd)
header=$(cd "$(dirname "$0")/../../include" && pwd)/softanvil.h
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# A program that could call everything: one table with the address of every function.
functions=$(grep -oE '^[A-Za-z].*\bsoftanvil_[a-z_]+\(' "$header" | grep -oE 'softanvil_[a-z_]+')
{
    echo '#include "softanvil.h"'
    echo 'typedef void (*function)(void);'
    echo 'function volatile table[] = {'
    for name in $functions; do echo "    (function)$name,"; done
    echo '};'
    echo 'int main(void) { return table[0] == 0; }'
} >"$work/table.c"
objcopy --remove-section=.eh_frame --remove-section='.gcc_except_table*' --remove-section='.init_array*' --strip-debug \
    "$libdir/libsoftanvil.a" "$work/bare.a" 2>"$work/objcopy.log" || { cat "$work/objcopy.log" >&2; exit 1; }
link() { gcc -std=c11 -I "$(dirname "$header")" "$work/table.c" -o "$work/table" "-Wl,--gc-sections$1" "$work/bare.a" \
    -lpthread -ldl -lm; }
link ''
guard=$(nm "$work/table" | grep -oE '_RN\w*9panicking19panic_cannot_unwind' || true)
[ -z "$guard" ] || link ",--allow-multiple-definition,--defsym=$guard=main"

nm -C "$work/table" >"$work/symbols"
linked=$(grep -cE ' T softanvil_[a-z_]+$' "$work/symbols")
wanted=$(wc -w <<<"$functions")
[ "$linked" = "$wanted" ] || { echo "only $linked of $wanted functions are linked" >&2; exit 1; }
if grep -E 'panic|_fail(ed)?(_|$)|alloc::|std::' "$work/symbols" | grep -v 'panic_cannot_unwind$' >&2; then
    echo "a panic or the heap can be reached" >&2
    exit 1
fi
nm -u "$work/table" | grep -oE '\bU \w+' | cut -d' ' -f2 | grep -vE '^(__libc_start_main|mem(cpy|move|set|cmp)|bcmp)$' \
    >"$work/foreign" || true
if [ -s "$work/foreign" ]; then
    echo "called from the C library: $(tr '\n' ' ' <"$work/foreign")" >&2
    exit 1
fi
echo "$wanted functions reach $(grep -cE ' [tT] ' "$work/symbols") functions in all: no panic, no heap, nothing of the C" \
    "library but $(nm -u "$work/table" | grep -oE '\b(mem\w+|bcmp)\b' | tr '\n' ' ')"
