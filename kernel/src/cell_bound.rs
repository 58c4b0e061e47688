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
//! takes one division. It leaves r of the two triangles and b.

use crate::complex::Complex;
use crate::element::{Block, HoopConstants};
use crate::real::Real;
use crate::vector::{Instructions, Vector};

/// Rows of strain of a cell.
const ROWS: usize = 7;
/// Halvings of the interval that holds the largest stable step.
const HALVINGS: usize = 30;
/// Parts of the hoop strain in r and in the dilatation, for one of e11 + e22.
const DEVIATORIC: Real = -2.0;
const DILATATION: Real = 1.0;

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

/// What decides on the stability of neighbouring cells.
pub(crate) struct CellMatrix<V> {
    /// w G / rho of both triangles, then kappa / rho, m2/s2.
    moduli: [V; 3],
    /// p p' of both triangles, which is q q' as well, 1/m2. p q' is zero.
    square: [V; 2],
    /// p p' + i p q' of the first triangle with the second, 1/m2.
    cross: Complex<V>,
    /// Products of r of both triangles and b, 1/m2; the lower triangle is in use.
    real: [[V; 3]; 3],
    /// Products of these with z of both triangles, 1/m2.
    mixed: [[Complex<V>; 2]; 3],
}

/// Square of the largest stable step of each cell, s2, to one part in 10^8 from below.
pub(crate) fn limit_squared<S: Instructions>(set: S, matrix: &CellMatrix<S::Vector>) -> S::Vector {
    let CellMatrix { moduli, square, real, .. } = matrix;
    let mut trace = moduli[2] * real[2][2];
    for t in 0..2 {
        trace = trace + moduli[t] * (real[t][t].times(THIRD) + square[t].times(2.0));
    }
    // The largest eigenvalue lies between the mean of all and their sum.
    let zero = set.splat(0.0);
    let mut stable = set.splat(1.0) / trace.larger(set.splat(Real::MIN_POSITIVE));
    let mut beyond = stable.times(ROWS as Real);
    for _ in 0..HALVINGS {
        let middle = (stable + beyond).times(0.5);
        let lost = unstable(set, matrix, middle);
        (stable, beyond) = (lost.if_greater(zero, stable, middle), lost.if_greater(zero, middle, beyond));
    }
    stable
}

/// 1 where the step of this square is too large, 0 elsewhere and where the state is not a number.
#[inline(always)]
pub(crate) fn unstable<S: Instructions>(set: S, matrix: &CellMatrix<S::Vector>, step_squared: S::Vector) -> S::Vector {
    let CellMatrix { moduli, square, cross, real, mixed } = matrix;
    let one = set.splat(1.0);
    let factor = [moduli[0] * step_squared, moduli[1] * step_squared, moduli[2] * step_squared];
    // 1 - E A of both z, and the inverse of what it is times 1 / E.
    let own = [one - factor[0] * square[0], one - factor[1] * square[1]];
    let both = factor[0] * factor[1];
    let determinant = own[0] * own[1] - both * cross.dot(cross);
    let inverse = one / determinant;
    let diagonal = [factor[0] * own[1] * inverse, factor[1] * own[0] * inverse];
    let across = cross.scaled(both * inverse);
    // A of the real rows, with what the elimination of both z adds.
    let mut rest = *real;
    for i in 0..3 {
        let [z, y] = mixed[i];
        let effect = [z.scaled(diagonal[0]) + across.conjugate() * y, y.scaled(diagonal[1]) + across * z];
        for j in 0..=i {
            rest[i][j] = rest[i][j] + (mixed[j][0].dot(&effect[0]) + mixed[j][1].dot(&effect[1]));
        }
    }
    let factor = [factor[0].times(THIRD), factor[1].times(THIRD), factor[2]];
    let minors = leading_minors(set, &factor, &rest);
    // Positive definite is what has positive leading minors.
    let mut unstable = set.splat(0.0);
    for minor in [own[0], determinant, minors[0], minors[1], minors[2]] {
        unstable = set.splat(Real::MIN_POSITIVE).if_greater(minor, one, unstable);
    }
    unstable
}

