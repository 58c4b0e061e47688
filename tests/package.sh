#!/usr/bin/env bash
# Packs every crate that is meant for others as a registry takes it, and compiles the packages beside each other, without
# anything of this folder: package.sh, no network. What a package lacks shows here. With the profile `release`, as clippy,
# whose compiled dependencies it takes.
set -euo pipefail
cd "$(dirname "$0")/.."
crates=(kernel kernel-f32 ffi fmu specimen workbooks records identify golden)
target=$PWD/target
work=$target/package/workspace
rm -rf "$work" "$target"/package/*.crate
mkdir -p "$work"

packages=(-p softanvil)
for crate in "${crates[@]}"; do packages+=(-p "softanvil-$crate"); done
cargo package -q --offline --allow-dirty --no-verify "${packages[@]}"

# Whatever is not for others says so, and what is has all that a registry shows.
cargo metadata -q --offline --no-deps --format-version 1 | python3 -c '
import json, sys
listed = set(sys.argv[1:])
for package in json.load(sys.stdin)["packages"]:
    name = package["name"]
    assert (package["publish"] == []) == (name not in listed), f"{name}: publish = false, or a package"
    if name in listed:
        for key in "description", "license", "readme", "documentation", "keywords", "categories", "rust_version":
            assert package[key], f"{name} lacks {key}"
        assert "docs" in (package["metadata"] or {}), f"{name} lacks settings of docs.rs"
        assert len(package["keywords"]) <= 5 and all(len(word) <= 20 for word in package["keywords"]), f"{name}: keywords"
' softanvil "${crates[@]/#/softanvil-}"
for package in "$target"/package/*.crate; do
    tar -tzf "$package" >"$work/files.txt"
    for file in README.md LICENSE-MIT LICENSE-APACHE; do
        grep -q "^[^/]*/$file\$" "$work/files.txt" || { echo "$package has no $file" >&2; exit 1; }
    done
done
rm "$work/files.txt"

# A workspace of the packages, with the profiles and the versions of this one; names of crates lead to each other. And with what the
# package for Python takes, so that what all take has the features with which clippy has compiled it.
mkdir -p "$work/python/src" && touch "$work/python/src/lib.rs"
{
    printf '[package]\nname = "python"\nedition = "2024"\n\n[dependencies]\n'
    grep -E '^(numpy|pyo3) = ' python/Cargo.toml
} >"$work/python/Cargo.toml"
{
    printf '[workspace]\nresolver = "3"\nmembers = ["*"]\n\n[patch.crates-io]\n'
    for name in softanvil "${crates[@]/#/softanvil-}"; do
        mkdir "$work/$name"
        # Dated now: the packages have a date of old, by which nothing would ever be compiled again.
        tar -xzmf "$target/package/$name"-[0-9]*.crate -C "$work/$name" --strip-components=1
        printf '%s = { path = "%s" }\n' "$name" "$name"
    done
    awk '/^\[profile/ { kept = 1 } kept' Cargo.toml
} >"$work/Cargo.toml"
cp Cargo.lock "$work"
cd "$work" && cargo check -q --offline --release --workspace --target-dir "$target"
