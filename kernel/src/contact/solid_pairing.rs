//! Which cell a node at an interface of a solid is over, and how both move.

use core::ops::Range;

use crate::contact::pairing::{BESIDE, DEEPEST, PUSHED_OUT};
use crate::contact::solid_node::{SolidNodes, dot};
use crate::mesh::Grid;
use crate::model::Constants;
use crate::number::math;
use crate::number::real::Real;
use crate::scenario::Symmetry;
use crate::state::{SolidPair, SolidPairRow};

/// One row of nodes at an interface, in all slices.
#[derive(Clone, Debug)]
pub(super) struct SolidSide<'m> {
    grid: &'m Grid,
    /// The first of the nodes.
    pub first: usize,
    /// Columns and slices of cells of their layer.
    own: [Range<usize>; 2],
    /// Those of the other one.
    other: [Range<usize>; 2],
    /// 1 where they are above the other row, -1 where they are below.
    upwards: Real,
    /// Whether the body goes on beyond the first column, and beyond the first slice, by symmetry.
    mirrored: [bool; 2],
    /// Time step, s.
    pub dt: Real,
}

impl<'m> SolidSide<'m> {
    /// The nodes above the interface below `layer` and those below it; none if it is bonded.
    pub fn both(constants: &'m Constants, layer: usize) -> Option<[Self; 2]> {
        let grid = &constants.grid;
        let [below, above] = grid.interface_rows(layer)?;
        let symmetry = constants.scenario.geometry.symmetry;
        let mirrored = [symmetry == Symmetry::Quarter, symmetry != Symmetry::Full];
        let cells = |layer| [grid.columns_of(layer), grid.slices_of(layer)];
        let [of_below, of_above] = [cells(layer.checked_sub(1)?), cells(layer)];
        let side = |row, own: &[Range<usize>; 2], other: &[Range<usize>; 2], upwards| Self {
            grid,
            first: row * grid.plane(),
            own: own.clone(),
            other: other.clone(),
            upwards,
            mirrored,
            dt: constants.dt,
        };
        Some([side(above, &of_above, &of_below, 1.0), side(below, &of_below, &of_above, -1.0)])
    }

    /// Column and slice of every node, and its place in the row.
    pub fn places(&self) -> impl Iterator<Item = ([usize; 2], usize)> + use<> {
        let ([columns, slices], stride) = (self.own.clone(), self.grid.stride());
        (slices.start..=slices.end)
            .flat_map(move |w| (columns.start..=columns.end).map(move |u| ([u, w], w * stride + u)))
    }

    /// Takes the nodes as they are at the start of a step, with the forces so far.
    pub fn gather(&self, nodes: &SolidNodes, row: &mut SolidPairRow) {
        for (_, place) in self.places() {
            let (Some(velocity), Some(position)) = (row.velocity.get_mut(place), row.pull.get_mut(place)) else {
                continue;
            };
            let Some(node) = nodes.node(self.first + place) else { continue };
            (*velocity, *position) = (node.next_velocity(self.dt), node.position);
        }
    }

    /// Adds the forces across the interface to those of the nodes, and leaves the means of their velocities over them.
    pub fn scatter(&self, nodes: &mut SolidNodes, row: &mut SolidPairRow) {
        for (_, place) in self.places() {
            let (Some(mean), Some(pull)) = (row.velocity.get_mut(place), row.pull.get(place)) else { continue };
            let Some(node) = nodes.node(self.first + place) else { continue };
            *mean = core::array::from_fn(|i| 0.5 * (mean[i] + node.velocity[i]));
            nodes.add_force(self.first + place, *pull);
        }
    }

    /// Finds where the nodes of `own` are over the other row at the start of a step, whose positions are in the place of what
    /// pulls at them.
    pub fn find(&self, own: &mut SolidPairRow, other: &SolidPairRow) {
        for (at, place) in self.places() {
            let (Some(numbers), Some(position)) = (own.pairs.get_mut(place), own.pull.get(place)) else { continue };
            let mut pair = SolidPair::of(*numbers);
            self.locate(at, &mut pair, position, other.pull);
            *numbers = pair.numbers();
        }
    }

    /// The cell of a pair, by column and slice.
    fn cell(&self, [u, w]: [usize; 2], pair: &SolidPair) -> [Real; 2] {
        [u as Real + pair.shift[0], w as Real + pair.shift[1]]
    }

    /// Places of the corners of the cell of a pair in the other row: those of its first slice, then those of the next.
    pub fn corners(&self, at: [usize; 2], pair: &SolidPair) -> [usize; 4] {
        // Cells are there, so neither is negative.
        let ([u, w], stride) = (self.cell(at, pair).map(|number| number as usize), self.grid.stride());
        let first = w * stride + u;
        [first, first + 1, first + stride, first + stride + 1]
    }

