//! [`Model`]: everything about a simulation that does not change, built once in memory that the caller lends.

use crate::element::{CellConstants, HoopConstants};
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
        Some(Self {
            reference_x: row()?,
            reference_y: row()?,
            inverse_mass_x: row()?,
            inverse_mass_y: row()?,
            nodal_mass: row()?,
        })
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
        };
        Self { constants, nodes, cells, hoops }
    }

    /// Positions of the nodes at rest, m, in rows of [`crate::mesh::Grid::stride`] from the core to the surface, the first
    /// `n_u + 1` of each row in use.
    pub fn reference_position(&self) -> [&[Real]; 2] {
        [self.nodes.reference_x, self.nodes.reference_y]
    }

    /// Volume of all triangles of the section, m3.
    pub fn reference_volume(&self) -> Real {
        self.cells
            .iter()
            .flat_map(|cell| &cell.triangle)
            .flat_map(|triangle| &triangle.reference_volume)
            .fold(0.0, |sum, volume| sum + volume)
    }
}
