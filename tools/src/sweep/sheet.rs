//! A table for people.

use crate::text::table::{FIXED_BLANK, align_right, new_plain_table, text as table_text};
use crate::text::wrap::filled;

/// A table for people.
pub struct Sheet {
    /// Above the table.
    pub title: String,
    /// Titles of the columns.
    pub header: Vec<String>,
    /// The rows.
    pub rows: Vec<Vec<String>>,
    /// Leading columns that are texts; the others are numbers.
    pub n_text: usize,
}

impl Sheet {
    /// For a terminal.
    pub fn text(&self) -> String {
        let header: Vec<&str> = self.header.iter().map(String::as_str).collect();
        let mut table = new_plain_table(&header);
        let fixed = |text: &String| text.replace(" %", &format!("{FIXED_BLANK}%"));
        table.add_rows(self.rows.iter().map(|row| row.iter().map(fixed).collect::<Vec<_>>()));
        align_right(&mut table, self.n_text..self.header.len());
        format!("{}{}\n", filled(&self.title), table_text(&mut table))
    }

    /// As a table of Markdown, without its title.
    pub fn markdown(&self) -> String {
        let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
        let rule = (0..self.header.len()).map(|i| if i < self.n_text { "---" } else { "---:" });
        let mut text = line(&self.header) + &format!("|{}|\n", rule.collect::<Vec<_>>().join("|"));
        self.rows.iter().for_each(|row| text += &line(row));
        text
    }
}
