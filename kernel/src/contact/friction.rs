//! Coulomb's law.

use crate::number::math;
use crate::number::real::Real;
use crate::number::vector::Vector;

/// `force`, its size limited to `limit`, N.
pub(super) fn limited_vector(force: [Real; 3], limit: Real) -> [Real; 3] {
    let size = math::sqrt(force[0] * force[0] + force[1] * force[1] + force[2] * force[2]);
    if size > limit { force.map(|force| force * (limit / size)) } else { force }
}

/// `force`, its size limited to `limit`.
#[inline(always)]
pub(crate) fn limited<V: Vector>(force: V, limit: V) -> V {
    let opposite = limit.mul_scalar(-1.0);
    force.select_greater(limit, limit, opposite.select_greater(force, opposite, force))
}
