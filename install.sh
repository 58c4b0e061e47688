#!/usr/bin/env bash
# Builds and installs the library for C and C++: static and shared library, headers, softanvil.pc, CMake package.
#
#     ./install.sh --prefix DIR        (and what else `cargo cinstall` takes: --libdir, --destdir, --target, ...)
#
# DESTDIR is respected. The work is that of cargo-c, which is built into target/cargo-c first if there is none; that
# takes some minutes and needs pkg-config and the headers of OpenSSL.
set -euo pipefail
cd "$(dirname "$0")"

# The newest version that builds with the Rust version of Cargo.toml.
version=0.10.18
tools=${CARGO_TARGET_DIR:-target}/cargo-c
PATH=$PATH:$tools/bin
if ! command -v cargo-cinstall >/dev/null; then
    # Speed of the tool does not matter, that of its compilation does.
    CARGO_PROFILE_RELEASE_OPT_LEVEL=0 CARGO_PROFILE_RELEASE_LTO=false CARGO_PROFILE_RELEASE_CODEGEN_UNITS=64 \
        cargo install cargo-c --locked --version "=$version" --root "$tools" --target-dir "$tools/build"
    rm -rf "$tools/build"
fi
cargo cinstall --release --package softanvil-ffi ${DESTDIR:+--destdir "$DESTDIR"} "$@"
