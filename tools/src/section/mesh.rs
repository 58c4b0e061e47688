//! The mesh of a section, or of a solid in the plane z = 0, as lists of nodes and triangles.

use std::f64::consts::FRAC_PI_2;

use softanvil_kernel::mesh::triangles as kernel_triangles;
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
    /// Nodes of each triangle that is there, counter-clockwise.
    pub triangles: Vec<[usize; 3]>,
    /// Place of each among the values of a field of triangles, which has those beside narrower layers too.
    pub places: Vec<usize>,
}

/// Offsets (column, row) of a cell's corners.
const CORNERS: [[usize; 2]; 4] = [[0, 0], [1, 0], [1, 1], [0, 1]];

impl Mesh {
    /// The mesh of `simulation`.
    ///
    /// # Errors
    /// Never in practice, as [`Simulation::read`].
    pub fn of(simulation: &Simulation) -> Result<Self, ModelError> {
        let constants = simulation.constants().clone();
        let grid = &constants.grid;
        let shape = [grid.node_rows(), grid.n_u + 1];
        let node_at = |row, column| grid.node(column, row, grid.centre_w);
        let nodes: Vec<usize> =
            (0..shape[0]).flat_map(|row| (0..shape[1]).map(move |column| node_at(row, column))).collect();
        // Of a solid the cells in front of the plane z = 0.
        let (mut triangles, mut places, slice) = (Vec::new(), Vec::new(), grid.centre_w);
        for (v, u) in
            (0..grid.n_v).flat_map(|v| (0..grid.n_u).map(move |u| (v, u))).filter(|(v, u)| grid.has_cell(*u, *v, slice))
        {
            let node = |[column, row]: [usize; 2]| (grid.node_row(v) + row) * shape[1] + u + column;
            triangles.extend(kernel_triangles(grid, u, v).map(|corners| corners.map(|corner| node(CORNERS[corner]))));
            places.extend([0, 1].map(|t| 2 * (v * grid.n_u + u) + t));
        }
        let reference = simulation.read(|model, _| {
            let [x, y] = model.reference_position();
            nodes.into_iter().map(|node| [x[node], y[node]]).collect()
        })?;
        Ok(Self { constants, shape, reference, triangles, places })
    }

    /// Whether this is the right half of a section that is symmetric about x = 0.
    pub fn is_half(&self) -> bool {
        self.constants.grid.centre == 0
    }

    /// Node of the surface in `column`.
    pub fn surface(&self, column: usize) -> usize {
        let grid = &self.constants.grid;
        grid.surface_row(column, grid.centre_w) * self.shape[1] + column
    }

    /// The values of a field of triangles, so many `components` each, of those that are there.
    pub fn of_triangles(&self, values: &[f64], components: usize) -> Vec<f64> {
        self.places.iter().flat_map(|place| &values[place * components..(place + 1) * components]).copied().collect()
    }

    /// Nodes along the boundary of each layer: along its lower side, and from its end over its upper side back. A half's line of
    /// symmetry is left open.
    pub fn outlines(&self) -> Vec<Vec<usize>> {
        (0..self.constants.scenario.layers.len()).map(|layer| self.outline(layer)).collect()
    }

    fn outline(&self, layer: usize) -> Vec<usize> {
        let (grid, columns) = (&self.constants.grid, self.constants.grid.columns_of(layer));
        let (first, rows) = (grid.node_row(grid.rows_of(layer).start), grid.rows_of(layer).len());
        let node = |row: usize, column: usize| (first + row) * self.shape[1] + column;
        let lower = (columns.start..=columns.end).map(|column| node(0, column));
        let right = (1..=rows).map(|row| node(row, columns.end));
        let upper = (columns.start..columns.end).rev().map(|column| node(rows, column));
        let left = (0..rows).rev().map(|row| node(row, columns.start)).take(if self.is_half() { 0 } else { rows });
        lower.chain(right).chain(upper).chain(left).collect()
    }

    /// Polygon of the core, m; of no area under a block.
    pub fn core(&self) -> Vec<[f64; 2]> {
        let edge = self.reference.iter().take(self.shape[1]).copied();
        edge.chain([[if self.is_half() { 0.0 } else { self.reference[0][0] }, 0.0]]).collect()
    }

