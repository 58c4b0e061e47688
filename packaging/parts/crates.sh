# shellcheck shell=bash
# The crates as a registry takes them. tests/package.sh packs and checks them, and compiles them beside each other.
[ -z "$(git status --porcelain 2>/dev/null)" ] || { echo "crates are packed from a commit: commit or stash the changes" >&2; exit 1; }
cargo fetch -q --locked
tests/package.sh
mkdir -p "$out/crates"
rm -f "$out"/crates/*.crate
cp target/package/*.crate "$out/crates"
