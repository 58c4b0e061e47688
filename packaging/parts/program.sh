# shellcheck shell=bash
# The command line without anything from the system: the linker and the C library come with rustc. Each is started and compared with
# the golden traces.
mkdir -p "$out/program"
rm -f "$out"/program/softanvil-*

# The manual pages, packed without name and date.
manual=$work/manual
rm -rf "$manual"
cargo run -q --release --locked -p softanvil --example manual -- "$manual"
gzip -9n "$manual"/*.1

for processor in x86_64 aarch64; do
    target=$processor-unknown-linux-musl runner=()
    [ "$processor" = "$(uname -m)" ] || runner=("qemu-$processor")
    if ! rustup -q target add "$target" >/dev/null 2>&1; then skip "program, $target" "rustup has no $target"; continue; fi
    RUSTFLAGS="$remap -Clinker=rust-lld -Clinker-flavor=ld.lld -Cstrip=symbols" \
        cargo build -q --release --locked -p softanvil --target "$target" --target-dir "$work/cargo"
    built=$work/cargo/$target/release/softanvil
    ! grep -aq "$root\|$HOME" "$built" || { echo "$built has folders of this machine in it" >&2; exit 1; }
    if [ ${#runner[@]} = 0 ] || need "${runner[0]}" qemu-user; then
        "${runner[@]}" "$built" golden check | grep "^kernel digest $digest\$"
        "${runner[@]}" "$built" --version | grep "^kernel digest $digest "
    else
        skip "check of the program, $target" "${runner[0]} is missing and cannot be installed"
    fi
    stage=$work/program name=softanvil-$version-$target
    rm -rf "$stage" && mkdir -p "$stage/$name/man/man1"
    cp "$built" LICENSE-MIT LICENSE-APACHE CHANGELOG.md "$stage/$name"
    cp "$manual"/*.1.gz "$stage/$name/man/man1"
    printf 'softanvil %s\nkernel digest %s\ntarget %s\n' "$version" "$digest" "$target" >"$stage/$name/VERSION"
    archive "$out/program/$name.tar.gz" "$stage" "$name"
done
