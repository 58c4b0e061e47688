//! The structured mesh of the section: rows of cells from the core (v = 0) to the surface, columns from the centre
//! line (u = 0) outwards, or from left to right in a full section.
//!
//! The topology is implicit: cell (u, v) has the corners (u, v), (u + 1, v), (u + 1, v + 1), (u, v + 1), numbered 0 to
//! 3 in this order, and is split into two triangles by a diagonal ([`triangles`] tells which). Blocks
//! of [`LANES`] cells lie along a row, so that the data of neighbouring cells are neighbours in memory and the element
//! loop needs no index table. A row is padded to whole blocks with cells of no volume and nodes of no mobility.

use core::ops::Range;

use crate::error::ModelError;
use crate::features::{PADS, SOLID};
use crate::mesh::columns::{MAX_PIECES, Piece, cells_along, layer_across, pieces};
use crate::mesh::paths::TETRAHEDRA;
use crate::mesh::slices::{Slices, meshed};
use crate::number::pack::{LANES, Pack};
use crate::number::real::{Real, SAME};
use crate::scenario::{Body, Formulation, Layer, MAX_LAYERS, Scenario};

/// Largest number of cells of a mesh.
pub const MAX_CELLS: usize = 1 << 20;

/// Counts and strides of the structured mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    /// Cells along a row, outwards from the centre line or, in a full section, from left to right.
    pub n_u: usize,
    /// Column of the nodes on the centre line.
    pub centre: usize,
    /// Rows of cells, from the core to the surface.
    pub n_v: usize,
    /// Row that ends each layer: the first of the next one. Layers that the scenario does not have end with the last.
    pub layer_end: [usize; MAX_LAYERS],
    /// Whether each layer has nodes of its own where it lies on the one below, which are a row more then.
    pub layer_open: [bool; MAX_LAYERS],
    /// Columns of cells of each layer to either side of the centre line; those beyond are empty. Layers that the scenario does
    /// not have are as the last.
    pub layer_columns: [usize; MAX_LAYERS],
    /// Row of nodes at the top of each layer, likewise.
    pub layer_top: [usize; MAX_LAYERS],
    /// How the columns of half the section are spread, from the centre line to the side; the last ones are alike.
    pub pieces: [Piece; MAX_PIECES],
    /// Whether the section turns about its centre line.
    pub axisymmetric: bool,
    /// Whether the slices of a solid are spread about its axis as the columns are about the centre line.
    pub revolved: bool,
    /// Slices of cells of a solid along z, from one end, or the plane z = 0, to the other end; 0 in a section.
    pub n_w: usize,
    /// Slice of the nodes on the plane z = 0.
    pub centre_w: usize,
    /// How the slices on either side of that plane are spread.
    pub slices: Slices,
}

impl Grid {
    /// The grid whose cells come nearest to the scenario's element size, each layer with at least one row.
    ///
    /// # Errors
    /// An element size that asks for more than [`MAX_CELLS`] cells.
    pub fn new(scenario: &Scenario) -> Result<Self, ModelError> {
        let geometry = &scenario.geometry;
        let element_size = scenario.mesh.element_size;
        let pieces = pieces(scenario);
        let half = pieces[MAX_PIECES - 1].end;
        let rows = scenario.layers.iter().fold(0.0, |sum, layer| sum + layer_rows(layer, element_size) as Real);
        let slices = if geometry.formulation.is_solid() { Slices::of(scenario, half) } else { Slices::NONE };
        let [n_w, centre_w] = meshed(geometry.symmetry, slices.half);
        let full = scenario.has_both_sides();
        let cells = if full { 2.0 } else { 1.0 } * half as Real * rows * n_w.max(1) as Real;
        if cells > MAX_CELLS as Real {
            return Err(ModelError::TooManyCells { cells, max: MAX_CELLS });
        }
        let mut n_v = 0;
        let mut layers = scenario.layers.iter();
        let layer_end = [(); MAX_LAYERS].map(|()| {
            n_v += layers.next().map_or(0, |layer| layer_rows(layer, element_size));
            n_v
        });
        let layer_open = core::array::from_fn(|place| scenario.is_open(place));
        let layer_columns = columns_of_layers(scenario, &pieces);
        let mut opened = 0;
        let layer_top = core::array::from_fn(|place| {
            opened += usize::from(scenario.is_open(place));
            layer_end[place.min(MAX_LAYERS - 1)] + opened
        });
        let axisymmetric = geometry.formulation == Formulation::Axisymmetric;
        let revolved = geometry.formulation.is_solid() && geometry.body == Body::Revolved;
        let [n_u, centre] = if full { [2 * half, half] } else { [half, 0] };
        Ok(Self {
            n_u,
            centre,
            n_v,
            layer_end,
            layer_open,
            layer_columns,
            layer_top,
            pieces,
            axisymmetric,
            revolved,
            n_w,
            centre_w,
            slices,
        })
    }

