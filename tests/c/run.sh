#!/usr/bin/env bash
# Builds the rigs in C and C++ against the library in LIBDIR, static and shared, and runs them: their traces agree with
# each other and, if SOFTANVIL_CLI names the command line program, with its own. Unless the library is that of the profile
# `checked`, which is linked in one way only, the rig of faults also runs under valgrind and under the address and
# undefined-behaviour sanitizers, the sweep over threads under helgrind and the thread sanitizer. For that of the profile
# `library`, which install.sh leaves in target/install/lib, it also compares the ABI with the last release and looks for
# paths to a panic. package.sh runs the rigs from an installed package.
#
#     tests/c/run.sh LIBDIR
set -euo pipefail

if [ $# -ne 1 ] || [ ! -e "$1/libsoftanvil.a" ] || [ ! -e "$1/libsoftanvil.so" ]; then
    echo "usage: tests/c/run.sh LIBDIR (with libsoftanvil.a and libsoftanvil.so)" >&2
    exit 2
fi
libdir=$(cd "$1" && pwd)
tests=$(cd "$(dirname "$0")/.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

warnings=(-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -ffp-contract=off -O1 -g)
c=(gcc -std=c11 -Wstrict-prototypes "${warnings[@]}")
cpp=(g++ -std=c++17 "${warnings[@]}")
include=(-I "$tests/../include" -I "$tests/c")
static=("$libdir/libsoftanvil.a" -lpthread -ldl -lm)
shared=(-L "$libdir" -lsoftanvil "-Wl,-rpath,$libdir")
sanitize=(-fsanitize=address,undefined -fno-sanitize-recover=all)

passed=0
failed=0

# check NAME COMMAND...: runs the command and counts; its output is shown if it fails.
check() {
    local name=$1
    shift
    if "$@" >"$work/output" 2>&1; then
        passed=$((passed + 1))
        echo "ok      $name"
    else
        failed=$((failed + 1))
        echo "FAILED  $name"
        sed 's/^/        /' "$work/output"
    fi
}

# Succeeds if the command fails.
fails() { ! "$@"; }

# Runs a rig and keeps what it prints.
trace() { "$work/$1" >"$work/$1.txt"; }

# The header alone, in every dialect that it promises, and as both languages.
for dialect in c99 c11 c17; do
    check "header as $dialect" gcc -std=$dialect -Wall -Wextra -Wpedantic -Werror -fsyntax-only -x c \
        "$tests/../include/softanvil.h"
done
for dialect in c++11 c++17 c++20; do
    check "header as $dialect" g++ -std=$dialect -Wall -Wextra -Wpedantic -Werror -fsyntax-only -x c++ \
        "$tests/../include/softanvil.h"
done
for dialect in c++17 c++20; do
    check "C++ header as $dialect" g++ -std=$dialect -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror \
        -fsyntax-only -x c++ "$tests/../include/softanvil.hpp"
    check "C++ header as $dialect without exceptions" g++ -std=$dialect -fno-exceptions -Wall -Wextra -Wpedantic \
        -Werror -fsyntax-only -x c++ "$tests/../include/softanvil.hpp"
done
check "layout frozen" "${c[@]}" "${include[@]}" -fsyntax-only "$tests/c/abi.c"

# A library with checks of its own arithmetic finds its faults itself: one way to link it will do, without instruments.
linkages=(static shared)
[ "$(basename "$libdir")" != checked ] || linkages=(static)
for linkage in "${linkages[@]}"; do
    declare -n library=$linkage
    check "build C rig, $linkage" "${c[@]}" "${include[@]}" "$tests/c/rig.c" -o "$work/c-$linkage" "${library[@]}"
    check "build C++ rig, $linkage" "${cpp[@]}" "${include[@]}" "$tests/cpp/rig.cpp" -o "$work/cpp-$linkage" \
        "${library[@]}"
    check "build rig of faults, $linkage" "${c[@]}" "${include[@]}" "$tests/c/faults.c" -o "$work/faults-$linkage" \
        "${library[@]}"
    check "build layers, $linkage" "${c[@]}" "${include[@]}" "$tests/c/layers.c" -o "$work/layers-$linkage" \
        "${library[@]}" -lm
    check "a stack of one material is one layer, $linkage" "$work/layers-$linkage"
    check "build solid, $linkage" "${c[@]}" "${include[@]}" "$tests/c/solid.c" -o "$work/solid-$linkage" "${library[@]}"
    check "run solid, $linkage" trace "solid-$linkage"
    check "build coupling, $linkage" "${c[@]}" "${include[@]}" "$tests/c/coupling.c" -o "$work/coupling-$linkage" \
        "${library[@]}" -lm
    check "mass outside, $linkage" "$work/coupling-$linkage"
    check "a deviation is noticed, $linkage" fails "$work/coupling-$linkage" 1e-9
    check "run C rig, $linkage" trace "c-$linkage"
    check "run C++ rig, $linkage" trace "cpp-$linkage"
    check "run rig of faults, $linkage" "$work/faults-$linkage"
done
# A host that has changed its floating-point environment; only the processors that the rig knows.
case $(uname -m) in x86_64 | aarch64)
    check "build rig of environments" "${c[@]}" "${include[@]}" "$tests/c/environment.c" -o "$work/environment" \
        "${static[@]}"
    check "run rig of environments" "$work/environment" ;;
esac
for linkage in "${linkages[@]}"; do
    for language in c cpp; do
        [ $language-$linkage = c-static ] ||
            check "c-static and $language-$linkage agree" cmp "$work/c-static.txt" "$work/$language-$linkage.txt"
    done
done

if [ "$(basename "$libdir")" != checked ]; then
    check "build sanitized rig of faults" "${c[@]}" "${include[@]}" "${sanitize[@]}" "$tests/c/faults.c" \
        -o "$work/faults-sanitized" "${static[@]}"
    check "run sanitized rig of faults" "$work/faults-sanitized"
    check "build sanitized C++ rig" "${cpp[@]}" "${include[@]}" "${sanitize[@]}" "$tests/cpp/rig.cpp" \
        -o "$work/cpp-sanitized" "${static[@]}"
    check "run sanitized C++ rig" "$work/cpp-sanitized"
    check "rig of faults under valgrind" valgrind -q --error-exitcode=9 --leak-check=full "$work/faults-static"

    # Threads share nothing: helgrind sees the library too, the sanitizer only the caller.
    check "build sweep" "${cpp[@]}" "${include[@]}" "$tests/cpp/sweep.cpp" -o "$work/sweep" "${static[@]}"
    check "sweep over threads" "$work/sweep" 4
    check "sweep under helgrind" valgrind -q --tool=helgrind --error-exitcode=9 "$work/sweep" 3 100e-6
    check "build sanitized sweep" "${cpp[@]}" "${include[@]}" -fsanitize=thread "$tests/cpp/sweep.cpp" \
        -o "$work/sweep-sanitized" "${static[@]}"
    check "run sanitized sweep" setarch -R "$work/sweep-sanitized" 3 5e-3
fi

# Only the ABI leaves the shared library.
only_abi() {
    nm -D --defined-only "$libdir/libsoftanvil.so" | awk '{print $3}' >"$work/symbols"
    grep -q '^softanvil_init$' "$work/symbols" && ! grep -Ev '^(softanvil_|fmi[23])' "$work/symbols"
}
check "only the ABI is exported" only_abi

# The command line program gives the same trace for the same energy.
same_as_cli() {
    local wanted
    wanted=$("$SOFTANVIL_CLI" run --energy "$1" --json | sed -n 's/.*"trace_hash": *"\([0-9a-f]*\)".*/\1/p')
    echo "command line: $wanted"
    [ -n "$wanted" ] && grep -E "^ *$1 J .* hash $wanted\$" "$work/c-static.txt"
}
same_solid_as_cli() {
    local wanted
    wanted=$("$SOFTANVIL_CLI" run --set geometry.formulation=solid --set mesh.element_size=0.0075 --duration 0.015 --json |
        sed -n 's/.*"trace_hash": *"\([0-9a-f]*\)".*/\1/p')
    echo "command line: $wanted"
    [ -n "$wanted" ] && grep "hash $wanted\$" "$work/solid-static.txt"
}
if [ -n "${SOFTANVIL_CLI:-}" ]; then
    for energy in 14.7 9.8 4.9; do
        check "C rig and command line agree at $energy J" same_as_cli "$energy"
    done
    check "C rig and command line agree on a solid" same_solid_as_cli
fi

case $(basename "$libdir") in library | lib)
    check "ABI of the last release" "$tests/c/abi/compare.sh" "$libdir"
    sed 's/softanvil_dt(const SoftanvilSimulation/softanvil_dt(SoftanvilSimulation/' "$tests/../include/softanvil.h" \
        >"$work/changed.h"
    check "a changed function is noticed" fails "$tests/c/abi/compare.sh" "$libdir" "$work/changed.h"
    sed 's/SOFTANVIL_STATUS_INVERTED = 300/SOFTANVIL_STATUS_INVERTED = 304/' "$tests/../include/softanvil.h" \
        >"$work/changed.h"
    check "a changed number is noticed" fails "$tests/c/abi/compare.sh" "$libdir" "$work/changed.h"
    check "no path to a panic" "$tests/c/panic.sh" "$libdir"
    # A program that was built against the last release runs with this library, and gives the same.
    mkdir "$work/released" && cp "$tests/c/abi/released.h" "$work/released/softanvil.h"
    check "build C rig against the last release" "${c[@]}" -DRELEASED_HEADER -I "$work/released" -I "$tests/c" "$tests/c/rig.c" \
        -o "$work/c-released" "${shared[@]}"
    check "run it with this library" trace c-released
    check "c-static and c-released agree" cmp "$work/c-static.txt" "$work/c-released.txt" ;;
esac
cat "$work/c-static.txt"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
