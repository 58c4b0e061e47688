//! A whole life of a simulation in lent memory, and nothing else: what the linker keeps of the kernel for it is the code
//! size that `run.sh` reports.

#![no_std]

use core::panic::PanicInfo;

use softanvil_kernel::state::{restore, save};
use softanvil_kernel::{Model, ModelMemory, Scenario, Size, State, StateMemory, StepInput, preset, step};

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    loop {}
}

/// The study's scenario, and what it needs.
#[unsafe(no_mangle)]
pub fn prepare(energy: f64) -> Option<(Scenario, Size)> {
    let mut scenario = preset::study();
    scenario.impactor = scenario.impactor.with_energy(energy);
    let size = Size::of(&scenario).ok()?;
    Some((scenario, size))
}

/// Steps, saves and restores.
#[unsafe(no_mangle)]
pub fn simulate(
    scenario: &Scenario,
    model: ModelMemory,
    mut state: StateMemory,
    input: &StepInput,
    steps: u64,
    snapshot: &mut [u8],
) -> Option<f64> {
    let model = Model::new(scenario, model, &mut state).ok()?;
    let mut state = State::new(&model, state).ok()?;
    for _ in 0..steps {
        step(&model, &mut state, input).ok()?;
    }
    save(&model, &state, snapshot).ok()?;
    restore(&model, &mut state, snapshot).ok()?;
    Some(state.scalars.metrics.peak_force)
}
