//! [`State`]: everything about a simulation that changes, in memory that the caller lends.

use crate::element::{CellHistory, Corners};
use crate::energy::Ledger;
use crate::error::{MemoryError, StepError};
use crate::impactor::ImpactorState;
use crate::lanes::{Deviator, LANES, Lane};
use crate::measurement::{Metrics, Sampler};
use crate::mesh::Grid;
use crate::model::Model;
use crate::real::Real;
use crate::storage::{StateMemory, split_row, take};
use crate::vector::{Instructions, Vector};

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
/// // The books close: what came in is where the ledger says.
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
    pub energy: Ledger,
    /// Why no further step can be made.
    pub failure: Option<StepError>,
}

/// Forces of a step on the whole anvil, N.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Forces {
    /// Contact force on the impactor, upwards.
    pub contact: Real,
    /// Force of the layer on the core, downwards.
    pub core_reaction: Real,
}

/// The arrays of the nodes, rows of [`Grid::stride`] from the core to the surface.
pub(crate) struct StateNodes<'a> {
    /// Displacement along x, m.
    pub displacement_x: &'a mut [Real],
    /// Displacement along y, m.
    pub displacement_y: &'a mut [Real],
    /// Velocity along x half a step back, m/s.
    pub velocity_x: &'a mut [Real],
    /// Velocity along y half a step back, m/s.
    pub velocity_y: &'a mut [Real],
    /// Force of the step along x, N.
    pub force_x: &'a mut [Real],
    /// Force of the step along y, N.
    pub force_y: &'a mut [Real],
    /// Contact force on the surface nodes, downwards, N.
    pub contact_normal: &'a mut [Real],
    /// Friction force on the surface nodes, outwards, N.
    pub contact_tangential: &'a mut [Real],
}

/// The changing part of a simulation.
///
/// ```
/// use softanvil_kernel::{Simulation, StepInput, preset};
///
/// let mut anvil = Simulation::new(&preset::study())?;
/// anvil.run(4e-3, &StepInput::default())?;
/// anvil.with(|model, state| {
///     // The first node of the last row: the top of the anvil on its centre line, which touches the face.
///     let top = model.constants.grid.n_v * model.constants.grid.stride();
///     let [_, along_y] = state.displacement();
///     assert!((along_y[top] - state.scalars.impactor.position).abs() < 1e-12);
/// })?;
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
pub struct State<'a> {
    /// The numbers that are not arrays.
    pub scalars: &'a mut Scalars,
    pub(crate) nodes: StateNodes<'a>,
    pub(crate) cells: &'a mut [CellHistory],
    pub(crate) viscous: &'a mut [Deviator],
}

impl<'a> State<'a> {
    /// A state of `model` at the start of its drop, in `memory`.
    ///
    /// # Errors
    /// Too little memory.
    pub fn new(model: &Model, memory: StateMemory<'a>) -> Result<Self, MemoryError> {
        let mut state = Self::view(model, memory)?;
        state.reset(model);
        Ok(state)
    }

    /// A state over memory that already holds one.
    ///
    /// # Errors
    /// Too little memory.
    // Of every call on a simulation: not inlined, the state would be written twice.
    #[inline(always)]
    pub fn view(model: &Model, memory: StateMemory<'a>) -> Result<Self, MemoryError> {
        let size = &model.constants.size;
        let grid = &model.constants.grid;
        let given = memory.nodes.len();
        let nodes = take(memory.nodes, size.state_nodes, "state nodes")?;
        let nodes = StateNodes::cut(nodes, grid.n_node(), grid.stride());
        Ok(Self {
            scalars: memory.scalars,
            nodes: nodes.ok_or(MemoryError { what: "state nodes", given, needed: size.state_nodes })?,
            cells: take(memory.cells, size.state_cells, "state cells")?,
            viscous: take(memory.viscous, size.state_viscous, "state viscous history")?,
        })
    }

    /// Back to the start of the drop.
    pub fn reset(&mut self, model: &Model) {
        *self.scalars = Scalars::start(model);
        for array in self.nodes.arrays_mut() {
            array.fill(0.0);
        }
        self.cells.fill(CellHistory::REST);
        self.viscous.fill(Deviator::ZERO);
    }

    /// Simulated time, s.
    pub fn time(&self, model: &Model) -> Real {
        model.constants.time(self.scalars.step_index)
    }

    /// Displacements of the nodes, m, laid out as [`Model::reference_position`].
    pub fn displacement(&self) -> [&[Real]; 2] {
        [self.nodes.displacement_x, self.nodes.displacement_y]
    }

    /// Displacements of the nodes, m, to be changed: initial conditions, prescribed fields. Nodes beyond `n_u + 1` in a
    /// row are padding and stay at zero.
    pub fn displacement_mut(&mut self) -> [&mut [Real]; 2] {
        [self.nodes.displacement_x, self.nodes.displacement_y]
    }

    /// Velocities of the nodes half a step back, m/s, laid out alike.
    pub fn velocity(&self) -> [&[Real]; 2] {
        [self.nodes.velocity_x, self.nodes.velocity_y]
    }

    /// Velocities of the nodes half a step back, m/s, to be changed.
    pub fn velocity_mut(&mut self) -> [&mut [Real]; 2] {
        [self.nodes.velocity_x, self.nodes.velocity_y]
    }

    /// Total force on each node in the last step, N: contact and friction minus internal forces.
    pub fn force(&self) -> [&[Real]; 2] {
        [self.nodes.force_x, self.nodes.force_y]
    }

