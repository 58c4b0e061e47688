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
