//! Symmetric tensors of a solid, and their principal values.

use crate::number::pack::Pack;
use crate::number::real::TINY_SQUARE;
use crate::number::vector::{Simd, Vector};

/// Packs of a [`Symmetric`].
pub(crate) const SYMMETRIC_PACKS: usize = 6;

/// A symmetric tensor by its components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Symmetric<V> {
    /// Component xx.
    pub xx: V,
    /// Component yy.
    pub yy: V,
    /// Component zz.
    pub zz: V,
    /// Component xy.
    pub xy: V,
    /// Component yz.
    pub yz: V,
    /// Component zx.
    pub zx: V,
}

/// Principal values of a symmetric tensor, in no order, and the directions that belong to them, a row each.
pub(crate) struct Principal<V> {
    pub values: [V; 3],
    pub directions: [[V; 3]; 3],
}

/// Sweeps of Jacobi's method: after the fourth, what is left beside the diagonal is below 10^-20 of it.
const SWEEPS: usize = 4;

impl<V: Vector> Symmetric<V> {
    /// Times the unit tensor.
    #[inline(always)]
    pub fn unit(value: V, zero: V) -> Self {
        Self { xx: value, yy: value, zz: value, xy: zero, yz: zero, zx: zero }
    }

    /// Sum of the diagonal.
    #[inline(always)]
    pub fn trace(&self) -> V {
        self.xx + self.yy + self.zz
    }

    /// Every component times `factor`.
    #[inline(always)]
    pub fn scaled(&self, factor: V) -> Self {
        Self {
            xx: factor * self.xx,
            yy: factor * self.yy,
            zz: factor * self.zz,
            xy: factor * self.xy,
            yz: factor * self.yz,
            zx: factor * self.zx,
        }
    }

    /// Sum of two tensors.
    #[inline(always)]
    pub fn plus(&self, other: &Self) -> Self {
        Self {
            xx: self.xx + other.xx,
            yy: self.yy + other.yy,
            zz: self.zz + other.zz,
            xy: self.xy + other.xy,
            yz: self.yz + other.yz,
            zx: self.zx + other.zx,
        }
    }

    /// Difference of two tensors.
    #[inline(always)]
    pub fn minus(&self, other: &Self) -> Self {
        Self {
            xx: self.xx - other.xx,
            yy: self.yy - other.yy,
            zz: self.zz - other.zz,
            xy: self.xy - other.xy,
            yz: self.yz - other.yz,
            zx: self.zx - other.zx,
        }
    }

    /// The adjugate: the inverse times the determinant.
    #[inline(always)]
    pub fn adjugate(&self) -> Self {
        let Self { xx, yy, zz, xy, yz, zx } = *self;
        Self {
            xx: yy * zz - yz * yz,
            yy: zz * xx - zx * zx,
            zz: xx * yy - xy * xy,
            xy: yz * zx - xy * zz,
            yz: zx * xy - yz * xx,
            zx: xy * yz - zx * yy,
        }
    }

    /// The determinant, from the adjugate.
    #[inline(always)]
    pub fn determinant(&self, adjugate: &Self) -> V {
        self.xx * adjugate.xx + self.xy * adjugate.xy + self.zx * adjugate.zx
    }

    /// The product with itself.
    #[inline(always)]
    pub fn square(&self) -> Self {
        let Self { xx, yy, zz, xy, yz, zx } = *self;
        let (a, b, c) = (xy * xy, yz * yz, zx * zx);
        Self {
            xx: xx * xx + a + c,
            yy: yy * yy + a + b,
            zz: zz * zz + b + c,
            xy: xy * (xx + yy) + yz * zx,
            yz: yz * (yy + zz) + zx * xy,
            zx: zx * (zz + xx) + xy * yz,
        }
    }

    /// The product with a vector.
    #[inline(always)]
    pub fn times(&self, [x, y, z]: [V; 3]) -> [V; 3] {
        [
            self.xx * x + self.xy * y + self.zx * z,
            self.xy * x + self.yy * y + self.yz * z,
            self.zx * x + self.yz * y + self.zz * z,
        ]
    }

    /// B A B with the symmetric A = `inner` and B this.
    #[inline(always)]
    pub fn around(&self, inner: &Self) -> Self {
        let rows = [
            inner.times([self.xx, self.xy, self.zx]),
            inner.times([self.xy, self.yy, self.yz]),
            inner.times([self.zx, self.yz, self.zz]),
        ];
        let [x, y, z] = [self.times(rows[0]), self.times(rows[1]), self.times(rows[2])];
        Self { xx: x[0], yy: y[1], zz: z[2], xy: x[1], yz: y[2], zx: x[2] }
    }

