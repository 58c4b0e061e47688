//! [`Memory`]: room for the model and the state of the largest scene, fixed at compile time.

use softanvil_kernel::element::{CellConstants, CellHistory, HoopConstants};
use softanvil_kernel::number::real::Real;
use softanvil_kernel::tensor::deviator::Deviator;
use softanvil_kernel::{Constants, ModelMemory, Scalars, StateMemory};

/// Blocks of cells of the largest mesh: the full section.
const BLOCKS: usize = 30;
/// Nodes of the largest mesh, padding included. A smaller mesh with an interface has more numbers a node.
const NODES: usize = 336;
/// Numbers of the model and of the state of a solid, which has those of its tetrahedra among them.
const SOLID: [usize; 2] = if cfg!(feature = "solid") { [4800, 10_240] } else { [0; 2] };
const MODEL_NUMBERS: usize = if 5 * NODES > SOLID[0] { 5 * NODES } else { SOLID[0] };
const STATE_NUMBERS: usize = if 10 * NODES > SOLID[1] { 10 * NODES } else { SOLID[1] };
/// Most viscous terms of a layer.
const TERMS: usize = 3;
/// Bytes of the longest snapshot.
pub const SNAPSHOT: usize = 96 << 10;

/// Room for a model and a state.
pub struct Memory {
    constants: Option<Constants>,
    model_nodes: [Real; MODEL_NUMBERS],
    model_cells: [CellConstants; BLOCKS],
    model_hoops: [HoopConstants; BLOCKS],
    scalars: Scalars,
    state_nodes: [Real; STATE_NUMBERS],
    state_cells: [CellHistory; BLOCKS],
    state_viscous: [Deviator; 2 * TERMS * BLOCKS],
}

impl Memory {
    /// Memory for one scene after the other.
    pub const fn new() -> Self {
        Self {
            constants: None,
            model_nodes: [0.0; MODEL_NUMBERS],
            model_cells: [CellConstants::ZERO; BLOCKS],
            model_hoops: [HoopConstants::ZERO; BLOCKS],
            scalars: Scalars::BLANK,
            state_nodes: [0.0; STATE_NUMBERS],
            state_cells: [CellHistory::REST; BLOCKS],
            state_viscous: [Deviator::ZERO; 2 * TERMS * BLOCKS],
        }
    }

    /// The parts of the model and of the state.
    pub fn split(&mut self) -> (ModelMemory<'_>, StateMemory<'_>) {
        (
            ModelMemory {
                constants: &mut self.constants,
                nodes: &mut self.model_nodes,
                cells: &mut self.model_cells,
                hoops: &mut self.model_hoops,
            },
            StateMemory {
                scalars: &mut self.scalars,
                nodes: &mut self.state_nodes,
                cells: &mut self.state_cells,
                viscous: &mut self.state_viscous,
            },
        )
    }
}

impl Default for Memory {
    fn default() -> Self {
        Self::new()
    }
}
