//! The highest frequency of single cells.
//!
//! With the mass m at each corner, omega^2 m is the largest eigenvalue of the cell's stiffness
//!
//! K = sum over triangles t of G_t V_t (r r' / 3 + p p' + q q') + kappa V b b',
//!
//! where r = e11 + e22 - 2 e33, p = e11 - e22 and q = 2 e12 are the deviatoric strains of a triangle and b the mean
//! dilatation of the cell, all as rows over the displacements of the corners, with the current (spatial) gradients. A step dt
//! is stable where dt^2 omega^2 < 4. With m = rho V / 4 that is where all eigenvalues of E A are below 1: A has the products
//! of the seven rows, and E is diagonal, dt^2 / rho times w_t G_t / 3, w_t G_t, w_t G_t and kappa, where w_t = V_t / V.
//! What makes the moduli G and kappa a bound is said in [`crate::material`].
//!
//! With z = p + i q, the products of p and q with those of either triangle are complex numbers, and the elimination of both z
//! takes one division. It leaves r of the triangles and b; b is the mean of r and three times the mean hoop strain h.

use crate::element::{Block, HoopConstants};
use crate::number::complex::Complex;
use crate::number::math::THIRD;
use crate::number::pack::ZERO;
use crate::number::real::Real;
use crate::number::real::consts::SQRT_2;
use crate::number::vector::{Simd, Vector};

/// Rows of strain of a cell.
const ROWS: usize = 7;
/// Halvings of the interval that holds the largest stable step.
pub(crate) const HALVINGS: usize = 30;

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

/// What decides on the stability of neighbouring cells. Products of rows are in 1/m2.
pub(crate) struct CellMatrix<V> {
    /// w G / rho of both triangles, then kappa / rho, m2/s2.
    moduli: [V; 3],
    /// w of both triangles.
    weight: [V; 2],
    /// p p' of both triangles, which is q q' as well; p q' is zero.
    square: [V; 2],
    /// p p' + i p q' of the first triangle with the second.
    cross: Complex<V>,
    /// Products of r of the triangles: first with first, first with second, second with second.
    real: [V; 3],
    /// Products of r of both triangles with z of both.
    mixed: [[Complex<V>; 2]; 2],
    /// Products of h, if axisymmetric.
    hoop: Option<HoopRow<V>>,
}

/// Products of the mean hoop strain of a cell.
struct HoopRow<V> {
    /// With r of both triangles, then with itself.
    real: [V; 3],
    /// With z of both triangles.
    mixed: [Complex<V>; 2],
}

/// Square of the largest stable step of each cell, s2, to one part in 10^8 from below; at most `bound`.
#[inline(always)]
pub(crate) fn limit_squared<S: Simd>(simd: S, matrix: &CellMatrix<S::Vector>, bound: S::Vector) -> S::Vector {
    let CellMatrix { moduli, square, real, hoop, .. } = matrix;
    let shear =
        [real[0].mul_scalar(THIRD) + square[0].mul_scalar(2.0), real[2].mul_scalar(THIRD) + square[1].mul_scalar(2.0)];
    let [.., volume] = dilatation(&matrix.weight, real, hoop.as_ref().map(|row| &row.real));
    let trace = moduli[0] * shear[0] + moduli[1] * shear[1] + moduli[2] * volume;
    // The largest eigenvalue lies between the mean of all and their sum.
    let zero = simd.splat(0.0);
    let mut stable = simd.splat(1.0) / trace.max(simd.splat(Real::MIN_POSITIVE));
    let mut beyond = stable.mul_scalar(ROWS as Real);
    beyond = beyond.select_greater(bound, bound, beyond);
    let mut probe = beyond;
    for _ in 0..=HALVINGS {
        let lost = unstable(simd, matrix, probe);
        (stable, beyond) = (lost.select_greater(zero, stable, probe), lost.select_greater(zero, probe, beyond));
        probe = (stable + beyond).mul_scalar(0.5);
        let mut open = ZERO;
        simd.store(beyond - stable, &mut open, 0);
        if open == ZERO {
            break;
        }
    }
    stable
}