/// Leading minors of 1 - E A for diagonal E and symmetric A.
#[inline(always)]
fn leading_minors<S: Instructions>(set: S, e: &[S::Vector; 3], a: &[[S::Vector; 3]; 3]) -> [S::Vector; 3] {
    let one = set.splat(1.0);
    let diagonal = [one - e[0] * a[0][0], one - e[1] * a[1][1], one - e[2] * a[2][2]];
    let (a10, a20, a21) = (a[1][0], a[2][0], a[2][1]);
    let first_two = diagonal[0] * diagonal[1] - (e[0] * a10) * (e[1] * a10);
    let with_third = diagonal[0] * ((e[1] * a21) * (e[2] * a21)) + diagonal[1] * ((e[0] * a20) * (e[2] * a20));
    let around = (e[0] * a10) * (e[1] * a21) * (e[2] * a20);
    [diagonal[0], first_two, first_two * diagonal[2] - (with_third + around.times(2.0))]
}

/// The matrix of neighbouring cells.
#[inline(always)]
pub(crate) fn cell_matrix<S: Instructions>(
    set: S,
    chunk: usize,
    block: &Block,
    stiffness: &CellStiffness<S::Vector>,
) -> CellMatrix<S::Vector> {
    let [first, second] = &block.constants.triangle;
    let weight = [set.load(&first.patch_weight, chunk), set.load(&second.patch_weight, chunk)];
    let products = Products::new(set, chunk, block, stiffness);
    let zero = set.splat(0.0);
    let none = Complex { re: zero, im: zero };
    let (mut real, mut mixed) = ([[zero; 3]; 3], [[none; 2]; 3]);
    for s in 0..2 {
        for t in 0..2 {
            real[s][t] = products.real(s, DEVIATORIC, t, DEVIATORIC);
            mixed[s][t] = products.mixed(s, DEVIATORIC, t);
            // b is the mean of the triangles' dilatations.
            real[2][t] = real[2][t] + weight[s] * products.real(s, DILATATION, t, DEVIATORIC);
            mixed[2][t] = mixed[2][t] + products.mixed(s, DILATATION, t).scaled(weight[s]);
            real[2][2] = real[2][2] + (weight[s] * weight[t]) * products.real(s, DILATATION, t, DILATATION);
        }
    }
    let inverse_density = 1.0 / block.laws.density;
    let shear = [weight[0] * stiffness.shear[0], weight[1] * stiffness.shear[1]];
    CellMatrix {
        moduli: [
            shear[0].times(inverse_density),
            shear[1].times(inverse_density),
            stiffness.bulk.times(inverse_density),
        ],
        square: [products.plane[0][0], products.plane[1][1]],
        cross: products.cross,
        real,
        mixed,
    }
}

/// Products of the rows e11 + e22, h = e33 and z of the two triangles, 1/m2.
struct Products<V> {
    /// Of e11 + e22 with each other.
    plane: [[V; 2]; 2],
    /// Of e11 + e22 with z.
    mixed: [[Complex<V>; 2]; 2],
    /// See [`CellMatrix`].
    cross: Complex<V>,
    /// In rings.
    hoop: Option<HoopProducts<V>>,
}

/// Products of the hoop strains, 1/m2.
struct HoopProducts<V> {
    /// With each other.
    hoop: [[V; 2]; 2],
    /// With z, whose real part is that with e11 + e22.
    mixed: [[Complex<V>; 2]; 2],
}

