//! Text for people: numbers, lines, tables.

pub mod number;
pub mod table;
pub mod wrap;
