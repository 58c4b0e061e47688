//! Right stretches of the section: one shear component in the plane, none out of it.

use crate::number::real::Real;
use crate::number::vector::Vector;

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

impl IsochoricStretch {
    /// No deformation.
    pub const REST: Self = Self { u11: 1.0, u22: 1.0, u12: 0.0, u33: 1.0 };

    /// Plane compression to `stretch` across the layer.
    pub fn plane_compression(stretch: Real) -> Self {
        Self { u11: 1.0 / stretch, u22: stretch, ..Self::REST }
    }
}

impl<V: Vector> IsochoricStretch<V> {
    /// I1 = tr C-bar and I2 = tr C-bar^-1.
    #[inline(always)]
    pub fn invariants(&self) -> (V, V) {
        let (c11, c22) = (self.u11 * self.u11 + self.u12 * self.u12, self.u22 * self.u22 + self.u12 * self.u12);
        let (c33, det) = (self.u33 * self.u33, self.u11 * self.u22 - self.u12 * self.u12);
        (c11 + c22 + c33, (c11 + c22) * c33 + det * det)
    }

    /// The larger and the smaller stretch in the section, and the one out of it.
    #[inline(always)]
    pub fn principal(&self) -> [V; 3] {
        let largest =
            largest_in_plane((self.u11 + self.u22).mul_scalar(0.5), (self.u11 - self.u22).mul_scalar(0.5), self.u12);
        [largest, (self.u11 * self.u22 - self.u12 * self.u12) / largest, self.u33]
    }
}

/// The larger principal stretch in the section, from the mean of U11 and U22, half their difference, and U12.
#[inline(always)]
pub fn largest_in_plane<V: Vector>(mean: V, difference: V, shear: V) -> V {
    mean + (difference * difference + shear * shear).square_root()
}
