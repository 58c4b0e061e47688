//! What a drop takes, known beforehand.

use softanvil_kernel::sampling::SMALLEST_STEP;
use softanvil_kernel::scenario::{Motion, StepBy};
use softanvil_kernel::step::critical_time_step;
use softanvil_kernel::{Scenario, Simulation};

use super::RunError;

/// Updates of elements that the drop of `scenario` takes, about: as many steps as are stable at rest. The trial that chooses its step
/// takes a good part of a drop's time, and is not made.
///
/// ```
/// use softanvil_kernel::preset;
/// use softanvil_tools::run::{Drop, work};
///
/// let drop = Drop::new(&preset::study())?;
/// let updates = drop.steps() * drop.elements() as u64;
/// let expected = work(&preset::study())?;
/// assert!(updates / 3 < expected && expected < updates);
/// # Ok::<(), softanvil_tools::run::RunError>(())
/// ```
///
/// # Errors
/// As [`super::Drop::new`], but for a step that turns out too small to offer.
pub fn work(scenario: &Scenario) -> Result<u64, RunError> {
    if scenario.impactor.motion == Motion::Driven {
        return Err(RunError::Driven);
    }
    let chosen = scenario.time.step_by == StepBy::SafetyFactor;
    let mut untried = scenario.clone();
    if chosen {
        (untried.time.step_by, untried.time.step) = (StepBy::Given, SMALLEST_STEP);
    }
    let mut simulation = Simulation::new(&untried)?;
    let elements = simulation.constants().grid.n_elem() as f64;
    let given = simulation.constants().dt;
    let step = if chosen {
        simulation.with(|model, state| critical_time_step(model, state).0).unwrap_or(given)
    } else {
        given
    };
    Ok((elements * scenario.time.duration / step) as u64)
}
