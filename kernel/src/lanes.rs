//! Lanes: the unit of data that the element loop works on.
//!
//! Every quantity of an element is stored as [`LANES`] neighbours side by side, so that a plain loop over a
//! [`Lane`] compiles to vector instructions of whatever width the target has. The width of the hardware changes
//! nothing in the result: no operation crosses lanes except sums that are written out in index order.

use crate::real::Real;

/// Number of cells in a block. A constant of the data layout, not of the hardware.
pub const LANES: usize = 8;

/// One quantity of the cells of a block.
pub type Lane = [Real; LANES];

/// A lane of zeros.
pub const ZERO: Lane = [0.0; LANES];

/// A symmetric deviatoric tensor in the unrotated frame (see [`crate::element`]), one per lane.
///
/// Only three components are stored: zz = -(xx + yy), and xz = yz = 0 in a section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deviator {
    /// Component along x.
    pub xx: Lane,
    /// Component along y.
    pub yy: Lane,
    /// Shear component in the section.
    pub xy: Lane,
}

impl Deviator {
    /// No stress, no strain.
    pub const ZERO: Self = Self { xx: ZERO, yy: ZERO, xy: ZERO };

    /// Adds `other` component by component.
    #[inline(always)]
    pub fn add(&mut self, other: &Self) {
        for l in 0..LANES {
            self.xx[l] += other.xx[l];
            self.yy[l] += other.yy[l];
            self.xy[l] += other.xy[l];
        }
    }

    /// The double contraction a : b of lane `l`, with the zz components.
    #[inline(always)]
    pub fn contract(&self, other: &Self, l: usize) -> Real {
        contract([self.xx[l], self.yy[l], self.xy[l]], [other.xx[l], other.yy[l], other.xy[l]])
    }
}

/// a : b of two deviators given as (xx, yy, xy).
#[inline(always)]
pub fn contract(a: [Real; 3], b: [Real; 3]) -> Real {
    let (sum, shear) = (b[0] + b[1], a[2] * b[2]);
    a[0] * (b[0] + sum) + a[1] * (b[1] + sum) + (shear + shear)
}

/// The sum of a lane, in index order.
#[inline(always)]
pub fn sum(lane: &Lane) -> Real {
    lane.iter().fold(0.0, |total, value| total + value)
}

/// The lane that starts at `index` of `row`; zeros past its end, which the sizes of [`crate::mesh::Grid`] exclude.
#[inline(always)]
pub fn load(row: &[Real], index: usize) -> Lane {
    match row.get(index..).and_then(|tail| tail.first_chunk::<LANES>()) {
        Some(chunk) => *chunk,
        None => ZERO,
    }
}

/// Writes `value` to the lane that starts at `index` of `row`.
#[inline(always)]
pub fn store(row: &mut [Real], index: usize, value: &Lane) {
    if let Some(chunk) = row.get_mut(index..).and_then(|tail| tail.first_chunk_mut::<LANES>()) {
        *chunk = *value;
    }
}

/// Subtracts `value` from the lane that starts at `index` of `row`.
#[inline(always)]
pub fn subtract_at(row: &mut [Real], index: usize, value: &Lane) {
    if let Some(chunk) = row.get_mut(index..).and_then(|tail| tail.first_chunk_mut::<LANES>()) {
        for l in 0..LANES {
            chunk[l] -= value[l];
        }
    }
}
