//! The shear tangent of laws of the invariants.

use crate::number::math::THIRD;
use crate::number::vector::{Instructions, Vector};
use crate::tensor::stretch::IsochoricStretch;

/// A majorant of the shear tangent of a law of the invariants, Pa, with what its own stress adds to it, from the first
/// derivatives W1, W2 and the second ones W11, W12, W22.
///
/// With the principal values b_i of C-bar, turning the directions i and j meets W1 (b_i + b_j) + W2 (1/b_i + 1/b_j). Strain
/// along them meets, with the geometric stiffness of the stress, W1 b_i + 3 W2 / b_i, of which a plane state that keeps its
/// volume leaves W2 / b_i; the sums W1 (I1 - 1) + W2 (2 I2 - 4), and 2 W2 for every unit that b_3 or its inverse exceeds
/// one by, are found to cover both in meshes of any state (`tests/verification/tests/suite/frequency.rs`). The second
/// derivatives add the squares of dev b and dev 1/b, exactly. What softens is not counted.
#[inline(always)]
pub(crate) fn invariant_shear_tangent<S: Instructions>(
    set: S,
    stretch: &IsochoricStretch<S::Vector>,
    [w1, w2]: [S::Vector; 2],
    [w11, w12, w22]: [S::Vector; 3],
) -> S::Vector {
    let ((i1, i2), zero) = (stretch.invariants(), set.splat(0.0));
    let out = stretch.u33 * stretch.u33;
    let around = out.larger(set.splat(1.0) / out).plus(-1.0);
    let first = w1.larger(zero) * i1.plus(-1.0) + w2.larger(zero) * (i2 + around).times(2.0).plus(-4.0);
    // Squares and product of dev b and dev 1/b, the latter with its sign turned.
    let squares = [i1 * i1.times(2.0 * THIRD) - i2.times(2.0), i2 * i2.times(2.0 * THIRD) - i1.times(2.0)];
    let product = (i1 * i2.times(THIRD)).plus(-3.0);
    let second = w11.larger(zero) * squares[0].larger(zero)
        + w22.larger(zero) * squares[1].larger(zero)
        + (w12.larger(zero) * product.larger(zero)).times(2.0);
    first + second.times(2.0)
}
