//! The highest frequency of single cells.
//!
//! With the mass m at each corner, omega^2 m is the largest eigenvalue of the cell's stiffness
//!
//! K = sum over triangles t of G_t V_t (r1 r1' + r2 r2' + r3 r3') + kappa V b b',
//!
//! where r1 = (e11 + e22 - 2 e33) / sqrt 3, r2 = e11 - e22 and r3 = 2 e12 are the deviatoric strains of a triangle and b
//! the mean dilatation of the cell, all as rows over the displacements of the corners, with the current (spatial) gradients.
//! The same eigenvalue has the 7 x 7 Gram matrix A of these rows, each times the root of its factor. A step is stable where
//! 4 / dt^2 - A is positive definite, which the pivots of its elimination tell without a root. What makes the moduli G and
//! kappa a bound is said in [`crate::material`].

use crate::element::Block;
use crate::lanes::SQRT_THIRD;
use crate::real::Real;
use crate::vector::{Instructions, Vector};

/// Rows of deviatoric strain of the two triangles, and the mean dilatation.
const ROWS: usize = 7;
/// Halvings of the interval that holds the largest stable step.
const HALVINGS: usize = 30;

/// Neighbouring cells in some state of deformation.
pub(crate) struct CellStiffness<V> {
    /// U^-1 of the section of each triangle: 11, 22, 12.
    pub inverse_stretch: [[V; 3]; 2],
    /// 1/U33 of each triangle.
    pub hoop_scale: [V; 2],
    /// Shear tangent of each triangle, Pa.
    pub shear: [V; 2],
    /// Tangent of the volume, Pa.
    pub bulk: V,
}

/// A row over the displacements of the four corners.
type Row<V> = [[V; 2]; 4];
/// A symmetric matrix, of which the lower triangle is in use.
type Matrix<V> = [[V; ROWS]; ROWS];

/// Square of the largest stable step of each cell, s2, to one part in 10^8 from below.
pub(crate) fn limit_squared<S: Instructions>(matrix: &Matrix<S::Vector>, set: S) -> S::Vector {
    let mut trace = set.splat(Real::MIN_POSITIVE);
    for (i, row) in matrix.iter().enumerate() {
        trace = trace + row[i];
    }
    // The largest eigenvalue lies between the mean of all and their sum.
    let mut stable = set.splat(4.0) / trace;
    let mut beyond = stable.times(ROWS as Real);
    for _ in 0..HALVINGS {
        let middle = (stable + beyond).times(0.5);
        let lost = unstable(set, matrix, set.splat(4.0) / middle);
        let zero = set.splat(0.0);
        (stable, beyond) = (lost.if_greater(zero, stable, middle), lost.if_greater(zero, middle, beyond));
    }
    stable
}

/// 1 where the largest eigenvalue exceeds `limit`, 0 elsewhere and where the state is not a number.
#[inline(always)]
pub(crate) fn unstable<S: Instructions>(set: S, matrix: &Matrix<S::Vector>, limit: S::Vector) -> S::Vector {
    let (one, smallest) = (set.splat(1.0), set.splat(Real::MIN_POSITIVE));
    let mut unstable = set.splat(0.0);
    let mut rest = *matrix;
    for k in 0..ROWS {
        let pivot = limit - rest[k][k];
        unstable = smallest.if_greater(pivot, one, unstable);
        let inverse = one / pivot;
        for i in k + 1..ROWS {
            let factor = rest[i][k] * inverse;
            for j in k + 1..=i {
                rest[i][j] = rest[i][j] + factor * rest[j][k];
            }
        }
    }
    unstable
}

