//! Lanes: the unit of data that the element loop works on.
//!
//! Every quantity of an element is stored as [`LANES`] neighbours side by side, so that the
//! vectors of any processor ([`crate::vector`]) hold some of them. The width of the hardware changes nothing in the result:
//! no operation crosses lanes except sums that are written out in index order.

use core::ops::{Add, Sub};

use crate::real::Real;
use crate::vector::Vector;

/// Number of cells in a block. A constant of the data layout, not of the hardware.
pub const LANES: usize = 8;

/// One quantity of the cells of a block.
pub type Lane = [Real; LANES];

/// A lane of zeros.
pub const ZERO: Lane = [0.0; LANES];

/// A symmetric deviatoric tensor in the unrotated frame (see [`crate::element`]), one per lane or neighbour.
///
/// A section has three components, since zz = -(xx + yy) and xz = yz = 0. They are stored in an orthogonal basis of equal
/// lengths, so that a contraction is a sum of three products: a : b = 2 (mean mean + difference difference + shear shear).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deviator<T = Lane> {
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
    /// Half of the double contraction a : b.
    #[inline(always)]
    pub fn half_contract(&self, other: &Self) -> V {
        self.mean * other.mean + self.difference * other.difference + self.shear * other.shear
    }

    /// Every component times `factor`.
    #[inline(always)]
    pub fn scaled(&self, factor: V) -> Self {
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

/// The sum of a lane, in index order.
#[inline(always)]
pub fn sum([first, rest @ ..]: &Lane) -> Real {
    rest.iter().fold(*first, |total, value| total + value)
}

/// The `count` lanes of `row` that begin at `start`; none if there are fewer.
#[inline(always)]
pub fn lanes(row: &[Real], start: usize, count: usize) -> Option<&[Lane]> {
    row.get(start..)?.as_chunks().0.get(..count)
}

/// The same, to be changed.
#[inline(always)]
pub fn lanes_mut(row: &mut [Real], start: usize, count: usize) -> Option<&mut [Lane]> {
    row.get_mut(start..)?.as_chunks_mut().0.get_mut(..count)
}
