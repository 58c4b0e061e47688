//! States of a specimen.

/// A measured state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Line of the file, from 1.
    pub line: usize,
    /// Load cycle, if a column tells.
    pub cycle: Option<f64>,
    /// Stretch of the loaded direction.
    pub stretch: f64,
    /// Nominal stress, Pa: force over original cross-section.
    pub stress: f64,
}

/// One specimen, in the order of the file.
#[derive(Clone, Debug)]
pub struct Repeat {
    /// Name of the specimen; empty if the file has one only.
    pub name: String,
    /// Its states.
    pub points: Vec<Point>,
}
