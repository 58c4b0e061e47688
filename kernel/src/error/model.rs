//! Models that cannot be built.

use core::fmt;

use super::memory::MemoryError;
use super::scenario::ScenarioError;
use crate::number::decimal::Decimal;
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
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ModelError {
    /// The scenario is refused.
    Scenario(ScenarioError),
    /// The mesh would have too many cells.
    TooManyCells {
        /// Cells that the element size asks for.
        cells: Real,
        /// Most cells of a mesh.
        max: usize,
    },
    /// The stable step is below the smallest divisor of the sampling interval that is offered.
    StepTooSmall {
        /// Stable step, s.
        step: Real,
        /// Smallest step, s.
        smallest: Real,
    },
    /// The given step is above the stability limit at rest.
    StepTooLarge {
        /// Given step, s.
        step: Real,
        /// Stability limit, s.
        limit: Real,
    },
    /// A triangle without area, or with its corners in the wrong order.
    NoArea {
        /// Index of the triangle.
        element: u32,
    },
    /// There is too little memory.
    Memory(MemoryError),
}

impl From<ScenarioError> for ModelError {
    fn from(error: ScenarioError) -> Self {
        Self::Scenario(error)
    }
}

impl From<MemoryError> for ModelError {
    fn from(error: MemoryError) -> Self {
        Self::Memory(error)
    }
}

impl fmt::Display for ModelError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Scenario(error) => error.fmt(f),
            Self::TooManyCells { cells, max } => write!(
                f,
                "mesh.element_size asks for {} cells: legal is 1 to {} (choose a larger size, in m)",
                Decimal(*cells),
                max
            ),
            Self::StepTooSmall { step, smallest } => {
                let (step, smallest) = (Decimal(*step), Decimal(*smallest));
                write!(f, "the stable time step is {step} s: legal is at least {smallest} s (softer or coarser)")
            }
            Self::StepTooLarge { step, limit } => {
                let (step, limit) = (Decimal(*step), Decimal(*limit));
                write!(f, "time.step = {step} s is refused: legal is above 0 s and up to {limit} s at rest")
            }
            Self::NoArea { element } => {
                write!(f, "element {element} has no area: legal are corners in counter-clockwise order")
            }
            Self::Memory(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for ModelError {}
