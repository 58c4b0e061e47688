//! The fixed time step: chosen once from the stiffest state expected, monitored ever after.
//!
//! The central difference scheme is stable for dt <= 2 / omega with the highest frequency omega of the mesh, which is
//! bounded by that of its parts (Irons and Treharne 1971). The parts here are the cells, with a quarter of their mass at
//! each corner: their two triangles share a pressure, and a cell's bound is closer than a triangle's. `cell_bound.rs` tells
//! how it is found.

use crate::cell_bound::{CellStiffness, gram, limit_squared, unstable};
use crate::element::{Block, CellConstants, Corners, HoopConstants, cell_kinematics};
use crate::error::{ModelError, StepError};
use crate::kinematics::Kinematics;
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

/// Neighbouring cells that the monitor visits together.
const GROUP: usize = 4;

/// The monitor visits every cell at least once in this many steps. At the study's speeds a stretch changes by some
/// hundredths in that time.
pub const MONITOR_PERIOD: usize = 64;

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
                let gram = gram(Scalar, l, &block, &pressed.stiffness(constants, l));
                if unstable(Scalar, &gram, 4.0 / smallest) > 0.0 || smallest == Real::INFINITY {
                    smallest = limit_squared(&gram, Scalar);
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
        let (bulk, shear) = (laws.volumetric.tangent(1.0), laws.shear_tangent(&IsochoricStretch::REST));
        // Poisson's ratio over one minus it: the lateral strain of a plate in plane strain.
        let spread = math::larger(0.0, (3.0 * bulk - 2.0 * shear) / (3.0 * bulk + 4.0 * shear));
        let width = math::exp(-spread * math::ln(thickness));
        let jacobian = width * thickness;
        let scale = math::exp(math::ln(jacobian) * (-1.0 / 3.0));
        let stretch = IsochoricStretch { u11: scale * width, u22: scale * thickness, u12: 0.0, u33: scale };
        Self {
            stretch: [width, thickness],
            shear: laws.shear_tangent(&stretch),
            bulk: laws.volumetric.tangent(jacobian),
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

/// Compares the step with the current limit of this step's share of the cells: so many groups of [`GROUP`] neighbours that
/// all have had their turn after [`MONITOR_PERIOD`] steps at most, the same number in every step.
///
/// # Errors
/// The first cell whose limit is below the step.
#[inline(always)]
pub(crate) fn monitor<S: Instructions>(set: S, model: &Model, state: &State) -> Result<(), StepError> {
    let groups = model.cells.len() * (LANES / GROUP);
    let share = groups.div_ceil(MONITOR_PERIOD);
    let first = state.scalars.step_index % groups.div_ceil(share.max(1)).max(1) as u64;
    for turn in 0..share {
        let group = (first as usize * share + turn) % groups.max(1);
        let (block, start) = (group / (LANES / GROUP), (group % (LANES / GROUP)) * GROUP);
        let Some(constants) = model.cells.get(block) else { continue };
        let block_of = Block { laws: model.constants.laws_of(block), constants, hoop: model.hoops.get(block) };
        let limit = set.splat(4.0 / (model.constants.dt * model.constants.dt));
        let mut lost = ZERO;
        for chunk in start / S::WIDTH..(start + GROUP).div_ceil(S::WIDTH) {
            let gram = current_gram(set, chunk, &block_of, &state.corners(set, chunk, &model.constants.grid, block));
            set.store(unstable(set, &gram, limit), &mut lost, chunk);
        }
        let lanes = lost.iter().enumerate().skip(start).take(GROUP);
        if lanes.clone().fold(0.0, |sum, (_, lost)| sum + lost) > 0.0 {
            return Err(failure(model, state, block, lanes.filter(|(_, lost)| **lost > 0.0).map(|(l, _)| l).next()));
        }
    }
    Ok(())
}

#[cold]
fn failure(model: &Model, state: &State, block: usize, l: Option<usize>) -> StepError {
    let (constants, l) = (&model.constants, l.unwrap_or_default());
    let limit = model.cells.get(block).map(|cell| {
        let block_of = Block { laws: constants.laws_of(block), constants: cell, hoop: model.hoops.get(block) };
        let gram = current_gram(Scalar, l, &block_of, &state.corners(Scalar, l, &constants.grid, block));
        math::sqrt(limit_squared(&gram, Scalar))
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
fn current_gram<S: Instructions>(
    set: S,
    chunk: usize,
    block: &Block,
    corners: &Corners<S::Vector>,
) -> [[S::Vector; 7]; 7] {
    let kinematics = cell_kinematics(set, chunk, block, corners);
    let (zero, one) = (set.splat(0.0), set.splat(1.0));
    let mut stiffness =
        CellStiffness { inverse_stretch: [[zero; 3]; 2], hoop_scale: [one; 2], shear: [zero; 2], bulk: zero };
    for t in 0..2 {
        let k = &kinematics[t];
        let inverse = one / (k.mean * k.mean - (k.difference * k.difference + k.shear * k.shear));
        stiffness.inverse_stretch[t] =
            [(k.mean - k.difference) * inverse, (k.mean + k.difference) * inverse, zero - k.shear * inverse];
        if block.hoop.is_some() {
            stiffness.hoop_scale[t] = one / k.hoop;
        }
        let [shear, bulk] = tangents(set, block.laws, k);
        stiffness.shear[t] = shear;
        stiffness.bulk = bulk.if_greater(stiffness.bulk, bulk, stiffness.bulk);
    }
    gram(set, chunk, block, &stiffness)
}

/// Shear tangent and tangent of the volume, Pa, of neighbouring triangles.
#[inline(always)]
fn tangents<S: Instructions>(set: S, laws: &Laws, k: &Kinematics<S::Vector>) -> [S::Vector; 2] {
    let scale = k.inverse_cbrt_j;
    let stretch = [scale * k.mean, scale * k.difference, scale * k.shear, scale * k.hoop, k.jacobian];
    set.map(stretch, |[mean, difference, u12, u33, jacobian]| {
        let stretch = IsochoricStretch { u11: mean + difference, u22: mean - difference, u12, u33 };
        [laws.shear_tangent(&stretch), laws.volumetric.tangent(jacobian)]
    })
}
