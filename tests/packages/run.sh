#!/usr/bin/env bash
# Builds a program of a project outside against the library, and runs it: its kernel digest is the one that is stated.
#
#     tests/packages/run.sh prefix PREFIX [DIGEST]    a package that lies in a folder: by find_package and by pkg-config
#     tests/packages/run.sh sources [CARGO_FOLDER]    the repository, by add_subdirectory and by FetchContent; what cargo has built in
#                                                     the folder is not built again
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
quietly() { "$@" >"$work/log" 2>&1 || { cat "$work/log"; echo "failed: $*"; exit 1; }; }

# by NAME CMAKE_ARGUMENT...: the project, its library taken in the way of that name.
by() {
    local name=$1; shift
    quietly cmake -S "$here" -B "$work/$name" -DBY="$name" "$@"
    quietly cmake --build "$work/$name"
    quietly ctest --test-dir "$work/$name" --output-on-failure
    echo "$name: $(grep -c 'Passed' "$work/log") programs, $("$work/$name/drop-static")"
}

case ${1:-} in
    prefix)
        prefix=$(cd "${2:?}" && pwd)
        by find_package -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_FIND_USE_CMAKE_SYSTEM_PATH=OFF
        PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name softanvil.pc)") && export PKG_CONFIG_PATH
        stated=$(pkg-config --variable=kernel_digest softanvil)
        # shellcheck disable=SC2046
        quietly gcc "$here/drop.c" $(pkg-config --cflags --libs softanvil) -Wl,-rpath,"$(pkg-config --variable=libdir softanvil)" -o "$work/drop"
        quietly "$work/drop" "$stated"
        echo "pkg-config: $(cat "$work/log")"
        [ -z "${3:-}" ] || [ "$stated" = "$3" ] ;;
    sources)
        for name in add_subdirectory fetch_content; do
            by $name -DSOURCES="$root" ${2:+-DSOFTANVIL_CARGO_FOLDER="$(realpath "$2")"}
        done ;;
    *) sed -n '2,6s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac
