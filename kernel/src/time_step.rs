//! The fixed time step: chosen once from the stiffest state expected, monitored ever after.
//!
//! The central difference scheme is stable for dt <= 2 / omega with the highest frequency omega of the mesh, which is
//! bounded by that of its parts (Irons and Treharne 1971). The parts here are the cells, with a quarter of their mass at
//! each corner: their two triangles share a pressure, and a cell's bound is closer than a triangle's. [`cell_bound`] tells
//! how it is found.

use crate::cell_bound::{CellStiffness, limit_squared, within_limit};
use crate::element::{CellConstants, HoopConstants, cell_kinematics};
use crate::error::{ModelError, StepError};
use crate::lanes::{LANES, Lane, ZERO};
use crate::material::Laws;
use crate::math;
use crate::mesh::Grid;
use crate::model::{Model, SAMPLING_INTERVAL};
use crate::real::{self, Real};
use crate::scenario::{Scenario, StepBy};
use crate::state::State;
use crate::stretch::IsochoricStretch;

/// Stretch through the thickness that the step is chosen for. It holds up to five times the energy of the study's
/// highest drop.
pub const DESIGN_STRETCH: Real = 0.56;

/// The same in rings: a dome meets the face in a point, and gets thinner there.
pub const DESIGN_STRETCH_RINGS: Real = 0.45;

/// The monitor visits every block once in this many steps, an equal share in each. At the study's speeds a stretch
/// changes by some hundredths in that time.
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
    // A step within one part in 10^9 of a whole divisor counts as that divisor.
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
    let laws = scenario.layers().map(|layer| Laws::new(layer.material, SAMPLING_INTERVAL));
    let mut smallest = Real::INFINITY;
    for (block, cell) in cells.iter().enumerate() {
        let [silicone, skin] = &laws;
        let laws = if block < grid.n_block_silicone() { silicone } else { skin };
        let squared = limit_squared(&pressed_cells(laws, cell, hoops.get(block), thickness));
        for l in 0..LANES {
            // Padding has no mass.
            if cell.triangle[0].reference_volume[l] > 0.0 && squared[l] < smallest {
                smallest = squared[l];
            }
        }
    }
    math::sqrt(smallest)
}

/// Cells pressed to `thickness` across the row, and spread along it as their unrelaxed material would if it were free to:
/// one that resists a change of volume keeps it, one that does not stays as wide as it is.
fn pressed_cells(laws: &Laws, cell: &CellConstants, hoop: Option<&HoopConstants>, thickness: Real) -> CellStiffness {
    let (bulk, shear) = (laws.volumetric.tangent(1.0), laws.shear_tangent(&IsochoricStretch::REST));
    // Poisson's ratio over one minus it: the lateral strain of a plate in plane strain.
    let spread = math::larger(0.0, (3.0 * bulk - 2.0 * shear) / (3.0 * bulk + 4.0 * shear));
    let width = math::exp(-spread * math::ln(thickness));
    let jacobian = width * thickness;
    let scale = math::exp(math::ln(jacobian) * (-1.0 / 3.0));
    let stretch = IsochoricStretch { u11: scale * width, u22: scale * thickness, u12: 0.0, u33: scale };
    let modulus = laws.shear_tangent(&stretch);
    let mut stiffness = CellStiffness {
        inverse_stretch: [[ZERO; 3]; 2],
        hoop_scale: [[1.0; LANES]; 2],
        shear: [[modulus; LANES]; 2],
        bulk: [laws.volumetric.tangent(jacobian); LANES],
        density: laws.density,
        cell: *cell,
        hoop: hoop.copied(),
    };
    for l in 0..LANES {
        // The row runs along the edge whose gradient is normal to the direction across.
        let along = direction_along_row(cell, l);
        let (cc, ss, cs) = (along[0] * along[0], along[1] * along[1], along[0] * along[1]);
        let (a, b) = (1.0 / width, 1.0 / thickness);
        for inverse in &mut stiffness.inverse_stretch {
            inverse[0][l] = a * cc + b * ss;
            inverse[1][l] = a * ss + b * cc;
            inverse[2][l] = (a - b) * cs;
        }
    }
    stiffness
}

/// Unit vector along the row: normal to the gradient of the edge across, which does not change along the row.
fn direction_along_row(cell: &CellConstants, l: usize) -> [Real; 2] {
    let [x, y] = cell.triangle[0].shape_gradient[1].map(|lane| lane[l]);
    let inverse = math::inverse_sqrt(math::larger(x * x + y * y, Real::MIN_POSITIVE));
    [y * inverse, -x * inverse]
}

/// Compares the step with the current limit of this step's share of the blocks.
///
/// # Errors
/// The first cell whose limit is below the step.
#[inline(always)]
pub(crate) fn monitor(model: &Model, state: &State) -> Result<(), StepError> {
    let first = (state.scalars.step_index % MONITOR_PERIOD as u64) as usize;
    for (block, cell) in model.cells.iter().enumerate().skip(first).step_by(MONITOR_PERIOD) {
        let stiffness = current_cells(model, state, block, cell);
        let stable = within_limit(&stiffness, model.constants.dt * model.constants.dt);
        if let Some(l) = stable.iter().position(|stable| !stable) {
            return Err(unstable(model, state, block, l, &limit_squared(&stiffness)));
        }
    }
    Ok(())
}

fn unstable(model: &Model, state: &State, block: usize, l: usize, squared: &Lane) -> StepError {
    let constants = &model.constants;
    StepError::Unstable {
        element: constants.grid.element_index(block, l, 0),
        time: constants.time(state.scalars.step_index),
        limit: math::sqrt(squared.get(l).copied().unwrap_or_default()),
        step: constants.dt,
    }
}

/// A block of cells as it stands.
#[inline(always)]
fn current_cells(model: &Model, state: &State, block: usize, cell: &CellConstants) -> CellStiffness {
    let laws = model.constants.laws_of(block);
    let hoop = model.hoops.get(block);
    let corners = state.corners(&model.constants.grid, block);
    let kinematics = cell_kinematics(cell, hoop, &corners);
    let mut stiffness = CellStiffness {
        inverse_stretch: [[ZERO; 3]; 2],
        hoop_scale: [ZERO; 2],
        shear: [ZERO; 2],
        bulk: ZERO,
        density: laws.density,
        cell: *cell,
        hoop: hoop.copied(),
    };
    for (t, k) in kinematics.iter().enumerate() {
        for l in 0..LANES {
            let (u11, u22, u12) = (k.u11[l], k.u22[l], k.u12[l]);
            let inverse = 1.0 / (u11 * u22 - u12 * u12);
            stiffness.inverse_stretch[t][0][l] = u22 * inverse;
            stiffness.inverse_stretch[t][1][l] = u11 * inverse;
            stiffness.inverse_stretch[t][2][l] = -u12 * inverse;
            stiffness.hoop_scale[t][l] = 1.0 / k.u33[l];
            stiffness.shear[t][l] = laws.shear_tangent(&k.isochoric_stretch(l));
            stiffness.bulk[l] = math::larger(stiffness.bulk[l], laws.volumetric.tangent(k.jacobian[l]));
        }
    }
    stiffness
}
