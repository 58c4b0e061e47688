//! Energies of the triangles of a block of cells.

use crate::number::pack::{LANES, Pack, ZERO};

/// Sums over the triangles of each lane: energies of the section, J.
#[derive(Clone, Copy, Debug)]
pub struct ElementEnergy {
    /// Long-term elastic energy, isochoric and volumetric, less what softening has taken of it.
    pub elastic: Pack,
    /// Energy stored in the damping springs.
    pub slider_stored: Pack,
    /// Work done on the viscous overstress in this step.
    pub viscous_increment: Pack,
    /// Energy dissipated by the sliders in this step.
    pub slider_increment: Pack,
    /// Energy dissipated by tearing in this step.
    pub tear_increment: Pack,
    /// Energy dissipated by softening in this step.
    pub softening_increment: Pack,
    /// Not an energy: 1 in lanes with a triangle whose Jacobian is not positive, or not a number; 0 in others.
    pub inverted: Pack,
}

impl ElementEnergy {
    /// Adds those of other elements, lane by lane.
    pub(crate) fn add(&mut self, other: &Self) {
        let pairs = [
            (&mut self.elastic, &other.elastic),
            (&mut self.slider_stored, &other.slider_stored),
            (&mut self.viscous_increment, &other.viscous_increment),
            (&mut self.slider_increment, &other.slider_increment),
            (&mut self.tear_increment, &other.tear_increment),
            (&mut self.softening_increment, &other.softening_increment),
            (&mut self.inverted, &other.inverted),
        ];
        for (sum, part) in pairs {
            for l in 0..LANES {
                sum[l] += part[l];
            }
        }
    }

    /// Nothing yet.
    pub const ZERO: Self = Self {
        elastic: ZERO,
        slider_stored: ZERO,
        viscous_increment: ZERO,
        slider_increment: ZERO,
        tear_increment: ZERO,
        softening_increment: ZERO,
        inverted: ZERO,
    };
}
