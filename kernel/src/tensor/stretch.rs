//! Right stretches of the section: one shear component in the plane, none out of it.

use crate::number::real::Real;
use crate::number::vector::{Simd, Vector};
use crate::tensor::deviator::{Deviator, SQRT_THIRD};

/// An isochoric right stretch U-bar = J^(-1/3) U.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IsochoricStretch<V = Real> {
    /// Component 11.
    pub u11: V,
    /// Component 22.
    pub u22: V,
    /// Component 12.
    pub u12: V,
    /// Out of the section.
    pub u33: V,
}

/// An isochoric right Cauchy-Green tensor C-bar = U-bar^2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CauchyGreen<V> {
    /// Mean in the section, (C11 + C22)/2.
    pub mean: V,
    /// Half difference in the section, (C11 - C22)/2.
    pub difference: V,
    /// Shear in the section, C12.
    pub shear: V,
    /// Component out of the section, C33.
    pub out: V,
}

/// What laws of the first invariant ask of C-bar, be it of a section or of a solid.
pub trait IsochoricTensor<V> {
    /// Its deviators.
    type Deviator;

    /// I1 - 3.
    fn first_invariant(&self) -> V;

    /// The deviator of `factor` times this.
    fn scaled_deviator(&self, factor: V) -> Self::Deviator;
}

impl<V: Vector> IsochoricTensor<V> for CauchyGreen<V> {
    type Deviator = Deviator<V>;

    #[inline(always)]
    fn first_invariant(&self) -> V {
        self.mean + self.mean + self.out.add_scalar(-3.0)
    }

    #[inline(always)]
    fn scaled_deviator(&self, factor: V) -> Deviator<V> {
        Deviator {
            mean: factor * (self.mean - self.out).mul_scalar(SQRT_THIRD),
            difference: factor * self.difference,
            shear: factor * self.shear,
        }
    }
}

/// What the bounds of the stable step ask of an isochoric stretch, be it of a section or of a solid.
pub trait IsochoricState<V> {
    /// I1 = tr C-bar and I2 = tr C-bar^-1.
    fn invariants(&self) -> (V, V);

    /// Principal stretches.
    fn principal(&self) -> [V; 3];

    /// The part of a majorant of the shear tangent that the first derivatives W1 and W2, Pa, of a law of the invariants
    /// make.
    fn first_order(&self, slopes: [V; 2]) -> V;
}

impl IsochoricStretch {
    /// No deformation.
    pub const REST: Self = Self { u11: 1.0, u22: 1.0, u12: 0.0, u33: 1.0 };

    /// Plane compression to `stretch` across the layer.
    pub fn plane_compression(stretch: Real) -> Self {
        Self { u11: 1.0 / stretch, u22: stretch, ..Self::REST }
    }
}

impl<V: Vector> IsochoricState<V> for IsochoricStretch<V> {
    #[inline(always)]
    fn invariants(&self) -> (V, V) {
        let (c11, c22) = (self.u11 * self.u11 + self.u12 * self.u12, self.u22 * self.u22 + self.u12 * self.u12);
        let (c33, det) = (self.u33 * self.u33, self.u11 * self.u22 - self.u12 * self.u12);
        (c11 + c22 + c33, (c11 + c22) * c33 + det * det)
    }

    /// The larger and the smaller stretch in the section, and the one out of it.
    #[inline(always)]
    fn principal(&self) -> [V; 3] {
        let largest =
            largest_in_plane((self.u11 + self.u22).mul_scalar(0.5), (self.u11 - self.u22).mul_scalar(0.5), self.u12);
        [largest, (self.u11 * self.u22 - self.u12 * self.u12) / largest, self.u33]
    }

    #[inline(always)]
    fn first_order(&self, [w1, w2]: [V; 2]) -> V {
        let ((i1, i2), simd) = (self.invariants(), w1.set());
        let (zero, out) = (simd.splat(0.0), self.u33 * self.u33);
        let around = out.max(simd.splat(1.0) / out).add_scalar(-1.0);
        w1.max(zero) * i1.add_scalar(-1.0) + w2.max(zero) * (i2 + around).mul_scalar(2.0).add_scalar(-4.0)
    }
}

/// Principal values of an isochoric stretch of a solid, in no order.
#[derive(Clone, Copy, Debug)]
pub struct PrincipalStretches<V>(pub [V; 3]);

impl<V: Vector> IsochoricState<V> for PrincipalStretches<V> {
    #[inline(always)]
    fn invariants(&self) -> (V, V) {
        let [a, b, c] = self.squares();
        (a + b + c, a * b + b * c + c * a)
    }

    #[inline(always)]
    fn principal(&self) -> [V; 3] {
        self.0
    }

    /// Turning two of the directions meets W1 (b_i + b_j) + W2 (1/b_i + 1/b_j), strain along one of them W1 b_i + 3 W2 / b_i.
    #[inline(always)]
    fn first_order(&self, [w1, w2]: [V; 2]) -> V {
        let (squares, zero) = (self.squares(), w1.set().splat(0.0));
        let (w1, w2, mut largest) = (w1.max(zero), w2.max(zero), zero);
        let inverse = [squares[1] * squares[2], squares[2] * squares[0], squares[0] * squares[1]];
        for i in 0..3 {
            let j = (i + 1) % 3;
            largest = largest.max(w1 * (squares[i] + squares[j]) + w2 * (inverse[i] + inverse[j]));
            largest = largest.max(w1 * squares[i] + (w2 * inverse[i]).mul_scalar(3.0));
        }
        largest
    }
}

impl<V: Vector> PrincipalStretches<V> {
    #[inline(always)]
    fn squares(&self) -> [V; 3] {
        let [a, b, c] = self.0;
        [a * a, b * b, c * c]
    }
}

/// The larger principal stretch in the section, from the mean of U11 and U22, half their difference, and U12.
#[inline(always)]
pub fn largest_in_plane<V: Vector>(mean: V, difference: V, shear: V) -> V {
    mean + (difference * difference + shear * shear).square_root()
}
