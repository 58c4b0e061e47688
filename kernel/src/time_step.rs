//! The fixed time step: chosen once from the stiffest state expected, monitored ever after.
//!
//! The highest frequency of a mesh is bounded by that of its elements (Irons and Treharne 1971). For a linear triangle
//! with a third of its mass at each corner, omega^2 <= 3 c lambda / rho, where lambda is the largest eigenvalue of
//! sum_a g_a (x) g_a over its spatial gradients g_a = F^-T dN_a/dX, and c = max(2 G, 2 K + 2 G / 3) the largest modulus
//! of an in-plane strain. The central difference scheme is stable for dt <= 2 / omega.

use crate::element::{CellConstants, Kinematics, TriangleConstants};
use crate::error::{ModelError, StepError};
use crate::lanes::LANES;
use crate::material::Laws;
use crate::math;
use crate::mesh::Grid;
use crate::model::{Model, SAMPLING_INTERVAL};
use crate::scenario::{Scenario, StepBy};
use crate::state::State;
use crate::stretch::IsochoricStretch;

/// Stretch through the thickness that the step is chosen for. It holds up to five times the energy of the study's
/// highest drop, where the layer gets thinner than this but, being compressible, less stiff than assumed.
pub const DESIGN_STRETCH: f64 = 0.6;

/// The monitor visits every block once in this many steps, an equal share in each.
pub const MONITOR_PERIOD: usize = 16;

/// Most steps in a sampling interval.
pub const MAX_STEPS_PER_SAMPLE: u32 = 5000;

/// Steps per sampling interval for `scenario` on the mesh `cells`.
///
/// # Errors
/// A stable step that is too small to offer, or a given step above the limit at rest.
pub(crate) fn steps_per_sample(scenario: &Scenario, grid: &Grid, cells: &[CellConstants]) -> Result<u32, ModelError> {
    let step = match scenario.time.step_by {
        StepBy::SafetyFactor => {
            // In plane compression to the stretch s gradients grow by 1/s.
            let stretch = IsochoricStretch::plane_compression(DESIGN_STRETCH);
            let growth = 1.0 / (DESIGN_STRETCH * DESIGN_STRETCH);
            scenario.time.safety_factor * smallest_limit(scenario, grid, cells, &stretch, growth)
        }
        StepBy::Given => {
            let at_rest = smallest_limit(scenario, grid, cells, &IsochoricStretch::REST, 1.0);
            if scenario.time.step > at_rest {
                return Err(ModelError::StepTooLarge { step: scenario.time.step, limit: at_rest });
            }
            scenario.time.step
        }
    };
    // A step within one part in 10^9 of a whole divisor counts as that divisor.
    let count = math::larger(1.0, math::ceil(SAMPLING_INTERVAL / step * (1.0 - 1e-9)));
    if count > f64::from(MAX_STEPS_PER_SAMPLE) {
        let smallest = SAMPLING_INTERVAL / f64::from(MAX_STEPS_PER_SAMPLE);
        return Err(ModelError::StepTooSmall { step, smallest });
    }
    Ok(count as u32)
}

/// Largest step, s, that is stable in every layer at an isochoric stretch, with eigenvalues `growth` times those at rest.
fn smallest_limit(
    scenario: &Scenario,
    grid: &Grid,
    cells: &[CellConstants],
    stretch: &IsochoricStretch,
    growth: f64,
) -> f64 {
    let (silicone, skin) = cells.split_at_checked(grid.n_block_silicone()).unwrap_or((cells, &[]));
    let mut smallest = f64::INFINITY;
    for (layer, cells) in scenario.layers().iter().zip([silicone, skin]) {
        // A layer without rows has the eigenvalue 0 and no limit.
        let laws = Laws::new(layer.material, SAMPLING_INTERVAL);
        let squared = limit_squared(&laws, stretch, 1.0, growth * largest_eigenvalue(cells));
        smallest = if squared < smallest { squared } else { smallest };
    }
    math::sqrt(smallest)
}

