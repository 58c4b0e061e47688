//! How large a step is stable: the limit of a state.
//!
//! The central difference scheme is stable for dt <= 2 / omega with the highest frequency omega of the mesh, which is
//! bounded by that of its parts (Irons and Treharne 1971). The parts here are the cells, with a quarter of their mass at
//! each corner: their two triangles share a pressure, and a cell's bound is closer than a triangle's. [`crate::element`] tells
//! how it is found. The tangents of a cell are majorants of those of its laws with the geometric stiffness of their stresses
//! ([`crate::material`]): against the true highest frequency of meshes in random states of all laws the limit is a bound,
//! except where a large overstress has not begun to relax, by less than the default safety factor takes off
//! (`tests/verification/tests/suite/frequency.rs`).

use crate::element::cell_bound::{CellMatrix, CellStiffness, cell_matrix, limit_squared, unstable};
use crate::element::whole_bound::WholeMatrix;
use crate::element::{Block, CellConstants, CellHistory, HoopConstants};
use crate::model::{Constants, Model, ModelArrays};
use crate::number::cube_root::inverse_cbrt;
use crate::number::instruction_set::InstructionSet;
use crate::number::math;
use crate::number::pack::{LANES, Pack, ZERO};
use crate::number::real::Real;
use crate::number::vector::{Simd, Vector, Work};
use crate::state::State;
use crate::step::critical::Critical;
use crate::step::solid_stable_step::SolidCells;
use crate::tensor::kinematics::Kinematics;
use crate::tensor::stretch::{IsochoricStretch, largest_in_plane};

/// Largest stable step of `state` as its last internal forces have found it, s, and the first triangle of the cell that
/// sets it.
#[inline(never)]
pub fn critical_time_step(model: &Model, state: &State) -> (Real, u32) {
    critical_time_step_with(InstructionSet::best(), model, state)
}

/// As [`critical_time_step`], found with an instruction set: the same bits with each. One that is not available is replaced by
/// the best that is.
pub fn critical_time_step_with(set: InstructionSet, model: &Model, state: &State) -> (Real, u32) {
    let critical = if model.constants.grid.is_solid() {
        SolidCells::of(model, state).critical(set, Real::MAX)
    } else {
        let cells = Cells { constants: model.constants, cells: model.cells, hoops: model.hoops };
        cells.critical(set, &|block| state.cells.get(block), Real::MAX)
    };
    critical.map_or((Real::INFINITY, 0), |found| (math::sqrt(found.limit_squared), found.element))
}

/// The cells of a mesh.
pub(crate) struct Cells<'m> {
    pub constants: &'m Constants,
    pub cells: &'m [CellConstants],
    pub hoops: &'m [HoopConstants],
}

impl<'m> Cells<'m> {
    /// Those in the arrays of a model.
    pub fn new(constants: &'m Constants, arrays: &'m ModelArrays) -> Self {
        Self { constants, cells: arrays.cells, hoops: arrays.hoops }
    }

    /// The cell with the smallest limit whose square is below `bound`, s2, by the `history` of each block; none if there is
    /// none.
    pub fn critical<'h>(
        &self,
        set: InstructionSet,
        history: &dyn Fn(usize) -> Option<&'h CellHistory>,
        bound: Real,
    ) -> Option<Critical> {
        set.run(Search { cells: self, history, bound })
    }

    /// Largest step that is stable at rest, s.
    pub fn limit_at_rest(&self) -> Real {
        let critical = self.critical(InstructionSet::best(), &|_| Some(&CellHistory::REST), Real::MAX);
        critical.map_or(Real::INFINITY, |critical| math::sqrt(critical.limit_squared))
    }
}

/// The search for the smallest limit, as work for an instruction set.
struct Search<'c, 'm, 'h> {
    cells: &'c Cells<'m>,
    history: &'c dyn Fn(usize) -> Option<&'h CellHistory>,
    bound: Real,
}

impl Work for Search<'_, '_, '_> {
    type Output = Option<Critical>;

    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Option<Critical> {
        let Cells { constants, cells, hoops } = *self.cells;
        let (mut critical, mut bound) = (None, self.bound);
        for (index, cell) in cells.iter().enumerate() {
            let Some(history) = (self.history)(index) else { continue };
            let block = Block { laws: constants.laws_of(index), constants: cell, hoop: hoops.get(index) };
            // One bound for the block: one for each chunk would differ with the width of the vectors.
            let squared = bound;
            for chunk in 0..LANES / S::WIDTH {
                let look = Look { chunk, block, history, squared, find: true };
                let Some(limits) = simd.apart(look) else { continue };
                for l in chunk * S::WIDTH..(chunk + 1) * S::WIDTH {
                    // Padding has no volume.
                    let limit_squared = limits[l % LANES];
                    if cell.triangle[0].reference_volume[l % LANES] > 0.0 && limit_squared < bound {
                        bound = limit_squared;
                        let element = constants.grid.element_index(index, l, 0);
                        critical = Some(Critical { limit_squared, element, stretch: smallest_stretch(history, l) });
                    }
                }
            }
        }
        critical
    }
}

