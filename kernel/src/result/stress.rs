//! Stress, stretch and rotation of single triangles, at the time of the last step's stresses.

use crate::mesh::{CORNERS, triangles};
use crate::model::Model;
use crate::number::math;
use crate::number::pack::LANES;
use crate::number::real::Real;
use crate::number::vector::Scalar;
use crate::state::StateView;
use crate::tensor::stretch::largest_in_plane;

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
        let whole = if laws.tear.active() { laws.tear.factor(Scalar, *history.largest_stretch.get(l)?) } else { 1.0 };
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
        mean += constants.volume_fraction.get(l)? * (jacobian(&history.stretch_prev, l)? - 1.0);
    }
    Some(mean)
}

/// Cauchy stress of triangle `column` (two per cell) in `row` along the fixed axes, Pa, positive in tension: xx, yy, xy,
/// and zz out of the section; none outside.
pub fn cauchy_stress(model: &Model, state: &StateView, row: usize, column: usize) -> Option<[Real; 4]> {
    let stress = Stress::of(model, state, row, column)?;
    let [cos, sin] = rotation(model, state, row, column)?;
    // R s R^T of the deviator's part in the section, whose trace does not turn.
    let [xx, yy, xy] = stress.deviator;
    let (centre, half) = (0.5 * (xx + yy), 0.5 * (xx - yy));
    let (cos_double, sin_double) = (cos * cos - sin * sin, 2.0 * cos * sin);
    let turned = half * cos_double - xy * sin_double;
    let shear = half * sin_double + xy * cos_double;
    Some([stress.mean + centre + turned, stress.mean + centre - turned, shear, stress.mean - (xx + yy)])
}

/// Principal stretches of a triangle: the larger and the smaller one in the section, then the one out of it.
pub fn principal_stretch(model: &Model, state: &StateView, row: usize, column: usize) -> Option<[Real; 3]> {
    let grid = &model.constants.grid;
    let (u, t) = (column / 2, column % 2);
    if u >= grid.n_u || row >= grid.n_v {
        return None;
    }
    let (block, l) = (row * grid.blocks_per_row() + u / LANES, u % LANES);
    let history = state.cells.get(block)?.triangle.get(t)?;
    let [mean, difference, shear, hoop] = history.stretch_prev.each_ref().map(|lane| lane.get(l).copied());
    let (mean, difference, shear) = (mean?, difference?, shear?);
    let largest = largest_in_plane(mean, difference, shear);
    Some([largest, (mean * mean - (difference * difference + shear * shear)) / largest, hoop?])
}

/// Cosine and sine of the rotation R of F = R U.
fn rotation(model: &Model, state: &StateView, row: usize, column: usize) -> Option<[Real; 2]> {
    let corners = triangles(&model.constants.grid, column / 2, row).get(column % 2)?.map(|corner| {
        let (du, dv) = CORNERS.get(corner).copied()?;
        let node = (row + dv) * model.constants.grid.stride() + column / 2 + du;
        Some((at(model.reference_position(), node)?, position(model, state, node)?))
    });
    let [a, b, c] = corners;
    let ((a, x), (b, y), (c, z)) = (a?, b?, c?);
    let (edge, other) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
    let (now, other_now) = ([y[0] - x[0], y[1] - x[1]], [z[0] - x[0], z[1] - x[1]]);
    // Det times F, by the adjugate of the edges; R has the angle of (F11 + F22, F21 - F12).
    let f = |i: usize| {
        let (p, q) = (now.get(i).copied()?, other_now.get(i).copied()?);
        Some([p * other[1] - q * edge[1], q * edge[0] - p * other[0]])
    };
    let ([f11, f12], [f21, f22]) = (f(0)?, f(1)?);
    let (a, b) = (f11 + f22, f21 - f12);
    let length = math::sqrt(a * a + b * b);
    Some([a / length, b / length])
}

/// Position of a node at the time of the last step's stresses, which is one step before that of its displacement, m.
fn position(model: &Model, state: &StateView, node: usize) -> Option<[Real; 2]> {
    let dt = model.constants.dt;
    let (rest, moved, velocity) =
        (at(model.reference_position(), node)?, at(state.displacement(), node)?, at(state.velocity(), node)?);
    Some([rest[0] + (moved[0] - dt * velocity[0]), rest[1] + (moved[1] - dt * velocity[1])])
}

fn at(arrays: [&[Real]; 2], node: usize) -> Option<[Real; 2]> {
    let [x, y] = arrays;
    Some([*x.get(node)?, *y.get(node)?])
}
