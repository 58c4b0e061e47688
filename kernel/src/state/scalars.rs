//! The numbers of a state that are not arrays.

use crate::error::StepError;
use crate::impactor::ImpactorState;
use crate::model::Model;
use crate::number::real::Real;
use crate::state::{EnergyBalance, Forces, Metrics, Sampler};

/// The numbers of a state that are not arrays.
///
/// ```
/// use softanvil_kernel::{Simulation, StepInput, preset};
///
/// let mut anvil = Simulation::new(&preset::study())?;
/// anvil.run(15e-3, &StepInput::default())?;
/// let scalars = anvil.scalars();
/// assert!(scalars.contact_has_ended());
/// assert!(scalars.impactor.velocity > 0.0 && scalars.metrics.restitution() < 1.0);
/// // The books close: what came in is where the balance says.
/// assert!(scalars.energy.residual().abs() < 1e-3 * scalars.energy.external);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scalars {
    /// Steps completed.
    pub step_index: u64,
    /// Motion of the impactor.
    pub impactor: ImpactorState,
    /// Forces of the last step.
    pub force: Forces,
    /// Half of the width over which the face touches the surface, m.
    pub contact_half_width: Real,
    /// Force samples at [`crate::SAMPLING_INTERVAL`].
    pub sampler: Sampler,
    /// Numbers of the test so far.
    pub metrics: Metrics,
    /// Energies of the last step.
    pub energy: EnergyBalance,
    /// Why no further step can be made.
    pub failure: Option<StepError>,
}

impl Scalars {
    /// Of no state yet, for memory that is to be lent to one.
    pub const BLANK: Self = Self {
        step_index: 0,
        impactor: ImpactorState::BLANK,
        force: Forces { contact: 0.0, core_reaction: 0.0 },
        contact_half_width: 0.0,
        sampler: Sampler::START,
        metrics: Metrics::START,
        energy: EnergyBalance::ZERO,
        failure: None,
    };

    /// Whether the face has touched the layer and been clear of it since the last complete sampling interval began.
    pub fn contact_has_ended(&self) -> bool {
        let forces = [self.sampler.last.contact_force, self.sampler.sum.contact, self.force.contact];
        self.metrics.has_touched() && forces.iter().all(|force| *force <= 0.0)
    }

    /// The start of the drop.
    pub(crate) fn start(model: &Model) -> Self {
        Self { impactor: ImpactorState::start(model), energy: EnergyBalance::start(model), ..Self::BLANK }
    }
}
