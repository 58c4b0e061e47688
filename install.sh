#!/usr/bin/env bash
# Builds and installs the library for C and C++: shared and static library, headers, packages for CMake and pkg-config.
#
#     ./install.sh --prefix DIR        (other options, in any order, go to CMake, as -DCMAKE_INSTALL_LIBDIR=lib)
#
# Needs cargo, CMake and a C compiler. DESTDIR is respected. The build is kept in target/install.
set -euo pipefail
cd "$(dirname "$0")"

prefix=/usr/local arguments=()
while [ $# -gt 0 ]; do
    case $1 in
        --prefix) prefix=${2:?--prefix needs a folder}; shift ;;
        --prefix=*) prefix=${1#*=} ;;
        -h | --help) sed -n '2,6s/^# \{0,1\}//p' "$0"; exit ;;
        -*) arguments+=("$1") ;;
        *) echo "install.sh: $1 is refused: expected --prefix DIR, --help, or an option of CMake" >&2; exit 2 ;;
    esac
    shift
done
case $prefix in /*) ;; *) prefix=$OLDPWD/$prefix ;; esac
build=${CARGO_TARGET_DIR:-target}/install
# What an earlier installation was told does not count; what cargo has built does.
rm -f "$build/CMakeCache.txt"
cmake -S . -B "$build" -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$prefix" "${arguments[@]}"
cmake --build "$build"
cmake --install "$build"
