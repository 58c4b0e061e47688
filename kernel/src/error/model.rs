//! Models that cannot be built.

use core::fmt;

use thiserror::Error;

use super::memory::MemoryError;
use super::scenario::ScenarioError;
use crate::number::decimal::Decimal;
use crate::number::math;
use crate::number::real::Real;

/// Why a model or a state could not be built.
///
/// ```
/// use softanvil_kernel::scenario::StepBy;
/// use softanvil_kernel::{ModelError, Simulation, preset};
///
/// let mut scenario = preset::study();
/// (scenario.time.step_by, scenario.time.step) = (StepBy::Given, 5e-5);
/// let Some(ModelError::StepTooLarge { step, limit }) = Simulation::new(&scenario).err() else { panic!("too large") };
/// assert!(step == 5e-5 && limit < step);
/// scenario.time.step = 0.5 * limit;
/// assert!(Simulation::new(&scenario).is_ok());
/// ```
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum ModelError {
    /// The scenario is refused.
    #[error(transparent)]
    Scenario(#[from] ScenarioError),
    /// The mesh would have too many cells.
    #[error("mesh.element_size asks for {} cells: expected 1 to {max} (choose a larger size, in m)", Decimal(*cells))]
    TooManyCells {
        /// Cells that the element size asks for.
        cells: Real,
        /// Most cells of a mesh.
        max: usize,
    },
    /// The stable step is below the smallest divisor of the sampling interval that is offered.
    #[error("the stable time step is {} s{}: expected at least {} s", Decimal(*step), Pressed(*stretch), Decimal(*smallest))]
    StepTooSmall {
        /// Stable step, s.
        step: Real,
        /// Smallest step, s.
        smallest: Real,
        /// Smallest principal stretch of the cell that limits the step, 1 at rest.
        stretch: Real,
    },
    /// The given step is above the stability limit at rest.
    #[error("time.step = {} s is refused: expected above 0 s and up to {} s at rest", Decimal(*step), Decimal(*limit))]
    StepTooLarge {
        /// Given step, s.
        step: Real,
        /// Stability limit, s.
        limit: Real,
    },
    /// A triangle without area, or with its corners in the wrong order.
    #[error("element {element} has no area: expected corners in counter-clockwise order")]
    NoArea {
        /// Index of the triangle.
        element: u32,
    },
    /// A tetrahedron without volume, or with its corners in the wrong order.
    #[error("element {element} has no volume: expected columns to the right, rows upwards and slices along z")]
    NoVolume {
        /// Index of the tetrahedron.
        element: u32,
    },
    /// There is too little memory.
    #[error(transparent)]
    Memory(#[from] MemoryError),
}

/// Where a step is too small, and what helps: a cell that is pressed to this stretch, or one at rest.
struct Pressed(Real);

impl fmt::Display for Pressed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0 >= 1.0 {
            return f.write_str(" at rest (larger cells or a softer layer allow more)");
        }
        if self.0 <= 0.0 {
            return f.write_str(
                " with a cell turned inside out: a layer does not bear this (less energy or depth, or a thicker or stiffer layer)",
            );
        }
        let percent = Decimal(math::ceil(1e3 * self.0) / 10.0);
        write!(
            f,
            " with a cell pressed to {percent} % of its size (less energy or depth, or a thicker or stiffer layer, allows more)"
        )
    }
}
