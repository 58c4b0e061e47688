//! The scalar constants of a model.

use crate::cfc::Coefficients;
use crate::features::PADS;
use crate::material::MaterialModel;
use crate::mesh::Grid;
use crate::model::Size;
use crate::number::math;
use crate::number::real::{self, Real};
use crate::sampling::SAMPLING_RATE;
use crate::scenario::{MAX_LAYERS, Outline, Scenario};

/// The scalar constants of a model.
///
/// ```
/// use softanvil_kernel::{Simulation, preset};
///
/// let anvil = Simulation::new(&preset::study())?;
/// let constants = anvil.constants();
/// // A millisecond has twenty sampling intervals of 50 us, each a whole number of steps.
/// let steps = constants.steps_in(1e-3);
/// assert_eq!(steps, 20 * u64::from(constants.steps_per_sample));
/// assert_eq!(constants.time(steps), 1e-3);
/// assert!((steps as f64 * constants.dt - 1e-3).abs() < 1e-15);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Constants {
    /// The scenario that the model was built from.
    pub scenario: Scenario,
    /// Counts and strides of the mesh.
    pub grid: Grid,
    /// Sizes of the memory of model and state.
    pub size: Size,
    /// Fixed time step, s.
    pub dt: Real,
    /// Smallest principal stretch in the section that the step was chosen for; 1 where the step was given.
    pub design_stretch: Real,
    /// Steps in a sampling interval; `dt` times it is [`crate::SAMPLING_INTERVAL`].
    pub steps_per_sample: u32,
    /// Packs that each tetrahedron of a solid remembers.
    pub(crate) solid_history_packs: usize,
    /// Channel filter of the contact force.
    pub channel: Coefficients,
    /// Material models of the layers from the core to the surface; behind them that of the last again.
    pub laws: [MaterialModel; MAX_LAYERS],
    /// Forces of the whole anvil per force of the meshed section: 2 in plane strain, which meshes one half.
    pub symmetry_factor: Real,
    /// The face of the impactor in the section.
    pub outline: Outline,
    /// Height of the undeformed anvil's top above the origin, m.
    pub top_height: Real,
    /// Fingerprint of the scenario and of the positions of the nodes at rest, which a snapshot must match.
    pub fingerprint: u64,
}

impl Constants {
    /// Goes over to steps of `dt` s, `steps_per_sample` of them in a sampling interval.
    pub(crate) fn set_step(&mut self, dt: Real, steps_per_sample: u32) {
        (self.dt, self.steps_per_sample) = (dt, steps_per_sample);
        for (place, laws) in self.laws.iter_mut().enumerate() {
            if let Some(layer) = self.scenario.layers.get(place).or(self.scenario.layers.last()) {
                *laws = MaterialModel::new(&layer.material, dt);
            }
        }
    }

    /// Mass of the impactor that belongs to the meshed section, kg.
    pub fn section_mass(&self) -> Real {
        self.scenario.impactor.mass / self.symmetry_factor
    }

    /// Whether the nodes that the face may meet are not one row under a flat face without edges.
    pub(crate) fn has_uneven_contact(&self) -> bool {
        PADS && (self.outline.radius > 0.0 || !self.grid.has_even_surface())
    }

    /// Mass that a force on a falling impactor moves within a step, kg: with the damping of its rails, which takes the velocity
    /// at the end of it.
    pub(crate) fn moved_mass(&self) -> Real {
        let impactor = &self.scenario.impactor;
        impactor.mass + self.dt * impactor.rail_damping
    }

    /// Material model of a block of cells.
    pub fn laws_of(&self, block: usize) -> &MaterialModel {
        let [first, second, third, fourth] = &self.laws;
        match self.grid.layer_of_block(block) {
            0 => first,
            1 => second,
            2 => third,
            _ => fourth,
        }
    }

    /// Material model of the layer of a row of cells.
    pub(crate) fn laws_of_row(&self, row: usize) -> &MaterialModel {
        let [first, second, third, fourth] = &self.laws;
        match self.grid.layer_of_row(row) {
            0 => first,
            1 => second,
            2 => third,
            _ => fourth,
        }
    }

    /// Whether any layer softens.
    pub fn softens(&self) -> bool {
        self.laws.iter().any(|laws| laws.softening.active())
    }

    /// Whether any layer has a compressible law.
    pub fn has_foam(&self) -> bool {
        self.laws.iter().any(|laws| laws.elastic.is_compressible())
    }

    /// Entries of viscous history per triangle: those of the layer that has more.
    pub fn n_history_entry(&self) -> usize {
        self.laws.iter().fold(0, |most, laws| most.max(laws.n_history_entry()))
    }

    /// Simulated time after `step_index` steps, s: whole sampling intervals and the steps beyond them.
    pub fn time(&self, step_index: u64) -> Real {
        let per_sample = u64::from(self.steps_per_sample).max(1);
        // Signed, since processors turn only signed integers into floats at once.
        let (samples, steps) = ((step_index / per_sample) as i64, (step_index % per_sample) as i64);
        // A quotient, so that the time of a sample is the double nearest to it.
        samples as Real / SAMPLING_RATE + steps as Real * self.dt
    }

    /// Steps that cover `duration` s, rounded up to whole sampling intervals.
    pub fn steps_in(&self, duration: Real) -> u64 {
        // The rate is a whole number, the interval is rounded.
        let samples = duration * SAMPLING_RATE;
        let nearest = math::round(samples);
        // A duration within rounding of a whole number of samples counts as that number.
        let is_whole = math::abs(samples - nearest) <= real::SAME_DURATION * samples;
        let samples = if is_whole { nearest } else { math::ceil(samples) };
        samples as u64 * u64::from(self.steps_per_sample)
    }
}
