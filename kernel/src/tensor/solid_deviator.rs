//! Deviatoric tensors of a solid.

use core::ops::{Add, Sub};

use crate::number::pack::Pack;
use crate::number::vector::{Simd, Vector};
use crate::tensor::deviator::{Deviatoric, SQRT_THIRD};
use crate::tensor::symmetric::Symmetric;

/// Packs of a [`SolidDeviator`].
pub(crate) const DEVIATOR_PACKS: usize = 5;

/// A symmetric deviatoric tensor in the unrotated frame: the basis of [`crate::tensor::deviator::Deviator`] and two further
/// shears, so that a : b is twice the sum of five products.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SolidDeviator<T> {
    /// Mean of the components across z, sqrt(3)/2 (xx + yy).
    pub mean: T,
    /// Half difference of them, (xx - yy)/2.
    pub difference: T,
    /// Component xy.
    pub shear: T,
    /// Component yz.
    pub yz: T,
    /// Component zx.
    pub zx: T,
}

impl<V: Vector> SolidDeviator<V> {
    /// No stress, no strain.
    #[inline(always)]
    pub fn none<S: Simd<Vector = V>>(simd: S) -> Self {
        Self::uniform(simd.splat(0.0))
    }

    /// The deviator of a tensor.
    #[inline(always)]
    pub fn of(tensor: &Symmetric<V>) -> Self {
        Self {
            mean: ((tensor.xx + tensor.yy).mul_scalar(0.5) - tensor.zz).mul_scalar(SQRT_THIRD),
            difference: (tensor.xx - tensor.yy).mul_scalar(0.5),
            shear: tensor.xy,
            yz: tensor.yz,
            zx: tensor.zx,
        }
    }

    /// The tensor with this deviator and the trace 3 `mean`.
    #[inline(always)]
    pub fn with_mean(&self, mean: V) -> Symmetric<V> {
        let across = mean + self.mean.mul_scalar(SQRT_THIRD);
        Symmetric {
            xx: across + self.difference,
            yy: across - self.difference,
            zz: mean - self.mean.mul_scalar(2.0 * SQRT_THIRD),
            xy: self.shear,
            yz: self.yz,
            zx: self.zx,
        }
    }

    /// The `chunk`-th vectors of packs of tensors.
    #[inline(always)]
    pub fn load<S: Simd<Vector = V>>(simd: S, packs: &[Pack; DEVIATOR_PACKS], chunk: usize) -> Self {
        let [mean, difference, shear, yz, zx] = packs;
        Self {
            mean: simd.load(mean, chunk),
            difference: simd.load(difference, chunk),
            shear: simd.load(shear, chunk),
            yz: simd.load(yz, chunk),
            zx: simd.load(zx, chunk),
        }
    }

    /// Writes the `chunk`-th vectors of packs of tensors.
    #[inline(always)]
    pub fn store<S: Simd<Vector = V>>(&self, simd: S, packs: &mut [Pack; DEVIATOR_PACKS], chunk: usize) {
        let [mean, difference, shear, yz, zx] = packs;
        simd.store(self.mean, mean, chunk);
        simd.store(self.difference, difference, chunk);
        simd.store(self.shear, shear, chunk);
        simd.store(self.yz, yz, chunk);
        simd.store(self.zx, zx, chunk);
    }
}

impl<V: Vector> Deviatoric<V> for SolidDeviator<V> {
    #[inline(always)]
    fn uniform(value: V) -> Self {
        Self { mean: value, difference: value, shear: value, yz: value, zx: value }
    }

    #[inline(always)]
    fn half_contract(&self, other: &Self) -> V {
        self.mean * other.mean
            + self.difference * other.difference
            + self.shear * other.shear
            + (self.yz * other.yz + self.zx * other.zx)
    }

    #[inline(always)]
    fn scaled(&self, factor: V) -> Self {
        Self {
            mean: factor * self.mean,
            difference: factor * self.difference,
            shear: factor * self.shear,
            yz: factor * self.yz,
            zx: factor * self.zx,
        }
    }
}

impl<V: Vector> Add for SolidDeviator<V> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self {
            mean: self.mean + other.mean,
            difference: self.difference + other.difference,
            shear: self.shear + other.shear,
            yz: self.yz + other.yz,
            zx: self.zx + other.zx,
        }
    }
}

impl<V: Vector> Sub for SolidDeviator<V> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self {
            mean: self.mean - other.mean,
            difference: self.difference - other.difference,
            shear: self.shear - other.shear,
            yz: self.yz - other.yz,
            zx: self.zx - other.zx,
        }
    }
}
