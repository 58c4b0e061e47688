//! Stress, stretch and rotation of single triangles, at the time of the last step's stresses.

use nalgebra::{Matrix2, Point2, Rotation2, UnitComplex};

use crate::element::{CellConstants, CellHistory, TriangleHistory};
use crate::material::MaterialModel;
use crate::mesh::{CORNERS, triangles};
use crate::model::Model;
use crate::number::math;
use crate::number::pack::LANES;
use crate::number::real::Real;
use crate::number::vector::Scalar;
use crate::state::StateView;
use crate::tensor::deviator::Deviator;
use crate::tensor::kinematics::Kinematics;
use crate::tensor::stretch::largest_in_plane;

/// Cauchy stress of a triangle in its unrotated frame, Pa, positive in tension.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stress {
    /// Deviator in the section, shape (2 x 2); out of it it is minus the trace.
    pub deviator: Matrix2<Real>,
    /// Mean stress: of the cell, from its mean dilatation, or of the triangle, by a compressible law.
    pub mean: Real,
}

impl Stress {
    /// Stress of triangle `column` (two per cell) in `row`, counted from the core and the first column; none outside.
    pub fn of(model: &Model, state: &StateView, row: usize, column: usize) -> Option<Self> {
        let triangle = Triangle::find(model, state, row, column)?;
        let laws = triangle.laws;
        let mut kirchhoff = triangle.history.elastic_prev.lane(triangle.lane)?;
        let overstress = triangle.overstress(model, state)?;
        for part in core::iter::once(&triangle.history.slider_stress).chain(overstress) {
            kirchhoff = kirchhoff + part.lane(triangle.lane)?;
        }
        let [xx, yy, xy] = kirchhoff.section();
        let largest = *triangle.history.largest_stretch.get(triangle.lane)?;
        let whole = if laws.tear.active() { laws.tear.factor(Scalar, largest) } else { 1.0 };
        let scale = whole / jacobian(triangle.stretch()?);
        let mean = if laws.elastic.is_compressible() {
            scale * triangle.whole_mean(model, state)?
        } else {
            laws.volumetric.stress(triangle.mean_jacobian()?)
        };
        Some(Self { deviator: Matrix2::new(xx, xy, xy, yy) * scale, mean })
    }

    /// Von Mises stress, Pa.
    pub fn von_mises(&self) -> Real {
        let trace = self.deviator.trace();
        math::sqrt(1.5 * (self.deviator.norm_squared() + trace * trace))
    }

    /// Principal stresses, Pa: the larger and the smaller one of the section, then the one out of the plane.
    pub fn principal(&self) -> [Real; 3] {
        let (xx, yy, xy) = (self.deviator.m11, self.deviator.m22, self.deviator.m12);
        let largest = largest_in_plane(0.5 * (xx + yy), 0.5 * (xx - yy), xy);
        [self.mean + largest, self.mean + (xx + yy - largest), self.mean - (xx + yy)]
    }
}

/// One triangle of one cell, and what it remembers.
struct Triangle<'a> {
    /// Number in its cell.
    number: usize,
    /// Block of the cell, and lane in it.
    block: usize,
    lane: usize,
    laws: &'a MaterialModel,
    constants: &'a CellConstants,
    cell: &'a CellHistory,
    history: &'a TriangleHistory,
}

impl<'a> Triangle<'a> {
    /// Triangle `column` (two per cell) of `row`; none outside.
    fn find(model: &Model<'a>, state: &StateView<'a>, row: usize, column: usize) -> Option<Self> {
        let grid = &model.constants.grid;
        let (u, number) = (column / 2, column % 2);
        if u >= grid.n_u || row >= grid.n_v {
            return None;
        }
        let (block, lane) = (row * grid.blocks_per_row() + u / LANES, u % LANES);
        let (constants, cell) = (model.cells.get(block)?, state.cells.get(block)?);
        let history = cell.triangle.get(number)?;
        Some(Self { number, block, lane, laws: model.constants.laws_of(block), constants, cell, history })
    }

