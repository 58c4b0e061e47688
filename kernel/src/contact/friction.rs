//! Coulomb's law.

use crate::number::vector::Vector;

/// `force`, its size limited to `limit`.
#[inline(always)]
pub(crate) fn limited<V: Vector>(force: V, limit: V) -> V {
    let opposite = limit.mul_scalar(-1.0);
    force.select_greater(limit, limit, opposite.select_greater(force, opposite, force))
}
