//! A bound of the highest frequency of single cells.
//!
//! With the mass m at each corner, omega^2 m is the largest eigenvalue of the cell's stiffness
//!
//! K = sum over triangles t of G_t V_t (r1 r1' + r2 r2' + r3 r3') + kappa V b b',
//!
//! where r1 = (e11 + e22 - 2 e33) / sqrt 3, r2 = e11 - e22 and r3 = 2 e12 are the deviatoric strains of a triangle and b
//! the mean dilatation of the cell, all as rows over the displacements of the corners, with the current (spatial) gradients.
//! The last term's eigenvalue is kappa V b'b. That of the others is the largest of the 6 x 6 Gram matrix A of their
//! rows, which trace(A^16)^(1/16) exceeds, by at most 12 % (if all six are alike). The sum of the two bounds that of the
//! whole. What makes the moduli G and kappa a bound is said in [`crate::material`].

use crate::element::{CellConstants, HoopConstants};
use crate::lanes::{LANES, Lane, ZERO};
use crate::math;
use crate::real::Real;

/// Rows of deviatoric strain of a cell.
const ROWS: usize = 6;
/// Squarings of the Gram matrix; the last one is only summed up.
const SQUARINGS: usize = 3;

/// A block of cells in some state of deformation.
pub(crate) struct CellStiffness {
    /// U^-1 of the section of each triangle: 11, 22, 12.
    pub inverse_stretch: [[Lane; 3]; 2],
    /// 1/U33 of each triangle.
    pub hoop_scale: [Lane; 2],
    /// Shear tangent of each triangle, Pa.
    pub shear: [Lane; 2],
    /// Tangent of the volume, Pa.
    pub bulk: Lane,
    /// Density at rest, kg/m3.
    pub density: Real,
    /// The cells at rest.
    pub cell: CellConstants,
    /// Their hoop constants, in rings.
    pub hoop: Option<HoopConstants>,
}

/// A row over the displacements of the four corners.
type Row = [[Lane; 2]; 4];
type Matrix = [[Lane; ROWS]; ROWS];

/// Square of the largest stable step of each cell, s2.
pub(crate) fn limit_squared(stiffness: &CellStiffness) -> Lane {
    let (gram, volumetric) = eigenvalue_parts(stiffness);
    // Scaled by its trace, so that no power leaves the range of numbers.
    let mut trace = ZERO;
    for i in 0..ROWS {
        for l in 0..LANES {
            trace[l] += gram[i][i][l];
        }
    }
    let power = trace_of_power(&gram, &trace.map(|trace| 1.0 / math::larger(trace, Real::MIN_POSITIVE)));
    core::array::from_fn(|l| {
        let mut root = power[l];
        for _ in 0..=SQUARINGS {
            root = math::sqrt(root);
        }
        4.0 / (trace[l] * root + volumetric[l])
    })
}

/// Whether a step is stable in each cell, without a root; true where the state is not a number.
#[inline(always)]
pub(crate) fn within_limit(stiffness: &CellStiffness, step_squared: Real) -> [bool; LANES] {
    let (gram, volumetric) = eigenvalue_parts(stiffness);
    let mut inverse = ZERO;
    for l in 0..LANES {
        inverse[l] = 1.0 / (4.0 / step_squared - volumetric[l]);
    }
    let power = trace_of_power(&gram, &inverse);
    core::array::from_fn(|l| !(power[l] > 1.0 || inverse[l] < 0.0))
}

/// The Gram matrix of the deviatoric rows, and the eigenvalue of the mean dilatation, both over the mass, 1/s2.
#[inline(always)]
fn eigenvalue_parts(stiffness: &CellStiffness) -> (Matrix, Lane) {
    let mut rows = [[[ZERO; 2]; 4]; ROWS];
    let mut dilatation = [[ZERO; 2]; 4];
    for t in 0..2 {
        add_triangle(stiffness, t, &mut rows, &mut dilatation);
    }
    let inverse_mass = inverse_mass(stiffness);
    let mut gram = [[ZERO; ROWS]; ROWS];
    for i in 0..ROWS {
        for j in 0..=i {
            let product = dot(&rows[i], &rows[j], &inverse_mass);
            gram[i][j] = product;
            gram[j][i] = product;
        }
    }
    let mut volumetric = dot(&dilatation, &dilatation, &inverse_mass);
    for l in 0..LANES {
        volumetric[l] *= stiffness.bulk[l] * cell_volume(stiffness, l);
    }
    (gram, volumetric)
}

fn cell_volume(stiffness: &CellStiffness, l: usize) -> Real {
    let [a, b] = &stiffness.cell.triangle;
    a.reference_volume[l] + b.reference_volume[l]
}

