//! How large a step is stable: the limit of a state, its monitor, and what tells that a step was too large.
//!
//! The central difference scheme is stable for dt <= 2 / omega with the highest frequency omega of the mesh, which is
//! bounded by that of its parts (Irons and Treharne 1971). The parts here are the cells, with a quarter of their mass at
//! each corner: their two triangles share a pressure, and a cell's bound is closer than a triangle's. `cell_bound.rs` tells
//! how it is found. The tangents of a cell are majorants of those of its laws with the geometric stiffness of their stresses
//! ([`crate::material`]): against the true highest frequency of meshes in random states of all laws the limit is a bound,
//! except where a large overstress has not begun to relax, by less than the default safety factor takes off
//! (`tests/verification/tests/suite/frequency.rs`).

use crate::cell_bound::{CellMatrix, CellStiffness, cell_matrix, limit_squared, unstable};
use crate::element::{Block, CellConstants, CellHistory, HoopConstants};
use crate::energy::Ledger;
use crate::error::StepError;
use crate::instruction_set::{InstructionSet, Work};
use crate::lanes::{LANES, ZERO};
use crate::math;
use crate::model::{Constants, Model};
use crate::real::Real;
use crate::state::State;
use crate::storage::ModelArrays;
use crate::stretch::{IsochoricStretch, largest_in_plane};
use crate::vector::{Instructions, Scalar, Vector};

/// The monitor visits every cell at least once in this many steps. At the study's speeds a stretch changes by some
/// hundredths in that time.
pub const MONITOR_PERIOD: usize = 64;

/// The fewest cells that it visits in a step: on a small mesh, all cells have their turn sooner.
const LEAST_GROUP: usize = 4;

/// Compares the step with the current limit of this step's share of the cells, as the internal forces have found them: the
/// same number in every step, so that all have had their turn after [`MONITOR_PERIOD`] steps at most.
///
/// # Errors
/// The first cell whose limit is below the step.
#[inline(always)]
pub(crate) fn monitor<S: Instructions>(set: S, model: &Model, state: &State) -> Result<(), StepError> {
    let share = Share::new(model.cells.len() * LANES, state.scalars.step_index);
    let step_squared = set.splat(model.constants.dt * model.constants.dt);
    for turn in 0..share.count {
        let (block, start) = (share.cell(turn) / LANES, share.cell(turn) % LANES);
        let (Some(constants), Some(history)) = (model.cells.get(block), state.cells.get(block)) else { continue };
        let block_of = Block { laws: model.constants.laws_of(block), constants, hoop: model.hoops.get(block) };
        for chunk in start / S::WIDTH..(start + share.group).div_ceil(S::WIDTH) {
            let matrix = current_matrix(set, chunk, &block_of, history);
            let mut lost = ZERO;
            set.store(unstable(set, &matrix, step_squared), &mut lost, chunk);
            let (first, end) = (start.max(chunk * S::WIDTH), (start + share.group).min((chunk + 1) * S::WIDTH));
            let visited = lost.get(first..end).unwrap_or_default();
            if let Some(l) = visited.iter().position(|lost| *lost > 0.0) {
                return Err(failure(model, state, block, first + l));
            }
        }
    }
    Ok(())
}

/// The cells that a step visits: groups of neighbours.
struct Share {
    /// Cells of a group, a divisor of [`LANES`].
    group: usize,
    /// The first group.
    first: usize,
    /// Number of groups.
    count: usize,
    /// Groups of the mesh, after the last of which comes the first.
    of: usize,
}

impl Share {
    /// Of the step `step_index`, for a mesh of so many `cells`, padding included.
    fn new(cells: usize, step_index: u64) -> Self {
        let each = cells.div_ceil(MONITOR_PERIOD);
        let (group, count, of) = if each > LEAST_GROUP {
            (LANES, each.div_ceil(LANES), cells / LANES)
        } else {
            (LEAST_GROUP, 1, cells / LEAST_GROUP)
        };
        let first = step_index % of.div_ceil(count).max(1) as u64;
        Self { group, first: first as usize * count, count, of }
    }

    /// The first cell of the group `turn`.
    fn cell(&self, turn: usize) -> usize {
        let place = self.first + turn;
        self.group * if place < self.of { place } else { place - self.of }
    }
}

/// The error of the cell in lane `l` of a block, with its limit.
#[cold]
#[inline(never)]
fn failure(model: &Model, state: &State, block: usize, l: usize) -> StepError {
    let element = model.constants.grid.element_index(block, l, 0);
    let mut limits = ZERO;
    if let (Some(constants), Some(history)) = (model.cells.get(block), state.cells.get(block)) {
        let block_of = Block { laws: model.constants.laws_of(block), constants, hoop: model.hoops.get(block) };
        let step_squared = model.constants.dt * model.constants.dt;
        Scalar.store(
            limit_squared(Scalar, &current_matrix(Scalar, l, &block_of, history), step_squared),
            &mut limits,
            l,
        );
    }
    unstable_at(model, state, element, math::sqrt(limits.get(l).copied().unwrap_or_default()))
}

