//! What an impact measures: simulated, or read from a file of instruments.

pub mod band;
pub mod contact;
pub mod curve_score;
pub mod errors;
pub mod measured;
pub mod quantity;
pub mod reading;
pub mod series;
