//! The block of memory that holds a simulation: its header, then the arrays of model and state.
//!
//! The block holds no address, so it may be copied or moved between calls.

use softanvil_kernel::element::{CellConstants, CellHistory, HoopConstants};
use softanvil_kernel::tensor::deviator::Deviator;
use softanvil_kernel::{
    Constants, Model, ModelMemory, Scalars, Scenario, Size, State, StateContent, StateMemory, StateView,
};

use crate::c_api::failure::Failure;
use crate::c_api::header::SoftanvilSimulation;
use crate::c_api::ptr::{Out, Region, SharedRegion, padded};

/// The arrays behind the header.
struct Arrays<'a> {
    nodes: &'a mut [f64],
    cells: &'a mut [CellConstants],
    hoops: &'a mut [HoopConstants],
    state: StateMemory<'a>,
}

impl<'a> Arrays<'a> {
    #[inline(always)]
    fn cut(size: &Size, scalars: &'a mut Scalars, region: &mut Region<'a>) -> Option<Self> {
        Some(Self {
            nodes: region.take(size.model_nodes)?,
            cells: region.take(size.model_cells)?,
            hoops: region.take(size.model_hoops)?,
            state: StateMemory {
                scalars,
                nodes: region.take(size.state_nodes)?,
                cells: region.take(size.state_cells)?,
                viscous: region.take(size.state_viscous)?,
            },
        })
    }
}

/// Length of the block of a simulation, bytes; the largest number if no address space could hold it.
pub(crate) fn bytes(size: &Size) -> usize {
    let parts = [
        padded::<SoftanvilSimulation>(1),
        padded::<f64>(size.model_nodes),
        padded::<CellConstants>(size.model_cells),
        padded::<HoopConstants>(size.model_hoops),
        padded::<f64>(size.state_nodes),
        padded::<CellHistory>(size.state_cells),
        padded::<Deviator>(size.state_viscous),
    ];
    parts.into_iter().fold(0, |sum: usize, part| sum.saturating_add(part.unwrap_or(usize::MAX)))
}

/// Builds a simulation of `scenario` at the start of its drop in zeroed memory of [`bytes`], and gives its address. Apart, so that
/// the constants are on the stack only when the scenario has been read.
#[inline(never)]
pub(crate) fn build(scenario: &Scenario, size: &Size, mut region: Region) -> Result<*mut SoftanvilSimulation, Failure> {
    let short = Failure::Short { argument: "memory", given: 0, needed: bytes(size) };
    let slot = region.slot::<SoftanvilSimulation>().ok_or(short)?;
    // Numbers that wait for their place in the header, and the region for no longer than they live.
    let (mut scalars, mut region) = (Scalars::BLANK, region);
    let Arrays { nodes, cells, hoops, state } = Arrays::cut(size, &mut scalars, &mut region).ok_or(short)?;
    let mut constants = None;
    let mut state = state;
    let model = Model::new(scenario, ModelMemory { constants: &mut constants, nodes, cells, hoops }, &mut state)?;
    State::new(&model, state)?;
    place(slot, bytes(size), &mut constants, &scalars).ok_or(short)
}

/// Writes the header and gives its address; none without constants. Apart, so that another copy of them is on the stack only when
/// the trial has left it.
#[inline(never)]
fn place(
    slot: Out<SoftanvilSimulation>,
    bytes: usize,
    constants: &mut Option<Constants>,
    scalars: &Scalars,
) -> Option<*mut SoftanvilSimulation> {
    let (marker, constants, scalars) = (SoftanvilSimulation::MARKER, constants.take()?, *scalars);
    Some(slot.place(SoftanvilSimulation { marker, bytes, constants, scalars }))
}

/// Does `work` on the model and the state of a simulation.
// Inlined with what it calls, the arrays are found once and written nowhere but into model and state.
#[inline(always)]
pub(crate) fn with<R>(
    (header, mut region): (&mut SoftanvilSimulation, Region),
    work: impl FnOnce(&Model, &mut State) -> Result<R, Failure>,
) -> Result<R, Failure> {
    let damaged = Failure::Uninitialised { argument: "simulation" };
    let arrays = Arrays::cut(&header.constants.size, &mut header.scalars, &mut region).ok_or(damaged)?;
    let model = Model::view(&header.constants, arrays.nodes, arrays.cells, arrays.hoops);
    let mut state = State::view(&model, arrays.state).map_err(|_| damaged)?;
    work(&model, &mut state)
}

/// Reads model and state of a simulation, which others may read at the same time.
pub(crate) fn look<'a, R>(
    (header, mut region): (&'a SoftanvilSimulation, SharedRegion<'a>),
    work: impl FnOnce(&Model<'a>, &StateView<'a>) -> Result<R, Failure>,
) -> Result<R, Failure> {
    let damaged = Failure::Uninitialised { argument: "simulation" };
    let (model, content) = parts(header, &mut region).ok_or(damaged)?;
    let state = StateView::new(&model, &header.scalars, content).map_err(|_| damaged)?;
    work(&model, &state)
}

/// Model and state behind the header, in the order of [`Arrays::cut`].
fn parts<'a>(header: &'a SoftanvilSimulation, region: &mut SharedRegion<'a>) -> Option<(Model<'a>, StateContent<'a>)> {
    let size = &header.constants.size;
    let (nodes, cells) = (region.take(size.model_nodes)?, region.take(size.model_cells)?);
    let model = Model::view(&header.constants, nodes, cells, region.take(size.model_hoops)?);
    let (nodes, cells) = (region.take(size.state_nodes)?, region.take(size.state_cells)?);
    Some((model, StateContent { nodes, cells, viscous: region.take(size.state_viscous)? }))
}