    /// First nodes of the four rows about the block at `place` of the row of cells in row `v` and slice `w` of a solid, in the order
    /// of the paths in a cell ([`crate::mesh::PATHS`]): bit 0 from the surface down, bit 1 away from z = 0.
    #[inline(always)]
    pub(crate) fn solid_rows(&self, [v, w]: [usize; 2], place: usize) -> [usize; 4] {
        let [near, far] = if w < self.centre_w { [w + 1, w] } else { [w, w + 1] };
        let (lower, first) = (self.node_row(v), place * LANES);
        [
            self.node(first, lower + 1, near),
            self.node(first, lower, near),
            self.node(first, lower + 1, far),
            self.node(first, lower, far),
        ]
    }

    /// 1 for the cells of the block at `place` of a row that are on the left of the centre line, if there are any.
    #[inline(always)]
    pub(crate) fn mirrored(&self, place: usize) -> Option<Pack> {
        let left = self.centre.saturating_sub(place * LANES);
        if left == 0 { None } else { Some(core::array::from_fn(|l| if l < left { 1.0 } else { 0.0 })) }
    }

    /// Row, slice and place of a block of a solid.
    pub(crate) fn solid_place(&self, block: usize) -> ([usize; 2], usize) {
        let (row, place) = (block / self.blocks_per_row().max(1), block % self.blocks_per_row().max(1));
        ([row / self.n_w.max(1), row % self.n_w.max(1)], place)
    }

    /// Whether the mesh is that of a solid.
    #[inline(always)]
    pub fn is_solid(&self) -> bool {
        SOLID && self.n_w > 0
    }

    /// Slices of nodes: one in a section.
    pub fn node_slices(&self) -> usize {
        if self.is_solid() { self.n_w + 1 } else { 1 }
    }

    /// Nodes of a row in all slices, padding included.
    pub fn plane(&self) -> usize {
        self.stride() * self.node_slices()
    }

    /// The nodes of column `u`, row `v` and slice `w`.
    pub fn node(&self, u: usize, v: usize, w: usize) -> usize {
        (v * self.node_slices() + w) * self.stride() + u
    }

    /// Blocks that hold a row of cells.
    pub fn blocks_per_row(&self) -> usize {
        self.n_u.div_ceil(LANES)
    }

    /// Blocks of the whole mesh.
    pub fn n_block(&self) -> usize {
        self.blocks_per_row() * self.n_v * self.n_w.max(1)
    }

    /// Rows of cells of a layer, counted from the core.
    pub fn rows_of(&self, layer: usize) -> Range<usize> {
        let end = |layer: usize| self.layer_end.get(layer).copied().unwrap_or(self.n_v);
        layer.checked_sub(1).map_or(0, end)..end(layer)
    }

    /// The layer, counted from the core, that a row of cells is in.
    pub fn layer_of_row(&self, row: usize) -> usize {
        self.layer_end.iter().take(MAX_LAYERS - 1).filter(|end| **end <= row).count()
    }

    /// The layer, counted from the core, that a block is in.
    #[inline(always)]
    pub fn layer_of_block(&self, block: usize) -> usize {
        let per_row = self.blocks_per_row();
        self.layer_end.iter().take(MAX_LAYERS - 1).filter(|end| per_row * **end <= block).count()
    }

    /// The node of column `u`, and slice `w` of a solid, that is at the surface.
    pub fn surface_node(&self, u: usize, w: usize) -> usize {
        self.node(u, self.surface_row(u, w), w)
    }

    /// Row of nodes of that node.
    pub fn surface_row(&self, u: usize, w: usize) -> usize {
        let ring = self.ring(u, w);
        let layers = self.layer_columns.iter().zip(self.layer_top);
        layers.fold(self.n_v, |row, (columns, top)| if ring <= *columns { top } else { row })
    }

    /// Row of nodes above the topmost cell in column `u` and slice `w` of a solid.
    pub(crate) fn surface_row_of_cell(&self, u: usize, w: usize) -> usize {
        let layers = (0..MAX_LAYERS).zip(self.layer_top);
        layers.fold(self.n_v, |row, (layer, top)| {
            if self.columns_of(layer).contains(&u) && self.slices_of(layer).contains(&w) { top } else { row }
        })
    }

    /// Columns of cells between a node and the centre line, or rings about the axis.
    fn ring(&self, u: usize, w: usize) -> usize {
        let (across, along) = (u.abs_diff(self.centre), w.abs_diff(self.centre_w));
        if self.revolved && along > across { along } else { across }
    }

    /// Columns of cells that a layer has.
    pub fn columns_of(&self, layer: usize) -> Range<usize> {
        let columns = self.layer_columns.get(layer).copied().unwrap_or_default();
        self.centre.saturating_sub(columns)..(self.centre + columns).min(self.n_u)
    }

    /// Slices of cells that a layer of a solid has.
    pub fn slices_of(&self, layer: usize) -> Range<usize> {
        if !self.revolved {
            return 0..self.n_w;
        }
        let rings = self.layer_columns.get(layer).copied().unwrap_or_default();
        self.centre_w.saturating_sub(rings)..(self.centre_w + rings).min(self.n_w)
    }

