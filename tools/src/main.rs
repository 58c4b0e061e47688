//! The command line of Softanvil.

use std::io::Write;
use std::process::ExitCode;

fn main() -> ExitCode {
    let outcome = softanvil_tools::cli::execute(std::env::args_os());
    // A reader that has gone away (`softanvil scenario | head`) is no failure of ours.
    let _ = std::io::stdout().write_all(outcome.stdout.as_bytes());
    let _ = std::io::stderr().write_all(outcome.stderr.as_bytes());
    ExitCode::from(outcome.exit_code)
}
