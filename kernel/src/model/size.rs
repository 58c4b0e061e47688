//! Sizes of the memory that the caller lends to a model and a state, known before anything is built.

use crate::element::{SOLID_BLOCK_PACKS, solid_history_packs};
use crate::error::ModelError;
use crate::mesh::{Grid, TETRAHEDRA};
use crate::number::pack::LANES;
use crate::scenario::{Outline, Scenario};

/// Numbers per node in a model: height of rest, inverse masses along x and y, mass, and x of rest.
pub(crate) const MODEL_NODE_FIELDS: usize = 5;
/// Numbers per node in a state: displacement, velocity and force, two components each.
pub(crate) const STATE_NODE_FIELDS: usize = 6;
/// Numbers per surface node in a state: normal and tangential contact force.
pub(crate) const SURFACE_FIELDS: usize = 2;
/// Numbers per surface node under a face that is round or has edges: depth in it, its direction there, and the node's mass.
pub(crate) const ROUNDING_FIELDS: usize = 4;

/// The same of a solid: see [`crate::contact`].
pub(crate) const SOLID_TOUCH_FIELDS: usize = 13;

/// Numbers for each pack of nodes that may touch the layer across an interface: see [`crate::state::PairRow`].
pub(crate) const PAIR_PACKS: usize = 14;
/// Numbers for each of these nodes as an end of segments, and of one pack more.
pub(crate) const END_FIELDS: usize = 4;
/// The same of a solid for each node: see [`crate::state::SolidPair`].
pub(crate) const SOLID_PAIR_FIELDS: usize = 13;
/// The same of a solid, for each node as a corner of cells.
pub(crate) const SOLID_END_FIELDS: usize = 6;

/// Lengths of the arrays of the nodes of a state.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NodeArrays {
    /// Of those with a number for every node.
    pub nodes: usize,
    /// Of those with a number for every surface node.
    pub surface: usize,
    /// Of that for the touch of a face that is round or has edges.
    pub rounding: usize,
    /// Of that for the nodes on both sides of the interfaces that are not bonded.
    pub pairs: usize,
    /// Of that for what only a solid has: see [`crate::state::SolidState`].
    pub solid: usize,
}

impl NodeArrays {
    /// Those of a mesh under a face of this outline.
    pub fn new(grid: &Grid, outline: &Outline, history_packs: usize) -> Self {
        let stride = grid.stride();
        let rounding =
            if outline.radius > 0.0 || !grid.has_even_surface() { ROUNDING_FIELDS * grid.stride() } else { 0 };
        // Under a solid every face counts as one with edges.
        let rounding = if grid.is_solid() { SOLID_TOUCH_FIELDS * grid.plane() } else { rounding };
        let sides = 2 * grid.layer_open.iter().filter(|open| **open).count();
        let of_side = if grid.is_solid() {
            (SOLID_PAIR_FIELDS + SOLID_END_FIELDS) * grid.plane()
        } else {
            PAIR_PACKS * stride + END_FIELDS * (stride + LANES)
        };
        let solid = if grid.is_solid() { SolidArrays::of_state(grid, history_packs).total() } else { 0 };
        Self { nodes: grid.n_node(), surface: grid.plane(), rounding, pairs: sides * of_side, solid }
    }

    /// Numbers of all.
    fn total(&self) -> usize {
        STATE_NODE_FIELDS * self.nodes + SURFACE_FIELDS * self.surface + self.rounding + self.pairs + self.solid
    }
}

/// Lengths of the arrays of numbers that only a solid has.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SolidArrays {
    /// Of those with a number for every node.
    pub nodes: usize,
    /// How many of those there are.
    pub fields: usize,
    /// Of that with a number for every surface node.
    pub surface: usize,
    /// Of that for the tetrahedra.
    pub tetrahedra: usize,
}

