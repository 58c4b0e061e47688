//! What the verification problems share: the tolerances, a driver for one element, and scenarios.
//!
//! A problem is computed in [`problems`], judged in a file of `tests/`, and reported in the [`table`], to which it adds its [`row`]s.

pub mod agreement;
pub mod band;
pub mod bearing;
pub mod body;
pub mod deformation;
pub mod element;
pub mod memo;
pub mod momentum;
pub mod order;
pub mod penetration;
pub mod plausible;
pub mod problems;
pub mod relaxation;
pub mod row;
pub mod scenes;
pub mod solid;
pub mod solid_body;
pub mod solid_statics;
pub mod statics;
pub mod table;
pub mod tolerance;