fn unstable_at(model: &Model, state: &State, element: u32, limit: Real) -> StepError {
    let constants = &model.constants;
    StepError::Unstable { element, time: constants.time(state.scalars.step_index), limit, step: constants.dt }
}

/// Part of the energy at hand that the kinetic energy of the layer may be below zero. Catching nodes at the face brings it
/// there for one step, by the energy of single nodes.
const NEGATIVE_PART: Real = 0.01;

/// Looks for an instability that grows between two visits of the monitor.
///
/// A mode above its limit turns round in every step, so that its kinetic energy 1/2 m v(n-1/2) v(n+1/2) is negative and
/// grows, which nothing else does in two steps running. The ledger still holds the last step's; `layer_kinetic` is that of
/// this one, J.
///
/// # Errors
/// The cell with the smallest limit.
#[inline(always)]
pub(crate) fn guard(model: &Model, state: &State, layer_kinetic: Real) -> Result<(), StepError> {
    if is_unstable(&state.scalars.energy, layer_kinetic) {
        let (limit, element) = critical_time_step(model, state);
        return Err(unstable_at(model, state, element, limit));
    }
    Ok(())
}

/// Whether the kinetic energies of this step and of the last, which `ledger` holds, are below zero by more than those of single
/// nodes.
#[inline(always)]
fn is_unstable(ledger: &Ledger, layer_kinetic: Real) -> bool {
    let before = ledger.at_forces.kinetic;
    if layer_kinetic >= 0.0 || before >= 0.0 {
        return false;
    }
    let at_hand = math::abs(ledger.external) + math::abs(ledger.elastic) + math::abs(ledger.viscous);
    let least = -math::larger(layer_kinetic, before);
    least > NEGATIVE_PART * at_hand && least > Real::EPSILON
}

/// Largest stable step of `state` as its last internal forces have found it, s, and the first triangle of the cell that
/// sets it.
#[inline(never)]
pub fn critical_time_step(model: &Model, state: &State) -> (Real, u32) {
    let cells = Cells { constants: model.constants, cells: model.cells, hoops: model.hoops };
    let critical = cells.critical(&|block| state.cells.get(block), Real::MAX);
    critical.map_or((Real::INFINITY, 0), |found| (math::sqrt(found.limit_squared), found.element))
}

/// The cells of a mesh.
pub(crate) struct Cells<'m> {
    pub constants: &'m Constants,
    pub cells: &'m [CellConstants],
    pub hoops: &'m [HoopConstants],
}

/// The cell with the smallest limit.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Critical {
    /// Square of its largest stable step, s2.
    pub limit_squared: Real,
    /// Its first triangle.
    pub element: u32,
    /// The smallest principal stretch of its triangles in the section.
    pub stretch: Real,
}

impl<'m> Cells<'m> {
    /// Those in the arrays of a model.
    pub fn new(constants: &'m Constants, arrays: &'m ModelArrays) -> Self {
        Self { constants, cells: arrays.cells, hoops: arrays.hoops }
    }

    /// The cell with the smallest limit whose square is below `bound`, s2, by the `history` of each block; none if there is
    /// none.
    pub fn critical<'h>(&self, history: &dyn Fn(usize) -> Option<&'h CellHistory>, bound: Real) -> Option<Critical> {
        InstructionSet::best().run(Search { cells: self, history, bound })
    }

    /// Largest step that is stable at rest, s.
    pub fn limit_at_rest(&self) -> Real {
        let critical = self.critical(&|_| Some(&CellHistory::REST), Real::MAX);
        critical.map_or(Real::INFINITY, |critical| math::sqrt(critical.limit_squared))
    }
}

/// The search for the smallest limit, as work for an instruction set.
struct Search<'c, 'm, 'h> {
    cells: &'c Cells<'m>,
    history: &'c dyn Fn(usize) -> Option<&'h CellHistory>,
    bound: Real,
}

