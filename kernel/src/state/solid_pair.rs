//! The nodes at an interface of a solid and the cells of the other layer's surface that they may touch.

use crate::model::{SOLID_END_FIELDS, SOLID_PAIR_FIELDS};
use crate::number::real::Real;

/// A node at an interface and the cell of the other one's row of nodes that it is over. What a step starts from is which cell it
/// follows and where it was over it, and the forces; all else is of one step.
#[derive(Clone, Copy)]
pub(crate) struct SolidPair {
    /// Column and slice of the cell less those of the node, whole numbers.
    pub shift: [Real; 2],
    /// Where the node is over the cell, along the columns and along the slices: from 0 to 1.
    pub part: [Real; 2],
    /// Direction out of the cell.
    pub normal: [Real; 3],
    /// Distance from the cell at the start of the step over the step, m/s; negative inside.
    pub opening: Real,
    /// Force over the change of the relative velocity that it brings about, kg/s; 0 where the node is beside the other layer.
    pub resistance: Real,
    /// Force on the node along the normal, N, never negative.
    pub pressing: Real,
    /// Friction on it, across the normal, N.
    pub friction: [Real; 3],
}

impl SolidPair {
    pub fn of(numbers: [Real; SOLID_PAIR_FIELDS]) -> Self {
        let [su, sw, pu, pw, nx, ny, nz, opening, resistance, pressing, fx, fy, fz] = numbers;
        let (normal, friction) = ([nx, ny, nz], [fx, fy, fz]);
        Self { shift: [su, sw], part: [pu, pw], normal, opening, resistance, pressing, friction }
    }

    pub fn numbers(&self) -> [Real; SOLID_PAIR_FIELDS] {
        let ([su, sw], [pu, pw], [nx, ny, nz], [fx, fy, fz]) = (self.shift, self.part, self.normal, self.friction);
        [su, sw, pu, pw, nx, ny, nz, self.opening, self.resistance, self.pressing, fx, fy, fz]
    }

    /// How much of what is on the node is on each of the corners of the cell: those of the first slice, then those of the next.
    pub fn weights(&self) -> [Real; 4] {
        let [u, w] = self.part;
        [(1.0 - u) * (1.0 - w), u * (1.0 - w), (1.0 - u) * w, u * w]
    }

    /// The force on the node, N.
    pub fn force(&self) -> [Real; 3] {
        core::array::from_fn(|i| self.pressing * self.normal[i] + self.friction[i])
    }
}

/// A row of nodes at an interface of a solid, in all its slices.
pub(crate) struct SolidPairRow<'s> {
    /// The nodes and their cells: [`SolidPair`].
    pub pairs: &'s mut [[Real; SOLID_PAIR_FIELDS]],
    /// Velocities of the nodes with the forces so far, m/s; when they are all known, their means over them.
    pub velocity: &'s mut [[Real; 3]],
    /// Forces that have not changed the velocities yet, N. Until the pairs are found, the positions at the start of the step, m.
    pub pull: &'s mut [[Real; 3]],
}

impl<'s> SolidPairRow<'s> {
    /// How many numbers a row has in memory, for a row of so many nodes in all slices.
    pub const fn numbers(plane: usize) -> usize {
        (SOLID_PAIR_FIELDS + SOLID_END_FIELDS) * plane
    }

    /// The row of `plane` nodes in `memory`; none if it is too short.
    pub fn of(memory: &'s mut [Real], plane: usize) -> Option<Self> {
        let (pairs, rest) = memory.split_at_mut_checked(SOLID_PAIR_FIELDS * plane)?;
        let (velocity, pull) = rest.split_at_mut_checked(SOLID_END_FIELDS / 2 * plane)?;
        Some(Self {
            pairs: pairs.as_chunks_mut().0,
            velocity: velocity.as_chunks_mut().0,
            pull: pull.as_chunks_mut().0,
        })
    }
}
