#!/usr/bin/env bash
# Installs the package into a scratch prefix and builds from it what users build: the rigs and the example by CMake,
# the example by pkg-config and by plain gcc. Prints what the example prints, three times the same.
#
#     tests/c/package.sh
set -euo pipefail

root=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
prefix=$work/prefix

"$root/install.sh" --prefix "$prefix" --libdir "$prefix/lib" >"$work/install.log" 2>&1 || { cat "$work/install.log"; exit 1; }
# A staged installation has the same files under DESTDIR, and its files do not know of it.
DESTDIR=$work/stage "$root/install.sh" --prefix /usr --libdir lib >"$work/install.log" 2>&1 || { cat "$work/install.log"; exit 1; }
diff <(cd "$prefix" && find . | sort) <(cd "$work/stage/usr" && find . | sort)
! grep -rIl "$work" "$work/stage"
soname=$(readelf -d "$prefix/lib/libsoftanvil.so" | sed -n 's/.*soname: \[\(.*\)\]/\1/p')
version=$(sed -n 's/^#define SOFTANVIL_VERSION_TEXT "\(.*\)"/\1/p' "$prefix/include/softanvil.h")
echo "version $version, soname $soname"
[ -e "$prefix/lib/$soname" ] && [[ $soname = libsoftanvil.so.* && $version = "${soname#libsoftanvil.so.}".* ]]

# Exactly the version or an older one of the same line is found, another line is not.
for wanted in "0.1:0" "$version EXACT:0" "99.0:1"; do
    printf 'cmake_minimum_required(VERSION 3.16)\nproject(v NONE)\nfind_package(softanvil %s CONFIG REQUIRED)\n' \
        "${wanted%:*}" >"$work/CMakeLists.txt"
    code=0
    cmake -S "$work" -B "$work/find" -DCMAKE_PREFIX_PATH="$prefix" >"$work/find.log" 2>&1 || code=1
    [ $code = "${wanted#*:}" ] || { cat "$work/find.log"; exit 1; }
    rm -rf "$work/find"
done

for rigs in c cpp; do
    cmake -S "$root/tests/$rigs" -B "$work/$rigs" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_BUILD_TYPE=Release >/dev/null
    cmake --build "$work/$rigs" >"$work/build.log" 2>&1 || { cat "$work/build.log"; exit 1; }
    ctest --test-dir "$work/$rigs" --output-on-failure
done
"$work/c/unit-static"
"$work/c/loop-static" 1000
"$work/c/loop-static" 20000
"$work/cpp/sweep-static"

example=$root/examples/c
cmake -S "$example" -B "$work/example" -DCMAKE_PREFIX_PATH="$prefix" >/dev/null
cmake --build "$work/example" >/dev/null
"$work/example/drop" | tee "$work/drop.txt"
export PKG_CONFIG_PATH=$prefix/lib/pkgconfig
gcc "$example/drop.c" $(pkg-config --cflags --libs softanvil) -Wl,-rpath,"$prefix/lib" -o "$work/drop-pkg-config"
"$work/drop-pkg-config" | tee "$work/drop-pkg-config.txt"
gcc -I "$prefix/include" "$example/drop.c" "$prefix/lib/libsoftanvil.a" -lpthread -ldl -lm -o "$work/drop-gcc"
"$work/drop-gcc" | tee "$work/drop-gcc.txt"
cmp "$work/drop.txt" "$work/drop-pkg-config.txt"
cmp "$work/drop.txt" "$work/drop-gcc.txt"
