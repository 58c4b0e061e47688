//! Packages an FMU: `cargo run --release -p softanvil-fmu --example package -- LIBRARY OUT_FOLDER`.

use std::path::PathBuf;
use std::process::ExitCode;

use softanvil_fmu::{Options, package};

fn main() -> ExitCode {
    let arguments: Vec<PathBuf> = std::env::args_os().skip(1).map(PathBuf::from).collect();
    let [library, out] = arguments.as_slice() else {
        eprintln!("usage: package LIBRARY OUT_FOLDER");
        return ExitCode::from(2);
    };
    match package(&Options { libraries: vec![library.clone()], out: out.clone() }) {
        Ok(path) => {
            println!("{}", path.display());
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}
