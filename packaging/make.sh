#!/usr/bin/env bash
# Makes the packages that others install into one folder, with their checksums:
#
#     packaging/make.sh [--out FOLDER] [PART...]      by default all parts, into target/packages
#
#     crates      what a registry of crates takes, *.crate
#     program     the command line as static binaries for Linux on x86-64 and aarch64, with manual pages
#     library     the library for C and C++: an archive, and Debian packages with the command line
#     conan       the same library as a package of Conan 2, its recipe and its sources
#     fmu         the FMUs, for all platforms
#     wheels      wheels and sdist for Python
#     embedded    a module for Zephyr and a library for Arduino and PlatformIO, with libraries for Cortex-M4 and Cortex-M7
#     sbom        the software bill of materials (CycloneDX) of the command line, the library and the wheels
#
# Every package is checked as it is made. The same commit gives the same bytes, in whatever folder (packaging/twice.sh). What a part needs
# is installed if it may be; a part that cannot be made is skipped by name, which with CI=true is a failure.
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
. tests/need.sh
. packaging/environment.sh

out=target/packages parts=()
while [ $# -gt 0 ]; do
    case $1 in
        --out) out=${2:?--out needs a folder}; shift ;;
        -h | --help) sed -n '2,15s/^# \{0,1\}//p' "$0"; exit ;;
        *)
            [ -f "packaging/parts/$1.sh" ] || { echo "make.sh: no part is called $1: --help lists them" >&2; exit 2; }
            parts+=("$1") ;;
    esac
    shift
done
[ ${#parts[@]} -gt 0 ] || parts=(crates program library conan fmu wheels embedded sbom)
mkdir -p "$out" && out=$(cd "$out" && pwd)
work=$root/target/packaging
mkdir -p "$work"

skipped=0
# skip PART REASON
skip() { skipped=$((skipped + 1)); printf 'SKIPPED: %s: %s\n' "$1" "$2" >&2; }

for part in "${parts[@]}"; do
    start=$SECONDS
    printf '== %s\n' "$part"
    # shellcheck source=/dev/null
    . "packaging/parts/$part.sh"
    printf -- '-- %s: %d s\n' "$part" $((SECONDS - start))
done

(cd "$out" && find . -type f ! -name SHA256SUMS -printf '%P\n' | LC_ALL=C sort | xargs -d '\n' sha256sum >SHA256SUMS)
cat "$out/SHA256SUMS"
printf '%d packages of %s in %s, %d parts skipped\n' "$(wc -l <"$out/SHA256SUMS")" "$version" "$out" $skipped
[ "${CI:-}" != true ] || [ $skipped = 0 ]
