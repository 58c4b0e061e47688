//! Softening after the first load (Mullins' effect), in the form of Ogden and Roxburgh (1999), with Abaqus' second parameter of
//! its denominator:
//!
//! tau = eta dW/dF F^T, eta = 1 - erf((W_max - W) / s) / r, s = m + beta W_max,
//!
//! with the strain energy density W of the elastic law and the largest one W_max that the point has seen. As long as W grows
//! beyond W_max the law is as it was; below it the stress is smaller, on the way down as on the way up again.
//!
//! It multiplies the long-term elastic stress, from which the Prony series then makes its overstress: so the material is
//! softer at every rate by the same factor, and what softening takes is known in closed form. A cycle to W_max loses
//!
//! D(W_max) = integral from 0 to W_max of (1 - eta) dW = s / r E(W_max / s), E(x) = integral of erf from 0 to x,
//!
//! which grows with W_max and with nothing else, so that dissipation is never negative, and below W_max the work is stored:
//! W + s / r E((W_max - W) / s) - D(W_max). With W of an isochoric law the pressure stays; of a compressible law W and the
//! stress are whole.

use crate::features::PADS;
use crate::material::Material;
use crate::number::erf::erf_of_positive;
use crate::number::real::Real;
use crate::number::vector::{Simd, Vector};

/// Constants of a softening.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Softening {
    /// 1 / r; 0 for a material that does not soften.
    inverse_r: Real,
    /// m, J/m3.
    m: Real,
    /// beta.
    beta: Real,
}

/// What softening leaves of the stress and energy of neighbouring triangles.
#[derive(Clone, Copy, Debug)]
pub struct Softened<V> {
    /// eta.
    pub factor: V,
    /// Energy that is stored, J/m3.
    pub stored: V,
    /// Energy dissipated since the last step, J/m3.
    pub increment: V,
}

impl<V: Vector> Softened<V> {
    /// Of a material that does not soften, whose energy is all stored.
    #[inline(always)]
    pub fn none<S: Simd<Vector = V>>(simd: S, stored: V) -> Self {
        Self { factor: simd.splat(1.0), stored, increment: simd.splat(0.0) }
    }
}

impl Softening {
    /// The softening of `material`.
    pub fn new(material: &Material) -> Self {
        let r = material.softening_r;
        Self { inverse_r: if r > 0.0 { 1.0 / r } else { 0.0 }, m: material.softening_m, beta: material.softening_beta }
    }

    /// Whether the material softens.
    #[inline(always)]
    pub fn active(&self) -> bool {
        PADS && self.inverse_r > 0.0
    }

    /// eta at the energy `w` of the whole law below the largest one so far, J/m3.
    #[inline(always)]
    pub fn factor<S: Simd>(&self, simd: S, w: S::Vector, largest: S::Vector) -> S::Vector {
        let erf = erf_of_positive(simd, (largest - w) / self.scale(largest));
        simd.splat(1.0) - erf.value.mul_scalar(self.inverse_r)
    }

    /// Takes the energy `w` of the whole law into the `largest` so far and the energy `dissipated` so far, J/m3.
    #[inline(always)]
    pub fn update<S: Simd>(
        &self,
        simd: S,
        w: S::Vector,
        largest: &mut S::Vector,
        dissipated: &mut S::Vector,
    ) -> Softened<S::Vector> {
        *largest = w.select_greater(*largest, w, *largest);
        let scale = self.scale(*largest);
        let part = scale.mul_scalar(self.inverse_r);
        let [whole, left] = [erf_of_positive(simd, *largest / scale), erf_of_positive(simd, (*largest - w) / scale)];
        // What a cycle to the largest energy loses.
        let lost = part * whole.integral;
        let increment = lost - *dissipated;
        *dissipated = lost;
        Softened {
            factor: simd.splat(1.0) - left.value.mul_scalar(self.inverse_r),
            stored: w + (part * left.integral - lost),
            increment,
        }
    }

    /// The largest that d eta / dW can be where the law's energy is `w`, J/m3, by which the square of the stress stiffens:
    /// 2 / (r sqrt(pi) s), m3/J.
    #[inline(always)]
    pub fn largest_slope<S: Simd>(&self, simd: S, w: S::Vector) -> S::Vector {
        simd.splat(DOUBLE_INVERSE_SQRT_PI * self.inverse_r) / self.scale(w.max(simd.splat(0.0)))
    }

    /// s, J/m3.
    #[inline(always)]
    fn scale<V: Vector>(&self, largest: V) -> V {
        largest.mul_scalar(self.beta).add_scalar(self.m)
    }
}

/// 2 / sqrt(pi).
const DOUBLE_INVERSE_SQRT_PI: Real = crate::number::real::consts::FRAC_2_SQRT_PI;
