//! Stress of single triangles, as the last step left it in their history.

use crate::lanes::{Deviator, LANES, contract};
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
        let mut deviator = [0.0; 3];
        for part in [&history.elastic_prev, &history.slider_stress].into_iter().chain(overstress) {
            add(&mut deviator, part, l)?;
        }
        let whole = if laws.tear.active() { laws.tear.factor(*history.largest_stretch.get(l)?) } else { 1.0 };
        let jacobian = jacobian(&history.stretch_prev, l)?;
        let mean = laws.volumetric.stress(&[mean_jacobian(model, state, block, l)?; LANES]);
        Some(Self { deviator: deviator.map(|kirchhoff| whole * kirchhoff / jacobian), mean: *mean.first()? })
    }

    /// Von Mises stress, Pa.
    pub fn von_mises(&self) -> Real {
        math::sqrt(1.5 * contract(self.deviator, self.deviator))
    }

    /// Principal stresses, Pa: the larger and the smaller one of the section, then the one out of the plane.
    pub fn principal(&self) -> [Real; 3] {
        let [xx, yy, xy] = self.deviator;
        let (centre, half) = (0.5 * (xx + yy), 0.5 * (xx - yy));
        let radius = math::sqrt(half * half + xy * xy);
        [self.mean + centre + radius, self.mean + centre - radius, self.mean - (xx + yy)]
    }
}

fn add(sum: &mut [Real; 3], part: &Deviator, l: usize) -> Option<()> {
    for (total, lane) in sum.iter_mut().zip([&part.xx, &part.yy, &part.xy]) {
        *total += lane.get(l)?;
    }
    Some(())
}

/// J of a triangle from its right stretch.
fn jacobian(stretch: &[[Real; LANES]; 4], l: usize) -> Option<Real> {
    let [u11, u22, u12, u33] = stretch.each_ref().map(|lane| lane.get(l).copied());
    let (u11, u22, u12, u33) = (u11?, u22?, u12?, u33?);
    Some((u11 * u22 - u12 * u12) * u33)
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
