# shellcheck shell=bash
# The software bill of materials: what each package is made of, with versions, licences and checksums, from Cargo.lock.
mkdir -p "$out/sbom"
rm -f "$out"/sbom/*.json
bom=$root/target/tools/bin/cargo-cyclonedx
if [ -x "$bom" ] || RUSTFLAGS='' cargo install -q --locked --root target/tools cargo-cyclonedx --version 0.5.9; then
    for of in program:tools library:ffi wheels:python; do
        manifest=${of#*:}
        # It writes beside the manifest of every member of the workspace.
        "$bom" cyclonedx -q --format json --spec-version 1.5 --override-filename softanvil-bom --target all \
            --manifest-path "$manifest/Cargo.toml" 2>"$work/sbom.txt" || { cat "$work/sbom.txt" >&2; exit 1; }
        # Our own crates are named by where they lie.
        sed "s#file://$root#file:///softanvil#g" "$manifest/softanvil-bom.json" >"$out/sbom/softanvil-$version-${of%:*}.cdx.json"
        find . -path ./target -prune -o -name softanvil-bom.json -exec rm {} +
    done
else
    skip sbom "cargo-cyclonedx cannot be installed"
fi
