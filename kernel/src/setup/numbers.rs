//! What the numbers of the nodes of a model come from, and how they are put there.

use crate::number::real::Real;

/// Where the nodes of column u, row v and slice w rest, m; a section has the one slice 0 and no z.
pub(crate) type Positions<'p> = &'p dyn Fn([usize; 3]) -> [Real; 3];

/// Sets one number; nothing past the end, which the sizes exclude.
pub(super) fn put(row: &mut [Real], node: usize, value: Real) {
    if let Some(place) = row.get_mut(node) {
        *place = value;
    }
}
