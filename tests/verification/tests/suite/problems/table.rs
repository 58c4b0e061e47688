//! The committed table is current: `docs/verification.md` holds the regular rows as they come out now.

use softanvil_verification::table::{markdown, markdown_checks, regular_rows, single_checks};

#[test]
fn the_committed_table_is_current() {
    let page = include_str!("../../../../../docs/verification.md");
    let current = markdown_checks(&single_checks()) + &markdown(&regular_rows());
    for line in current.lines() {
        assert!(page.lines().any(|committed| committed == line), "docs/verification.md lacks\n{line}");
    }
}
