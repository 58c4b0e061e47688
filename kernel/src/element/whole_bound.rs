//! The highest frequency of single cells of a compressible material, whose triangles share nothing.
//!
//! With spatial gradients L of the displacement along the principal directions of U, the second variation of the energy of a
//! triangle is, with the tangents a_ij = l_j d tau_i / d l_j and S = (tau_1 - tau_2) / (l_1^2 - l_2^2) (Ogden 1984),
//!
//! sum a_ij L_ii L_jj - sum tau_i L_ii^2 + S (l_2^2 L_12^2 + l_1^2 L_21^2) + 2 (S l_2^2 - tau_2) L_12 L_21,
//!
//! geometric stiffness and all. An overstress that is o times as stiff, and relaxed, adds o (a_ij L_ii L_jj +
//! S l_1 l_2 (L_12 + L_21)^2); where it has not relaxed, -tau_i counts 1 + o times where that is more. Maxwell terms and
//! spring-sliders add their shear modulus, and softening, while it recovers, the square of the stress. It all is a matrix of
//! the eight displacements of a cell's corners, and a step dt is stable where rho V - dt^2 K is positive definite, with a
//! quarter of the mass at each corner: where Gauss' elimination meets positive pivots alone. As in
//! [`crate::element::cell_bound`], the rotation of one triangle against the other is left out.

use crate::element::Block;
use crate::element::cell_bound::HALVINGS;
use crate::material::{MaterialModel, PrincipalTangent};
use crate::number::complex::Complex;
use crate::number::math::THIRD;
use crate::number::pack::ZERO;
use crate::number::real::{Real, TINY_SQUARE};
use crate::number::vector::{Simd, Vector};
use crate::tensor::kinematics::Kinematics;

/// Displacements of a cell: of each corner along the row and across.
const N: usize = 8;

/// Strains of a triangle: t = L11 + L22, p = L11 - L22, h = L33, q = L12 + L21 and w = L21 - L12.
const STRAINS: usize = 5;

/// K / (rho V) of neighbouring cells, 1/s2; below the diagonal.
pub(crate) struct WholeMatrix<V>([[V; N]; N]);

impl<V: Vector> WholeMatrix<V> {
    /// Nothing.
    pub fn new<S: Simd<Vector = V>>(simd: S) -> Self {
        Self([[simd.splat(0.0); N]; N])
    }

    /// Adds triangle `t` of each cell in the state `kinematics`.
    #[inline(always)]
    pub fn add<S: Simd<Vector = V>>(
        &mut self,
        simd: S,
        chunk: usize,
        block: &Block,
        t: usize,
        kinematics: &Kinematics<V>,
    ) {
        let tangent = block.laws.elastic.principal_tangent(simd, kinematics);
        let stiffness = Stiffness::new(simd, block.laws, kinematics, &tangent);
        let rows = strain_rows(simd, chunk, block, t, kinematics);
        let forces = stiffness.times(&rows);
        let scale =
            simd.load(&block.constants.triangle[t % 2].volume_fraction, chunk).mul_scalar(1.0 / block.laws.density);
        for i in 0..N {
            for j in 0..=i {
                let mut sum = rows[0][i] * forces[0][j];
                for k in 1..STRAINS {
                    sum = sum + rows[k][i] * forces[k][j];
                }
                self.0[i][j] = self.0[i][j] + scale * sum;
            }
        }
    }

    /// 1 where the step of this square is too large, 0 elsewhere and where the state is not a number.
    #[inline(always)]
    pub fn unstable<S: Simd<Vector = V>>(&self, simd: S, step_squared: V) -> V {
        let (one, mut unstable) = (simd.splat(1.0), simd.splat(0.0));
        let mut left = self.0;
        for i in 0..N {
            for j in 0..=i {
                left[i][j] = simd.splat(0.0) - step_squared * left[i][j];
            }
            left[i][i] = left[i][i].add_scalar(1.0);
        }
        for k in 0..N {
            unstable = simd.splat(Real::MIN_POSITIVE).select_greater(left[k][k], one, unstable);
            let inverse = one / left[k][k];
            for i in k + 1..N {
                let factor = left[i][k] * inverse;
                for j in k + 1..=i {
                    left[i][j] = left[i][j] - factor * left[j][k];
                }
            }
        }
        unstable
    }

