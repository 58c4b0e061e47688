//! What the laws of the invariants share: their stress, its closed form, their shear tangent.

use crate::material::coefficient::Coefficient;
use crate::number::math::THIRD;
use crate::number::real::Real;
use crate::number::vector::{Simd, Vector};
use crate::tensor::stretch::IsochoricState;

/// The coefficient of (I1 - 3) in the polynomials.
pub(crate) const C10: Coefficient =
    Coefficient::modulus("c10", (0.1, 1.0), "coefficient of (I1 - 3) in neo_hookean, mooney_rivlin and yeoh");
/// The coefficient of (I1 - 3)^2 in the polynomials.
pub(crate) const C20: Coefficient =
    Coefficient::modulus("c20", (0.0, 0.2), "mooney_rivlin and yeoh coefficient of (I1 - 3)^2");

/// The principal stresses 2 (W1 l^2 - W2 / l^2) by Rivlin (1948), Pa, from `slopes`, dW/dI1 and dW/dI2 at the invariants.
pub(crate) fn invariant_principal_stress(
    stretches: [Real; 3],
    slopes: impl Fn(Real, Real) -> (Real, Real),
) -> [Real; 3] {
    let squares = stretches.map(|stretch| stretch * stretch);
    let i1 = squares[0] + squares[1] + squares[2];
    let i2 = 1.0 / squares[0] + 1.0 / squares[1] + 1.0 / squares[2];
    let (w1, w2) = slopes(i1, i2);
    squares.map(|square| 2.0 * (w1 * square - w2 / square))
}

/// A majorant of the shear tangent of a law of the invariants, Pa, with what its own stress adds to it, from the first
/// derivatives W1, W2 and the second ones W11, W12, W22.
///
/// With the principal values b_i of C-bar, turning the directions i and j meets W1 (b_i + b_j) + W2 (1/b_i + 1/b_j). Strain
/// along them meets, with the geometric stiffness of the stress, W1 b_i + 3 W2 / b_i, of which a plane state that keeps its
/// volume leaves W2 / b_i; the sums W1 (I1 - 1) + W2 (2 I2 - 4), and 2 W2 for every unit that b_3 or its inverse exceeds
/// one by, are found to cover both in meshes of any state (`tests/verification/tests/suite/frequency.rs`). The second
/// derivatives add the squares of dev b and dev 1/b, exactly. What softens is not counted.
#[inline(always)]
pub(crate) fn invariant_shear_tangent<S: Simd>(
    simd: S,
    stretch: &impl IsochoricState<S::Vector>,
    [w1, w2]: [S::Vector; 2],
    [w11, w12, w22]: [S::Vector; 3],
) -> S::Vector {
    let ((i1, i2), zero) = (stretch.invariants(), simd.splat(0.0));
    let first = stretch.first_order([w1, w2]);
    // Squares and product of dev b and dev 1/b, the latter with its sign turned.
    let squares =
        [i1 * i1.mul_scalar(2.0 * THIRD) - i2.mul_scalar(2.0), i2 * i2.mul_scalar(2.0 * THIRD) - i1.mul_scalar(2.0)];
    let product = (i1 * i2.mul_scalar(THIRD)).add_scalar(-3.0);
    let second = w11.max(zero) * squares[0].max(zero)
        + w22.max(zero) * squares[1].max(zero)
        + (w12.max(zero) * product.max(zero)).mul_scalar(2.0);
    first + second.mul_scalar(2.0)
}
