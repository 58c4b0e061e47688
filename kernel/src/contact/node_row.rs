//! A row of nodes that something rigid may touch; of a solid, in all its slices.

use crate::model::Model;
use crate::number::pack::{LANES, Pack, packs, packs_mut};
use crate::number::real::Real;
use crate::number::vector::Simd;

/// A row of nodes, in packs of neighbours; x before y.
pub(super) struct NodeRow<'s> {
    /// Lumped mass, kg; 0 in padding.
    pub mass: &'s [Pack],
    /// 1/kg; 0 where fixed.
    pub inverse_mass: [&'s [Pack]; 2],
    /// Position at rest, m.
    pub reference: [&'s [Pack]; 2],
    /// Displacement, m.
    pub displacement: [&'s [Pack]; 2],
    /// Velocity half a step back, m/s.
    pub velocity: [&'s [Pack]; 2],
    /// Force of the step, N.
    pub force: [&'s mut [Pack]; 2],
}

impl<'s> NodeRow<'s> {
    /// Row `v` from the core, of `plane` nodes (those of a solid in all its slices), from displacement, velocity and force of all
    /// nodes; none if an array is too short, which the sizes of [`crate::mesh::Grid`] exclude. The caller says how many, so that
    /// the compiler sees where its own arrays are as long.
    #[inline(always)]
    pub fn of(
        model: &'s Model,
        v: usize,
        plane: usize,
        [ux, uy]: &'s [&mut [Real]; 2],
        [vx, vy]: &'s [&mut [Real]; 2],
        [fx, fy]: &'s mut [&mut [Real]; 2],
    ) -> Option<Self> {
        let fixed = &model.nodes;
        let (first, count) = (v * plane, plane / LANES);
        let row = |[x, y]: [&'s [Real]; 2]| Some([packs(x, first, count)?, packs(y, first, count)?]);
        Some(Self {
            mass: packs(fixed.nodal_mass, first, count)?,
            inverse_mass: row([fixed.inverse_mass_x, fixed.inverse_mass_y])?,
            reference: row([fixed.reference_x, fixed.reference_y])?,
            displacement: row([ux, uy])?,
            velocity: row([vx, vy])?,
            force: [packs_mut(fx, first, count)?, packs_mut(fy, first, count)?],
        })
    }

    /// Coordinate `axis` of some nodes of pack `i`, m.
    #[inline(always)]
    pub fn position<S: Simd>(&self, simd: S, axis: usize, i: usize, chunk: usize) -> S::Vector {
        simd.load(&self.reference[axis][i], chunk) + simd.load(&self.displacement[axis][i], chunk)
    }
}
