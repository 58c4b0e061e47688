//! Stress of single triangles, as the last step left it in their history.

use crate::lanes::LANES;
use crate::math;
use crate::model::Model;
use crate::real::Real;
use crate::state_view::StateView;

/// Cauchy stress of a triangle in its unrotated frame, Pa, positive in tension.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stress {
    /// Deviator: xx, yy, xy; zz is minus the sum of the first two.
    pub deviator: [Real; 3],
    /// Mean stress of the cell, from its mean dilatation.
    pub mean: Real,
}

impl Stress {
    /// Stress of triangle `column` (two per cell) in `row`, counted from the core and the first column; none outside.
    pub fn of(model: &Model, state: &StateView, row: usize, column: usize) -> Option<Self> {
        let grid = &model.constants.grid;
        let (u, t) = (column / 2, column % 2);
        if u >= grid.n_u || row >= grid.n_v {
            return None;
        }
        let (block, l) = (row * grid.blocks_per_row() + u / LANES, u % LANES);
        let history = state.cells.get(block)?.triangle.get(t)?;
        let laws = model.constants.laws_of(block);
        // The terms of the first triangle, then those of the second, in a block's share of the history.
        let first = 2 * block * model.constants.n_term() + t * laws.n_term();
        let overstress = state.viscous.get(first..first + laws.n_term())?;
        let mut deviator = history.elastic_prev.lane(l)?;
        for part in core::iter::once(&history.slider_stress).chain(overstress) {
            deviator = deviator + part.lane(l)?;
        }
        let deviator = deviator.section();
        let whole = if laws.tear.active() { laws.tear.factor(*history.largest_stretch.get(l)?) } else { 1.0 };
        let jacobian = jacobian(&history.stretch_prev, l)?;
        let mean = laws.volumetric.stress(mean_jacobian(model, state, block, l)?);
        Some(Self { deviator: deviator.map(|kirchhoff| whole * kirchhoff / jacobian), mean })
    }

    /// Von Mises stress, Pa.
    pub fn von_mises(&self) -> Real {
        let [xx, yy, xy] = self.deviator;
        math::sqrt(3.0 * (xx * (xx + yy) + yy * yy + xy * xy))
    }

    /// Principal stresses, Pa: the larger and the smaller one of the section, then the one out of the plane.
    pub fn principal(&self) -> [Real; 3] {
        let [xx, yy, xy] = self.deviator;
        let (centre, half) = (0.5 * (xx + yy), 0.5 * (xx - yy));
        let radius = math::sqrt(half * half + xy * xy);
        [self.mean + centre + radius, self.mean + centre - radius, self.mean - (xx + yy)]
    }
}

/// J of a triangle from its right stretch.
fn jacobian(stretch: &[[Real; LANES]; 4], l: usize) -> Option<Real> {
    let [mean, difference, shear, hoop] = stretch.each_ref().map(|lane| lane.get(l).copied());
    let (mean, difference, shear) = (mean?, difference?, shear?);
    Some((mean * mean - (difference * difference + shear * shear)) * hoop?)
}

/// Volume-weighted mean J of a cell.
fn mean_jacobian(model: &Model, state: &StateView, block: usize, l: usize) -> Option<Real> {
    let (constants, history) = (model.cells.get(block)?, state.cells.get(block)?);
    let mut mean = 1.0;
    for (constants, history) in constants.triangle.iter().zip(&history.triangle) {
        mean += constants.patch_weight.get(l)? * (jacobian(&history.stretch_prev, l)? - 1.0);
    }
    Some(mean)
}
