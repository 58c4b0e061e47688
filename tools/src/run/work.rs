//! What a drop takes, known beforehand.

use softanvil_kernel::sampling::SMALLEST_STEP;
use softanvil_kernel::scenario::{Motion, StepBy};
use softanvil_kernel::step::critical_time_step;
use softanvil_kernel::{ModelError, Scenario, Simulation};

use super::RunError;

/// Updates of elements that the drop of `scenario` takes at least, by the step that is stable at rest: a compressed layer takes a smaller
/// one, a soft foam's less than half. The trial that chooses the step takes a good part of a drop's time, and is not made.
///
/// ```
/// use softanvil_kernel::preset;
/// use softanvil_tools::run::{Drop, element_updates};
///
/// let drop = Drop::new(&preset::study())?;
/// let updates = (drop.steps() * drop.elements() as u64) as f64;
/// let expected = element_updates(&preset::study())? as f64;
/// assert!((0.4..1.0).contains(&(expected / updates)), "{expected} of {updates}");
/// # Ok::<(), softanvil_tools::run::RunError>(())
/// ```
///
/// # Errors
/// As [`super::Drop::new`], but for a step that turns out too small to offer: that gives 0 or what it would take.
pub fn element_updates(scenario: &Scenario) -> Result<u64, RunError> {
    if scenario.impactor.motion == Motion::Driven {
        return Err(RunError::Driven);
    }
    let time = &scenario.time;
    if time.step_by == StepBy::Given {
        let simulation = Simulation::new(scenario)?;
        return Ok(updates(&simulation, time.duration / simulation.constants().dt));
    }
    let mut untried = scenario.clone();
    (untried.time.step_by, untried.time.step) = (StepBy::Given, SMALLEST_STEP);
    let mut simulation = match Simulation::new(&untried) {
        Err(ModelError::StepTooLarge { .. }) => return Ok(0),
        simulation => simulation?,
    };
    let at_rest = simulation.with(|model, state| critical_time_step(model, state).0);
    let step = time.safety_factor * at_rest.unwrap_or(SMALLEST_STEP);
    Ok(updates(&simulation, time.duration / step))
}

fn updates(simulation: &Simulation, steps: f64) -> u64 {
    (simulation.constants().grid.n_elem() as f64 * steps) as u64
}

#[cfg(test)]
mod tests {
    use softanvil_kernel::material::VolumetricBy;
    use softanvil_kernel::preset;

    use super::*;

    #[test]
    fn a_step_that_is_too_small_at_rest_is_no_error_of_the_given_one() {
        let mut scenario = preset::study();
        scenario.mesh.element_size = 1e-3;
        let material = &mut scenario.layers[0].material;
        (material.volumetric_by, material.bulk_modulus, material.density) = (VolumetricBy::BulkModulus, 1e12, 10.0);
        let few = element_updates(&scenario).unwrap();
        assert!(few > element_updates(&preset::study()).unwrap());
        scenario.mesh.element_size = 2e-5;
        scenario.geometry.core_radius = 1e-3;
        scenario.layers[0].thickness = 2e-5;
        scenario.impactor.face_diameter = 1e-3;
        assert_eq!(element_updates(&scenario).unwrap(), 0, "{:?}", Simulation::new(&scenario).err());
    }
}