    /// The face and what is drawn of the impactor above it: a polygon from the left end of the face, m from the impactor's
    /// axis and above its lowest point. Of a face that is round or has edges it is what is not higher than [`SLAB`].
    pub fn impactor(&self) -> Vec<[f64; 2]> {
        let outline = self.constants.outline;
        let rise = outline.radius.min(SLAB);
        let end = FRAC_PI_2.min((1.0 - rise / outline.radius.max(rise)).acos());
        let arc = |i: usize| {
            let angle = end * i as f64 / ARC as f64;
            [outline.flat + outline.radius * angle.sin(), outline.radius * (1.0 - angle.cos())]
        };
        let rounding: Vec<[f64; 2]> = (0..if outline.radius > 0.0 { ARC + 1 } else { 1 }).map(arc).collect();
        let right = rounding.iter().skip(usize::from(outline.flat == 0.0)).copied();
        let face = rounding.iter().rev().map(|[x, y]| [-x, *y]).chain(right);
        let widest = rounding.last().map_or(0.0, |point| point[0]);
        let top = if rise < SLAB { vec![[widest, SLAB], [-widest, SLAB]] } else { Vec::new() };
        face.chain(top).collect()
    }

    /// Half the width of all that is drawn, m: of the face, or of the layer where that is wider.
    pub fn reach(&self) -> f64 {
        let impactor = self.impactor();
        let ends = impactor.iter().map(|[x, _]| x.abs()).chain(self.reference.iter().map(|[x, _]| x.abs()));
        ends.fold(0.0, f64::max)
    }
}

/// Pieces of a rounding.
const ARC: usize = 16;

/// Height of what is drawn of the impactor, m.
pub const SLAB: f64 = 8e-3;

#[cfg(test)]
mod tests {
    use super::*;
    use softanvil_kernel::preset;
    use softanvil_kernel::scenario::{FaceShape, Formulation, Layer, LayerInterface};

    #[test]
    fn a_stack_is_drawn_as_it_is() {
        let mut scenario = preset::study();
        let (interface, gap) = (LayerInterface::Separating, 2e-3);
        scenario.add_layer(Layer { thickness: 6e-3, width: 60e-3, interface, gap, ..preset::spare_layer() }).unwrap();
        let mesh = Mesh::of(&Simulation::new(&scenario).unwrap()).unwrap();
        let grid = &mesh.constants.grid;
        let cells = grid.n_u * grid.rows_of(0).len() + grid.columns_of(1).len() * grid.rows_of(1).len();
        assert!(grid.columns_of(1).len() < grid.n_u);
        assert_eq!([mesh.triangles.len(), mesh.places.len()], [2 * cells, 2 * cells]);
        // The lower side of the pad ends 30 mm along it, and lies 2 mm above the layer.
        let (lower, upper) = (&mesh.outlines()[0], &mesh.outlines()[1]);
        let end = mesh.reference[upper[grid.columns_of(1).len()]];
        let radius = 37.5e-3 + 15e-3 + 2e-3;
        assert!((end[0] - radius * (30e-3_f64 / radius).sin()).abs() < 1e-12, "{end:?}");
        let top = mesh.reference[mesh.surface(grid.n_u)];
        assert_eq!(top, mesh.reference[lower[grid.n_u + grid.rows_of(0).len()]]);
    }

    #[test]
    fn the_impactor_is_drawn_as_it_is() {
        let mut scenario = preset::study();
        let mut face = |change: &dyn Fn(&mut softanvil_kernel::Scenario)| {
            change(&mut scenario);
            Mesh::of(&Simulation::new(&scenario).unwrap()).unwrap().impactor()
        };
        assert_eq!(face(&|_| {}), [[-65e-3, 0.0], [65e-3, 0.0], [65e-3, SLAB], [-65e-3, SLAB]]);
        let narrow = face(&|scenario| scenario.impactor.face_diameter = 40e-3);
        assert!(narrow.iter().all(|[x, _]| x.abs() < 20e-3 + 1e-12) && narrow.contains(&[19e-3, 0.0]));
        let ball = face(&|scenario| {
            (scenario.geometry.formulation, scenario.impactor.shape) = (Formulation::Axisymmetric, FaceShape::Sphere);
        });
        assert!(ball.iter().all(|[x, y]| (x.hypot(y - 20e-3) - 20e-3).abs() < 1e-12));
        assert!((ball[0][1] - SLAB).abs() < 1e-12);
    }
}
