//! Additive viscoelasticity: Maxwell elements of absolute shear modulus G_k and decay constant beta_k beside the rest, as
//! in LS-DYNA's MAT_077_H and OpenRadioss's viscous option of its hyperelastic laws:
//!
//! H_k' = -beta_k H_k + 2 G_k dev(e'), overstress = sum H_k,
//!
//! with the unrotated rate of deformation e' = R^T D R, as in [`crate::material::slider`], and the recurrence of
//! [`crate::material::relaxation`].

use crate::material::Material;
use crate::material::relaxation::{Branches, Overstress};
use crate::number::pack::Pack;
use crate::number::real::Real;
use crate::number::vector::Simd;
use crate::tensor::deviator::Deviator;
use crate::tensor::solid_deviator::{DEVIATOR_PACKS, SolidDeviator};

/// The constants of the recurrence, for one step size.
#[derive(Clone, Debug, PartialEq)]
pub struct Maxwell {
    branches: Branches,
    shear_modulus: Real,
}

impl Maxwell {
    /// The terms of `material` with G > 0, for steps of `dt` s.
    pub fn new(material: &Material, dt: Real) -> Self {
        let mut maxwell = Self { branches: Branches::NONE, shear_modulus: 0.0 };
        for (g, beta) in material.maxwell_g.iter().zip(material.maxwell_beta) {
            if *g > 0.0 {
                maxwell.branches.push(2.0 * g, dt * beta);
                maxwell.shear_modulus += g;
            }
        }
        maxwell
    }

    /// Number of active terms.
    pub fn n_term(&self) -> usize {
        self.branches.n_term()
    }

    /// Shear modulus of all terms unrelaxed, Pa.
    pub fn shear_modulus(&self) -> Real {
        self.shear_modulus
    }

    /// Advances the `history` of the two triangles of each cell of a block (one entry per active term) by the deviatoric
    /// strain increment.
    #[inline(always)]
    pub fn update<S: Simd>(
        &self,
        simd: S,
        chunk: usize,
        strain_increment: &[Deviator<S::Vector>; 2],
        history: [&mut [Deviator]; 2],
        overstress: &mut [Overstress<Deviator<S::Vector>>; 2],
    ) {
        self.branches.update(simd, chunk, strain_increment, history, overstress);
    }

    /// The same for tetrahedra.
    #[inline(always)]
    pub fn update_solid<S: Simd>(
        &self,
        simd: S,
        chunk: usize,
        strain_increment: &SolidDeviator<S::Vector>,
        history: &mut [[Pack; DEVIATOR_PACKS]],
        overstress: &mut Overstress<SolidDeviator<S::Vector>>,
    ) {
        self.branches.update_solid(simd, chunk, strain_increment, history, overstress);
    }
}
