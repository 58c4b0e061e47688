//! How large a step of a solid is stable: the limit of a state, by that of its cells ([`crate::element::solid_bound`]).

use crate::element::solid_bound::SolidMatrix;
use crate::element::{SolidBlock, SolidConstants};
use crate::error::StepError;
use crate::mesh::TETRAHEDRA;
use crate::model::{Constants, Model};
use crate::number::instruction_set::InstructionSet;
use crate::number::math;
use crate::number::pack::{LANES, Pack, ZERO};
use crate::number::real::Real;
use crate::number::vector::{Scalar, Simd, Work};
use crate::state::{SolidView, State};
use crate::step::monitor::{self, MonitorWindow};
use crate::step::stable_step::{Critical, any};
use crate::tensor::symmetric::Symmetric;

/// The cells of a solid.
pub(crate) struct SolidCells<'m> {
    pub constants: &'m Constants,
    pub blocks: &'m [SolidConstants],
    /// Histories of the tetrahedra; nothing where all are at rest.
    pub history: &'m [Pack],
}

impl<'m> SolidCells<'m> {
    /// The cells of a state.
    pub fn of(model: &Model<'m>, state: &'m State) -> Self {
        let solid = SolidView::of(&model.constants.grid, model.constants.solid_history_packs, state.nodes.solid);
        Self { constants: model.constants, blocks: model.solid().blocks, history: solid.history }
    }

    /// The cells of a model at rest.
    pub fn at_rest(model: &Model<'m>) -> Self {
        Self { constants: model.constants, blocks: model.solid().blocks, history: &[] }
    }

    /// Largest stable step, s.
    pub fn limit(&self) -> Real {
        self.critical(Real::MAX).map_or(Real::INFINITY, |critical| math::sqrt(critical.limit_squared))
    }

    /// The cell with the smallest limit whose square is below `bound`, s2; none if there is none.
    pub fn critical(&self, bound: Real) -> Option<Critical> {
        InstructionSet::best().run(Search { cells: self, bound })
    }

    /// Packs of the history of a block; nothing at rest.
    #[inline(always)]
    fn history_of(&self, block: usize) -> &'m [Pack] {
        let share = TETRAHEDRA * self.constants.solid_history_packs;
        self.history.get(block * share..(block + 1) * share).unwrap_or_default()
    }

    #[inline(always)]
    fn matrix<S: Simd>(&self, simd: S, chunk: usize, index: usize) -> Option<SolidMatrix<S::Vector>> {
        let ([row, _], _) = self.constants.grid.solid_place(index);
        let block = SolidBlock { laws: self.constants.laws_of_row(row), constants: self.blocks.get(index)? };
        Some(SolidMatrix::new(simd, chunk, &block, self.history_of(index)))
    }

    /// Whether a cell is there, or padding.
    #[inline(always)]
    fn has_cell(&self, block: usize, l: usize) -> bool {
        let (_, place) = self.constants.grid.solid_place(block);
        place * LANES + l < self.constants.grid.n_u
    }
}

/// The search for the smallest limit, as work for an instruction set.
struct Search<'c, 'm> {
    cells: &'c SolidCells<'m>,
    bound: Real,
}

impl Work for Search<'_, '_> {
    type Output = Option<Critical>;

    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Option<Critical> {
        let Self { cells, mut bound } = self;
        let mut critical = None;
        for index in 0..cells.blocks.len() {
            for chunk in 0..LANES / S::WIDTH {
                let step_squared = simd.splat(bound);
                let Some(matrix) = cells.matrix(simd, chunk, index) else { continue };
                if !any(simd, matrix.unstable(simd, step_squared)) {
                    continue;
                }
                let mut limits = ZERO;
                simd.store(matrix.limit_squared(simd, step_squared), &mut limits, chunk);
                for l in chunk * S::WIDTH..(chunk + 1) * S::WIDTH {
                    let limit_squared = limits[l % LANES];
                    if cells.has_cell(index, l) && limit_squared < bound {
                        bound = limit_squared;
                        let element = cells.constants.grid.element_index(index, l, 0);
                        let stretch = smallest_stretch(cells, index, l);
                        critical = Some(Critical { limit_squared, element, stretch });
                    }
                }
            }
        }
        critical
    }
}

/// The smallest principal stretch of the tetrahedra of lane `l`.
fn smallest_stretch(cells: &SolidCells, block: usize, l: usize) -> Real {
    let share = cells.constants.solid_history_packs.max(1);
    let of_tetrahedron = |packs: &[Pack]| {
        let stretch = Symmetric::load(Scalar, packs.first_chunk()?, l).plus(&Symmetric::unit(1.0, 0.0));
        Some(stretch.principal(Scalar).values)
    };
    let values = cells.history_of(block).chunks_exact(share).filter_map(of_tetrahedron).flatten();
    values.fold(1.0, |least, value| if value < least { value } else { least })
}

/// Compares the step with the current limit of this step's share of the cells, as [`monitor::check`].
///
/// # Errors
/// The cell with the smallest limit, where that of one of them is below the step.
#[inline(always)]
pub(super) fn check<S: Simd>(simd: S, model: &Model, state: &State) -> Result<(), StepError> {
    let window = MonitorWindow::new(model.solid().blocks.len() * LANES, state.scalars.step_index);
    let step_squared = simd.splat(model.constants.dt * model.constants.dt);
    let mut exceeded = false;
    let cells = SolidCells::of(model, state);
    for turn in 0..window.count {
        let (block, start) = (window.cell(turn) / LANES, window.cell(turn) % LANES);
        for chunk in start / S::WIDTH..(start + window.group).div_ceil(S::WIDTH) {
            let Some(matrix) = cells.matrix(simd, chunk, block) else { continue };
            let mut lost = ZERO;
            simd.store(matrix.unstable(simd, step_squared), &mut lost, chunk);
            let (first, end) = (start.max(chunk * S::WIDTH), (start + window.group).min((chunk + 1) * S::WIDTH));
            exceeded |= lost.get(first..end).unwrap_or_default().iter().any(|lost| *lost > 0.0);
        }
    }
    if exceeded { Err(monitor::failure(model, state)) } else { Ok(()) }
}
