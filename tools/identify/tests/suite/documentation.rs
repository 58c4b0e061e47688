//! Figures of docs/fits.md against the files that they come from.

use std::path::Path;

#[test]
fn the_table_of_peers_is_that_of_the_last_run() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let table = std::fs::read_to_string(root.join("tests/identify/peers.csv")).unwrap();
    let page = std::fs::read_to_string(root.join("docs/fits.md")).unwrap();
    let lines: Vec<&str> = page.lines().collect();
    let shown = lines.iter().filter(|line| line.starts_with("| ") && line.matches('|').count() == 6).count();
    assert_eq!(shown, table.lines().count());
    for row in table.lines() {
        let cells: Vec<&str> = row.split(',').take(6).collect();
        let line = format!("| {} | {} | {} |", cells[0], cells[1], cells[3..].join(" | "));
        assert!(lines.contains(&line.as_str()), "{line}");
    }
}