    /// Whether a cell is there, or a layer is narrower than others; of a section in slice 0.
    pub fn has_cell(&self, u: usize, row: usize, w: usize) -> bool {
        let layer = self.layer_of_row(row);
        self.columns_of(layer).contains(&u) && (!self.revolved || self.slices_of(layer).contains(&w))
    }

    /// Whether all nodes of the surface lie in one row.
    pub fn has_even_surface(&self) -> bool {
        self.layer_columns.iter().all(|columns| *columns == self.n_u - self.centre)
    }

    /// The row of nodes at the top of the layer below the layer `layer`, and that at its own lower side, if they are not bonded.
    pub fn interface_rows(&self, layer: usize) -> Option<[usize; 2]> {
        let open = self.layer_open.get(layer).copied().unwrap_or_default();
        let upper = self.node_row(self.rows_of(layer).start);
        if open { Some([upper.checked_sub(1)?, upper]) } else { None }
    }

    /// Where the column `u` of nodes stands: 0 on the centre line, 1 at the right side, -1 at the left one.
    pub fn across(&self, u: usize) -> Real {
        let part = self.part_to_side(u.abs_diff(self.centre));
        if u < self.centre { -part } else { part }
    }

    /// The same of the slice `w` of a body of revolution.
    pub(crate) fn along(&self, w: usize) -> Real {
        let part = self.part_to_side(w.abs_diff(self.centre_w));
        if w < self.centre_w { -part } else { part }
    }

    /// Part of the way to the side at which so many columns have passed.
    fn part_to_side(&self, columns_passed: usize) -> Real {
        let passed = columns_passed as Real;
        if !PADS {
            return passed / (self.n_u - self.centre) as Real;
        }
        let mut start = Piece { end: 0, across: 0.0 };
        for piece in self.pieces {
            if columns_passed <= piece.end {
                let (columns, width) = ((piece.end - start.end) as Real, piece.across - start.across);
                let within = passed - start.end as Real;
                // Of one piece a part of its columns and no more, which rounds once.
                return if start.end == 0 && piece.across == 1.0 {
                    within / columns
                } else {
                    start.across + width * (within / columns)
                };
            }
            start = piece;
        }
        1.0
    }

    /// Nodes from one row to the next, padding included: whole lanes, and one node more than cells.
    pub fn stride(&self) -> usize {
        self.blocks_per_row() * LANES + LANES
    }

    /// Row of a block, and its place in the row.
    pub fn place(&self, block: usize) -> [usize; 2] {
        let per_row = self.blocks_per_row().max(1);
        [block / per_row, block % per_row]
    }

    /// Rows of nodes.
    pub fn node_rows(&self) -> usize {
        self.n_v + 1 + self.layer_open.iter().filter(|open| **open).count()
    }

    /// The row of nodes below a row of cells; the next one is above it.
    #[inline(always)]
    pub fn node_row(&self, row: usize) -> usize {
        let open = self.layer_open.iter().skip(1).zip(&self.layer_end);
        row + open.filter(|(open, end)| **open && **end <= row).count()
    }

    /// First node below and first node above the block at `place` of row `row`.
    #[inline(always)]
    pub fn first_nodes(&self, [row, place]: [usize; 2]) -> [usize; 2] {
        let lower = self.node_row(row) * self.stride() + place * LANES;
        [lower, lower + self.stride()]
    }

    /// Nodes of the whole mesh, padding included.
    pub fn n_node(&self) -> usize {
        self.plane() * self.node_rows()
    }

    /// Triangles or tetrahedra of the whole mesh, without padding and the empty cells beside narrower layers.
    pub fn n_elem(&self) -> usize {
        let cells =
            |layer| self.rows_of(layer).len() * self.columns_of(layer).len() * self.slices_of(layer).len().max(1);
        let per_cell = if self.is_solid() { TETRAHEDRA } else { 2 };
        per_cell * (0..MAX_LAYERS).map(cells).sum::<usize>()
    }

    /// Index of the triangle `t` (0 or 1) or tetrahedron `t` (0 to 5) of lane `l` in block `block`, counted row by row without
    /// padding, in a solid slice by slice of a row.
    pub fn element_index(&self, block: usize, l: usize, t: usize) -> u32 {
        let row = block / self.blocks_per_row().max(1);
        let column = (block % self.blocks_per_row().max(1)) * LANES + l;
        let per_cell = if self.is_solid() { TETRAHEDRA } else { 2 };
        (per_cell * (row * self.n_u + column) + t) as u32
    }
}

/// Columns of cells of each layer beside the centre line: to the end of the piece where it ends.
fn columns_of_layers(scenario: &Scenario, pieces: &[Piece; MAX_PIECES]) -> [usize; MAX_LAYERS] {
    core::array::from_fn(|place| {
        let across = layer_across(scenario, place);
        let last = pieces[MAX_PIECES - 1].end;
        pieces.iter().find(|piece| piece.across >= across - SAME).map_or(last, |piece| piece.end)
    })
}

/// Rows of cells of a layer: as many as it says, or as come nearest to an element size.
fn layer_rows(layer: &Layer, element_size: Real) -> usize {
    match layer.rows {
        0 => cells_along(layer.thickness, element_size) as usize,
        rows => rows,
    }
}