impl<V: Vector> Products<V> {
    /// Takes the gradients of a triangle's two edges as complex numbers. With those along the row reversed where the diagonal
    /// rises, its corners have the products 2 of an edge with itself and 1 of the two; the edges along and across of different
    /// triangles have -1, others 0.
    #[inline(always)]
    fn new<S: Instructions<Vector = V>>(set: S, chunk: usize, block: &Block, stiffness: &CellStiffness<V>) -> Self {
        let [[a, b], [c, d]] =
            [edge_gradients(set, chunk, block, stiffness, 0), edge_gradients(set, chunk, block, stiffness, 1)];
        let norm = [a.dot(&a) + b.dot(&b) + a.dot(&b), c.dot(&c) + d.dot(&d) + c.dot(&d)];
        let square = [a * a + b * b + a * b, c * c + d * d + c * d];
        let cross = (a.conjugate() * d + b.conjugate() * c).times(-1.0);
        let mixed = (a * d + b * c).times(-1.0);
        Self {
            plane: [[norm[0].times(2.0), cross.re], [cross.re, norm[1].times(2.0)]],
            mixed: [[square[0].times(2.0), mixed], [mixed, square[1].times(2.0)]],
            cross,
            hoop: match block.hoop {
                Some(hoop) => Some(HoopProducts::new(set, chunk, hoop, stiffness, [a + b, c + d])),
                None => None,
            },
        }
    }

    /// Of e11 + e22 + `with` e33 of triangle `s` and e11 + e22 + `and` e33 of triangle `t`.
    #[inline(always)]
    fn real(&self, s: usize, with: Real, t: usize, and: Real) -> V {
        match &self.hoop {
            None => self.plane[s][t],
            Some(HoopProducts { hoop, mixed }) => {
                self.plane[s][t]
                    + (mixed[s][t].re.times(with) + mixed[t][s].re.times(and) + hoop[s][t].times(with * and))
            }
        }
    }

    /// Of e11 + e22 + `with` e33 of triangle `s` and z of triangle `t`.
    #[inline(always)]
    fn mixed(&self, s: usize, with: Real, t: usize) -> Complex<V> {
        match &self.hoop {
            None => self.mixed[s][t],
            Some(hoop) => self.mixed[s][t] + hoop.mixed[s][t].times(with),
        }
    }
}

impl<V: Vector> HoopProducts<V> {
    /// A triangle's hoop strain is the same of all its corners, over which gradients add up to nothing; `outer` is less the
    /// gradient of the corner that a triangle does not share.
    #[inline(always)]
    fn new<S: Instructions<Vector = V>>(
        set: S,
        chunk: usize,
        HoopConstants { weight: [first, second] }: &HoopConstants,
        stiffness: &CellStiffness<V>,
        outer: [Complex<V>; 2],
    ) -> Self {
        // Whichever way the diagonal runs, the first triangle has corner 1 and the second corner 3.
        let e = set.load(&first[1], chunk) * stiffness.hoop_scale[0];
        let f = set.load(&second[3], chunk) * stiffness.hoop_scale[1];
        let zero = set.splat(0.0);
        let none = Complex { re: zero, im: zero };
        let shared = (e * f).times(2.0);
        Self {
            hoop: [[(e * e).times(3.0), shared], [shared, (f * f).times(3.0)]],
            mixed: [[none, outer[1].scaled(e).times(-1.0)], [outer[0].scaled(f), none]],
        }
    }
}

/// U^-1 times the gradients of a triangle's edges: the spatial ones but for a rotation. That along the row, reversed where
/// the diagonal rises, then that across.
#[inline(always)]
fn edge_gradients<S: Instructions>(
    set: S,
    chunk: usize,
    block: &Block,
    stiffness: &CellStiffness<S::Vector>,
    t: usize,
) -> [Complex<S::Vector>; 2] {
    let [v11, v22, v12] = stiffness.inverse_stretch[t];
    let zero = set.splat(0.0);
    let mut edges = [Complex { re: zero, im: zero }; 2];
    for edge in 0..2 {
        let [x, y] = set.load_pair(&block.constants.triangle[t].shape_gradient[edge], chunk);
        edges[edge] = Complex { re: v11 * x + v12 * y, im: v12 * x + v22 * y };
    }
    let (rising, reversed) = (set.load(&block.constants.rising, chunk), edges[0].times(-1.0));
    edges[0].re = rising.if_greater(zero, reversed.re, edges[0].re);
    edges[0].im = rising.if_greater(zero, reversed.im, edges[0].im);
    edges
}

/// 1/3, rounded once.
const THIRD: Real = 1.0 / 3.0;
