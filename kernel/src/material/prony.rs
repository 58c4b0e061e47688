//! Quasi-linear viscoelasticity on the isochoric stress, or the whole one of a compressible law (Fung's form of the Prony
//! series):
//!
//! H_k' = -H_k / tau_k + (g_k / g_inf) tau_iso', overstress = sum H_k,
//!
//! where tau_iso is the long-term Kirchhoff stress in the unrotated frame and g_inf + sum g_k = 1. The recurrence is that
//! of [`crate::material::relaxation`].
//!
//! At finite strain no energy belongs to such a branch: its work cannot be told into stored and dissipated (see
//! [`crate::state`]).

use crate::material::Material;
use crate::material::relaxation::{Branches, Overstress};
use crate::number::pack::Pack;
use crate::number::real::Real;
use crate::number::vector::Simd;
use crate::tensor::deviator::Deviator;
use crate::tensor::solid_deviator::{DEVIATOR_PACKS, SolidDeviator};

/// The constants of the recurrence, for one step size.
#[derive(Clone, Debug, PartialEq)]
pub struct Prony {
    branches: Branches,
    overstress: Real,
}

impl Prony {
    /// The terms of `material` with g > 0, for steps of `dt` s.
    pub fn new(material: &Material, dt: Real) -> Self {
        let mut prony = Self { branches: Branches::NONE, overstress: 0.0 };
        let g_inf = material.prony_g_inf();
        for (g, tau) in material.prony_g.iter().zip(material.prony_tau) {
            if *g > 0.0 {
                let ratio = g / g_inf;
                prony.branches.push(ratio, dt / tau);
                prony.overstress += ratio;
            }
        }
        prony
    }

    /// Number of active terms.
    pub fn n_term(&self) -> usize {
        self.branches.n_term()
    }

    /// Ratio of instantaneous overstress to long-term stress, sum g_k / g_inf.
    pub fn overstress(&self) -> Real {
        self.overstress
    }

    /// Advances the `history` of the two triangles of each cell of a block (one entry per active term) by the increment of
    /// the elastic stress.
    #[inline(always)]
    pub fn update<S: Simd>(
        &self,
        simd: S,
        chunk: usize,
        increment: &[Deviator<S::Vector>; 2],
        history: [&mut [Deviator]; 2],
        overstress: &mut [Overstress<Deviator<S::Vector>>; 2],
    ) {
        self.branches.update(simd, chunk, increment, history, overstress);
    }

    /// The same for tetrahedra.
    #[inline(always)]
    pub fn update_solid<S: Simd>(
        &self,
        simd: S,
        chunk: usize,
        increment: &SolidDeviator<S::Vector>,
        history: &mut [[Pack; DEVIATOR_PACKS]],
        overstress: &mut Overstress<SolidDeviator<S::Vector>>,
    ) {
        self.branches.update_solid(simd, chunk, increment, history, overstress);
    }
    /// Advances the `history` of the mean stress of a compressible law by its increment; see [`Branches::update_mean`].
    #[inline(always)]
    pub fn update_mean<S: Simd>(
        &self,
        simd: S,
        chunk: usize,
        increment: S::Vector,
        history: &mut [Deviator],
    ) -> [S::Vector; 2] {
        self.branches.update_mean(simd, chunk, increment, history)
    }

    /// The same for tetrahedra, a pack of `history` for each term.
    #[inline(always)]
    pub fn update_solid_mean<S: Simd>(
        &self,
        simd: S,
        chunk: usize,
        increment: S::Vector,
        history: &mut [Pack],
    ) -> [S::Vector; 2] {
        self.branches.update_solid_mean(simd, chunk, increment, history)
    }
}
