//! Steps that cannot be completed.

use thiserror::Error;

use super::memory::MemoryError;
use super::parameter::ParameterError;
use crate::number::decimal::Decimal;
use crate::number::math;
use crate::number::real::Real;
use crate::sampling::SAMPLING_INTERVAL;

/// Why a step could not be completed. But for an input or a memory that is refused, the state stays as the failing step
/// left it, and every further step gives the same error until the state is reset or restored.
///
/// ```
/// use softanvil_kernel::scenario::Motion;
/// use softanvil_kernel::{Simulation, StepError, StepInput, preset};
///
/// let mut scenario = preset::study();
/// scenario.impactor.motion = Motion::Driven;
/// let mut anvil = Simulation::new(&scenario)?;
///
/// // Refused before anything happens: a face a kilometre below the anvil.
/// let far = StepInput { driven_position: Some(-1e3), ..StepInput::default() };
/// assert!(matches!(anvil.run(1e-3, &far), Err(StepError::Input { .. })));
/// assert_eq!(anvil.time(), 0.0);
///
/// // Fails on its way through the core, and from then on.
/// let through = StepInput { driven_position: Some(-0.05), ..StepInput::default() };
/// let failure = anvil.run(1e-3, &through).unwrap_err();
/// assert!(matches!(failure, StepError::Unstable { .. } | StepError::Inverted { .. }));
/// assert_eq!(anvil.step(1, &StepInput::default()), Err(failure));
/// anvil.reset()?;
/// anvil.step(1, &StepInput::default())?;
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum StepError {
    /// A triangle turned inside out, or its shape is not finite.
    #[error(
        "element {element} is inverted or not finite at {} s: a layer is pressed further than its law and its mesh can follow (less \
         energy, a thicker or stiffer layer, damping, or a smaller time.safety_factor may do)",
        Decimal(*time)
    )]
    Inverted {
        /// Index of the triangle.
        element: u32,
        /// Simulated time, s.
        time: Real,
    },
    /// The step exceeds the current stability limit of a triangle.
    #[error(
        "the time step of {} s is above the stability limit {} s of element {element} at {} s: {} s would do there \
         (time.step_by = given with time.step, or for a driven face a larger time.design_compression)",
        Decimal(*step),
        Decimal(*limit),
        Decimal(*time),
        Decimal(enough(*limit))
    )]
    Unstable {
        /// Index of the triangle.
        element: u32,
        /// Simulated time, s.
        time: Real,
        /// Stability limit there, s.
        limit: Real,
        /// The fixed step, s.
        step: Real,
    },
    /// An input is not legal. No step is made, and the state is as before.
    #[error("{error} (input at {} s)", Decimal(*time))]
    Input {
        /// The input, its refused value and what is legal.
        error: ParameterError,
        /// Simulated time, s.
        time: Real,
    },
    /// There is too little memory for the state. No step is made.
    #[error(transparent)]
    Memory(#[from] MemoryError),
}

/// The largest step that is a whole divisor of the sampling interval and at least a tenth below `limit`, s.
fn enough(limit: Real) -> Real {
    SAMPLING_INTERVAL / math::ceil(SAMPLING_INTERVAL / (0.9 * limit))
}
