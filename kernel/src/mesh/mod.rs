//! The structured mesh of the section, or of a solid.

mod cell;
mod columns;
mod grid;
mod paths;
mod section;
mod slices;
mod solid;

pub use cell::{CORNERS, triangles};
pub use columns::{MAX_PIECES, Piece};
pub use grid::{Grid, MAX_CELLS};
pub use paths::{PATHS, TETRAHEDRA};
pub use section::{out_of_plane, reference_position};
pub use slices::Slices;
pub(crate) use solid::cell_nodes;
pub use solid::{solid_position, tetrahedra};
