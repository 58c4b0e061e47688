//! A simulation of the study's mesh in RAM that the linker sets aside.

use core::mem::MaybeUninit;

use cortex_m::singleton;
use softanvil_kernel::element::{CellConstants, CellHistory, HoopConstants};
use softanvil_kernel::number::real::Real;
use softanvil_kernel::tensor::deviator::Deviator;
use softanvil_kernel::{Constants, Model, ModelMemory, Scalars, Scenario, State, StateMemory};

/// The study's mesh: nodes with padding, nodes of the surface, blocks of cells, viscous terms. `Size::of` tells what a
/// scenario needs; too little is an error that names the numbers.
const NODES: usize = 6 * 32;
const SURFACE: usize = 32;
const BLOCKS: usize = 5 * 3;
const TERMS: usize = 2;

/// Arrays that live as long as the program; filled in place, not by way of the stack.
macro_rules! array {
    ($count:expr, $type:ty, $start:expr) => {{
        let place = singleton!(: [MaybeUninit<$type>; $count] = [const { MaybeUninit::uninit() }; $count]).unwrap();
        place.iter_mut().for_each(|item| _ = item.write($start));
        // SAFETY: every item was written.
        unsafe { place.assume_init_mut() }
    }};
}

/// The model of `scenario` and its state at the start. There is memory for one simulation: a second call panics.
pub fn build(scenario: &Scenario) -> (Model<'static>, State<'static>) {
    let model_memory = ModelMemory {
        constants: singleton!(: Option<Constants> = None).unwrap(),
        nodes: array!(5 * NODES, Real, 0.0),
        cells: array!(BLOCKS, CellConstants, CellConstants::ZERO),
        hoops: array!(0, HoopConstants, HoopConstants::ZERO),
    };
    let mut state_memory = StateMemory {
        scalars: singleton!(: Scalars = Scalars::BLANK).unwrap(),
        nodes: array!(6 * NODES + 2 * SURFACE, Real, 0.0),
        cells: array!(BLOCKS, CellHistory, CellHistory::REST),
        viscous: array!(2 * TERMS * BLOCKS, Deviator, Deviator::ZERO),
    };
    let model = Model::new(scenario, model_memory, &mut state_memory).unwrap();
    let state = State::new(&model, state_memory).unwrap();
    (model, state)
}
