#!/usr/bin/env bash
# Makes the packages of the last commit twice, in two folders of different names and from two clones, and compares every byte:
#
#     packaging/twice.sh [PART...]      parts as of packaging/make.sh
#
# It takes twice as long as making them, so it is run by hand before a release.
set -euo pipefail
cd "$(dirname "$0")/.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# Both of the same commit, whatever is committed meanwhile.
for folder in one another/place; do git clone -q --no-hardlinks . "$work/$folder"; done
for folder in one another/place; do
    # Tools, which are not compared, are installed once.
    mkdir -p target/tools "$work/$folder/target" && ln -s "$PWD/target/tools" "$work/$folder/target/tools"
    "$work/$folder/packaging/make.sh" --out "$work/$folder-packages" "$@" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
    grep '^-- \|^SKIPPED' "$work/log"
    # Room for the next.
    rm -rf "$work/$folder"
done
if diff "$work/one-packages/SHA256SUMS" "$work/another/place-packages/SHA256SUMS"; then
    cat "$work/one-packages/SHA256SUMS"
    echo "$(wc -l <"$work/one-packages/SHA256SUMS") packages, the same bytes twice"
else
    echo "FAILED: these differ" >&2
    exit 1
fi
