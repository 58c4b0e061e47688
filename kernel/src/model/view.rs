//! [`Model`]: everything about a simulation that does not change, built once in memory that the caller lends.

use crate::element::{CellConstants, HoopConstants, SolidConstants, TETRAHEDRON_PACKS, VOLUME};
use crate::model::Constants;
use crate::number::real::Real;

/// Constants of every node, one slice per quantity, rows of [`crate::mesh::Grid::stride`].
pub(crate) struct ModelNodes<'a> {
    /// Reference x, m.
    pub reference_x: &'a [Real],
    /// Reference height above the origin, m.
    pub reference_y: &'a [Real],
    /// 1/m along x, 1/kg; 0 where fixed.
    pub inverse_mass_x: &'a [Real],
    /// 1/m along y, 1/kg; 0 where fixed.
    pub inverse_mass_y: &'a [Real],
    /// Lumped mass, kg.
    pub nodal_mass: &'a [Real],
    /// What only a solid has: [`SolidModel`].
    pub solid: &'a [Real],
}

/// What a model of a solid has besides.
pub(crate) struct SolidModel<'a> {
    /// Reference z, m.
    pub reference_z: &'a [Real],
    /// 1/m along z, 1/kg; 0 where fixed.
    pub inverse_mass_z: &'a [Real],
    /// Constants of the blocks of cells.
    pub blocks: &'a [SolidConstants],
}

impl<'a> ModelNodes<'a> {
    /// Cuts `memory` into rows of `n` numbers, one per node; none if it is too short.
    #[inline(always)]
    fn cut(mut memory: &'a [Real], n: usize) -> Option<Self> {
        let mut row = || {
            let (row, rest) = memory.split_at_checked(n)?;
            memory = rest;
            Some(row)
        };
        let (reference_x, reference_y) = (row()?, row()?);
        let (inverse_mass_x, inverse_mass_y, nodal_mass) = (row()?, row()?, row()?);
        Some(Self { reference_x, reference_y, inverse_mass_x, inverse_mass_y, nodal_mass, solid: memory })
    }
}

/// The immutable part of a simulation. One model may serve any number of states at once.
///
/// ```
/// use softanvil_kernel::element::{CellConstants, CellHistory, HoopConstants};
/// use softanvil_kernel::tensor::deviator::Deviator;
/// use softanvil_kernel::{Model, ModelMemory, Scalars, Size, State, StateMemory, StepInput, preset, steps};
///
/// let scenario = preset::study();
/// let size = Size::of(&scenario)?;
/// let (mut constants, mut nodes) = (None, vec![0.0; size.model_nodes]);
/// let mut cells = vec![CellConstants::ZERO; size.model_cells];
/// let mut hoops = vec![HoopConstants::ZERO; size.model_hoops];
/// let of_model = ModelMemory { constants: &mut constants, nodes: &mut nodes, cells: &mut cells, hoops: &mut hoops };
/// let (mut scalars, mut nodes) = (Scalars::BLANK, vec![0.0; size.state_nodes]);
/// let mut cells = vec![CellHistory::REST; size.state_cells];
/// let mut viscous = vec![Deviator::ZERO; size.state_viscous];
/// let mut of_state = StateMemory { scalars: &mut scalars, nodes: &mut nodes, cells: &mut cells, viscous: &mut viscous };
///
/// let model = Model::new(&scenario, of_model, &mut of_state)?;
/// let mut state = State::new(&model, of_state)?;
/// let count = model.constants.steps_in(scenario.time.duration);
/// steps(&model, &mut state, count, &StepInput::default())?;
/// assert_eq!(state.time(&model), scenario.time.duration);
/// let peak = state.scalars.metrics.peak_force;
/// assert!(peak > 5000.0 && peak < 6000.0, "{peak} N");
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
pub struct Model<'a> {
    /// Scalar constants.
    pub constants: &'a Constants,
    pub(crate) nodes: ModelNodes<'a>,
    pub(crate) cells: &'a [CellConstants],
    pub(crate) hoops: &'a [HoopConstants],
}

impl<'a> Model<'a> {
    /// A model over memory that [`Model::new`] filled for the same `constants`.
    #[inline(always)]
    pub fn view(
        constants: &'a Constants,
        nodes: &'a [Real],
        cells: &'a [CellConstants],
        hoops: &'a [HoopConstants],
    ) -> Self {
        match ModelNodes::cut(nodes, constants.grid.n_node()) {
            Some(nodes) => Self { constants, nodes, cells, hoops },
            None => Self::without_nodes(constants, cells, hoops),
        }
    }

    /// A model over too little memory, which sizes exclude.
    #[cold]
    #[inline(never)]
    fn without_nodes(constants: &'a Constants, cells: &'a [CellConstants], hoops: &'a [HoopConstants]) -> Self {
        let nodes = ModelNodes {
            reference_x: &[],
            reference_y: &[],
            inverse_mass_x: &[],
            inverse_mass_y: &[],
            nodal_mass: &[],
            solid: &[],
        };
        Self { constants, nodes, cells, hoops }
    }

    /// What a solid has besides; nothing in a section.
    pub(crate) fn solid(&self) -> SolidModel<'a> {
        let n = self.constants.grid.n_node();
        let (reference_z, rest) = self.nodes.solid.split_at_checked(n).unwrap_or_default();
        let (inverse_mass_z, rest) = rest.split_at_checked(n).unwrap_or_default();
        SolidModel { reference_z, inverse_mass_z, blocks: rest.as_chunks().0.as_chunks().0 }
    }

    /// Positions of the nodes at rest along z, m, laid out as [`Self::reference_position`]; none in a section.
    pub fn reference_z(&self) -> &'a [Real] {
        self.solid().reference_z
    }

    /// Lumped mass of the node in column `u`, row `v` and slice `w`, kg; 0 where there is none.
    pub fn nodal_mass(&self, u: usize, v: usize, w: usize) -> Real {
        self.nodes.nodal_mass.get(self.constants.grid.node(u, v, w)).copied().unwrap_or_default()
    }

    /// Positions of the nodes at rest, m, in rows of [`crate::mesh::Grid::stride`] from the core to the surface, the first
    /// `n_u + 1` of each row in use.
    pub fn reference_position(&self) -> [&[Real]; 2] {
        [self.nodes.reference_x, self.nodes.reference_y]
    }

    /// Volume of all triangles of the section, or of all tetrahedra of the solid, m3.
    pub fn reference_volume(&self) -> Real {
        if self.constants.grid.is_solid() {
            return solid_volume(self.solid().blocks);
        }
        self.cells
            .iter()
            .flat_map(|cell| &cell.triangle)
            .flat_map(|triangle| &triangle.reference_volume)
            .fold(0.0, |sum, volume| sum + volume)
    }
}

/// Volume of all tetrahedra, m3.
fn solid_volume(blocks: &[SolidConstants]) -> Real {
    let tetrahedra = blocks.iter().flat_map(|block| block.as_chunks::<TETRAHEDRON_PACKS>().0);
    tetrahedra.flat_map(|packs| &packs[VOLUME]).fold(0.0, |sum, volume| sum + volume)
}
