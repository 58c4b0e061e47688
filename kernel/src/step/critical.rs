//! What a search for the smallest limit finds.

use crate::number::real::Real;

/// The cell with the smallest limit.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Critical {
    /// Square of its largest stable step, s2.
    pub limit_squared: Real,
    /// Its first triangle.
    pub element: u32,
    /// The smallest principal stretch of its triangles in the section.
    pub stretch: Real,
}
