//! Every instruction set of this processor gives the same bits, in one process.

use softanvil_kernel::material::{Material, VolumetricLaw};
use softanvil_kernel::scenario::Formulation;
use softanvil_kernel::state::state_digest;
use softanvil_kernel::step::critical_time_step_with;
use softanvil_kernel::{InstructionSet, Scenario, Simulation, StepInput, preset, step_with};
use softanvil_verification::scenes::ogden;

/// Digest of the whole state after a drop, and the limit of the step with the element that sets it.
fn outcome(scenario: &Scenario, set: InstructionSet) -> (u64, (u64, u32)) {
    let mut simulation = Simulation::new(scenario).expect("a legal scenario");
    let steps = simulation.constants().steps_in(scenario.time.duration);
    simulation
        .with(|model, state| {
            for _ in 0..steps {
                step_with(set, model, state, &StepInput::default()).expect("a stable run");
            }
            let (limit, element) = critical_time_step_with(set, model, state);
            (state_digest(model, state), (limit.to_bits(), element))
        })
        .expect("memory of the right size")
}

#[test]
fn give_the_same_bits() {
    let mut rings = preset::study();
    rings.geometry.formulation = Formulation::Axisymmetric;
    rings.add_layer(preset::chamois()).expect("room");
    rings.time.duration = 6e-3;
    let mut powers = rings.clone();
    powers.layers[0].material =
        Material { volumetric_law: VolumetricLaw::Simo, ..ogden(2e6, [0.3e6, 2e3, -0.02e6], [1.3, 5.0, -2.0]) };
    powers.set_layer_count(1);
    powers.time.duration = 4e-3;
    for scenario in [preset::study(), rings, powers] {
        let baseline = outcome(&scenario, InstructionSet::Baseline);
        for set in InstructionSet::ALL.into_iter().filter(|set| set.available()) {
            assert_eq!(outcome(&scenario, set), baseline, "{set:?}");
        }
    }
}
