//! How a tetrahedron deforms: its right stretch, and the increment of its strain.
//!
//! The stretch U of the polar decomposition F = R U is closed (Hoger and Carlson 1984): with C = F^T F and the invariants
//! i1, i2, i3 of U,
//!
//! (i1 i2 - i3) U = i1 i3 1 + (i1^2 - i2) C - C^2, U^-1 = (C - i1 U + i2 1) / i3,
//!
//! where i3 = det F, 2 i2 = i1^2 - tr C, and i1 is the largest root of i1^4 - 2 I i1^2 - 8 i3 i1 + I^2 - 4 II with the invariants I
//! and II of C. All of its roots are real, so Halley's method comes down to it from sqrt(3 I) without a branch. The rotation itself
//! is not needed: with a stress T in the unrotated frame, P = F (U^-1 T U^-1).

use crate::number::cube_root::inverse_cbrt;
use crate::number::vector::{Simd, Vector};
use crate::tensor::solid_deviator::SolidDeviator;
use crate::tensor::stretch::IsochoricTensor;
use crate::tensor::symmetric::Symmetric;

/// Halley's steps to the trace of U: exact to the last digit for stretches of which one is up to 25 times another.
const HALLEY_STEPS: usize = 5;

/// A deformation gradient, row by row.
pub(crate) type Gradient<V> = [[V; 3]; 3];

/// Deformation of one tetrahedron of some neighbouring cells.
#[derive(Clone, Copy, Debug)]
pub struct SolidKinematics<V> {
    /// C = F^T F.
    pub cauchy_green: Symmetric<V>,
    /// Right stretch U.
    pub stretch: Symmetric<V>,
    /// U^-1.
    pub inverse_stretch: Symmetric<V>,
    /// J = det F.
    pub jacobian: V,
    /// J^(-1/3).
    pub inverse_cbrt_j: V,
}

/// The determinant of a gradient.
#[inline(always)]
pub(crate) fn determinant<V: Vector>([a, b, c]: &Gradient<V>) -> V {
    a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
}

/// The product of two columns.
#[inline(always)]
fn columns_product<V: Vector>(f: &Gradient<V>, i: usize, j: usize) -> V {
    f[0][i] * f[0][j] + f[1][i] * f[1][j] + f[2][i] * f[2][j]
}

/// F^T F.
#[inline(always)]
fn cauchy_green<V: Vector>(f: &Gradient<V>) -> Symmetric<V> {
    Symmetric {
        xx: columns_product(f, 0, 0),
        yy: columns_product(f, 1, 1),
        zz: columns_product(f, 2, 2),
        xy: columns_product(f, 0, 1),
        yz: columns_product(f, 1, 2),
        zx: columns_product(f, 2, 0),
    }
}

/// What iterations find of a deformation gradient, one step waiting for the other: those of several tetrahedra are best found in
/// a loop of their own, in which a processor works at more than one at a time.
#[derive(Clone, Copy)]
pub(crate) struct Roots<V> {
    /// C = F^T F.
    cauchy_green: Symmetric<V>,
    /// J = det F.
    pub jacobian: V,
    /// tr U.
    trace: V,
    /// J^(-1/3).
    inverse_cbrt_j: V,
}

impl<V: Vector> Roots<V> {
    /// No deformation.
    #[inline(always)]
    pub fn none<S: Simd<Vector = V>>(simd: S) -> Self {
        let (zero, one) = (simd.splat(0.0), simd.splat(1.0));
        Self { cauchy_green: Symmetric::unit(one, zero), jacobian: one, trace: simd.splat(3.0), inverse_cbrt_j: one }
    }

    /// Of a gradient.
    #[inline(always)]
    pub fn new(gradient: &Gradient<V>) -> Self {
        let (c, jacobian) = (cauchy_green(gradient), determinant(gradient));
        let minors = [c.xx * c.yy - c.xy * c.xy, c.yy * c.zz - c.yz * c.yz, c.zz * c.xx - c.zx * c.zx];
        let trace = trace_of_stretch(c.trace(), minors[0] + minors[1] + minors[2], jacobian);
        Self { cauchy_green: c, jacobian, trace, inverse_cbrt_j: inverse_cbrt(jacobian) }
    }
}