impl Work for Search<'_, '_, '_> {
    type Output = Option<Critical>;

    #[inline(always)]
    fn run<S: Instructions>(self, set: S) -> Option<Critical> {
        let Cells { constants, cells, hoops } = *self.cells;
        let (mut critical, mut bound) = (None, self.bound);
        for (index, cell) in cells.iter().enumerate() {
            let Some(history) = (self.history)(index) else { continue };
            let block = Block { laws: constants.laws_of(index), constants: cell, hoop: hoops.get(index) };
            for chunk in 0..LANES / S::WIDTH {
                let matrix = current_matrix(set, chunk, &block, history);
                let (step_squared, mut lost) = (set.splat(bound), ZERO);
                set.store(unstable(set, &matrix, step_squared), &mut lost, chunk);
                if lost == ZERO {
                    continue;
                }
                let mut limits = ZERO;
                set.store(limit_squared(set, &matrix, step_squared), &mut limits, chunk);
                for l in chunk * S::WIDTH..(chunk + 1) * S::WIDTH {
                    // Padding has no volume.
                    let limit_squared = limits[l % LANES];
                    if cell.triangle[0].reference_volume[l % LANES] > 0.0 && limit_squared < bound {
                        bound = limit_squared;
                        let element = constants.grid.element_index(index, l, 0);
                        critical = Some(Critical { limit_squared, element, stretch: smallest_stretch(history, l) });
                    }
                }
            }
        }
        critical
    }
}

/// The smallest principal stretch in the section of the triangles of lane `l`.
fn smallest_stretch(history: &CellHistory, l: usize) -> Real {
    let stretches = history.triangle.each_ref().map(|triangle| {
        let [mean, difference, shear, _] = triangle.stretch_prev.map(|lane| lane[l % LANES]);
        mean + mean - largest_in_plane(mean, difference, shear)
    });
    if stretches[0] < stretches[1] { stretches[0] } else { stretches[1] }
}

/// The matrix of neighbouring cells at the stretches that the last internal forces have left in the history.
#[inline(always)]
fn current_matrix<S: Instructions>(
    set: S,
    chunk: usize,
    block: &Block,
    history: &CellHistory,
) -> CellMatrix<S::Vector> {
    let (zero, one) = (set.splat(0.0), set.splat(1.0));
    let mut stiffness =
        CellStiffness { inverse_stretch: [[zero; 3]; 2], hoop_scale: [one; 2], shear: [zero; 2], bulk: zero };
    for t in 0..2 {
        let [mean, difference, shear, hoop] = &history.triangle[t].stretch_prev;
        let (mean, difference) = (set.load(mean, chunk), set.load(difference, chunk));
        let (u12, u33) = (set.load(shear, chunk), set.load(hoop, chunk));
        let (u11, u22) = (mean + difference, mean - difference);
        let section = mean * mean - (difference * difference + u12 * u12);
        let inverse = one / section;
        stiffness.inverse_stretch[t] = [u22 * inverse, u11 * inverse, (u12 * inverse).times(-1.0)];
        if block.hoop.is_some() {
            stiffness.hoop_scale[t] = one / u33;
        }
        let jacobian = section * u33;
        let scale = math::inverse_cbrt(jacobian);
        let isochoric = IsochoricStretch { u11: scale * u11, u22: scale * u22, u12: scale * u12, u33: scale * u33 };
        stiffness.shear[t] = block.laws.shear_tangent(set, &isochoric);
        // Stresses stiffen a change of volume, too: by about what they add to the shear.
        let added = stiffness.shear[t].plus(-block.laws.shear_modulus_0).larger(zero);
        stiffness.bulk = (block.laws.volumetric.tangent(set, jacobian) + added).larger(stiffness.bulk);
    }
    cell_matrix(set, chunk, block, &stiffness)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_kinetic_energies_below_zero_in_two_steps_running_are_an_instability() {
        let ledger = |layer_kinetic, external| {
            let mut ledger = Ledger::ZERO;
            (ledger.at_forces.kinetic, ledger.external) = (layer_kinetic, external);
            ledger
        };
        // A mode that doubles in every step; a node that was caught; round-off.
        for (before, now, expected) in
            [(-0.2, -0.4, true), (0.3, -0.4, false), (-0.4, 0.1, false), (-0.11, -0.4, false), (-1e-17, -1e-17, false)]
        {
            assert_eq!(is_unstable(&ledger(before, 12.0), now), expected, "{before} J, then {now} J");
        }
        // Nothing but round-off is at hand.
        assert!(!is_unstable(&ledger(-1e-20, 0.0), -1e-20));
    }

    #[test]
    fn the_monitor_visits_every_cell_in_its_period() {
        for blocks in 1..300 {
            let cells = blocks * LANES;
            for start in [0, 1, 12_345] {
                let mut visits = [0; 300 * LANES];
                for step in start..start + MONITOR_PERIOD as u64 {
                    let share = Share::new(cells, step);
                    for cell in (0..share.count).map(|turn| share.cell(turn)) {
                        assert_eq!(cell / LANES, (cell + share.group - 1) / LANES);
                        visits[cell..cell + share.group].iter_mut().for_each(|visits| *visits += 1);
                    }
                }
                assert!(visits[..cells].iter().all(|visits| *visits > 0), "{cells} cells from step {start}");
            }
        }
    }
}
