//! Tearing: once the largest principal stretch so far passes a limit, the deviatoric stress falls irreversibly.
//!
//! With m the largest principal stretch of U that the point has seen, all deviatoric stresses are multiplied by
//!
//! phi(m) = 1 - (1 - residual) s((m - limit) / width), s(x) = x^2 (3 - 2 x) between 0 and 1,
//!
//! an isotropic damage of the deviatoric response in the manner of Kachanov (1958) and Simo (1987), driven by stretch.
//! The pressure stays: a torn skin is still squeezed. The energies that the point stores, elastic and in its damping
//! spring, are phi times those of the whole material; what they lose while phi falls, -phi' times the stored energy of the
//! whole material, is dissipated, and no history makes it negative. The energy in the springs of the viscous branches is
//! counted with their work (see [`crate::state`]), before and after.

use crate::material::Material;
use crate::number::real::Real;
use crate::number::vector::{Simd, Vector};
use crate::tensor::kinematics::Kinematics;
use crate::tensor::stretch::largest_in_plane;

/// Constants of a tear.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tear {
    /// Largest principal stretch at which the tear begins; 0 for a material that does not tear.
    pub limit: Real,
    /// Stretch over which the stress falls.
    pub width: Real,
    /// Part of the stress that remains.
    pub residual: Real,
}

impl Tear {
    /// The tear of `material`.
    pub fn new(material: &Material) -> Self {
        Self { limit: material.tear_stretch, width: material.tear_width, residual: material.tear_residual }
    }

    /// Whether the material tears.
    #[inline(always)]
    pub fn active(&self) -> bool {
        self.limit > 0.0
    }

    /// phi at the largest stretch so far.
    #[inline(always)]
    pub fn factor<S: Simd>(&self, simd: S, largest: S::Vector) -> S::Vector {
        let (zero, one) = (simd.splat(0.0), simd.splat(1.0));
        let x = (largest - simd.splat(self.limit)) / simd.splat(self.width);
        let fallen = (x * x * (simd.splat(3.0) - x.mul_scalar(2.0))).mul_scalar(1.0 - self.residual);
        let torn = one.select_greater(x, one - fallen, simd.splat(self.residual));
        x.select_greater(zero, torn, one)
    }

    /// Takes the stretch of neighbouring triangles into the `largest` so far; returns it, and phi before and after.
    #[inline(always)]
    pub fn update<S: Simd>(&self, simd: S, kinematics: &Kinematics<S::Vector>, before: S::Vector) -> [S::Vector; 3] {
        let Kinematics { mean, difference, shear, hoop, .. } = *kinematics;
        let section = largest_in_plane(mean, difference, shear);
        let largest = section.select_greater(before, section, before);
        let largest = hoop.select_greater(largest, hoop, largest);
        [largest, self.factor(simd, before), self.factor(simd, largest)]
    }

    /// The same for tetrahedra, of these principal stretches.
    #[inline(always)]
    pub fn update_solid<S: Simd>(&self, simd: S, stretches: [S::Vector; 3], before: S::Vector) -> [S::Vector; 3] {
        let mut largest = before;
        for stretch in stretches {
            largest = stretch.select_greater(largest, stretch, largest);
        }
        [largest, self.factor(simd, before), self.factor(simd, largest)]
    }
}