/// 1 where the step of this square is too large, 0 elsewhere and where the state is not a number.
#[inline(always)]
pub(crate) fn unstable<S: Simd>(simd: S, matrix: &CellMatrix<S::Vector>, step_squared: S::Vector) -> S::Vector {
    let CellMatrix { moduli, weight, square, cross, real, mixed, hoop } = matrix;
    let one = simd.splat(1.0);
    let factor = [moduli[0] * step_squared, moduli[1] * step_squared, moduli[2] * step_squared];
    // 1 - E A of both z, and the inverse of what it is times 1 / E.
    let own = [one - factor[0] * square[0], one - factor[1] * square[1]];
    let both = factor[0] * factor[1];
    let determinant = own[0] * own[1] - both * cross.dot(cross);
    let inverse = one / determinant;
    let elimination = Elimination {
        diagonal: [factor[0] * own[1] * inverse, factor[1] * own[0] * inverse],
        across: cross.scaled(both * inverse),
    };
    // The products of the other rows, with what the elimination adds.
    let effect = [elimination.effect(&mixed[0]), elimination.effect(&mixed[1])];
    let rest = [
        real[0] + product(&mixed[0], &effect[0]),
        real[1] + product(&mixed[1], &effect[0]),
        real[2] + product(&mixed[1], &effect[1]),
    ];
    let rest_of_hoop = elimination.rest_of_hoop(hoop.as_ref(), &effect);
    let dilatation = dilatation(weight, &rest, rest_of_hoop.as_ref());
    let factor = [factor[0].mul_scalar(THIRD), factor[1].mul_scalar(THIRD), factor[2]];
    let minors = leading_minors(simd, &factor, &rest, &dilatation);
    // Positive definite is what has positive leading minors.
    let mut unstable = simd.splat(0.0);
    for minor in [own[0], determinant, minors[0], minors[1], minors[2]] {
        unstable = simd.splat(Real::MIN_POSITIVE).select_greater(minor, one, unstable);
    }
    unstable
}

/// The inverse of the block of both z.
struct Elimination<V> {
    diagonal: [V; 2],
    across: Complex<V>,
}

impl<V: Vector> Elimination<V> {
    /// The inverse times the products of a row with both z.
    #[inline(always)]
    fn effect(&self, [z, y]: &[Complex<V>; 2]) -> [Complex<V>; 2] {
        [z.scaled(self.diagonal[0]) + self.across.conjugate() * *y, y.scaled(self.diagonal[1]) + self.across * *z]
    }

    /// The products of the hoop strain with what is added, where those of r with both z have the effects `of_r`.
    #[inline(always)]
    fn rest_of_hoop(&self, row: Option<&HoopRow<V>>, of_r: &[[Complex<V>; 2]; 2]) -> Option<[V; 3]> {
        let HoopRow { real, mixed } = row?;
        Some([
            real[0] + product(mixed, &of_r[0]),
            real[1] + product(mixed, &of_r[1]),
            real[2] + product(mixed, &self.effect(mixed)),
        ])
    }
}

#[inline(always)]
fn product<V: Vector>(mixed: &[Complex<V>; 2], effect: &[Complex<V>; 2]) -> V {
    mixed[0].dot(&effect[0]) + mixed[1].dot(&effect[1])
}

/// Products of b with r of both triangles, then with itself, from those of r and, if axisymmetric, of h.
#[inline(always)]
fn dilatation<V: Vector>([w, x]: &[V; 2], [first, across, second]: &[V; 3], hoop: Option<&[V; 3]>) -> [V; 3] {
    let mean = [*w * *first + *x * *across, *w * *across + *x * *second];
    match hoop {
        Some([a, b, c]) => {
            let with = [mean[0] + a.mul_scalar(3.0), mean[1] + b.mul_scalar(3.0)];
            let with_hoop = *w * *a + *x * *b + c.mul_scalar(3.0);
            [with[0], with[1], *w * with[0] + *x * with[1] + with_hoop.mul_scalar(3.0)]
        }
        None => [mean[0], mean[1], *w * mean[0] + *x * mean[1]],
    }
}

/// Leading minors of 1 - E A for diagonal E and the symmetric A of r of both triangles and b.
#[inline(always)]
fn leading_minors<S: Simd>(
    simd: S,
    e: &[S::Vector; 3],
    [a00, a10, a11]: &[S::Vector; 3],
    [a20, a21, a22]: &[S::Vector; 3],
) -> [S::Vector; 3] {
    let one = simd.splat(1.0);
    let diagonal = [one - e[0] * *a00, one - e[1] * *a11, one - e[2] * *a22];
    let (of_first, of_second) = (e[0] * *a10, e[1] * *a10);
    let first_two = diagonal[0] * diagonal[1] - of_first * of_second;
    let (first, second) = (e[0] * *a20, e[1] * *a21);
    let across =
        diagonal[0] * (second * *a21) + diagonal[1] * (first * *a20) + (of_first * second * *a20).mul_scalar(2.0);
    [diagonal[0], first_two, first_two * diagonal[2] - e[2] * across]
}

