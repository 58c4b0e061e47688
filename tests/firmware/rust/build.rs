//! Hands the memory map and the linker scripts to the linker.

fn main() {
    let here = std::env::var("CARGO_MANIFEST_DIR").expect("cargo sets it");
    // memory.x stands beside this file, which may be of another folder than the manifest.
    println!("cargo:rustc-link-search={here}");
    println!("cargo:rustc-link-search={here}/..");
    println!("cargo:rustc-link-arg-bins=-Tlink.x");
    println!("cargo:rustc-link-arg-bins=--nmagic");
    println!("cargo:rerun-if-changed=memory.x");
}
