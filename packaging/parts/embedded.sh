# shellcheck shell=bash
# For microcontrollers: one folder is a module of Zephyr, a library of Arduino and one of PlatformIO, with the compiled library of each
# processor and calling convention. What can be tried without their SDKs is tried: packaging/embedded/test.sh.
mkdir -p "$out/embedded"
rm -f "$out"/embedded/*
name=softanvil-embedded-$version tree=$work/embedded/softanvil
rm -rf "$work/embedded" && mkdir -p "$tree/src"

# processor CPU UNIT CONVENTION TARGET: the C ABI without the solid, which takes more than a board has.
processor() {
    RUSTFLAGS="$remap -Ctarget-cpu=$1" cargo rustc -q --locked --profile library -p softanvil-ffi --no-default-features \
        --features c-abi,pads --crate-type staticlib --target "$4" --target-dir "$work/cargo-$1"
    mkdir -p "$tree/src/$1/$2-$3"
    cp "$work/cargo-$1/$4/library/libsoftanvil.a" "$tree/src/$1/$2-$3"
}
if rustup -q target add thumbv7em-none-eabihf thumbv7em-none-eabi >/dev/null 2>&1; then
    processor cortex-m4 fpv4-sp-d16 hard thumbv7em-none-eabihf
    processor cortex-m4 fpv4-sp-d16 softfp thumbv7em-none-eabi
    processor cortex-m7 fpv5-d16 hard thumbv7em-none-eabihf
    processor cortex-m7 fpv5-d16 softfp thumbv7em-none-eabi
    cp include/softanvil.h include/softanvil.hpp "$tree/src"
    cp -r packaging/embedded/zephyr packaging/embedded/arduino/{examples,platformio.py} "$tree"
    cp LICENSE-MIT LICENSE-APACHE CHANGELOG.md packaging/embedded/README.md "$tree"
    for file in library.properties library.json; do
        sed "s/@version@/$version/; s/@digest@/$digest/" "packaging/embedded/arduino/$file.in" >"$tree/$file"
    done
    packaging/embedded/test.sh "$tree" || exit 1
    archive "$out/embedded/$name.tar.gz" "$work/embedded" softanvil
    # Arduino's library manager and its "Add .ZIP library" take a zip file, PlatformIO either.
    python3 packaging/zip.py "$out/embedded/$name.zip" "$work/embedded" softanvil
else
    skip embedded "rustup has no thumbv7em-none-eabihf"
fi
