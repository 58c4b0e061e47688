//! The command line of Softanvil.

use std::io::{self, ErrorKind, Write};
use std::process::ExitCode;

use softanvil_tools::failure::Failure;

fn main() -> ExitCode {
    let outcome = softanvil_tools::cli::execute(std::env::args_os());
    // There is nowhere else to say that an error cannot be written.
    let _ = write(io::stderr(), &outcome.stderr);
    match write(io::stdout(), &outcome.stdout) {
        Ok(()) => ExitCode::from(outcome.exit_code),
        Err(error) => {
            let failure = Failure::Failed(format!("standard output cannot be written: {error}"));
            let _ = write(io::stderr(), &format!("error: {failure}\n"));
            ExitCode::from(failure.exit_code())
        }
    }
}

/// Writes all of `text`. A reader that has gone away (`softanvil scenario | head`) is no failure of ours.
fn write(mut stream: impl Write, text: &str) -> io::Result<()> {
    match stream.write_all(text.as_bytes()).and_then(|()| stream.flush()) {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        written => written,
    }
}
