//! How a triangle deforms: rotation and stretch of its deformation gradient, and the increment of its strain.

use crate::number::cube_root::inverse_cbrt;
use crate::number::real::Real;
use crate::number::vector::{Simd, Vector};
use crate::tensor::deviator::{Deviator, SQRT_THIRD};
use crate::tensor::stretch::{CauchyGreen, IsochoricStretch};

/// Deformation of one triangle of some neighbouring cells.
#[derive(Clone, Copy, Debug)]
pub struct Kinematics<V> {
    /// Cosine and sine of twice the angle of the rotation R.
    pub rotation_2theta: [V; 2],
    /// Right stretch U: mean in the section, (U11 + U22)/2.
    pub mean: V,
    /// Half difference, (U11 - U22)/2.
    pub difference: V,
    /// Shear, U12.
    pub shear: V,
    /// Hoop stretch U33; 1 in plane strain.
    pub hoop: V,
    /// J = det F.
    pub jacobian: V,
    /// J^(-1/3).
    pub inverse_cbrt_j: V,
}

impl Kinematics<Real> {
    /// No deformation.
    pub const REST: Self = Self {
        rotation_2theta: [1.0, 0.0],
        mean: 1.0,
        difference: 0.0,
        shear: 0.0,
        hoop: 1.0,
        jacobian: 1.0,
        inverse_cbrt_j: 1.0,
    };
}

impl<V: Vector> Kinematics<V> {
    /// Deformation of one triangle of each cell from the gradients of two edges, 1/m, the differences of displacement along
    /// them, m, and, if axisymmetric, its hoop stretch: F = I + sum (difference) (x) gradient.
    ///
    /// With the plane as complex numbers, F z = a z + b z*, where 2 a = (F11 + F22) + i (F21 - F12) and
    /// 2 b = (F11 - F22) + i (F21 + F12). Then R is a / |a|, U z = |a| z + (R* b) z*, and det F = |a|^2 - |b|^2.
    #[inline(always)]
    pub(crate) fn new<S: Simd<Vector = V>>(
        simd: S,
        [g, h]: [[V; 2]; 2],
        [[ax, ay], [bx, by]]: [[V; 2]; 2],
        hoop: Option<V>,
    ) -> Self {
        // F less the unit tensor.
        let (f11, f12) = (ax * g[0] + bx * h[0], ax * g[1] + bx * h[1]);
        let (f21, f22) = (ay * g[0] + by * h[0], ay * g[1] + by * h[1]);
        let (a, b) = ([(f11 + f22).add_scalar(2.0), f21 - f12], [f11 - f22, f21 + f12]);
        let of_a = [a[0] * a[0], a[1] * a[1]];
        let squares = [of_a[0] + of_a[1], b[0] * b[0] + b[1] * b[1]];
        let length = squares[0].square_root();
        let inverse = simd.splat(1.0) / length;
        let (half_inverse, inverse_square) = (inverse.mul_scalar(0.5), inverse * inverse);
        let section = (squares[0] - squares[1]).mul_scalar(0.25);
        let jacobian = match hoop {
            Some(hoop) => section * hoop,
            None => section,
        };
        Self {
            rotation_2theta: [(of_a[0] - of_a[1]) * inverse_square, (a[0] * a[1]).mul_scalar(2.0) * inverse_square],
            mean: length.mul_scalar(0.5),
            difference: (a[0] * b[0] + a[1] * b[1]) * half_inverse,
            shear: (a[0] * b[1] - a[1] * b[0]) * half_inverse,
            hoop: hoop.unwrap_or(simd.splat(1.0)),
            jacobian,
            inverse_cbrt_j: inverse_cbrt(jacobian),
        }
    }

    /// The deformation that has the right stretch U (mean, half difference, shear, hoop), and no rotation; for laws that take the
    /// whole stretch and not J^(-1/3).
    #[inline(always)]
    pub(crate) fn of_stretch<S: Simd<Vector = V>>(simd: S, [mean, difference, shear, hoop]: [V; 4]) -> Self {
        let (zero, one) = (simd.splat(0.0), simd.splat(1.0));
        let jacobian = (mean * mean - (difference * difference + shear * shear)) * hoop;
        Self { rotation_2theta: [one, zero], mean, difference, shear, hoop, jacobian, inverse_cbrt_j: one }
    }

    /// The deformation of an isochoric stretch, without rotation.
    #[inline(always)]
    pub fn of_isochoric<S: Simd<Vector = V>>(simd: S, stretch: &IsochoricStretch<V>) -> Self {
        let (mean, difference) =
            ((stretch.u11 + stretch.u22).mul_scalar(0.5), (stretch.u11 - stretch.u22).mul_scalar(0.5));
        Self::of_stretch(simd, [mean, difference, stretch.u12, stretch.u33])
    }

    /// C-bar = J^(-2/3) U^2.
    #[inline(always)]
    pub fn isochoric_cauchy_green(&self) -> CauchyGreen<V> {
        let scale = self.inverse_cbrt_j * self.inverse_cbrt_j;
        let double = scale * (self.mean + self.mean);
        let deviation = self.difference * self.difference + self.shear * self.shear;
        CauchyGreen {
            mean: scale * (self.mean * self.mean + deviation),
            difference: double * self.difference,
            shear: double * self.shear,
            out: scale * (self.hoop * self.hoop),
        }
    }

    /// tr(delta U U^-1) against the stretch before, likewise: the increment of ln J.
    #[inline(always)]
    pub(crate) fn volume_increment<S: Simd<Vector = V>>(&self, simd: S, before: &[V; 4], axisymmetric: bool) -> V {
        let [mean, difference, shear, hoop] = *before;
        let change = [self.mean - mean, self.difference - difference, self.shear - shear];
        let sum = [self.mean + mean, self.difference + difference, self.shear + shear];
        let double_inverse = simd.splat(2.0) / (sum[0] * sum[0] - (sum[1] * sum[1] + sum[2] * sum[2]));
        let section = (change[0] * sum[0] - (change[1] * sum[1] + change[2] * sum[2])) * double_inverse;
        let half = if axisymmetric { section + (self.hoop - hoop) / (self.hoop + hoop) } else { section };
        half + half
    }

    /// dev sym(delta U U^-1) against the stretch before (mean, half difference, shear, hoop), at the mean stretch.
    #[inline(always)]
    pub(crate) fn strain_increment<S: Simd<Vector = V>>(
        &self,
        simd: S,
        before: &[V; 4],
        axisymmetric: bool,
    ) -> Deviator<V> {
        let [mean, difference, shear, hoop] = *before;
        let change = [self.mean - mean, self.difference - difference, self.shear - shear];
        // Twice the mean stretch, whose inverse is twice its adjugate over its determinant.
        let sum = [self.mean + mean, self.difference + difference, self.shear + shear];
        let double_inverse = simd.splat(2.0) / (sum[0] * sum[0] - (sum[1] * sum[1] + sum[2] * sum[2]));
        let section = (change[0] * sum[0] - (change[1] * sum[1] + change[2] * sum[2])) * double_inverse;
        let trace_free =
            if axisymmetric { section - (self.hoop - hoop).mul_scalar(2.0) / (self.hoop + hoop) } else { section };
        Deviator {
            mean: trace_free.mul_scalar(SQRT_THIRD),
            difference: (sum[0] * change[1] - change[0] * sum[1]) * double_inverse,
            shear: (sum[0] * change[2] - change[0] * sum[2]) * double_inverse,
        }
    }
}