/// Square of the largest stable step, s2, at an isochoric stretch, a Jacobian and the eigenvalue `lambda`, 1/m2.
fn limit_squared(laws: &Laws, stretch: &IsochoricStretch, jacobian: f64, lambda: f64) -> f64 {
    let shear = laws.shear_tangent(stretch);
    let bulk = laws.volumetric.tangent(jacobian);
    let modulus = math::larger(2.0 * shear, 2.0 * bulk + (2.0 / 3.0) * shear);
    4.0 * laws.density / (3.0 * modulus * lambda)
}

/// Largest eigenvalue of sum_a dN_a/dX (x) dN_a/dX over all triangles at rest, 1/m2.
fn largest_eigenvalue(cells: &[CellConstants]) -> f64 {
    let mut largest = 0.0;
    for triangle in cells.iter().flat_map(|cell| &cell.triangle) {
        for l in 0..LANES {
            let [xx, yy, xy] = gradient_products(triangle, l);
            largest = math::larger(largest, eigenvalue(xx, yy, xy));
        }
    }
    largest
}

/// Components xx, yy, xy of sum_a dN_a/dX (x) dN_a/dX.
fn gradient_products(triangle: &TriangleConstants, l: usize) -> [f64; 3] {
    let mut products = [0.0; 3];
    let mut rest = [0.0; 2];
    let mut add = |g: [f64; 2]| {
        products[0] += g[0] * g[0];
        products[1] += g[1] * g[1];
        products[2] += g[0] * g[1];
    };
    for gradient in &triangle.shape_gradient {
        let g = [gradient[0][l], gradient[1][l]];
        rest = [rest[0] - g[0], rest[1] - g[1]];
        add(g);
    }
    add(rest);
    products
}

/// Larger eigenvalue of a symmetric 2 x 2 matrix.
fn eigenvalue(xx: f64, yy: f64, xy: f64) -> f64 {
    let half = 0.5 * (xx - yy);
    let squared = half * half + xy * xy;
    0.5 * (xx + yy) + squared * math::inverse_sqrt(squared)
}

/// Compares the step with the current limit of this step's share of the blocks.
///
/// # Errors
/// The first triangle whose limit is below the step.
pub(crate) fn monitor(model: &Model, state: &State) -> Result<(), StepError> {
    let first = (state.scalars.step_index % MONITOR_PERIOD as u64) as usize;
    for (block, cell) in model.cells.iter().enumerate().skip(first).step_by(MONITOR_PERIOD) {
        let corners = state.corners(&model.constants.grid, block);
        for (t, triangle) in cell.triangle.iter().enumerate() {
            let hoop = model.hoops.get(block).map(|h| &h.weight[t]);
            let kinematics = Kinematics::new(triangle, hoop, &corners);
            let place = Place { block, t };
            check_triangle(model, state, place, triangle, &kinematics)?;
        }
    }
    Ok(())
}

/// Triangle `t` of each cell of a block.
struct Place {
    block: usize,
    t: usize,
}

fn check_triangle(
    model: &Model,
    state: &State,
    place: Place,
    triangle: &TriangleConstants,
    k: &Kinematics,
) -> Result<(), StepError> {
    let constants = &model.constants;
    let laws = constants.laws_of(place.block);
    for l in 0..LANES {
        let (u11, u22, u12) = (k.u11[l], k.u22[l], k.u12[l]);
        // The eigenvalues of G_ij = g_i . g_j are those of U^-1 (sum dN/dX (x) dN/dX) U^-1.
        let det = u11 * u22 - u12 * u12;
        let (v11, v22, v12) = (u22 / det, u11 / det, -u12 / det);
        let [xx, yy, xy] = gradient_products(triangle, l);
        let (a11, a12) = (v11 * xx + v12 * xy, v11 * xy + v12 * yy);
        let (a21, a22) = (v12 * xx + v22 * xy, v12 * xy + v22 * yy);
        let lambda = eigenvalue(a11 * v11 + a12 * v12, a21 * v12 + a22 * v22, a11 * v12 + a12 * v22);
        let squared = limit_squared(laws, &k.isochoric_stretch(l), k.jacobian[l], lambda);
        if squared < constants.dt * constants.dt {
            return Err(StepError::Unstable {
                element: constants.grid.element_index(place.block, l, place.t),
                time: constants.time(state.scalars.step_index),
                limit: math::sqrt(squared),
                step: constants.dt,
            });
        }
    }
    Ok(())
}
