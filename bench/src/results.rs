//! Figures for the tables: one file a benchmark, one line a figure, in the target folder beside criterion's.

use std::fs;
use std::path::{Path, PathBuf};

/// Writes `figures`, name and value, as the results of `benchmark`, and prints them.
///
/// # Panics
/// If the file cannot be written.
pub fn write(benchmark: &str, figures: &[(String, f64)]) {
    let mut text = String::from("figure,value\n");
    for (name, value) in figures {
        println!("{benchmark}: {name} = {value:.4}");
        text += &format!("\"{name}\",{value}\n");
    }
    let folder = folder();
    fs::create_dir_all(&folder)
        .and_then(|()| fs::write(folder.join(format!("{benchmark}.csv")), text))
        .expect("a file");
}

fn folder() -> PathBuf {
    let target = Path::new(env!("CARGO_MANIFEST_DIR")).join("../target");
    std::env::var_os("CARGO_TARGET_DIR").map_or(target, PathBuf::from).join("softanvil-bench")
}
