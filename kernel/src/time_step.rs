//! The fixed time step: chosen once from the stiffest state expected, monitored ever after.
//!
//! The central difference scheme is stable for dt <= 2 / omega with the highest frequency omega of the mesh, which is
//! bounded by that of its parts (Irons and Treharne 1971). The parts here are the cells, with a quarter of their mass at
//! each corner: their two triangles share a pressure, and a cell's bound is closer than a triangle's. `cell_bound.rs` tells
//! how it is found.

use crate::cell_bound::{CellMatrix, CellStiffness, cell_matrix, limit_squared, unstable};
use crate::element::{Block, CellConstants, CellHistory, HoopConstants, TriangleHistory};
use crate::error::{ModelError, StepError};
use crate::lanes::{LANES, ZERO};
use crate::material::Laws;
use crate::math;
use crate::mesh::Grid;
use crate::model::{Model, SAMPLING_INTERVAL};
use crate::real::{self, Real};
use crate::scenario::{Material, Scenario, StepBy};
use crate::state::State;
use crate::stretch::IsochoricStretch;
use crate::vector::{Instructions, Scalar, Vector};

/// Stretch through the thickness that the step is chosen for. It holds up to five times the energy of the study's
/// highest drop.
pub const DESIGN_STRETCH: Real = 0.56;

/// The same in rings: a dome meets the face in a point, and gets thinner there.
pub const DESIGN_STRETCH_RINGS: Real = 0.45;

/// The monitor visits every cell at least once in this many steps. At the study's speeds a stretch changes by some
/// hundredths in that time.
pub const MONITOR_PERIOD: usize = 64;

/// The fewest cells that it visits in a step: on a small mesh, all cells have their turn sooner.
const LEAST_GROUP: usize = 4;

/// Most steps in a sampling interval.
pub const MAX_STEPS_PER_SAMPLE: u32 = 5000;

/// Steps per sampling interval for `scenario` on the mesh `cells`.
///
/// # Errors
/// A stable step that is too small to offer, or a given step above the limit at rest.
pub(crate) fn steps_per_sample(
    scenario: &Scenario,
    grid: &Grid,
    cells: &[CellConstants],
    hoops: &[HoopConstants],
) -> Result<u32, ModelError> {
    let at_rest = smallest_limit(scenario, grid, cells, hoops, 1.0);
    let step = match scenario.time.step_by {
        StepBy::SafetyFactor => {
            let design = if grid.axisymmetric { DESIGN_STRETCH_RINGS } else { DESIGN_STRETCH };
            let pressed = smallest_limit(scenario, grid, cells, hoops, design);
            scenario.time.safety_factor * if pressed < at_rest { pressed } else { at_rest }
        }
        StepBy::Given => {
            if scenario.time.step > at_rest {
                return Err(ModelError::StepTooLarge { step: scenario.time.step, limit: at_rest });
            }
            scenario.time.step
        }
    };
    // A step that is a whole divisor but for `SAME` counts as that divisor.
    let count = math::larger(1.0, math::ceil(SAMPLING_INTERVAL / step * (1.0 - real::SAME)));
    if count > MAX_STEPS_PER_SAMPLE as Real {
        let smallest = SAMPLING_INTERVAL / MAX_STEPS_PER_SAMPLE as Real;
        return Err(ModelError::StepTooSmall { step, smallest });
    }
    Ok(count as u32)
}

/// Largest step, s, that is stable in every layer when pressed to `thickness` of what it is at rest.
fn smallest_limit(
    scenario: &Scenario,
    grid: &Grid,
    cells: &[CellConstants],
    hoops: &[HoopConstants],
    thickness: Real,
) -> Real {
    let pressed = scenario.layers().map(|layer| Pressed::new(layer.material, thickness));
    let mut smallest = Real::INFINITY;
    for (block, constants) in cells.iter().enumerate() {
        let [silicone, skin] = &pressed;
        let pressed = if block < grid.n_block_silicone() { silicone } else { skin };
        let block = Block { laws: &pressed.laws, constants, hoop: hoops.get(block) };
        for l in 0..LANES {
            // Padding has no mass.
            if constants.triangle[0].reference_volume[l] > 0.0 {
                let matrix = cell_matrix(Scalar, l, &block, &pressed.stiffness(constants, l));
                if unstable(Scalar, &matrix, smallest) > 0.0 || smallest == Real::INFINITY {
                    smallest = limit_squared(Scalar, &matrix);
                }
            }
        }
    }
    math::sqrt(smallest)
}

/// A material pressed to some thickness across the row, and spread along it as it would if it were free to while nothing
/// has relaxed: one that resists a change of volume keeps it, one that does not stays as wide as it is.
struct Pressed {
    laws: Laws,
    /// Stretches along and across the row.
    stretch: [Real; 2],
    shear: Real,
    bulk: Real,
}