    /// Overstresses of its viscous terms, Pa.
    fn overstress(&self, model: &Model, state: &StateView<'a>) -> Option<&'a [Deviator]> {
        // The terms of the first triangle, then those of the second.
        let (terms, _) = self.entries(model, state)?.split_at_checked(2 * self.laws.n_term())?;
        terms.chunks_exact(self.laws.n_term().max(1)).nth(self.number).or(Some(&[]))
    }

    /// What it remembers of softening and of the mean stress of a compressible law.
    fn extra(&self, model: &Model, state: &StateView<'a>) -> Option<&'a [Deviator]> {
        let (_, extra) = self.entries(model, state)?.split_at_checked(2 * self.laws.n_term())?;
        extra.chunks_exact(self.laws.n_extra_entry().max(1)).nth(self.number).or(Some(&[]))
    }

    /// The share of its block of the viscous history.
    fn entries(&self, model: &Model, state: &StateView<'a>) -> Option<&'a [Deviator]> {
        let share = 2 * model.constants.n_history_entry();
        state.viscous.get(self.block * share..)?.get(..2 * self.laws.n_history_entry())
    }

    /// Mean of the Kirchhoff stress of a compressible law before any tear, Pa.
    fn whole_mean(&self, model: &Model, state: &StateView<'a>) -> Option<Real> {
        let [elastic] = self.laws.elastic.whole_stress(Scalar, &[self.kinematics()?], true);
        let Some((numbers, means)) = self.extra(model, state)?.split_first() else { return Some(elastic.mean) };
        let mut mean = elastic.mean;
        if self.laws.softening.active() {
            let largest = *numbers.difference.get(self.lane)?;
            mean *= self.laws.softening.factor(Scalar, elastic.energy, largest);
        }
        // Packs that no term needs are 0.
        for entry in means {
            let Deviator { mean: first, difference: second, shear: third } = entry.lane(self.lane)?;
            mean += first + second + third;
        }
        Some(mean)
    }

    /// Its stretch, as laws want it.
    fn kinematics(&self) -> Option<Kinematics<Real>> {
        Some(Kinematics::of_stretch(Scalar, self.stretch()?))
    }

    /// Right stretch: mean and half difference in the section, shear, hoop.
    fn stretch(&self) -> Option<[Real; 4]> {
        stretch(self.history, self.lane)
    }

    /// Volume-weighted mean J of its cell.
    fn mean_jacobian(&self) -> Option<Real> {
        let mut mean = 1.0;
        for (constants, history) in self.constants.triangle.iter().zip(&self.cell.triangle) {
            mean += constants.volume_fraction.get(self.lane)? * (jacobian(stretch(history, self.lane)?) - 1.0);
        }
        Some(mean)
    }
}

/// Right stretch of lane `l`: mean and half difference in the section, shear, hoop.
fn stretch(history: &TriangleHistory, l: usize) -> Option<[Real; 4]> {
    let [mean, difference, shear, hoop] = history.stretch_prev.each_ref().map(|lane| lane.get(l).copied());
    Some([mean?, difference?, shear?, hoop?])
}

/// J of a right stretch.
fn jacobian([mean, difference, shear, hoop]: [Real; 4]) -> Real {
    (mean * mean - (difference * difference + shear * shear)) * hoop
}

/// Cauchy stress of triangle `column` (two per cell) in `row` along the fixed axes, Pa, positive in tension: xx, yy, xy,
/// and zz out of the section; none outside.
pub fn cauchy_stress(model: &Model, state: &StateView, row: usize, column: usize) -> Option<[Real; 4]> {
    let Stress { deviator, mean } = Stress::of(model, state, row, column)?;
    let rotation = rotation(model, state, row, column)?.into_inner();
    let turned = rotation * deviator * rotation.transpose();
    Some([mean + turned.m11, mean + turned.m22, turned.m12, mean - deviator.trace()])
}

/// Principal stretches of a triangle: the larger and the smaller one in the section, then the one out of it.
pub fn principal_stretch(model: &Model, state: &StateView, row: usize, column: usize) -> Option<[Real; 3]> {
    let [mean, difference, shear, hoop] = Triangle::find(model, state, row, column)?.stretch()?;
    let largest = largest_in_plane(mean, difference, shear);
    Some([largest, (mean * mean - (difference * difference + shear * shear)) / largest, hoop])
}

/// The rotation R of F = R U.
fn rotation(model: &Model, state: &StateView, row: usize, column: usize) -> Option<Rotation2<Real>> {
    let corners = triangles(&model.constants.grid, column / 2, row).get(column % 2)?.map(|corner| {
        let (du, dv) = CORNERS.get(corner).copied()?;
        let node = (row + dv) * model.constants.grid.stride() + column / 2 + du;
        Some((at(model.reference_position(), node)?, position(model, state, node)?))
    });
    let [a, b, c] = corners;
    let ((a, x), (b, y), (c, z)) = (a?, b?, c?);
    let (rest, now) = (Matrix2::from_columns(&[b - a, c - a]), Matrix2::from_columns(&[y - x, z - x]));
    // F times the determinant at rest, by the adjugate; R has the angle of (F11 + F22, F21 - F12).
    let f = now * Matrix2::new(rest.m22, -rest.m12, -rest.m21, rest.m11);
    let (cos, sin) = (f.m11 + f.m22, f.m21 - f.m12);
    let length = math::sqrt(cos * cos + sin * sin);
    Some(UnitComplex::from_cos_sin_unchecked(cos / length, sin / length).to_rotation_matrix())
}

/// Position of a node at the time of the last step's stresses, which is one step before that of its displacement, m.
fn position(model: &Model, state: &StateView, node: usize) -> Option<Point2<Real>> {
    let (moved, velocity) = (at(state.displacement(), node)?, at(state.velocity(), node)?);
    Some(at(model.reference_position(), node)? + (moved - velocity.coords * model.constants.dt).coords)
}

fn at(arrays: [&[Real]; 2], node: usize) -> Option<Point2<Real>> {
    let [x, y] = arrays;
    Some(Point2::new(*x.get(node)?, *y.get(node)?))
}