/// The Gram matrix of the rows of neighbouring cells over their mass, 1/s2.
#[inline(always)]
pub(crate) fn gram<S: Instructions>(
    set: S,
    chunk: usize,
    block: &Block,
    stiffness: &CellStiffness<S::Vector>,
) -> Matrix<S::Vector> {
    let zero = set.splat(0.0);
    let mut rows = [[[zero; 2]; 4]; ROWS];
    for t in 0..2 {
        add_triangle(set, chunk, block, stiffness, t, &mut rows);
    }
    let [a, b] = &block.constants.triangle;
    let volume = set.load(&a.reference_volume, chunk) + set.load(&b.reference_volume, chunk);
    let root = (stiffness.bulk * volume).square_root();
    for corner in 0..4 {
        for i in 0..2 {
            rows[ROWS - 1][corner][i] = root * rows[ROWS - 1][corner][i];
        }
    }
    let smallest = set.splat(Real::MIN_POSITIVE);
    let mass = volume.times(0.25 * block.laws.density);
    let inverse_mass = set.splat(1.0) / mass.if_greater(smallest, mass, smallest);
    let mut gram = [[zero; ROWS]; ROWS];
    for i in 0..ROWS {
        for j in 0..=i {
            gram[i][j] = dot(&rows[i], &rows[j]) * inverse_mass;
        }
    }
    gram
}

#[inline(always)]
fn dot<V: Vector>(a: &Row<V>, b: &Row<V>) -> V {
    let mut sum = a[0][0] * b[0][0] + a[0][1] * b[0][1];
    for corner in 1..4 {
        sum = sum + (a[corner][0] * b[corner][0] + a[corner][1] * b[corner][1]);
    }
    sum
}

/// The three deviatoric rows of triangle `t`, times the root of G V, and its part of the mean dilatation.
#[inline(always)]
fn add_triangle<S: Instructions>(
    set: S,
    chunk: usize,
    block: &Block,
    stiffness: &CellStiffness<S::Vector>,
    t: usize,
    rows: &mut [Row<S::Vector>; ROWS],
) {
    let triangle = &block.constants.triangle[t];
    let gradient = corner_gradients(set, chunk, block, stiffness, t);
    let root = (stiffness.shear[t] * set.load(&triangle.reference_volume, chunk)).square_root();
    let third = root.times(SQRT_THIRD);
    let weight = set.load(&triangle.patch_weight, chunk);
    let zero = set.splat(0.0);
    for a in 0..4 {
        let [x, y] = gradient[a];
        let (mut out, mut around) = (x, x);
        if let Some(hoop) = block.hoop {
            let hoop = set.load(&hoop.weight[t][a], chunk) * stiffness.hoop_scale[t];
            out = x - hoop.times(2.0);
            around = x + hoop;
        }
        rows[3 * t][a] = [third * out, third * y];
        rows[3 * t + 1][a] = [root * x, zero - root * y];
        rows[3 * t + 2][a] = [root * y, root * x];
        let dilatation = &mut rows[ROWS - 1][a];
        *dilatation = [dilatation[0] + weight * around, dilatation[1] + weight * y];
    }
}

/// U^-1 dN_a/dX of the four corners: the spatial gradients but for a rotation.
#[inline(always)]
fn corner_gradients<S: Instructions>(
    set: S,
    chunk: usize,
    block: &Block,
    stiffness: &CellStiffness<S::Vector>,
    t: usize,
) -> Row<S::Vector> {
    let [v11, v22, v12] = stiffness.inverse_stretch[t];
    let zero = set.splat(0.0);
    let mut edges = [[zero; 2]; 2];
    for edge in 0..2 {
        let [x, y] = set.load_pair(&block.constants.triangle[t].shape_gradient[edge], chunk);
        edges[edge] = [v11 * x + v12 * y, v12 * x + v22 * y];
    }
    let rising = set.load(&block.constants.rising, chunk);
    let mut gradient = [[zero; 2]; 4];
    for i in 0..2 {
        let (along, across) = (edges[0][i], edges[1][i]);
        // Each edge has its start and its end; the one across is the right one in the first triangle of a rising diagonal.
        let (one, other) = (rising.if_greater(zero, across, zero), rising.if_greater(zero, zero, across));
        let (right, left) = if t == 0 { (one, other) } else { (other, one) };
        let (bottom, top) = if t == 0 { (along, zero) } else { (zero, along) };
        gradient[0][i] = zero - (bottom + left);
        gradient[1][i] = bottom - right;
        gradient[2][i] = top + right;
        gradient[3][i] = left - top;
    }
    gradient
}