impl Pressed {
    fn new(material: &Material, thickness: Real) -> Self {
        let laws = Laws::new(material, SAMPLING_INTERVAL);
        let (bulk, shear) = (laws.volumetric.tangent(Scalar, 1.0), laws.shear_tangent(Scalar, &IsochoricStretch::REST));
        // Poisson's ratio over one minus it: the lateral strain of a plate in plane strain.
        let spread = math::larger(0.0, (3.0 * bulk - 2.0 * shear) / (3.0 * bulk + 4.0 * shear));
        let width = math::exp(-spread * math::ln(thickness));
        let jacobian = width * thickness;
        let scale = math::exp(math::ln(jacobian) * (-1.0 / 3.0));
        let stretch = IsochoricStretch { u11: scale * width, u22: scale * thickness, u12: 0.0, u33: scale };
        Self {
            stretch: [width, thickness],
            shear: laws.shear_tangent(Scalar, &stretch),
            bulk: laws.volumetric.tangent(Scalar, jacobian),
            laws,
        }
    }

    /// The cell of lane `l`.
    fn stiffness(&self, cell: &CellConstants, l: usize) -> CellStiffness<Real> {
        // The row runs along the edge whose gradient is normal to the direction across.
        let along = direction_along_row(cell, l);
        let (cc, ss, cs) = (along[0] * along[0], along[1] * along[1], along[0] * along[1]);
        let [a, b] = self.stretch.map(|stretch| 1.0 / stretch);
        CellStiffness {
            inverse_stretch: [[a * cc + b * ss, a * ss + b * cc, (a - b) * cs]; 2],
            hoop_scale: [1.0; 2],
            shear: [self.shear; 2],
            bulk: self.bulk,
        }
    }
}

/// Unit vector along the row: normal to the gradient of the edge across, which does not change along the row.
fn direction_along_row(cell: &CellConstants, l: usize) -> [Real; 2] {
    let [x, y] = cell.triangle[0].shape_gradient[1].map(|lane| lane[l]);
    let inverse = 1.0 / math::sqrt(math::larger(x * x + y * y, Real::MIN_POSITIVE));
    [y * inverse, -x * inverse]
}

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
        let mut lost = ZERO;
        for chunk in start / S::WIDTH..(start + share.group).div_ceil(S::WIDTH) {
            let matrix = current_matrix(set, chunk, &block_of, history);
            set.store(unstable(set, &matrix, step_squared), &mut lost, chunk);
        }
        let visited = lost.get(start..start + share.group).unwrap_or_default();
        if let Some(l) = visited.iter().position(|lost| *lost > 0.0) {
            return Err(failure(model, state, block, start + l));
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

#[cold]
fn failure(model: &Model, state: &State, block: usize, l: usize) -> StepError {
    let constants = &model.constants;
    let limit = model.cells.get(block).zip(state.cells.get(block)).map(|(cell, history)| {
        let block_of = Block { laws: constants.laws_of(block), constants: cell, hoop: model.hoops.get(block) };
        math::sqrt(limit_squared(Scalar, &current_matrix(Scalar, l, &block_of, history)))
    });
    StepError::Unstable {
        element: constants.grid.element_index(block, l, 0),
        time: constants.time(state.scalars.step_index),
        limit: limit.unwrap_or_default(),
        step: constants.dt,
    }
}

/// The matrix of neighbouring cells as they stand.
#[inline(always)]
fn current_matrix<S: Instructions>(
    set: S,
    chunk: usize,
    block: &Block,
    history: &CellHistory,
) -> CellMatrix<S::Vector> {
    let [a, b] = [
        TriangleStiffness::new(set, chunk, block, &history.triangle[0]),
        TriangleStiffness::new(set, chunk, block, &history.triangle[1]),
    ];
    let stiffness = CellStiffness {
        inverse_stretch: [a.inverse_stretch, b.inverse_stretch],
        hoop_scale: [a.hoop_scale, b.hoop_scale],
        shear: [a.shear, b.shear],
        bulk: a.bulk.larger(b.bulk),
    };
    cell_matrix(set, chunk, block, &stiffness)
}

/// A triangle's part in a [`CellStiffness`].
struct TriangleStiffness<V> {
    inverse_stretch: [V; 3],
    hoop_scale: V,
    shear: V,
    bulk: V,
}

impl<V: Vector> TriangleStiffness<V> {
    /// At the stretch that the last internal forces have left in the history.
    #[inline(always)]
    fn new<S: Instructions<Vector = V>>(set: S, chunk: usize, block: &Block, history: &TriangleHistory) -> Self {
        let [mean, difference, shear, hoop] = &history.stretch_prev;
        let (mean, difference) = (set.load(mean, chunk), set.load(difference, chunk));
        let (u12, u33) = (set.load(shear, chunk), set.load(hoop, chunk));
        let (u11, u22) = (mean + difference, mean - difference);
        let section = mean * mean - (difference * difference + u12 * u12);
        let one = set.splat(1.0);
        let inverse = one / section;
        let jacobian = section * u33;
        let scale = math::inverse_cbrt(jacobian);
        let isochoric = IsochoricStretch { u11: scale * u11, u22: scale * u22, u12: scale * u12, u33: scale * u33 };
        Self {
            inverse_stretch: [u22 * inverse, u11 * inverse, (u12 * inverse).times(-1.0)],
            hoop_scale: if block.hoop.is_some() { one / u33 } else { one },
            shear: block.laws.shear_tangent(set, &isochoric),
            bulk: block.laws.volumetric.tangent(set, jacobian),
        }
    }
}

#[cfg(all(test, not(feature = "single")))]
mod tests {
    use super::*;

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
