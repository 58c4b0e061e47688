//! The structured mesh of the section.

mod cell;
mod columns;
mod grid;
mod section;

pub use cell::{CORNERS, triangles};
pub use columns::{MAX_PIECES, Piece};
pub use grid::{Grid, MAX_CELLS};
pub use section::{out_of_plane, reference_position};
