//! Deviatoric tensors of the section.

use core::ops::{Add, Sub};

use crate::number::pack::{Pack, ZERO};
use crate::number::real::Real;
use crate::number::vector::{Simd, Vector};

/// A symmetric deviatoric tensor in the unrotated frame (see [`crate::material`]), one per lane or neighbour.
///
/// A section has three components, since zz = -(xx + yy) and xz = yz = 0. They are stored in an orthogonal basis of equal
/// lengths, so that a contraction is a sum of three products: a : b = 2 (mean mean + difference difference + shear shear).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deviator<T = Pack> {
    /// Mean of the section, sqrt(3)/2 (xx + yy).
    pub mean: T,
    /// Half difference of the section, (xx - yy)/2.
    pub difference: T,
    /// Shear component in the section, xy.
    pub shear: T,
}

impl Deviator {
    /// No stress, no strain.
    pub const ZERO: Self = Self { mean: ZERO, difference: ZERO, shear: ZERO };

    /// The packs of its components, for a history of other numbers than those of a tensor.
    pub(crate) fn packs_mut(&mut self) -> [&mut Pack; 3] {
        [&mut self.mean, &mut self.difference, &mut self.shear]
    }

    /// The tensor of lane `l`; none past the last.
    pub fn lane(&self, l: usize) -> Option<Deviator<Real>> {
        Some(Deviator { mean: *self.mean.get(l)?, difference: *self.difference.get(l)?, shear: *self.shear.get(l)? })
    }
}

impl Deviator<Real> {
    /// Components xx, yy and xy.
    pub fn section(&self) -> [Real; 3] {
        let mean = SQRT_THIRD * self.mean;
        [mean + self.difference, mean - self.difference, self.shear]
    }
}

impl<V: Vector> Deviator<V> {
    /// The `chunk`-th vectors of a lane of tensors.
    #[inline(always)]
    pub fn load<S: Simd<Vector = V>>(simd: S, deviator: &Deviator, chunk: usize) -> Self {
        Self {
            mean: simd.load(&deviator.mean, chunk),
            difference: simd.load(&deviator.difference, chunk),
            shear: simd.load(&deviator.shear, chunk),
        }
    }

    /// Writes the `chunk`-th vectors of a lane of tensors.
    #[inline(always)]
    pub fn store<S: Simd<Vector = V>>(&self, simd: S, deviator: &mut Deviator, chunk: usize) {
        simd.store(self.mean, &mut deviator.mean, chunk);
        simd.store(self.difference, &mut deviator.difference, chunk);
        simd.store(self.shear, &mut deviator.shear, chunk);
    }
}

/// What the deviatoric laws ask of a deviator, be it of a section or of a solid.
pub trait Deviatoric<V>: Copy + Add<Output = Self> + Sub<Output = Self> {
    /// The same number in every component of the basis.
    fn uniform(value: V) -> Self;

    /// Half of the double contraction a : b.
    fn half_contract(&self, other: &Self) -> V;

    /// Every component times `factor`.
    fn scaled(&self, factor: V) -> Self;
}

impl<V: Vector> Deviatoric<V> for Deviator<V> {
    #[inline(always)]
    fn uniform(value: V) -> Self {
        Self { mean: value, difference: value, shear: value }
    }

    #[inline(always)]
    fn half_contract(&self, other: &Self) -> V {
        self.mean * other.mean + self.difference * other.difference + self.shear * other.shear
    }

    #[inline(always)]
    fn scaled(&self, factor: V) -> Self {
        Self { mean: factor * self.mean, difference: factor * self.difference, shear: factor * self.shear }
    }
}

impl<V: Vector> Add for Deviator<V> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self {
            mean: self.mean + other.mean,
            difference: self.difference + other.difference,
            shear: self.shear + other.shear,
        }
    }
}

impl<V: Vector> Sub for Deviator<V> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self {
            mean: self.mean - other.mean,
            difference: self.difference - other.difference,
            shear: self.shear - other.shear,
        }
    }
}

/// The square root of 1/3, rounded once: the mean of a section from the component of a [`Deviator`].
pub const SQRT_THIRD: Real = 0.577_350_269_189_625_8;