/// A look at neighbouring cells, as work of its own: both who searches the smallest limit and who watches the step do it.
pub(crate) struct Look<'c> {
    pub chunk: usize,
    pub block: Block<'c>,
    pub history: &'c CellHistory,
    /// The square of a step, s2.
    pub squared: Real,
    /// Whether to find the limits, or only which of them are passed.
    pub find: bool,
}

impl Work for Look<'_> {
    /// None where no cell has a limit below the step; else the squares of their limits, s2, or 1 where one is passed and 0
    /// elsewhere.
    type Output = Option<Pack>;

    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Option<Pack> {
        let Self { chunk, block, history, squared, find } = self;
        let (squared, mut found) = (simd.splat(squared), ZERO);
        if block.laws.elastic.is_compressible() {
            let matrix = whole_matrix(simd, chunk, &block, history);
            simd.store(matrix.unstable(simd, squared), &mut found, chunk);
            if find && found != ZERO {
                simd.store(matrix.limit_squared(simd, squared), &mut found, chunk);
            }
        } else {
            let matrix = current_matrix(simd, chunk, &block, history);
            simd.store(unstable(simd, &matrix, squared), &mut found, chunk);
            if find && found != ZERO {
                simd.store(limit_squared(simd, &matrix, squared), &mut found, chunk);
            }
        }
        (found != ZERO).then_some(found)
    }
}

/// The matrix of neighbouring cells of a compressible material, as [`current_matrix`].
#[inline(always)]
fn whole_matrix<S: Simd>(simd: S, chunk: usize, block: &Block, history: &CellHistory) -> WholeMatrix<S::Vector> {
    let mut matrix = WholeMatrix::new(simd);
    for (t, triangle) in history.triangle.iter().enumerate() {
        let [mean, difference, shear, hoop] = &triangle.stretch_prev;
        let section = [simd.load(mean, chunk), simd.load(difference, chunk), simd.load(shear, chunk)];
        let [mean, difference, shear] = section;
        let kinematics = Kinematics::of_stretch(simd, [mean, difference, shear, simd.load(hoop, chunk)]);
        matrix.add(simd, chunk, block, t, &kinematics);
    }
    matrix
}

/// The smallest principal stretch in the section of the triangles of lane `l`.
fn smallest_stretch(history: &CellHistory, l: usize) -> Real {
    let stretches = history.triangle.each_ref().map(|triangle| {
        let [mean, difference, shear, _] = triangle.stretch_prev.map(|lane| lane[l % LANES]);
        mean + mean - largest_in_plane(mean, difference, shear)
    });
    if stretches[0] < stretches[1] { stretches[0] } else { stretches[1] }
}

/// The matrix of neighbouring cells at the stretches that the last internal forces have left in the history.
#[inline(always)]
fn current_matrix<S: Simd>(simd: S, chunk: usize, block: &Block, history: &CellHistory) -> CellMatrix<S::Vector> {
    let (zero, one) = (simd.splat(0.0), simd.splat(1.0));
    let mut stiffness =
        CellStiffness { inverse_stretch: [[zero; 3]; 2], hoop_scale: [one; 2], shear: [zero; 2], bulk: zero };
    for t in 0..2 {
        let [mean, difference, shear, hoop] = &history.triangle[t].stretch_prev;
        let (mean, difference) = (simd.load(mean, chunk), simd.load(difference, chunk));
        let (u12, u33) = (simd.load(shear, chunk), simd.load(hoop, chunk));
        let (u11, u22) = (mean + difference, mean - difference);
        let section = mean * mean - (difference * difference + u12 * u12);
        let inverse = one / section;
        stiffness.inverse_stretch[t] = [u22 * inverse, u11 * inverse, (u12 * inverse).mul_scalar(-1.0)];
        if block.hoop.is_some() {
            stiffness.hoop_scale[t] = one / u33;
        }
        let jacobian = section * u33;
        let scale = inverse_cbrt(jacobian);
        let isochoric = IsochoricStretch { u11: scale * u11, u22: scale * u22, u12: scale * u12, u33: scale * u33 };
        stiffness.shear[t] = block.laws.shear_tangent(simd, &isochoric);
        // Stresses stiffen a change of volume, too: by about what they add to the shear.
        let added = stiffness.shear[t].add_scalar(-block.laws.shear_modulus_0).max(zero);
        stiffness.bulk = (block.laws.volumetric.tangent(simd, jacobian) + added).max(stiffness.bulk);
    }
    cell_matrix(simd, chunk, block, &stiffness)
}
