# shellcheck shell=bash
# The library as install.sh has it, for the C library of this machine: an archive that may be unpacked anywhere, and Debian packages
# of the same files. A program is built against what is unpacked.
need cmake cmake || { skip library "cmake is missing and cannot be installed"; return; }
mkdir -p "$out/library"
rm -f "$out"/library/*
build=$work/library stage=$work/stage
rm -rf "$build/CMakeCache.txt" "$stage" "$build/packages"
program=$work/cargo/$(uname -m)-unknown-linux-musl/release/softanvil with_program=()
[ ! -x "$program" ] || with_program=("-DSOFTANVIL_PROGRAM=$program" "-DSOFTANVIL_MANUAL=$work/manual")
cmake -S . -B "$build" -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX=/usr -DCMAKE_INSTALL_LIBDIR=lib \
    "${with_program[@]}" >/dev/null
cmake --build "$build" >/dev/null

name=softanvil-$version-$(rustc -vV | sed -n 's/^host: //p')
for component in runtime development; do
    DESTDIR=$stage cmake --install "$build" --component $component >/dev/null
done
mkdir -p "$stage/$name" && mv "$stage"/usr/* "$stage/$name"
cp CHANGELOG.md "$stage/$name"
archive "$out/library/$name.tar.gz" "$stage" "$name"
tests/packages/run.sh prefix "$stage/$name" "$digest"

if need dpkg-deb dpkg && need dpkg-shlibdeps dpkg-dev; then
    # Where Debian has libraries.
    cmake -S . -B "$build" -DCMAKE_INSTALL_LIBDIR="lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH)" >/dev/null
    (cd "$build" && cpack -B packages >/dev/null)
    cp "$build"/packages/*.deb "$out/library"
    rm -rf "$work/root"
    for package in "$out"/library/*.deb; do dpkg-deb -x "$package" "$work/root"; done
    tests/packages/run.sh prefix "$work/root/usr" "$digest"
    [ ! -x "$program" ] || "$work/root/usr/bin/softanvil" --version | grep "^kernel digest $digest "
else
    skip "Debian packages" "dpkg-deb or dpkg-shlibdeps is missing and cannot be installed"
fi
