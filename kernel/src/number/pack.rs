//! Lanes: the unit of data that the element loop works on.
//!
//! Every quantity of an element is stored as [`LANES`] neighbours side by side, so that the
//! vectors of any processor ([`crate::number::vector`]) hold some of them. The width of the hardware changes nothing in the result:
//! no operation crosses lanes except sums that are written out in index order.

use crate::number::real::Real;

/// Number of cells in a block. A constant of the data layout, not of the hardware.
pub const LANES: usize = 8;

/// One quantity of the cells of a block.
pub type Pack = [Real; LANES];

/// A lane of zeros.
pub const ZERO: Pack = [0.0; LANES];

/// The sum of a lane, in index order.
#[inline(always)]
pub fn sum([first, rest @ ..]: &Pack) -> Real {
    rest.iter().fold(*first, |total, value| total + value)
}

/// The `count` lanes of `row` that begin at `start`; none if there are fewer.
#[inline(always)]
pub fn packs(row: &[Real], start: usize, count: usize) -> Option<&[Pack]> {
    row.get(start..)?.as_chunks().0.get(..count)
}

/// The same, to be changed.
#[inline(always)]
pub fn packs_mut(row: &mut [Real], start: usize, count: usize) -> Option<&mut [Pack]> {
    row.get_mut(start..)?.as_chunks_mut().0.get_mut(..count)
}
