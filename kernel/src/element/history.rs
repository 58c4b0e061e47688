//! What the triangles of a block of cells remember.

use crate::number::pack::{LANES, Pack, ZERO};
use crate::tensor::deviator::Deviator;

/// What the triangles of a block of cells remember.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CellHistory {
    /// First and second triangle of each cell.
    pub triangle: [TriangleHistory; 2],
}

/// What one triangle of each cell of a block remembers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangleHistory {
    /// Right stretch of the last step: mean, half difference, shear, hoop (see [`crate::tensor::kinematics::Kinematics`]).
    pub stretch_prev: [Pack; 4],
    /// Long-term isochoric stress of the last step, Pa, before any tear.
    pub elastic_prev: Deviator,
    /// Stress of the damping spring, Pa, before any tear.
    pub slider_stress: Deviator,
    /// Largest principal stretch so far, where the material can tear; 1 otherwise.
    pub largest_stretch: Pack,
    /// Isochoric and spring energy of the last step before any tear, J/m3, where the material can tear; 0 otherwise.
    pub stored_prev: Pack,
}

impl CellHistory {
    /// At rest: unit stretch, no stress.
    pub const REST: Self = Self { triangle: [TriangleHistory::REST; 2] };
}

impl TriangleHistory {
    /// At rest.
    pub const REST: Self = Self {
        stretch_prev: [ONE, ZERO, ZERO, ONE],
        elastic_prev: Deviator::ZERO,
        slider_stress: Deviator::ZERO,
        largest_stretch: ONE,
        stored_prev: ZERO,
    };
}

const ONE: Pack = [1.0; LANES];
