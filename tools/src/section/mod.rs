//! The section as it deforms: recorded from a simulation, as a series for ParaView, and as pictures.

mod contour;
pub mod film;
mod frame;
mod levels;
mod mesh;
pub mod paraview;
pub mod picture;
mod vtu;

pub use contour::nodal_means;
pub use film::{Film, Moment, SHADES, Shade};
pub use frame::Frame;
pub use levels::Levels;
pub use mesh::Mesh;