    /// Where the node of the column and slice `at` is over the other row, whose nodes are at `positions`, m.
    fn locate(&self, at: [usize; 2], pair: &mut SolidPair, node: &[Real; 3], positions: &[[Real; 3]]) {
        self.hold_to_cells(at, pair);
        let places = self.corners(at, pair);
        let [a, b, c, d] = places.map(|place| positions.get(place).copied().unwrap_or_default());
        // Of the cell in its middle, where it has a plane whatever its shape.
        let along: [Real; 3] = core::array::from_fn(|i| 0.5 * ((b[i] - a[i]) + (d[i] - c[i])));
        let across: [Real; 3] = core::array::from_fn(|i| 0.5 * ((c[i] - a[i]) + (d[i] - b[i])));
        let normal = cross(&across, &along).map(|part| self.upwards * part);
        let area = math::sqrt(dot(&normal, &normal));
        if area <= 0.0 {
            return self.part_from(pair);
        }
        let from = |pair: &SolidPair| -> [Real; 3] {
            let weights = pair.weights();
            core::array::from_fn(|i| {
                node[i] - (weights[0] * a[i] + weights[1] * b[i] + weights[2] * c[i] + weights[3] * d[i])
            })
        };
        // One step of a search that goes on from step to step: a node slides by far less than a cell in one.
        let (beside, [uu, uw, ww]) = (from(pair), [dot(&along, &along), dot(&along, &across), dot(&across, &across)]);
        let ([u, w], determinant) = ([dot(&along, &beside), dot(&across, &beside)], area * area);
        let found = [pair.part[0] + (ww * u - uw * w) / determinant, pair.part[1] + (uu * w - uw * u) / determinant];
        let past = self.follow_cells(at, pair, found);
        pair.normal = normal.map(|part| part / area);
        let distance = dot(&from(&SolidPair { part: found.map(held), ..*pair }), &pair.normal);
        let length = math::sqrt(area);
        if past || distance < -DEEPEST * length {
            return self.part_from(pair);
        }
        pair.opening = math::max(distance, -PUSHED_OUT * length) / self.dt;
        pair.resistance = 1.0;
        let along_normal = dot(&pair.friction, &pair.normal);
        pair.friction = core::array::from_fn(|i| pair.friction[i] - along_normal * pair.normal[i]);
    }

    /// Leaves no forces.
    fn part_from(&self, pair: &mut SolidPair) {
        (pair.resistance, pair.pressing, pair.friction) = (0.0, 0.0, [0.0; 3]);
    }

    /// Keeps the cell of a pair among those that are there: the nodes of the last column and of the last slice begin at its end.
    fn hold_to_cells(&self, at: [usize; 2], pair: &mut SolidPair) {
        let cell = self.cell(at, pair);
        for i in 0..2 {
            let [first, last] = self.ends(i);
            if cell[i] > last {
                (pair.shift[i], pair.part[i]) = (last - at[i] as Real, 1.0);
            } else if cell[i] < first {
                (pair.shift[i], pair.part[i]) = (first - at[i] as Real, 0.0);
            }
        }
    }

    /// First and last column (0) or slice (1) of cells of the other layer.
    fn ends(&self, direction: usize) -> [Real; 2] {
        let [columns, slices] = &self.other;
        let cells = if direction == 0 { columns } else { slices };
        [cells.start as Real, cells.end.saturating_sub(1) as Real]
    }

    /// Goes on to the cell beside where a node was `found` beside its own; whether it is past an end of the row.
    fn follow_cells(&self, at: [usize; 2], pair: &mut SolidPair, found: [Real; 2]) -> bool {
        let (cell, mut past) = (self.cell(at, pair), false);
        for i in 0..2 {
            let [first, last] = self.ends(i);
            pair.part[i] = held(found[i]);
            if found[i] > 1.0 + BESIDE {
                if cell[i] < last {
                    (pair.shift[i], pair.part[i]) = (pair.shift[i] + 1.0, 0.0);
                } else {
                    past = true;
                }
            } else if found[i] < -BESIDE {
                if cell[i] > first {
                    (pair.shift[i], pair.part[i]) = (pair.shift[i] - 1.0, 1.0);
                } else if !self.mirrored[i] {
                    past = true;
                }
            }
        }
        past
    }
}

/// A place over a cell, or its nearest end: one near an end is held by that end alone.
fn held(part: Real) -> Real {
    if part > 1.0 - BESIDE {
        1.0
    } else if part > BESIDE {
        part
    } else {
        0.0
    }
}

/// a x b.
fn cross(a: &[Real; 3], b: &[Real; 3]) -> [Real; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
