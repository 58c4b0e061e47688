# shellcheck shell=bash
# The FMUs with the binaries of all platforms for which there is a compiler. FMI 2.0 has no name for Linux on aarch64.
mkdir -p "$out/fmu"
rm -f "$out"/fmu/*.fmu
targets=(--target x86_64-unknown-linux-gnu) only_fmi3=()
if need x86_64-w64-mingw32-gcc gcc-mingw-w64-x86-64; then
    targets+=(--target x86_64-pc-windows-gnu)
else
    skip "FMU, Windows" "x86_64-w64-mingw32-gcc is missing and cannot be installed"
fi
if need aarch64-linux-gnu-gcc gcc-aarch64-linux-gnu libc6-dev-arm64-cross; then
    only_fmi3=(--target aarch64-unknown-linux-gnu)
else
    skip "FMU, Linux on aarch64" "aarch64-linux-gnu-gcc is missing and cannot be installed"
fi
rustup -q target add x86_64-unknown-linux-gnu aarch64-unknown-linux-gnu x86_64-pc-windows-gnu >/dev/null 2>&1
cargo run -q --release --locked -p softanvil -- fmu --fmi 2 "${targets[@]}" --out "$out/fmu"
cargo run -q --release --locked -p softanvil -- fmu --fmi 3 "${targets[@]}" "${only_fmi3[@]}" --out "$out/fmu"
for fmu in "$out"/fmu/*.fmu; do
    python3 -c 'import sys, zipfile
sys.exit(sys.argv[2] not in zipfile.ZipFile(sys.argv[1]).read("modelDescription.xml").decode())' "$fmu" "<Kernel digest=\"$digest\"/>"
done
