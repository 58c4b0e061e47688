//! Complex numbers of vectors, for pairs of components that a turn of the plane mixes.

use core::ops::{Add, Mul};

use crate::number::real::Real;
use crate::number::vector::Vector;

/// A complex number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Complex<V> {
    /// Real part.
    pub re: V,
    /// Imaginary part.
    pub im: V,
}

impl<V: Vector> Complex<V> {
    /// Same size, opposite angle.
    #[inline(always)]
    pub fn conjugate(&self) -> Self {
        Self { re: self.re, im: self.im.mul_scalar(-1.0) }
    }

    /// Both parts times `factor`.
    #[inline(always)]
    pub fn scaled(&self, factor: V) -> Self {
        Self { re: self.re * factor, im: self.im * factor }
    }

    /// Both parts times the same number.
    #[inline(always)]
    pub fn mul_scalar(&self, number: Real) -> Self {
        Self { re: self.re.mul_scalar(number), im: self.im.mul_scalar(number) }
    }

    /// Sum of the products of the parts: the real part of one number times the conjugate of the other.
    #[inline(always)]
    pub fn dot(&self, other: &Self) -> V {
        self.re * other.re + self.im * other.im
    }
}

impl<V: Vector> Add for Complex<V> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { re: self.re + other.re, im: self.im + other.im }
    }
}

impl<V: Vector> Mul for Complex<V> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self { re: self.re * other.re - self.im * other.im, im: self.re * other.im + self.im * other.re }
    }
}
