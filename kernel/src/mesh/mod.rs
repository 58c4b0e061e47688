//! The structured mesh of the section, or of a solid.

mod cell;
mod columns;
mod grid;
mod section;
mod slices;
mod solid;

pub use cell::{CORNERS, PATHS, TETRAHEDRA, triangles};
pub use columns::{MAX_PIECES, Piece};
pub use grid::{Grid, MAX_CELLS};
pub use section::{out_of_plane, reference_position};
pub use slices::Slices;
pub use solid::solid_position;
