//! Speed of the study's drop with every instruction set of this processor, and a check that all give the same trace.
//!
//!     cargo run --release -p softanvil-verification --example speed
//!
//! The figure per update is the fastest slice of a sample's steps: what other programs on the machine leave out of it.

use std::time::Instant;

use softanvil_kernel::{InstructionSet, Simulation, StepInput, preset, step_with};

/// Drops per instruction set.
const DROPS: usize = 20;

fn main() {
    let scenario = preset::study();
    let mut simulation = Simulation::new(&scenario).expect("the preset is legal");
    let constants = *simulation.constants();
    let (per_sample, elements) = (constants.steps_per_sample, constants.grid.n_elem() as f64);
    let samples = constants.steps_in(scenario.time.duration) / u64::from(per_sample);
    println!("{elements} triangles, {per_sample} steps per sample, {} ms simulated", 1e3 * scenario.time.duration);
    let mut expected = None;
    for set in InstructionSet::ALL.into_iter().filter(|set| set.available()) {
        let (mut slice, mut drop) = (f64::INFINITY, f64::INFINITY);
        for _ in 0..DROPS {
            simulation.reset();
            let start = Instant::now();
            for _ in 0..samples {
                let start = Instant::now();
                simulation
                    .with(|model, state| {
                        (0..per_sample).try_for_each(|_| step_with(set, model, state, &StepInput::default()))
                    })
                    .expect("memory of the right size")
                    .expect("a stable run");
                slice = slice.min(start.elapsed().as_secs_f64());
            }
            drop = drop.min(start.elapsed().as_secs_f64());
        }
        let hash = simulation.scalars().sampler.trace_hash;
        assert_eq!(*expected.get_or_insert(hash), hash, "{set:?} gives another trace");
        let update = 1e9 * slice / (f64::from(per_sample) * elements);
        println!(
            "{set:?}: {update:.1} ns per update at best, {:.1} ms per drop at best, trace {hash:016x}",
            1e3 * drop
        );
    }
}