/// 1/m of a corner.
#[inline(always)]
fn inverse_mass(stiffness: &CellStiffness) -> Lane {
    let mut inverse = ZERO;
    for l in 0..LANES {
        let mass = 0.25 * stiffness.density * cell_volume(stiffness, l);
        inverse[l] = 1.0 / math::larger(mass, Real::MIN_POSITIVE);
    }
    inverse
}

/// Sum over the corners of `a` times `b`, times `scale`.
#[inline(always)]
fn dot(a: &Row, b: &Row, scale: &Lane) -> Lane {
    let mut sum = ZERO;
    for (a, b) in a.iter().flatten().zip(b.iter().flatten()) {
        for l in 0..LANES {
            sum[l] += a[l] * b[l];
        }
    }
    for l in 0..LANES {
        sum[l] *= scale[l];
    }
    sum
}

/// The three deviatoric rows of triangle `t`, times the root of G V, and its part of the mean dilatation.
#[inline(always)]
fn add_triangle(stiffness: &CellStiffness, t: usize, rows: &mut [Row; ROWS], dilatation: &mut Row) {
    let triangle = &stiffness.cell.triangle[t];
    let gradient = corner_gradients(stiffness, t);
    for l in 0..LANES {
        let stiff = stiffness.shear[t][l] * triangle.reference_volume[l];
        let root = stiff * math::inverse_sqrt(math::larger(stiff, Real::MIN_POSITIVE));
        let weight = triangle.patch_weight[l];
        for a in 0..4 {
            let [x, y] = [gradient[a][0][l], gradient[a][1][l]];
            let hoop = match &stiffness.hoop {
                Some(hoop) => hoop.weight[t][a][l] * stiffness.hoop_scale[t][l],
                None => 0.0,
            };
            rows[3 * t][a][0][l] = root * SQRT_THIRD * (x - 2.0 * hoop);
            rows[3 * t][a][1][l] = root * SQRT_THIRD * y;
            rows[3 * t + 1][a][0][l] = root * x;
            rows[3 * t + 1][a][1][l] = -root * y;
            rows[3 * t + 2][a][0][l] = root * y;
            rows[3 * t + 2][a][1][l] = root * x;
            dilatation[a][0][l] += weight * (x + hoop);
            dilatation[a][1][l] += weight * y;
        }
    }
}

/// U^-1 dN_a/dX of the four corners: the spatial gradients but for a rotation.
#[inline(always)]
fn corner_gradients(stiffness: &CellStiffness, t: usize) -> Row {
    let mut gradient = [[ZERO; 2]; 4];
    let [v11, v22, v12] = &stiffness.inverse_stretch[t];
    for l in 0..LANES {
        let [g, h] = stiffness.cell.triangle[t].shape_gradient.map(|[x, y]| {
            let (x, y) = (x[l], y[l]);
            [v11[l] * x + v12[l] * y, v12[l] * x + v22[l] * y]
        });
        let rising = stiffness.cell.rising[l] > 0.0;
        for i in 0..2 {
            // Each edge has its start and its end; the one across is the left or the right one.
            let right = (t == 0) == rising;
            let (at_right, at_left) = if right { (h[i], 0.0) } else { (0.0, h[i]) };
            let (bottom, top) = if t == 0 { (g[i], 0.0) } else { (0.0, g[i]) };
            gradient[0][i][l] = -(bottom + at_left);
            gradient[1][i][l] = bottom - at_right;
            gradient[2][i][l] = top + at_right;
            gradient[3][i][l] = at_left - top;
        }
    }
    gradient
}

/// trace((scale A)^(2^(SQUARINGS + 1))).
#[inline(always)]
fn trace_of_power(matrix: &Matrix, scale: &Lane) -> Lane {
    let mut power = *matrix;
    for lane in power.iter_mut().flatten() {
        for l in 0..LANES {
            lane[l] *= scale[l];
        }
    }
    for _ in 0..SQUARINGS {
        power = square(&power);
    }
    let mut trace = ZERO;
    for lane in power.iter().flatten() {
        for l in 0..LANES {
            trace[l] += lane[l] * lane[l];
        }
    }
    trace
}

/// The square of a symmetric matrix.
#[inline(always)]
fn square(matrix: &Matrix) -> Matrix {
    let mut product = [[ZERO; ROWS]; ROWS];
    for i in 0..ROWS {
        for j in 0..=i {
            let mut sum = ZERO;
            for (a, b) in matrix[i].iter().zip(&matrix[j]) {
                for l in 0..LANES {
                    sum[l] += a[l] * b[l];
                }
            }
            product[i][j] = sum;
            product[j][i] = sum;
        }
    }
    product
}

/// The square root of 1/3, rounded once.
const SQRT_THIRD: Real = 0.577_350_269_189_625_8;
