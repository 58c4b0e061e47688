//! The kernel itself.

use softanvil_kernel::{InstructionSet, Scenario, Simulation, StepInput, step_with};

use super::Host;

/// An owned simulation, stepped with one instruction set.
pub struct Kernel {
    simulation: Simulation,
    set: InstructionSet,
}

impl Kernel {
    /// A simulation of `scenario`.
    ///
    /// # Panics
    /// If the kernel refuses it.
    pub fn new(scenario: &Scenario, set: InstructionSet) -> Self {
        Self { simulation: Simulation::new(scenario).expect("a legal scenario"), set }
    }

    /// The simulation.
    pub fn simulation(&mut self) -> &mut Simulation {
        &mut self.simulation
    }
}

impl Host for Kernel {
    fn restart(&mut self) {
        self.simulation.reset().expect("memory of the right size");
    }

    fn advance(&mut self, calls: u64, steps: u64) {
        let input = StepInput::default();
        let set = self.set;
        for _ in 0..calls {
            let made =
                self.simulation.with(|model, state| (0..steps).try_for_each(|_| step_with(set, model, state, &input)));
            made.expect("memory of the right size").expect("a stable run");
        }
    }

    fn steps_of_drop(&self) -> u64 {
        let constants = self.simulation.constants();
        constants.steps_in(constants.scenario.time.duration)
    }

    fn trace_hash(&mut self) -> u64 {
        self.simulation.scalars().sampler.trace_hash
    }
}
