//! Writes `docs/verification.md`: every problem on its regular meshes, and the long convergence studies.

use std::error::Error;
use std::fs;
use std::path::Path;

use softanvil_verification::table::{long_rows, markdown, markdown_checks, regular_rows, single_checks};

const HEAD: &str = "# Verification

Every problem is a file in `tests/verification/tests/suite/`, which names the source of its reference. Errors are relative.
[verification-guide.md](verification-guide.md) says how to read the tables, and which row answers which question.
`cargo run --release -p softanvil-verification --example table` writes this page.
";

fn main() -> Result<(), Box<dyn Error>> {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs");
    let (regular, long) = (markdown(&regular_rows()), markdown(&long_rows()));
    let single = markdown_checks(&single_checks());
    let page = format!(
        "{HEAD}\n## Materials through one element, patch test, impactor\n\n{single}\n## Regular meshes\n\n{regular}\n## Long studies\n\n{long}"
    );
    fs::create_dir_all(&docs)?;
    fs::write(docs.join("verification.md"), page)?;
    Ok(())
}