/// The matrix of neighbouring cells.
#[inline(always)]
pub(crate) fn cell_matrix<S: Simd>(
    simd: S,
    chunk: usize,
    block: &Block,
    stiffness: &CellStiffness<S::Vector>,
) -> CellMatrix<S::Vector> {
    let [first, second] = &block.constants.triangle;
    let weight = [simd.load(&first.volume_fraction, chunk), simd.load(&second.volume_fraction, chunk)];
    let shear = [weight[0] * stiffness.shear[0], weight[1] * stiffness.shear[1]];
    let inverse_density = simd.splat(1.0 / block.laws.density);
    let moduli = [shear[0] * inverse_density, shear[1] * inverse_density, stiffness.bulk * inverse_density];
    // Gradients of edges as complex numbers. With those along the row reversed where the diagonal rises, the rows of the
    // corners have these products: 2 of an edge with itself, 1 of the two edges of a triangle, -1 of edges along and across of
    // different triangles, 0 of others.
    let [[a, b], [c, d]] =
        [edge_gradients(simd, chunk, block, stiffness, 0), edge_gradients(simd, chunk, block, stiffness, 1)];
    let (square, own) = own_products([&a, &b]);
    let (other_square, other) = own_products([&c, &d]);
    let cross = (a.conjugate() * d + b.conjugate() * c).mul_scalar(-1.0);
    let mixed = (a * d + b * c).mul_scalar(-1.0);
    let mut matrix = CellMatrix {
        moduli,
        weight,
        square: [square, other_square],
        cross,
        real: [square, cross.re, other_square],
        mixed: [[own, mixed], [mixed, other]],
        hoop: None,
    };
    if let Some(HoopConstants { weight: [first, second] }) = block.hoop {
        // Whichever way the diagonal runs, the first triangle has corner 1 and the second corner 3.
        let e = simd.load(&first[1], chunk) * stiffness.hoop_scale[0];
        let f = simd.load(&second[3], chunk) * stiffness.hoop_scale[1];
        matrix.add_hoop([e, f], [&(a + b), &(c + d)]);
    }
    matrix
}

/// |z|^2 / 2 and z z of a triangle from the gradients of its edges: twice a a* + b b* + a b and a a + b b + a b.
#[inline(always)]
fn own_products<V: Vector>([a, b]: [&Complex<V>; 2]) -> (V, Complex<V>) {
    // (a + b/2)^2 + 3/4 b^2.
    let (c, d) = ((*a + b.mul_scalar(0.5)).mul_scalar(SQRT_2), b.mul_scalar(SQRT_THREE_HALVES));
    let [re, im] = [c.re * c.re + d.re * d.re, c.im * c.im + d.im * d.im];
    (re + im, Complex { re: re - im, im: (c.re * c.im + d.re * d.im).mul_scalar(2.0) })
}

impl<V: Vector> CellMatrix<V> {
    /// Takes the hoop strain into r, and adds its row. That of a triangle is `hoop` at all its corners, over which the
    /// gradients add up to nothing; `outer` is less the gradient of the corner that it does not share.
    #[inline(always)]
    fn add_hoop(&mut self, [e, f]: [V; 2], outer: [&Complex<V>; 2]) {
        let [w, x] = self.weight;
        // Products of the triangles' hoop strains with each other and with z, whose real part is that with e11 + e22.
        let (first, across, second) = ((e * e).mul_scalar(3.0), (e * f).mul_scalar(2.0), (f * f).mul_scalar(3.0));
        let (with_second, with_first) = (outer[1].scaled(e).mul_scalar(-1.0), outer[0].scaled(f));
        self.hoop = Some(HoopRow {
            real: [
                x * with_first.re - (w * first + x * across).mul_scalar(2.0),
                w * with_second.re - (w * across + x * second).mul_scalar(2.0),
                w * (w * first + x * across) + x * (w * across + x * second),
            ],
            mixed: [with_first.scaled(x), with_second.scaled(w)],
        });
        self.real[0] = self.real[0] + first.mul_scalar(4.0);
        self.real[1] = self.real[1] + across.mul_scalar(4.0) - (with_first.re + with_second.re).mul_scalar(2.0);
        self.real[2] = self.real[2] + second.mul_scalar(4.0);
        self.mixed[0][1] = self.mixed[0][1] + with_second.mul_scalar(-2.0);
        self.mixed[1][0] = self.mixed[1][0] + with_first.mul_scalar(-2.0);
    }
}

/// U^-1 times the gradients of a triangle's edges: the spatial ones but for a rotation. That along the row, reversed where
/// the diagonal rises, then that across.
#[inline(always)]
fn edge_gradients<S: Simd>(
    simd: S,
    chunk: usize,
    block: &Block,
    stiffness: &CellStiffness<S::Vector>,
    t: usize,
) -> [Complex<S::Vector>; 2] {
    let [v11, v22, v12] = stiffness.inverse_stretch[t];
    let zero = simd.splat(0.0);
    let mut edges = [Complex { re: zero, im: zero }; 2];
    for edge in 0..2 {
        let [x, y] = simd.load_pair(&block.constants.triangle[t].shape_gradient[edge], chunk);
        edges[edge] = Complex { re: v11 * x + v12 * y, im: v12 * x + v22 * y };
    }
    let (diagonal, reversed) = (simd.load(&block.constants.diagonal, chunk), edges[0].mul_scalar(-1.0));
    edges[0].re = diagonal.select_greater(zero, reversed.re, edges[0].re);
    edges[0].im = diagonal.select_greater(zero, reversed.im, edges[0].im);
    edges
}
/// The square root of 3/2, rounded once.
const SQRT_THREE_HALVES: Real = 1.224_744_871_391_589;
