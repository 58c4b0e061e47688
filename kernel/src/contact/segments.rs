//! What the nodes of a pack and the two neighbours of the other row that each is between give each other: a value at a node's
//! place between them, and its share for both. Where the neighbours of a pack follow each other as its nodes do, they
//! are a row moved on; the bits do not depend on it.

use crate::number::pack::{LANES, Pack, ZERO};
use crate::number::real::Real;
use crate::number::vector::{Simd, Vector, small_integer};
use crate::state::{ABREAST, LEFT, PairPack, WEIGHT};

/// Numbers of the neighbours of a pack that follow each other.
type Span = [Real; LANES + 1];

/// Place in a row of the other layer, which begins with a pack before the first column, of a column.
#[inline(always)]
fn place(column: Real) -> usize {
    LANES.wrapping_add_signed(small_integer(column))
}

/// Place of the first left neighbour of a pack, if the others follow it.
#[inline(always)]
fn abreast(pack: &PairPack) -> Option<usize> {
    if pack[ABREAST][0] > 0.0 { Some(place(pack[LEFT][0])) } else { None }
}

/// Numbers of a `row` of the other layer at the left and at the right neighbours of the nodes of `pack`, in `ends` if they do not
/// lie in the row side by side.
#[inline(always)]
pub(super) fn neighbours<'r>(pack: &PairPack, row: &'r [Real], ends: &'r mut [Pack; 2]) -> [&'r Pack; 2] {
    let span: Option<&Span> = abreast(pack).and_then(|first| row.get(first..)?.first_chunk());
    if let Some(span) = span {
        let ([left @ .., _], [_, right @ ..]) = (span, span);
        return [left, right];
    }
    let [left, right] = ends;
    for ((left, right), column) in left.iter_mut().zip(&mut *right).zip(&pack[LEFT]) {
        let found = row.get(place(*column)..).and_then(|tail| tail.first_chunk());
        [*left, *right] = found.copied().unwrap_or_default();
    }
    [left, right]
}

/// A `row` of the other layer under the nodes of `pack`.
#[inline(always)]
pub(super) fn under<S: Simd>(simd: S, pack: &PairPack, row: &[Real]) -> Pack {
    let (mut ends, mut mean) = ([ZERO; 2], ZERO);
    let [left, right] = neighbours(pack, row, &mut ends);
    for chunk in 0..LANES / S::WIDTH {
        let of_left = simd.load(&pack[WEIGHT[0]], chunk) * simd.load(left, chunk);
        simd.store(of_left + simd.load(&pack[WEIGHT[1]], chunk) * simd.load(right, chunk), &mut mean, chunk);
    }
    mean
}

/// Takes `amount` of the nodes of `pack`, by their weights, from a `row` of the other layer: of all left neighbours, then of all
/// right ones.
#[inline(always)]
pub(super) fn take<S: Simd>(simd: S, pack: &PairPack, amount: &Pack, row: &mut [Real]) {
    let mut shares = [ZERO; 2];
    for chunk in 0..LANES / S::WIDTH {
        let amount = simd.load(amount, chunk);
        simd.store(simd.load(&pack[WEIGHT[0]], chunk) * amount, &mut shares[0], chunk);
        simd.store(simd.load(&pack[WEIGHT[1]], chunk) * amount, &mut shares[1], chunk);
    }
    let span = abreast(pack).and_then(|first| row.get_mut(first..)?.first_chunk_mut::<{ LANES + 1 }>());
    if let Some([lane @ .., last]) = span {
        let mut before = simd.splat(0.0);
        for chunk in 0..LANES / S::WIDTH {
            let of_right = simd.load(&shares[1], chunk);
            let rest = simd.load(lane, chunk) - simd.load(&shares[0], chunk);
            simd.store(rest - of_right.shift(before), lane, chunk);
            before = of_right;
        }
        *last -= shares[1][LANES - 1];
        return;
    }
    for (end, shares) in shares.iter().enumerate() {
        for (share, column) in shares.iter().zip(&pack[LEFT]) {
            if let Some(number) = row.get_mut(place(*column) + end) {
                *number -= share;
            }
        }
    }
}

/// Lets the neighbours of a pack follow each other where it is the same: a node over an end of a segment is over that of the next
/// one as well, and what has no weight is anywhere.
#[inline(always)]
pub(super) fn line_up(pack: &mut PairPack) {
    for l in 1..LANES {
        let (last, this) = (pack[LEFT][l - 1], pack[LEFT][l]);
        let [left, right] = [pack[WEIGHT[0]][l], pack[WEIGHT[1]][l]];
        if left == 0.0 && (right == 0.0 || (right == 1.0 && this == last)) {
            (pack[LEFT][l], pack[WEIGHT[0]][l], pack[WEIGHT[1]][l]) = (last + 1.0, right, 0.0);
        }
    }
    for l in (0..LANES - 1).rev() {
        let (this, next) = (pack[LEFT][l], pack[LEFT][l + 1]);
        let [left, right] = [pack[WEIGHT[0]][l], pack[WEIGHT[1]][l]];
        if right == 0.0 && (left == 0.0 || (left == 1.0 && this == next)) {
            (pack[LEFT][l], pack[WEIGHT[0]][l], pack[WEIGHT[1]][l]) = (next - 1.0, 0.0, left);
        }
    }
    pack[ABREAST][0] = if are_abreast(&pack[LEFT]) { 1.0 } else { 0.0 };
}

/// Whether columns follow each other.
#[inline(always)]
pub(super) fn are_abreast(columns: &Pack) -> bool {
    let mut last = columns[0];
    let mut abreast = true;
    for column in columns.iter().skip(1) {
        abreast &= *column == last + 1.0;
        last = *column;
    }
    abreast
}
