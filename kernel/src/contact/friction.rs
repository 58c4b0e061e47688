//! Coulomb's law.

use crate::number::vector::Vector;

/// `force`, its size limited to `limit`.
#[inline(always)]
pub(crate) fn limited<V: Vector>(force: V, limit: V) -> V {
    let opposite = limit.times(-1.0);
    force.if_greater(limit, limit, opposite.if_greater(force, opposite, force))
}
