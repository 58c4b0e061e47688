//! Stress, stretch and rotation of single tetrahedra, at the time of the last step's stresses; as [`crate::result::stress`].

use nalgebra::Matrix3;

use crate::element::{INVERSE_VOLUME, SolidBlock, SolidMemory, TETRAHEDRON_PACKS, VOLUME, tetrahedron_gradient};
use crate::mesh::TETRAHEDRA;
use crate::model::Model;
use crate::number::math;
use crate::number::pack::LANES;
use crate::number::real::Real;
use crate::number::vector::Scalar;
use crate::state::{SolidView, StateView, solid_corners};
use crate::tensor::symmetric::Symmetric;

/// Cauchy stress of a tetrahedron in its unrotated frame, Pa, positive in tension.
pub(super) struct SolidStress {
    /// Deviator.
    deviator: Symmetric<Real>,
    /// Mean stress: of the cell, from its mean dilatation, or of the tetrahedron, by a compressible law.
    pub mean: Real,
    stretch: Symmetric<Real>,
    /// Block, lane and number in the cell.
    place: [usize; 3],
}

impl SolidStress {
    /// Stress of tetrahedron `column` (six per cell) in `row`, slice by slice of the rows from the core; none outside.
    pub fn of(model: &Model, state: &StateView, row: usize, column: usize) -> Option<Self> {
        let (constants, grid) = (model.constants, &model.constants.grid);
        let (u, number) = (column / TETRAHEDRA, column % TETRAHEDRA);
        if u >= grid.n_u {
            return None;
        }
        let (block, lane) = (row * grid.blocks_per_row() + u / LANES, u % LANES);
        let packs = constants.solid_history_packs;
        let history = SolidView::of(grid, packs, state.nodes.solid).history;
        let ([layer_row, _], _) = grid.solid_place(block);
        let laws = constants.laws_of_row(layer_row);
        let memory = |t: usize| {
            let start = (block * TETRAHEDRA + t) * packs;
            SolidMemory::of(laws, history.get(start..start + packs)?, lane)
        };
        let own = memory(number)?;
        let torn = if laws.tear.active() { laws.tear.factor(Scalar, own.largest_stretch) } else { 1.0 };
        let scale = torn / jacobian(&own.stretch);
        let mean = if laws.elastic.is_compressible() {
            scale * own.mean
        } else {
            let fixed = model.solid().blocks.get(block)?;
            let mut mean = 1.0;
            for (t, tetrahedron) in fixed.as_chunks::<TETRAHEDRON_PACKS>().0.iter().enumerate() {
                let part = tetrahedron[VOLUME].get(lane)? * fixed[INVERSE_VOLUME].get(lane)?;
                mean += part * (jacobian(&memory(t)?.stretch) - 1.0);
            }
            laws.volumetric.stress(mean)
        };
        let deviator = own.deviator.with_mean(0.0).scaled(scale);
        Some(Self { deviator, mean, stretch: own.stretch, place: [block, lane, number] })
    }

    /// Von Mises stress, Pa.
    pub fn von_mises(&self) -> Real {
        let square = self.deviator.square();
        math::sqrt(1.5 * square.trace())
    }

    /// Principal stresses, Pa, from the largest to the smallest.
    pub fn principal(&self) -> [Real; 3] {
        sorted(self.deviator.principal(Scalar).values).map(|value| self.mean + value)
    }

    /// Principal stretches, from the largest to the smallest.
    pub fn stretches(&self) -> [Real; 3] {
        sorted(self.stretch.principal(Scalar).values)
    }

    /// Stress along the fixed axes, Pa.
    pub fn cauchy(&self, model: &Model, state: &StateView) -> Option<Matrix3<Real>> {
        let rotation = self.rotation(model, state)?;
        let unrotated = matrix(&self.deviator) + Matrix3::identity() * self.mean;
        Some(rotation * unrotated * rotation.transpose())
    }

    /// The rotation R = F U^-1.
    fn rotation(&self, model: &Model, state: &StateView) -> Option<Matrix3<Real>> {
        let (constants, grid, [block, lane, number]) = (model.constants, &model.constants.grid, self.place);
        let (row, place) = grid.solid_place(block);
        let laws = constants.laws_of_row(row[0]);
        let block = SolidBlock { laws, constants: model.solid().blocks.get(block)? };
        let (rows, mirrored) = (grid.solid_rows(row, place), grid.mirrored(place));
        let ([ux, uy], [vx, vy], [uz, vz, ..]) = (state.displacement(), state.velocity(), state.along_z(model));
        let now = solid_corners(Scalar, lane, &rows, [ux, uy, uz], mirrored.as_ref());
        let velocity = solid_corners(Scalar, lane, &rows, [vx, vy, vz], mirrored.as_ref());
        // The stresses are those of one step before the displacements.
        let before = core::array::from_fn(|corner: usize| {
            let (now, velocity) = (now[corner % 8], velocity[corner % 8]);
            core::array::from_fn(|i: usize| now[i % 3] - constants.dt * velocity[i % 3])
        });
        let (gradient, _) = tetrahedron_gradient(&block, lane, number, &before);
        let gradient = Matrix3::from_fn(|i, j| gradient[i % 3][j % 3]);
        Some(gradient * matrix(&self.stretch).try_inverse()?)
    }
}

/// From the largest to the smallest.
fn sorted([a, b, c]: [Real; 3]) -> [Real; 3] {
    let (a, b) = if a < b { (b, a) } else { (a, b) };
    let (b, c) = if b < c { (c, b) } else { (b, c) };
    let (a, b) = if a < b { (b, a) } else { (a, b) };
    [a, b, c]
}

/// J of a stretch.
fn jacobian(stretch: &Symmetric<Real>) -> Real {
    stretch.determinant(&stretch.adjugate())
}

fn matrix(tensor: &Symmetric<Real>) -> Matrix3<Real> {
    let Symmetric { xx, yy, zz, xy, yz, zx } = *tensor;
    Matrix3::new(xx, xy, zx, xy, yy, yz, zx, yz, zz)
}
