//! The nodes at an interface and the segments of the other layer that they may touch.

use crate::model::{END_FIELDS, PAIR_PACKS};
use crate::number::pack::{LANES, Pack};
use crate::number::real::Real;

/// Numbers of a node at an interface and of the segment of the other one's row of nodes that it is over, each for neighbouring
/// columns. What a step starts from is which segments they follow, and the forces; all else is of one step. Columns without
/// a node have zeros.
pub(crate) type PairPack = [Pack; PAIR_PACKS];

/// Column of the segment less that of the node, a whole number.
pub(crate) const SHIFT: usize = 0;
/// Where the node is over the segment: 0 at its left end, 1 at its right end, and beyond where it is beside it.
pub(crate) const PART: usize = 1;
/// Force on the node along the normal, N, never negative, then friction, to the right of the normal.
pub(crate) const FORCE: [usize; 2] = [2, 3];
/// Direction out of the segment, x before y.
pub(crate) const NORMAL: [usize; 2] = [4, 5];
/// Distance from the segment at the start of the step over the step, m/s; negative inside.
pub(crate) const OPENING: usize = 6;
/// Force over the change of the relative velocity that it brings about, kg/s; 0 where the node is beside the other layer.
pub(crate) const RESISTANCE: usize = 7;
/// How much of what is on the node is on the left one and on the right one of two neighbours of the other row; nothing where it
/// is beside.
pub(crate) const WEIGHT: [usize; 2] = [8, 9];
/// Column of the left one, which may be the one before the first.
pub(crate) const LEFT: usize = 10;
/// In the first place, 1 where those of the pack follow each other as its nodes do.
pub(crate) const ABREAST: usize = 11;
/// Step over mass of the node, s/kg, x before y; 0 where fixed.
pub(crate) const MOBILITY: [usize; 2] = [12, 13];

/// A row of nodes at an interface between two layers.
pub(crate) struct PairRow<'s> {
    /// The nodes and their segments.
    pub packs: &'s mut [PairPack],
    /// Velocities of the nodes with the forces so far, m/s; when they are all known, their means over them. A pack of columns
    /// before the first comes first, here and below.
    pub velocity: [&'s mut [Real]; 2],
    /// Forces that have not changed the velocities yet, N. Until the pairs are found, the positions at the start of the step, m.
    pub pull: [&'s mut [Real]; 2],
}

impl<'s> PairRow<'s> {
    /// How many numbers a row has in memory, for a row of nodes of `stride`.
    pub const fn numbers(stride: usize) -> usize {
        PAIR_PACKS * stride + END_FIELDS * (stride + LANES)
    }

    /// The row of `count` nodes in `memory`; none if it is too short.
    #[inline(always)]
    pub fn of(memory: &'s mut [Real], stride: usize, count: usize) -> Option<Self> {
        let (packs, rest) = memory.split_at_mut_checked(PAIR_PACKS * stride)?;
        let mut rest = rest.chunks_exact_mut((stride + LANES).max(1));
        let mut next = || rest.next();
        Some(Self {
            packs: packs.as_chunks_mut().0.as_chunks_mut().0.get_mut(..count.div_ceil(LANES))?,
            velocity: [next()?, next()?],
            pull: [next()?, next()?],
        })
    }
}

/// Numbers of the columns of pack `i` in a row with a pack before the first.
#[inline(always)]
pub(crate) fn columns(row: &[Real], i: usize) -> Option<&Pack> {
    row.as_chunks().0.get(i + 1)
}

/// The same, to be changed.
#[inline(always)]
pub(crate) fn columns_mut(row: &mut [Real], i: usize) -> Option<&mut Pack> {
    row.as_chunks_mut().0.get_mut(i + 1)
}