impl SolidArrays {
    /// Of a model: z at rest and inverse mass along z; constants of the tetrahedra.
    pub fn of_model(grid: &Grid) -> Self {
        let tetrahedra = SOLID_BLOCK_PACKS * LANES * grid.n_block();
        Self { nodes: grid.n_node(), fields: 2, surface: 0, tetrahedra }
    }

    /// Of a state whose tetrahedra remember so many packs: displacement, velocity and force along z; friction along z; histories.
    pub fn of_state(grid: &Grid, history_packs: usize) -> Self {
        let tetrahedra = history_packs * TETRAHEDRA * LANES * grid.n_block();
        Self { nodes: grid.n_node(), fields: 3, surface: grid.plane(), tetrahedra }
    }

    /// Numbers of those for nodes.
    pub fn at_nodes(&self) -> usize {
        self.fields * self.nodes + self.surface
    }

    /// Numbers of all.
    fn total(&self) -> usize {
        self.at_nodes() + self.tetrahedra
    }
}

/// Items of each kind that a model and its states need.
///
/// ```
/// use softanvil_kernel::{Size, preset};
///
/// let size = Size::of(&preset::study())?;
/// // The history of two triangles a cell for every Prony term, and no hoops in plane strain.
/// let terms = preset::study().layers[0].material.n_viscous_term();
/// assert_eq!((size.state_viscous, size.model_hoops), (2 * terms * size.state_cells, 0));
///
/// // Half the edge length makes about four times the cells.
/// let mut finer = preset::study();
/// finer.mesh.element_size *= 0.5;
/// let ratio = Size::of(&finer)?.state_cells as f64 / size.state_cells as f64;
/// assert!(ratio > 3.0 && ratio < 5.0);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    /// Numbers for the nodes of a model.
    pub model_nodes: usize,
    /// Blocks of element constants of a model.
    pub model_cells: usize,
    /// Blocks of hoop constants of a model (none in plane strain).
    pub model_hoops: usize,
    /// Numbers for the nodes of a state.
    pub state_nodes: usize,
    /// Blocks of element history of a state.
    pub state_cells: usize,
    /// Blocks of viscous history of a state.
    pub state_viscous: usize,
}

impl Size {
    /// What `scenario` needs.
    ///
    /// # Errors
    /// A scenario that is refused, or too many cells.
    pub fn of(scenario: &Scenario) -> Result<Self, ModelError> {
        scenario.validate()?;
        Ok(Self::of_grid(scenario, &Grid::new(scenario)?))
    }

    /// What a legal `scenario` needs on its `grid`.
    pub(crate) fn of_grid(scenario: &Scenario, grid: &Grid) -> Self {
        if grid.is_solid() {
            return Self::of_solid(scenario, grid);
        }
        let entries = scenario.layers.iter().fold(0, |most, layer| most.max(layer.material.n_history_entry()));
        Self {
            model_nodes: MODEL_NODE_FIELDS * grid.n_node(),
            model_cells: grid.n_block(),
            model_hoops: if grid.axisymmetric { grid.n_block() } else { 0 },
            state_nodes: NodeArrays::new(grid, &Outline::of(scenario), 0).total(),
            state_cells: grid.n_block(),
            state_viscous: 2 * entries * grid.n_block(),
        }
    }

    /// A solid has all of its numbers among those of the nodes.
    fn of_solid(scenario: &Scenario, grid: &Grid) -> Self {
        let packs = history_packs(scenario);
        Self {
            model_nodes: MODEL_NODE_FIELDS * grid.n_node() + SolidArrays::of_model(grid).total(),
            model_cells: 0,
            model_hoops: 0,
            state_nodes: NodeArrays::new(grid, &Outline::of(scenario), packs).total(),
            state_cells: 0,
            state_viscous: 0,
        }
    }
}

/// Packs that each tetrahedron of a solid remembers: those of the layer that has most.
pub(crate) fn history_packs(scenario: &Scenario) -> usize {
    scenario.layers.iter().fold(0, |most, layer| most.max(solid_history_packs(&layer.material)))
}
