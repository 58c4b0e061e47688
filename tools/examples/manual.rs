//! Writes the manual pages of the command line, one of the program and one of each subcommand: `cargo run --release -p softanvil
//! --example manual -- FOLDER`. Packages have them.

use std::path::PathBuf;

fn main() -> std::io::Result<()> {
    let folder = std::env::args_os().nth(1).map(PathBuf::from).expect("manual FOLDER");
    std::fs::create_dir_all(&folder)?;
    // The pages of the section of user commands, without those of hidden commands.
    clap_mangen::generate_to(softanvil_tools::cli::program(), &folder)
}