    /// Normal force of the face on each surface node in the last step, N, by column.
    pub fn contact_normal(&self) -> &[Real] {
        self.nodes.contact_normal
    }

    /// Friction force of the face on each surface node in the last step, N, outwards, by column.
    pub fn contact_tangential(&self) -> &[Real] {
        self.nodes.contact_tangential
    }

    /// Displacements of the corners of neighbouring cells of a block.
    #[inline(always)]
    pub(crate) fn corners<S: Instructions>(
        &self,
        set: S,
        chunk: usize,
        grid: &Grid,
        block: usize,
    ) -> Corners<S::Vector> {
        corners(set, chunk, &self.nodes.rows(grid.first_nodes(grid.place(block))))
    }
}

impl StateNodes<'_> {
    /// Displacements of the rows of nodes below and above the block whose first nodes are `first`.
    #[inline(always)]
    pub(crate) fn rows(&self, [lower, upper]: [usize; 2]) -> Rows<'_> {
        let (x, y) = (&*self.displacement_x, &*self.displacement_y);
        [[span(x, lower), span(y, lower)], [span(x, upper), span(y, upper)]]
    }

    /// Takes the forces of the cells of a block from their corners.
    #[inline(always)]
    pub(crate) fn subtract_force<S: Instructions>(
        &mut self,
        set: S,
        [lower, upper]: [usize; 2],
        force: &Corners<Lane>,
    ) {
        let [c0, c1, c2, c3] = force;
        for i in 0..2 {
            let row = if i == 0 { &mut *self.force_x } else { &mut *self.force_y };
            subtract_ends(set, row, lower, &c0[i], &c1[i]);
            subtract_ends(set, row, upper, &c3[i], &c2[i]);
        }
    }
}

/// Numbers at the nodes of a row of cells of a block.
type Span = [Real; LANES + 1];
/// Two numbers at the nodes below and above the cells of a block.
pub(crate) type Rows<'r> = [[&'r Span; 2]; 2];

#[inline(always)]
fn span(row: &[Real], start: usize) -> &Span {
    row.get(start..).and_then(|tail| tail.first_chunk()).unwrap_or(&[0.0; LANES + 1])
}

/// The numbers at the corners of neighbouring cells of a block.
#[inline(always)]
pub(crate) fn corners<S: Instructions>(set: S, chunk: usize, rows: &Rows) -> Corners<S::Vector> {
    let mut corners = [[set.splat(0.0); 2]; 4];
    for i in 0..2 {
        let ([left @ .., _], [_, right @ ..]) = (rows[0][i], rows[0][i]);
        corners[0][i] = set.load(left, chunk);
        corners[1][i] = set.load(right, chunk);
        let ([left @ .., _], [_, right @ ..]) = (rows[1][i], rows[1][i]);
        corners[2][i] = set.load(right, chunk);
        corners[3][i] = set.load(left, chunk);
    }
    corners
}

/// Subtracts from the numbers of a row of nodes at the left ends of the cells of a block, then at the right ends, which are
/// one place on. Without a store between: a processor is late to read what two stores have just written in parts.
#[inline(always)]
fn subtract_ends<S: Instructions>(set: S, row: &mut [Real], start: usize, left: &Lane, right: &Lane) {
    let Some(span) = row.get_mut(start..).and_then(|tail| tail.first_chunk_mut::<{ LANES + 1 }>()) else { return };
    let [lane @ .., last] = span;
    let mut before = set.splat(0.0);
    for chunk in 0..LANES / S::WIDTH {
        let of_right = set.load(right, chunk);
        let rest = set.load(lane, chunk) - set.load(left, chunk);
        set.store(rest - of_right.moved_on(before), lane, chunk);
        before = of_right;
    }
    *last -= right[LANES - 1];
}

impl<'a> StateNodes<'a> {
    /// Cuts `memory` into rows of `n` numbers, one per node, and two of `surface`; none if it is too short.
    #[inline(always)]
    fn cut(mut memory: &'a mut [Real], n: usize, surface: usize) -> Option<Self> {
        let mut row = |n| split_row(&mut memory, n);
        Some(Self {
            displacement_x: row(n)?,
            displacement_y: row(n)?,
            velocity_x: row(n)?,
            velocity_y: row(n)?,
            force_x: row(n)?,
            force_y: row(n)?,
            contact_normal: row(surface)?,
            contact_tangential: row(surface)?,
        })
    }

    /// Every array, in the order of storage.
    pub(crate) fn arrays_mut(&mut self) -> [&mut [Real]; 8] {
        [
            self.displacement_x,
            self.displacement_y,
            self.velocity_x,
            self.velocity_y,
            self.force_x,
            self.force_y,
            self.contact_normal,
            self.contact_tangential,
        ]
    }
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
        energy: Ledger::ZERO,
        failure: None,
    };

    /// Whether the face has touched the layer and been clear of it since the last complete sampling interval began.
    pub fn contact_has_ended(&self) -> bool {
        let forces = [self.sampler.last.contact_force, self.sampler.sum.contact, self.force.contact];
        self.metrics.has_touched() && forces.iter().all(|force| *force <= 0.0)
    }

    /// The start of the drop.
    fn start(model: &Model) -> Self {
        Self { impactor: ImpactorState::start(model), energy: Ledger::start(model), ..Self::BLANK }
    }
}
