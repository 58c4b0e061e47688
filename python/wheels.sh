#!/usr/bin/env bash
# Makes the wheels and the sdist of the package: wheels.sh [FOLDER], by default python/dist. Linux x86-64 and aarch64 are linked by
# zig, for glibc 2.17 and newer (manylinux2014); Windows x86-64 by mingw. Needs rustup, mingw (gcc-mingw-w64-x86-64) and python3
# with venv; maturin and zig come as Python packages. One wheel serves CPython 3.10 and all later ones (stable ABI).
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/.." && pwd)
out=$(mkdir -p "${1:-$here/dist}" && cd "${1:-$here/dist}" && pwd)
venv=$root/target/wheels
export CARGO_TARGET_DIR=$root/target/python

[ -x "$venv/bin/python" ] || python3 -m venv "$venv"
"$venv/bin/python" -m pip install --quiet --disable-pip-version-check maturin==1.16.0 ziglang==0.17.1
export PATH=$venv/bin:$PATH
rustup --quiet target add x86_64-unknown-linux-gnu aarch64-unknown-linux-gnu x86_64-pc-windows-gnu

cd "$here"
rm -f "$out"/softanvil-*.whl "$out"/softanvil-*.tar.gz
for target in x86_64-unknown-linux-gnu aarch64-unknown-linux-gnu; do
    maturin build --quiet --release --locked --out "$out" --target "$target" --zig --compatibility manylinux2014
done
maturin build --quiet --release --locked --out "$out" --target x86_64-pc-windows-gnu
maturin sdist --out "$out"
ls -1 "$out"
