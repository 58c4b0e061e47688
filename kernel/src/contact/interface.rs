//! Contact and friction between two layers that are not bonded.
//!
//! Each node of either row is paired with the segment of the other one that it is over, which it follows as it slides. The forces
//! are Lagrange multipliers of the forward increment, as those of [`crate::contact::face`]: at the end of the step no node is
//! inside its segment, and one that sticks does not slide. Pairs share nodes, so the forces are found by passes over them in
//! the order of their columns, each pair bringing its own condition about (projected Gauss-Seidel; Jean 1999, Comput. Methods
//! Appl. Mech. Eng. 177, 235), from the forces of the last step. Rows that lie on each other node by node are done after one
//! pass. What a force does to a node, its opposite does to the ends of the segment, by the node's place over it: momentum is
//! kept whatever the number of passes.

use crate::contact::pairing::{Row, Side, ends, exert, relative_velocity};
use crate::features::PADS;
use crate::model::Model;
use crate::number::math;
use crate::number::real::Real;
use crate::scenario::{LayerInterface, MAX_LAYERS};
use crate::state::{ContactWork, Pair, State, StateNodes};

/// Passes over the pairs. Each leaves a part of a change of the forces, most where light nodes lie between heavy ones, and the
/// next step goes on from there. With one, layers have shaken themselves apart; with two, nodes were up to 4 % of a thin cell
/// inside the other layer, in drops on random stacks (`tests/verification/src/plausible.rs`).
const PASSES: usize = 6;

/// Adds the forces between layers to those of the nodes, and says what they take over their impulse.
#[inline(always)]
pub(crate) fn press(model: &Model, state: &mut State) -> ContactWork {
    if PADS && !state.nodes.pairs.is_empty() { press_all(model, &mut state.nodes) } else { ContactWork::default() }
}

#[inline(never)]
fn press_all(model: &Model, nodes: &mut StateNodes<&mut [Real]>) -> ContactWork {
    let (pairs, mut work) = (core::mem::take(&mut nodes.pairs), ContactWork::default());
    for mut interface in Interface::all(model, pairs) {
        interface.press(model, nodes, &mut work);
    }
    nodes.pairs = pairs;
    work
}

/// An interface that is not bonded, and the pairs of the nodes above and below it.
struct Interface<'p> {
    sides: [Side; 2],
    rows: [&'p mut Row; 2],
    friction_coefficient: Real,
}

impl<'p> Interface<'p> {
    /// The interfaces whose pairs are `pairs`, from the core.
    fn all(model: &Model, pairs: &'p mut [Real]) -> impl Iterator<Item = Self> {
        let constants = model.constants;
        let mut rows = pairs.as_chunks_mut().0.chunks_exact_mut(constants.grid.stride());
        (1..MAX_LAYERS).filter_map(move |layer| {
            let sides = Side::both(constants, layer)?;
            let upper = constants.scenario.layers.get(layer)?;
            let friction_coefficient = match upper.interface {
                LayerInterface::Frictional => upper.friction_coefficient,
                LayerInterface::Separating | LayerInterface::Bonded => 0.0,
            };
            Some(Self { sides, rows: [rows.next()?, rows.next()?], friction_coefficient })
        })
    }

    /// Does something with every pair and the row of its segment, the nodes above the interface before those below it.
    #[inline(always)]
    fn each(&mut self, mut act: impl FnMut(&Side, usize, &mut Pair, &mut Row)) {
        let ([upper, lower], [above, below]) = (&self.sides, &mut self.rows);
        visit(upper, upper.columns(), above, below, &mut act);
        visit(lower, lower.columns(), below, above, &mut act);
    }

    fn press(&mut self, model: &Model, nodes: &mut StateNodes<&mut [Real]>, work: &mut ContactWork) {
        for (side, row) in self.sides.iter().zip(&mut self.rows) {
            side.gather(model, nodes, row);
        }
        let coefficient = self.friction_coefficient;
        self.each(|side, column, pair, other| side.find(column, pair, other));
        for _ in 0..PASSES {
            self.each(|side, column, pair, other| touch(side.segment(column, pair), pair, other, coefficient));
        }
        for (side, row) in self.sides.iter().zip(&mut self.rows) {
            side.scatter(nodes, row);
        }
        let dt = model.constants.dt;
        self.each(|side, column, pair, other| {
            let Some([left, right]) = ends(other, side.segment(column, pair)) else { return };
            let [apart, sliding] = relative_velocity(pair, [left, right]);
            work.contact_dissipation -= dt * (pair.pressing * apart);
            work.frictional_dissipation -= dt * (pair.rubbing * sliding);
        });
    }
}

/// Does something with every pair of a row and the `other` row.
#[inline(always)]
fn visit(
    side: &Side,
    columns: impl Iterator<Item = usize>,
    own: &mut Row,
    other: &mut Row,
    act: &mut impl FnMut(&Side, usize, &mut Pair, &mut Row),
) {
    for column in columns {
        let Some(memory) = own.get_mut(column) else { continue };
        let mut pair = Pair::load(memory);
        act(side, column, &mut pair, other);
        pair.store(memory);
    }
}

/// Brings about the conditions of a pair, by forces along its normal and across it: neither changes what the other does.
#[inline(always)]
fn touch(segment: usize, pair: &mut Pair, other: &mut Row, coefficient: Real) {
    let Some([left, right]) = ends(other, segment) else { return };
    let [apart, sliding] = relative_velocity(pair, [left, right]);
    let pressing = math::max(0.0, pair.pressing - pair.resistance * (pair.opening + apart));
    let (stick, limit) = (pair.rubbing - pair.resistance * sliding, coefficient * pressing);
    let rubbing = if stick > limit { limit } else { math::max(-limit, stick) };
    exert(pair, [left, right], pressing - pair.pressing, rubbing - pair.rubbing);
    (pair.pressing, pair.rubbing) = (pressing, rubbing);
}
