# shellcheck shell=bash
# The crates in the order in which a registry takes them. tests/package.sh compiles them beside each other.
crates=(kernel kernel-f32 workbooks records specimen golden ffi fmu identify)
packages=()
for crate in "${crates[@]}"; do packages+=(-p "softanvil-$crate"); done
cargo package -q --locked --no-verify "${packages[@]}" -p softanvil
mkdir -p "$out/crates"
rm -f "$out"/crates/*.crate
for crate in "${crates[@]/#/softanvil-}" softanvil; do
    cp "target/package/$crate-$version.crate" "$out/crates"
    # What a stranger needs: what it is, and what may be done with it.
    for file in README.md LICENSE-MIT LICENSE-APACHE; do
        tar -tzf "$out/crates/$crate-$version.crate" "$crate-$version/$file" >/dev/null
    done
done
