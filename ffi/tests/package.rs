//! The version that the installed files state against Cargo.toml.

use std::path::Path;

#[test]
fn the_cmake_package_has_the_version_of_the_crate() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("cmake");
    let text = std::fs::read_to_string(folder.join("softanvilConfigVersion.cmake")).unwrap();
    assert!(text.contains(&format!("set(PACKAGE_VERSION \"{}\")", env!("CARGO_PKG_VERSION"))));
}
