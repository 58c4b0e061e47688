#!/usr/bin/env bash
# Compares the ABI with that of the last release, of which this folder keeps header, symbols and layouts: what a program
# was built against then still exists, means the same number, has the same type and lies at the same place.
#
#     tests/c/abi/compare.sh LIBDIR [HEADER]
#     tests/c/abi/compare.sh --release LIBDIR     (makes the present ABI the reference; part of making a release)
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
header=$here/../../../include/softanvil.h

exported() { nm -D --defined-only "$1/libsoftanvil.so" | awk '{print $3}' | grep '^softanvil_' | LC_ALL=C sort; }

if [ "$1" = --release ]; then
    exported "$2" >"$here/released.symbols"
    cp "$header" "$here/released.h"
    cp "$here/../abi.inc" "$here/released.inc"
    exit
fi
libdir=$1
header=${2:-$header}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Every function that was exported still is.
missing=$(LC_ALL=C comm -23 "$here/released.symbols" <(exported "$libdir"))
if [ -n "$missing" ]; then
    echo "no longer exported: $missing" >&2
    exit 1
fi

# Every constant has its number, every structure its layout; C refuses a second declaration of another type.
released() { sed -E ':join; /\/\*/{ /\*\//!{ N; b join } }; s|/\*([^*]\|\*[^/])*\*/||g' "$here/released.h"; }
{
    echo '#include <stddef.h>'
    echo "#include \"$(realpath "$header")\""
    echo '#define SIZE(type, bytes) _Static_assert(sizeof(type) == (bytes), "size of " #type);'
    echo '#define ALIGNMENT(type, bytes) _Static_assert(_Alignof(type) == (bytes), "alignment of " #type);'
    echo '#define FIELD(type, field, offset) _Static_assert(offsetof(type, field) == (offset), #type "." #field);'
    echo '#define VALUE(name, number) _Static_assert((name) == (number), "value of " #name);'
    cat "$here/released.inc"
    released | grep -oE '\bSOFTANVIL_[A-Z0-9_]+ = [0-9]+' | sed -E 's/(.*) = (.*)/VALUE(\1, \2)/'
    released | grep -E '^#define SOFTANVIL_[A-Z_]+_(SIZE|SLOTS) ' | awk '{print "VALUE(" $2 ", " $3 ")"}'
    released | awk '/^[A-Za-z].*softanvil_[a-z_]+\(/ { inside = 1 } inside { print } /;/ { inside = 0 }'
} >"$work/released.c"
gcc -std=c11 -Wall -Wextra -Werror -fsyntax-only "$work/released.c"
echo "$(grep -c '^VALUE' "$work/released.c") constants, $(grep -cE '^(SIZE|FIELD|ALIGNMENT)' "$work/released.c") places," \
    "$(wc -l <"$here/released.symbols") functions as released"