impl<V: Vector> SolidKinematics<V> {
    /// Of what iterations have found of a gradient.
    #[inline(always)]
    pub(crate) fn new<S: Simd<Vector = V>>(simd: S, roots: &Roots<V>) -> Self {
        let Roots { cauchy_green: c, jacobian, trace, inverse_cbrt_j } = *roots;
        let (first, square) = (c.trace(), trace * trace);
        let second = (square - first).mul_scalar(0.5);
        let one = simd.splat(1.0);
        let (scale, inverse_j) = (one / (trace * second - jacobian), one / jacobian);
        let (of_unit, of_c) = (trace * jacobian * scale, (square - second) * scale);
        let zero = simd.splat(0.0);
        let stretch = Symmetric::unit(of_unit, zero).plus(&c.scaled(of_c)).minus(&c.square().scaled(scale));
        let inverse_stretch = Symmetric::unit(second, zero).plus(&c).minus(&stretch.scaled(trace)).scaled(inverse_j);
        Self { cauchy_green: c, stretch, inverse_stretch, jacobian, inverse_cbrt_j }
    }

    /// The deformation that has this stretch, and no rotation.
    #[inline(always)]
    pub(crate) fn of_stretch<S: Simd<Vector = V>>(simd: S, stretch: &Symmetric<V>) -> Self {
        let adjugate = stretch.adjugate();
        let jacobian = stretch.determinant(&adjugate);
        Self {
            cauchy_green: stretch.square(),
            stretch: *stretch,
            inverse_stretch: adjugate.scaled(simd.splat(1.0) / jacobian),
            jacobian,
            inverse_cbrt_j: inverse_cbrt(jacobian),
        }
    }

    /// C-bar = J^(-2/3) C.
    #[inline(always)]
    pub fn isochoric_cauchy_green(&self) -> IsochoricSymmetric<V> {
        IsochoricSymmetric(self.cauchy_green.scaled(self.inverse_cbrt_j * self.inverse_cbrt_j))
    }

    /// The symmetric part of (delta U) U^-1 against the stretch before, at the mean stretch.
    #[inline(always)]
    pub(crate) fn strain_increment<S: Simd<Vector = V>>(&self, simd: S, before: &Symmetric<V>) -> Symmetric<V> {
        let (change, sum) = (self.stretch.minus(before), self.stretch.plus(before));
        // Twice the mean stretch, whose inverse is twice its adjugate over its determinant.
        let adjugate = sum.adjugate();
        let double_inverse = simd.splat(2.0) / sum.determinant(&adjugate);
        change.symmetric_product(&adjugate).scaled(double_inverse)
    }
}

/// The trace of U, from the first and the second invariant of C and J.
#[inline(always)]
fn trace_of_stretch<V: Vector>(first: V, second: V, jacobian: V) -> V {
    let (double, quadruple, linear) = (first + first, first.mul_scalar(4.0), jacobian.mul_scalar(8.0));
    let constant = first * first - second.mul_scalar(4.0);
    let mut x = first.mul_scalar(3.0).square_root();
    for _ in 0..HALLEY_STEPS {
        let square = x * x;
        let value = (square - double) * square - linear * x + constant;
        let slope = (square - first) * x.mul_scalar(4.0) - linear;
        let curvature = square.mul_scalar(12.0) - quadruple;
        let denominator = (slope * slope).mul_scalar(2.0) - value * curvature;
        x = x - (value + value) * slope / denominator;
    }
    x
}

/// An isochoric right Cauchy-Green tensor.
#[derive(Clone, Copy, Debug)]
pub struct IsochoricSymmetric<V>(pub Symmetric<V>);

impl<V: Vector> IsochoricTensor<V> for IsochoricSymmetric<V> {
    type Deviator = SolidDeviator<V>;

    #[inline(always)]
    fn first_invariant(&self) -> V {
        self.0.trace().add_scalar(-3.0)
    }

    #[inline(always)]
    fn scaled_deviator(&self, factor: V) -> SolidDeviator<V> {
        SolidDeviator::of(&self.0.scaled(factor))
    }
}
