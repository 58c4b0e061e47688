#!/usr/bin/env bash
# Installs the package into a scratch prefix and builds from it what users build: the rigs in C and C++, which CTest runs,
# and the program of docs/first-drop.md by CMake, by pkg-config and by plain gcc. With SOFTANVIL_CLI, peak force and trace hash
# must be those of the command line program. Needs cmake and pkg-config.
#
#     tests/c/package.sh
set -euo pipefail

root=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
prefix=$work/prefix

# quietly COMMAND...: shows the output of a command if it fails.
quietly() { "$@" >"$work/log" 2>&1 || { cat "$work/log"; echo "failed: $*"; exit 1; }; }

# Two installations in one; a staged one has the same files under DESTDIR, and its files do not know of it.
quietly "$root/install.sh" --prefix "$prefix"
DESTDIR=$work/stage quietly "$root/install.sh" -DCMAKE_INSTALL_LIBDIR=lib --prefix /usr
diff <(cd "$prefix" && find . | sort) <(cd "$work/stage/usr" && find . | sort)
! grep -rIl "$work" "$work/stage" "$prefix"
soname=$(readelf -d "$prefix/lib/libsoftanvil.so" | sed -n 's/.*soname: \[\(.*\)\]/\1/p')
version=$(sed -n 's/^#define SOFTANVIL_VERSION_TEXT "\(.*\)"/\1/p' "$prefix/include/softanvil.h")
echo "version $version, soname $soname"
[ -e "$prefix/lib/$soname" ] && [[ $soname = libsoftanvil.so.* && $version = "${soname#libsoftanvil.so.}".* ]]
# No symbol but the ABI.
! nm -D --defined-only "$prefix/lib/libsoftanvil.so" | awk '{print $3}' | grep -Ev '^(softanvil_|fmi[23])'

# Exactly the version or an older one of the same line is found, another line is not.
for wanted in "${version%.*}:0" "$version EXACT:0" "99.0:1"; do
    printf 'cmake_minimum_required(VERSION 3.16)\nproject(v NONE)\nfind_package(softanvil %s CONFIG REQUIRED)\n' \
        "${wanted%:*}" >"$work/CMakeLists.txt"
    code=0
    cmake -S "$work" -B "$work/find" -DCMAKE_PREFIX_PATH="$prefix" >"$work/log" 2>&1 || code=1
    [ $code = "${wanted#*:}" ] || { cat "$work/log"; exit 1; }
    rm -rf "$work/find"
done

# The package may move.
mv "$prefix" "$work/moved" && prefix=$work/moved
export PKG_CONFIG_PATH=$prefix/lib/pkgconfig

# The program of docs/first-drop.md, three ways.
example=$work/example
mkdir "$example"
block() { sed -n "/^\`\`\`$1\$/,/^\`\`\`\$/p" "$root/docs/first-drop.md" | sed '1d;$d'; }
block c >"$example/drop.c"
block cmake >"$example/CMakeLists.txt"
quietly cmake -S "$example" -B "$example/build" -DCMAKE_PREFIX_PATH="$prefix"
quietly cmake --build "$example/build"
gcc "$example/drop.c" $(pkg-config --cflags --libs softanvil) -Wl,-rpath,"$prefix/lib" -o "$example/by-pkg-config"
gcc -I "$prefix/include" "$example/drop.c" "$prefix/lib/libsoftanvil.a" $(pkg-config --libs-only-l --static softanvil |
    sed 's/-lsoftanvil//') -o "$example/by-gcc"
peak=$("$example/build/drop")
echo "program of docs/first-drop.md: $peak"
[ "$("$example/by-pkg-config")" = "$peak" ] && [ "$("$example/by-gcc")" = "$peak" ]
if [ -n "${SOFTANVIL_CLI:-}" ]; then
    [ "$peak" = "$("$SOFTANVIL_CLI" run --energy 14.7 --json | sed -n 's/.*"peak_force": *\([0-9.]*\).*/\1/p' |
        xargs printf '%.0f N')" ]
fi

for rigs in c cpp; do
    quietly cmake -S "$root/tests/$rigs" -B "$work/$rigs" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_BUILD_TYPE=Release
    quietly cmake --build "$work/$rigs" -j 2
    ctest --test-dir "$work/$rigs" --output-on-failure
done
"$work/c/unit-static"
"$work/c/loop-static" 1000
"$work/c/loop-static" 20000
"$work/cpp/sweep-static"
# The installed library gives the kernel's bits.
if [ -n "${SOFTANVIL_CLI:-}" ]; then
    for energy in 14.7 9.8 4.9; do
        hash=$("$SOFTANVIL_CLI" run --energy $energy --json | sed -n 's/.*"trace_hash": *"\([0-9a-f]*\)".*/\1/p')
        for linkage in softanvil static; do "$work/c/rig-$linkage" | grep -E "^ *$energy J .* hash $hash\$"; done
    done
fi