    /// Square of the largest stable step of each cell, s2, to one part in 10^8 from below; at most `bound`.
    #[inline(always)]
    pub fn limit_squared<S: Simd<Vector = V>>(&self, simd: S, bound: V) -> V {
        let zero = simd.splat(0.0);
        // The largest eigenvalue lies between the largest on the diagonal and the largest sum of a row (Gershgorin).
        let (mut least, mut most) = (simd.splat(Real::MIN_POSITIVE), simd.splat(Real::MIN_POSITIVE));
        for i in 0..N {
            let mut sum = zero;
            for j in 0..N {
                let entry = if j <= i { self.0[i][j] } else { self.0[j][i] };
                sum = sum + entry.max(zero - entry);
            }
            (least, most) = (least.max(self.0[i][i]), most.max(sum));
        }
        let (mut stable, mut beyond) = (simd.splat(1.0) / most, simd.splat(1.0) / least);
        beyond = beyond.select_greater(bound, bound, beyond);
        let mut probe = beyond;
        for _ in 0..=HALVINGS {
            let lost = self.unstable(simd, probe);
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
}

/// The second variation of the energy of a triangle as a matrix over its strains, Pa: of t, p and h, then of q and w.
struct Stiffness<V> {
    along: [[V; 3]; 3],
    across: [[V; 2]; 2],
}

impl<V: Vector> Stiffness<V> {
    #[inline(always)]
    fn new<S: Simd<Vector = V>>(
        simd: S,
        laws: &MaterialModel,
        kinematics: &Kinematics<V>,
        tangent: &PrincipalTangent<V>,
    ) -> Self {
        let additive = laws.maxwell.shear_modulus() + laws.slider.stiffness();
        let mut stiffness = Self {
            along: Self::along(simd, laws, tangent),
            across: Self::across(kinematics, tangent, laws.prony.overstress()),
        };
        // Twice the modulus times the square of the deviator: p^2 + q^2 + (t - 2 h)^2 / 3.
        let [[tt, _, th], [_, pp, _], [ht, _, hh]] = &mut stiffness.along;
        for (entry, part) in [(tt, THIRD), (th, -2.0 * THIRD), (ht, -2.0 * THIRD), (hh, 4.0 * THIRD), (pp, 1.0)] {
            *entry = entry.add_scalar(part * additive);
        }
        stiffness.across[0][0] = stiffness.across[0][0].add_scalar(additive);
        stiffness
    }

    /// Of strains along the principal directions.
    #[inline(always)]
    fn along<S: Simd<Vector = V>>(simd: S, laws: &MaterialModel, tangent: &PrincipalTangent<V>) -> [[V; 3]; 3] {
        let (zero, whole) = (simd.splat(0.0), 1.0 + laws.prony.overstress());
        // While softening recovers, its factor grows with the energy.
        let slope = if laws.softening.active() { laws.softening.largest_slope(simd, tangent.energy) } else { zero };
        let (mut own, mut against) = ([zero; 3], [zero; 3]);
        for i in 0..3 {
            let pressing = zero - tangent.stress[i];
            own[i] = (tangent.own[i] + tangent.common + slope * (pressing * pressing)).mul_scalar(whole);
            against[i] = pressing.max(pressing.mul_scalar(whole));
        }
        let [a, b, hh] = [own[0] + against[0], own[1] + against[1], own[2] + against[2]];
        let [first, second, third] = tangent.stress;
        let double = (tangent.common + slope * (first * second)).mul_scalar(2.0 * whole);
        let with_first = (tangent.common + slope * (first * third)).mul_scalar(whole);
        let with_second = (tangent.common + slope * (second * third)).mul_scalar(whole);
        let (tt, pp) = ((a + b + double).mul_scalar(0.25), (a + b - double).mul_scalar(0.25));
        let (tp, th, ph) = (
            (a - b).mul_scalar(0.25),
            (with_first + with_second).mul_scalar(0.5),
            (with_first - with_second).mul_scalar(0.5),
        );
        [[tt, tp, th], [tp, pp, ph], [th, ph, hh]]
    }

    /// Of shears from one principal direction to the other.
    #[inline(always)]
    fn across(kinematics: &Kinematics<V>, tangent: &PrincipalTangent<V>, overstress: Real) -> [[V; 2]; 2] {
        let Kinematics { mean, difference, shear, .. } = *kinematics;
        let radius = (difference * difference + shear * shear).square_root();
        let (longer, shorter) = (mean + radius, mean - radius);
        let viscous = (tangent.turning * (longer * shorter)).mul_scalar(overstress);
        let of_first = tangent.turning * (shorter * shorter);
        let (ij, ji) = (of_first + viscous, tangent.turning * (longer * longer) + viscous);
        let mixed = (of_first - tangent.stress[1] + viscous).mul_scalar(2.0);
        let (qq, ww) = ((ij + ji + mixed).mul_scalar(0.25), (ij + ji - mixed).mul_scalar(0.25));
        let qw = (ji - ij).mul_scalar(0.25);
        [[qq, qw], [qw, ww]]
    }

    /// The matrix times the `rows` of the strains.
    #[inline(always)]
    fn times(&self, rows: &[[V; N]; STRAINS]) -> [[V; N]; STRAINS] {
        let mut product = *rows;
        for i in 0..N {
            let [t, p, h, q, w] = [rows[0][i], rows[1][i], rows[2][i], rows[3][i], rows[4][i]];
            for k in 0..3 {
                let of = &self.along[k];
                product[k][i] = of[0] * t + of[1] * p + of[2] * h;
            }
            for k in 0..2 {
                product[3 + k][i] = self.across[k][0] * q + self.across[k][1] * w;
            }
        }
        product
    }
}

/// The strains of triangle `t` of each cell along the principal directions of its stretch, as rows over the displacements of
/// the corners, 1/m.
#[inline(always)]
fn strain_rows<S: Simd>(
    simd: S,
    chunk: usize,
    block: &Block,
    t: usize,
    kinematics: &Kinematics<S::Vector>,
) -> [[S::Vector; N]; STRAINS] {
    let (zero, one) = (simd.splat(0.0), simd.splat(1.0));
    let Kinematics { difference, shear, hoop, .. } = *kinematics;
    let square = difference * difference + shear * shear;
    let inverse_radius = one / square.add_scalar(TINY_SQUARE).square_root();
    // Twice the angle of the larger stretch; none where both are the same.
    let cos = square.select_greater(simd.splat(TINY_SQUARE), difference * inverse_radius, one);
    let turn = Complex { re: cos, im: zero - shear * inverse_radius };
    let inverse_hoop = one / hoop;
    let mut rows = [[zero; N]; STRAINS];
    for (corner, gradient) in corner_gradients(simd, chunk, block, t, kinematics).into_iter().enumerate() {
        let (x, y) = (2 * corner % N, (2 * corner + 1) % N);
        (rows[0][x], rows[0][y]) = (gradient.re, gradient.im);
        (rows[4][x], rows[4][y]) = (zero - gradient.im, gradient.re);
        // p + i q is the product of displacement and gradient.
        let turned = turn * gradient;
        (rows[1][x], rows[3][x]) = (turned.re, turned.im);
        (rows[1][y], rows[3][y]) = (zero - turned.im, turned.re);
        if let Some(constants) = block.hoop {
            rows[2][x] = simd.load(&constants.weight[t % 2][corner % 4], chunk) * inverse_hoop;
        }
    }
    rows
}

/// U^-1 times the gradients of the corners in triangle `t` of each cell: the spatial ones but for a rotation, 1/m.
#[inline(always)]
fn corner_gradients<S: Simd>(
    simd: S,
    chunk: usize,
    block: &Block,
    t: usize,
    kinematics: &Kinematics<S::Vector>,
) -> [Complex<S::Vector>; 4] {
    let zero = simd.splat(0.0);
    let none = Complex { re: zero, im: zero };
    let Kinematics { mean, difference, shear, .. } = *kinematics;
    let inverse = simd.splat(1.0) / (mean * mean - (difference * difference + shear * shear));
    let mut edges = [none; 2];
    for edge in 0..2 {
        let [x, y] = simd.load_pair(&block.constants.triangle[t % 2].shape_gradient[edge], chunk);
        let (re, im) = ((mean - difference) * x - shear * y, (mean + difference) * y - shear * x);
        edges[edge] = Complex { re: re * inverse, im: im * inverse };
    }
    let [along, across] = edges;
    let (back, down) = (along.mul_scalar(-1.0), across.mul_scalar(-1.0));
    // Where the diagonal rises, then where it falls.
    let corners = if t == 0 {
        [[back, along + down, across, none], [back + down, along, none, across]]
    } else {
        [[down, none, along, across + back], [none, down, along + across, back]]
    };
    let diagonal = simd.load(&block.constants.diagonal, chunk);
    let [rising, falling] = corners;
    let mut gradients = [none; 4];
    for corner in 0..4 {
        let (rises, falls) = (rising[corner], falling[corner]);
        gradients[corner] = Complex {
            re: diagonal.select_greater(zero, rises.re, falls.re),
            im: diagonal.select_greater(zero, rises.im, falls.im),
        };
    }
    gradients
}
