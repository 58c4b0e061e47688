//! [`StateView`]: a state that is only read, over memory that others may read at the same time.

use crate::element::CellHistory;
use crate::error::MemoryError;
use crate::model::{Model, NodeArrays};
use crate::number::real::Real;
use crate::state::{Scalars, SolidView, State, StateNodes};
use crate::tensor::deviator::Deviator;

/// A state to read from.
///
/// ```
/// use softanvil_kernel::{Simulation, StepInput, preset};
///
/// let mut anvil = Simulation::new(&preset::study())?;
/// anvil.run(4e-3, &StepInput::default())?;
/// // The force on the impactor is that of the surface nodes, of the meshed half and of the other.
/// let force = anvil.with(|model, state| {
///     let [pressing, _] = state.as_view().contact_force();
///     model.constants.symmetry_factor * pressing.iter().sum::<f64>()
/// })?;
/// assert!(force > 100.0);
/// assert!((force / anvil.scalars().force.contact - 1.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy)]
pub struct StateView<'a> {
    /// The numbers that are not arrays.
    pub scalars: &'a Scalars,
    pub(crate) nodes: StateNodes<&'a [Real]>,
    pub(crate) cells: &'a [CellHistory],
    pub(crate) viscous: &'a [Deviator],
}

/// Memory of a state as [`crate::StateMemory`] lends it, to read from.
///
/// ```
/// use softanvil_kernel::element::CellHistory;
/// use softanvil_kernel::tensor::deviator::Deviator;
/// use softanvil_kernel::{Field, Scalars, Simulation, State, StateContent, StateMemory, StateView, preset};
///
/// let mut anvil = Simulation::new(&preset::study())?;
/// let gap = anvil.constants().scenario.impactor.gap;
/// anvil.with(|model, _| {
///     let size = &model.constants.size;
///     let (mut scalars, mut nodes) = (Scalars::BLANK, vec![0.0; size.state_nodes]);
///     let mut cells = vec![CellHistory::REST; size.state_cells];
///     let mut viscous = vec![Deviator::ZERO; size.state_viscous];
///     let memory = StateMemory { scalars: &mut scalars, nodes: &mut nodes, cells: &mut cells, viscous: &mut viscous };
///     State::new(model, memory)?;
///     // Whoever lent the memory has it back and reads the state in it.
///     let content = StateContent { nodes: &nodes, cells: &cells, viscous: &viscous };
///     let view = StateView::new(model, &scalars, content)?;
///     assert_eq!(view.scalars.impactor.position, gap);
///     let velocity = Field::find("node.velocity").unwrap();
///     assert_eq!(velocity.value(model, &view, 0, 0, 1), Some(0.0));
///     Ok::<_, softanvil_kernel::MemoryError>(())
/// })??;
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy)]
pub struct StateContent<'a> {
    /// At least [`crate::Size::state_nodes`] numbers.
    pub nodes: &'a [Real],
    /// At least [`crate::Size::state_cells`] blocks.
    pub cells: &'a [CellHistory],
    /// At least [`crate::Size::state_viscous`] blocks.
    pub viscous: &'a [Deviator],
}

impl<'a> StateView<'a> {
    /// A view of the state that `content` holds, with the `scalars` that belong to it.
    ///
    /// # Errors
    /// Too little memory.
    pub fn new(model: &Model, scalars: &'a Scalars, content: StateContent<'a>) -> Result<Self, MemoryError> {
        let (constants, size) = (model.constants, &model.constants.size);
        let lengths = NodeArrays::new(&constants.grid, &constants.outline, constants.solid_history_packs);
        let mut nodes = content.nodes;
        let row = |n| {
            let (row, rest) = nodes.split_at_checked(n)?;
            nodes = rest;
            Some(row)
        };
        let (given, needed) = (content.nodes.len(), size.state_nodes);
        let nodes = StateNodes::of(&lengths, row);
        let nodes = nodes.ok_or(MemoryError { what: "state nodes", given, needed })?;
        Ok(Self { scalars, nodes, cells: content.cells, viscous: content.viscous })
    }

    /// Displacements of the nodes, m, laid out as [`Model::reference_position`].
    pub fn displacement(&self) -> [&'a [Real]; 2] {
        self.nodes.displacement
    }

    /// Velocities of the nodes half a step back, m/s, laid out alike.
    pub fn velocity(&self) -> [&'a [Real]; 2] {
        self.nodes.velocity
    }

    /// Total force on each node in the last step, N: contact and friction minus internal forces.
    pub fn force(&self) -> [&'a [Real]; 2] {
        self.nodes.force
    }

    /// What a solid has along z: displacement, m, velocity half a step back, m/s, and force of the last step, N, of the nodes, then
    /// the friction force of the face on the surface nodes, N. Nothing in a section.
    pub fn along_z(&self, model: &Model) -> [&'a [Real]; 4] {
        let constants = model.constants;
        let solid = SolidView::of(&constants.grid, constants.solid_history_packs, self.nodes.solid);
        [solid.displacement, solid.velocity, solid.force, solid.friction]
    }

    /// Normal force of the face on each surface node in the last step, N, then its friction force outwards, by column.
    pub fn contact_force(&self) -> [&'a [Real]; 2] {
        self.nodes.contact
    }
}

impl State<'_> {
    /// This state, to read from.
    pub fn as_view(&self) -> StateView<'_> {
        StateView { scalars: self.scalars, nodes: self.nodes.as_read(), cells: self.cells, viscous: self.viscous }
    }
}
