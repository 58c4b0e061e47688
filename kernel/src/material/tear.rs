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
//! counted with their work (see [`crate::energy`]), before and after.

use crate::element::Kinematics;
use crate::lanes::{LANES, Lane};
use crate::real::Real;
use crate::scenario::Material;
use crate::stretch::largest_in_plane;

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
    pub fn factor(&self, largest: Real) -> Real {
        let x = (largest - self.limit) / self.width;
        if x <= 0.0 {
            1.0
        } else if x >= 1.0 {
            self.residual
        } else {
            1.0 - (1.0 - self.residual) * (x * x * (3.0 - 2.0 * x))
        }
    }

    /// Takes the stretch of a block into the `largest` so far; returns phi before and after.
    #[inline]
    pub fn update(&self, kinematics: &Kinematics, largest: &mut Lane) -> [Lane; 2] {
        let mut factors = [[1.0; LANES]; 2];
        for l in 0..LANES {
            factors[0][l] = self.factor(largest[l]);
            let in_plane = largest_in_plane(kinematics.u11[l], kinematics.u22[l], kinematics.u12[l]);
            for stretch in [in_plane, kinematics.u33[l]] {
                largest[l] = if stretch > largest[l] { stretch } else { largest[l] };
            }
            factors[1][l] = self.factor(largest[l]);
        }
        factors
    }
}
