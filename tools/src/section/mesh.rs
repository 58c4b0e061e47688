//! The mesh of a section as lists of nodes and triangles.

use softanvil_kernel::mesh::triangles;
use softanvil_kernel::scenario::Section;
use softanvil_kernel::{Constants, ModelError, Simulation};

/// Nodes and triangles, in the order of the kernel's fields: rows from the core to the surface.
#[derive(Clone, Debug)]
pub struct Mesh {
    /// Constants of the model it belongs to.
    pub constants: Constants,
    /// Rows and columns of nodes.
    pub shape: [usize; 2],
    /// Positions of the nodes at rest, x and height above the centre of the core, m.
    pub reference: Vec<[f64; 2]>,
    /// Nodes of each triangle, counter-clockwise.
    pub triangles: Vec<[usize; 3]>,
}

/// Offsets (column, row) of a cell's corners.
const CORNERS: [[usize; 2]; 4] = [[0, 0], [1, 0], [1, 1], [0, 1]];

impl Mesh {
    /// The mesh of `simulation`.
    ///
    /// # Errors
    /// Never in practice, as [`Simulation::with`].
    pub fn of(simulation: &mut Simulation) -> Result<Self, ModelError> {
        let constants = simulation.constants().clone();
        let grid = constants.grid;
        let shape = [grid.n_v + 1, grid.n_u + 1];
        let node = |row: usize, column: usize| row * shape[1] + column;
        let places = (0..shape[0]).flat_map(|row| (0..shape[1]).map(move |column| row * grid.stride() + column));
        let cells = (0..grid.n_v).flat_map(|v| (0..grid.n_u).map(move |u| (u, v)));
        let triangles = cells.flat_map(|(u, v)| {
            triangles(&grid, u, v)
                .map(|corners| corners.map(|corner| node(v + CORNERS[corner][1], u + CORNERS[corner][0])))
        });
        let reference = simulation.with(|model, _| {
            let [x, y] = model.reference_position();
            places.map(|place| [x[place], y[place]]).collect()
        })?;
        Ok(Self { constants, shape, reference, triangles: triangles.collect() })
    }

    /// Whether this is the right half of a section that is symmetric about x = 0.
    pub fn is_half(&self) -> bool {
        self.constants.scenario.geometry.section == Section::Half
    }

    /// Index of the first node of the surface.
    pub fn first_of_surface(&self) -> usize {
        (self.shape[0] - 1) * self.shape[1]
    }

    /// Nodes along the boundary of the layer: along the core, and from its end over the surface back. A half's line of
    /// symmetry is left open.
    pub fn outline(&self) -> Vec<usize> {
        let [rows, columns] = self.shape;
        let node = |row: usize, column: usize| row * columns + column;
        let core = (0..columns).map(|column| node(0, column));
        let right = (1..rows).map(|row| node(row, columns - 1));
        let surface = (0..columns - 1).rev().map(|column| node(rows - 1, column));
        let left = (0..rows - 1).rev().map(|row| node(row, 0)).take(if self.is_half() { 0 } else { rows });
        core.chain(right).chain(surface).chain(left).collect()
    }

    /// Polygon of the core, m; of no area under a block.
    pub fn core(&self) -> Vec<[f64; 2]> {
        let edge = self.reference.iter().take(self.shape[1]).copied();
        edge.chain([[if self.is_half() { 0.0 } else { self.reference[0][0] }, 0.0]]).collect()
    }

    /// Half the width of all that is drawn, m: of the face, or of the layer where that is wider.
    pub fn reach(&self) -> f64 {
        let face = 0.5 * self.constants.scenario.impactor.face_diameter;
        self.reference.iter().fold(face, |reach, [x, _]| reach.max(x.abs()))
    }
}
