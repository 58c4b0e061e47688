//! How large a step of a solid is stable: the limit of a state, by that of its cells ([`crate::element::solid_bound`]).

use crate::element::solid_bound::SolidMatrix;
use crate::element::{SolidBlock, SolidConstants};
use crate::mesh::TETRAHEDRA;
use crate::model::{Constants, Model};
use crate::number::instruction_set::InstructionSet;
use crate::number::math;
use crate::number::pack::{LANES, Pack, ZERO};
use crate::number::real::Real;
use crate::number::vector::{Scalar, Simd, Work};
use crate::state::{SolidView, State};
use crate::step::critical::Critical;
use crate::step::window::MonitorWindow;
use crate::tensor::symmetric::Symmetric;

/// Groups of cells that are looked at one after another, with the smallest limit so far as the bound.
const GROUPS_OF_A_PART: usize = 32;

/// The one with the smallest limit; the first of equal ones.
fn smallest(found: impl Iterator<Item = Option<Critical>>) -> Option<Critical> {
    found.flatten().min_by(|one, other| one.limit_squared.total_cmp(&other.limit_squared))
}

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
        self.critical(InstructionSet::best(), Real::MAX)
            .map_or(Real::INFINITY, |critical| math::sqrt(critical.limit_squared))
    }

    /// The cell with the smallest limit whose square is below `bound`, s2; none if there is none.
    pub fn critical(&self, set: InstructionSet, bound: Real) -> Option<Critical> {
        let whole = MonitorWindow::whole(self.blocks.len() * LANES);
        // Each part from the same bound, so that no bit depends on who has looked at another one before.
        let of_part = |part| self.critical_of(set, whole.part(part, GROUPS_OF_A_PART), bound);
        let parts = whole.count.div_ceil(GROUPS_OF_A_PART);
        #[cfg(feature = "threads")]
        if super::solid_threads::pays(&self.constants.grid) {
            return smallest(super::solid_threads::each(0..parts, of_part).into_iter());
        }
        smallest((0..parts).map(of_part))
    }

    /// The same among the cells of a `window`.
    fn critical_of(&self, set: InstructionSet, window: MonitorWindow, bound: Real) -> Option<Critical> {
        set.run(Search { cells: self, window, bound })
    }

    /// Packs of the history of a block; nothing at rest.
    #[inline(always)]
    fn history_of(&self, block: usize) -> &'m [Pack] {
        let share = TETRAHEDRA * self.constants.solid_history_packs;
        self.history.get(block * share..(block + 1) * share).unwrap_or_default()
    }

    /// Whether a cell is there, or padding, or a layer is narrower than others.
    #[inline(always)]
    fn has_cell(&self, block: usize, l: usize) -> bool {
        let ([row, slice], place) = self.constants.grid.solid_place(block);
        self.constants.grid.has_cell(place * LANES + l, row, slice)
    }
}

/// The search for the smallest limit, as work for an instruction set: the one copy of it all.
struct Search<'c, 'm> {
    cells: &'c SolidCells<'m>,
    window: MonitorWindow,
    bound: Real,
}

impl Work for Search<'_, '_> {
    type Output = Option<Critical>;

    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> Option<Critical> {
        let Self { cells, window, mut bound } = self;
        let (constants, mut critical, mut matrix) = (cells.constants, None, SolidMatrix::none(simd));
        for turn in 0..window.count {
            let (index, start) = (window.cell(turn) / LANES, window.cell(turn) % LANES);
            let ([row, _], _) = constants.grid.solid_place(index);
            let Some(block) = cells.blocks.get(index) else { continue };
            let block = SolidBlock { laws: constants.laws_of_row(row), constants: block };
            // One bound for the group: one for each chunk would differ with the width of the vectors.
            let squared = simd.splat(bound);
            for chunk in start / S::WIDTH..(start + window.group).div_ceil(S::WIDTH) {
                matrix.fill(simd, chunk, &block, cells.history_of(index));
                let mut limits = ZERO;
                simd.store(matrix.limit_squared(simd, squared), &mut limits, chunk);
                for l in (chunk * S::WIDTH).max(start)..((chunk + 1) * S::WIDTH).min(start + window.group) {
                    let limit_squared = limits[l % LANES];
                    if limit_squared < bound && cells.has_cell(index, l) {
                        bound = limit_squared;
                        let element = constants.grid.element_index(index, l, 0);
                        critical =
                            Some(Critical { limit_squared, element, stretch: smallest_stretch(cells, index, l) });
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

/// Whether the step `step_index` is above the current limit of one of its share of the cells, which have this `history`.
pub(super) fn is_exceeded(set: InstructionSet, model: &Model, history: &[Pack], step_index: u64) -> bool {
    let cells = SolidCells { constants: model.constants, blocks: model.solid().blocks, history };
    let window = MonitorWindow::new(cells.blocks.len() * LANES, step_index);
    let squared = model.constants.dt * model.constants.dt;
    #[cfg(feature = "threads")]
    if super::solid_threads::pays(&model.constants.grid) {
        return super::solid_threads::any(window.count, |part, size| {
            cells.critical_of(set, window.part(part, size), squared).is_some()
        });
    }
    cells.critical_of(set, window, squared).is_some()
}