    /// The symmetric part of the product with another symmetric tensor.
    #[inline(always)]
    pub fn symmetric_product(&self, other: &Self) -> Self {
        let rows = [
            self.times([other.xx, other.xy, other.zx]),
            self.times([other.xy, other.yy, other.yz]),
            self.times([other.zx, other.yz, other.zz]),
        ];
        Self {
            xx: rows[0][0],
            yy: rows[1][1],
            zz: rows[2][2],
            xy: (rows[0][1] + rows[1][0]).mul_scalar(0.5),
            yz: (rows[1][2] + rows[2][1]).mul_scalar(0.5),
            zx: (rows[0][2] + rows[2][0]).mul_scalar(0.5),
        }
    }

    /// The `chunk`-th vectors of packs of tensors.
    #[inline(always)]
    pub fn load<S: Simd<Vector = V>>(
        simd: S,
        [xx, yy, zz, xy, yz, zx]: &[Pack; SYMMETRIC_PACKS],
        chunk: usize,
    ) -> Self {
        Self {
            xx: simd.load(xx, chunk),
            yy: simd.load(yy, chunk),
            zz: simd.load(zz, chunk),
            xy: simd.load(xy, chunk),
            yz: simd.load(yz, chunk),
            zx: simd.load(zx, chunk),
        }
    }

    /// Writes the `chunk`-th vectors of packs of tensors.
    #[inline(always)]
    pub fn store<S: Simd<Vector = V>>(&self, simd: S, packs: &mut [Pack; SYMMETRIC_PACKS], chunk: usize) {
        let [xx, yy, zz, xy, yz, zx] = packs;
        simd.store(self.xx, xx, chunk);
        simd.store(self.yy, yy, chunk);
        simd.store(self.zz, zz, chunk);
        simd.store(self.xy, xy, chunk);
        simd.store(self.yz, yz, chunk);
        simd.store(self.zx, zx, chunk);
    }

    /// Principal values and directions, by Jacobi's method with a fixed number of sweeps.
    #[inline(always)]
    pub(crate) fn principal<S: Simd<Vector = V>>(&self, simd: S) -> Principal<V> {
        let (zero, one) = (simd.splat(0.0), simd.splat(1.0));
        let mut rows = [[self.xx, self.xy, self.zx], [self.xy, self.yy, self.yz], [self.zx, self.yz, self.zz]];
        let mut directions = [[one, zero, zero], [zero, one, zero], [zero, zero, one]];
        for _ in 0..SWEEPS {
            turn::<S, 0, 1, 2>(simd, &mut rows, &mut directions);
            turn::<S, 0, 2, 1>(simd, &mut rows, &mut directions);
            turn::<S, 1, 2, 0>(simd, &mut rows, &mut directions);
        }
        Principal { values: [rows[0][0], rows[1][1], rows[2][2]], directions }
    }
}

/// Turns the axes P and Q so that nothing is left between them. Constants, so that no index is looked at.
#[inline(always)]
fn turn<S: Simd, const P: usize, const Q: usize, const OTHER: usize>(
    simd: S,
    rows: &mut [[S::Vector; 3]; 3],
    directions: &mut [[S::Vector; 3]; 3],
) {
    let (zero, one) = (simd.splat(0.0), simd.splat(1.0));
    let (double, difference) = (rows[P][Q] + rows[P][Q], rows[Q][Q] - rows[P][P]);
    // Never zero, so that the quotient has its limit.
    let root = (difference * difference + double * double).add_scalar(TINY_SQUARE).square_root();
    let tangent = double / difference.select_greater(zero, difference + root, difference - root);
    let cos = one / (tangent * tangent).add_scalar(1.0).square_root();
    let sin = tangent * cos;
    let change = tangent * rows[P][Q];
    rows[P][P] = rows[P][P] - change;
    rows[Q][Q] = rows[Q][Q] + change;
    let (a, b) = (rows[P][OTHER], rows[Q][OTHER]);
    (rows[P][OTHER], rows[Q][OTHER]) = (cos * a - sin * b, sin * a + cos * b);
    (rows[OTHER][P], rows[OTHER][Q]) = (rows[P][OTHER], rows[Q][OTHER]);
    (rows[P][Q], rows[Q][P]) = (zero, zero);
    for k in 0..3 {
        let (a, b) = (directions[P][k], directions[Q][k]);
        directions[P][k] = cos * a - sin * b;
        directions[Q][k] = sin * a + cos * b;
    }
}

impl<V: Vector> Principal<V> {
    /// The tensor with other `values` in the same directions.
    #[inline(always)]
    pub fn with_values(&self, values: [V; 3]) -> Symmetric<V> {
        Symmetric {
            xx: self.component(values, 0, 0),
            yy: self.component(values, 1, 1),
            zz: self.component(values, 2, 2),
            xy: self.component(values, 0, 1),
            yz: self.component(values, 1, 2),
            zx: self.component(values, 2, 0),
        }
    }

    #[inline(always)]
    fn component(&self, [p, q, r]: [V; 3], i: usize, j: usize) -> V {
        let [a, b, c] = &self.directions;
        p * (a[i] * a[j]) + q * (b[i] * b[j]) + r * (c[i] * c[j])
    }
}
