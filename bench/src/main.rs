//! The study's drop, for instruments that watch a program from outside (`instructions.sh`).
//!
//!     softanvil-bench INSTRUCTION_SET [STEPS]
//!
//! STEPS are the first of the drop alone, for instruments that are slow.

use std::hint::black_box;
use std::process::ExitCode;

use softanvil_kernel::{InstructionSet, Model, Simulation, State, StepInput, preset, step_with};

fn main() -> ExitCode {
    let given = std::env::args().nth(1).unwrap_or_default();
    let set = InstructionSet::ALL.into_iter().find(|set| format!("{set:?}") == given);
    let Some(set) = set.filter(|set| set.available()) else {
        eprintln!("'{given}' is refused: one of {:?} that this processor has", InstructionSet::ALL);
        return ExitCode::FAILURE;
    };
    let scenario = preset::study();
    let mut simulation = Simulation::new(&scenario).expect("a legal scenario");
    let drop = simulation.constants().steps_in(scenario.time.duration);
    let steps = std::env::args().nth(2).and_then(|steps| steps.parse().ok()).unwrap_or(drop);
    let work = simulation.with(|model, state| (0..steps).for_each(|_| measured_step(set, model, state)));
    work.expect("memory of the right size");
    println!("{} {steps} {:016x}", simulation.constants().grid.n_elem(), simulation.scalars().sampler.trace_hash);
    ExitCode::SUCCESS
}

/// One step, under a name that an instrument can find.
#[inline(never)]
#[unsafe(no_mangle)]
fn measured_step(set: InstructionSet, model: &Model, state: &mut State) {
    black_box(step_with(set, model, state, &StepInput::default())).expect("a stable run");
}
