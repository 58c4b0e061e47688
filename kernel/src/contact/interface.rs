//! Contact and friction between two layers that are not bonded.
//!
//! Each node of either row is paired with the segment of the other one that it is over, which it follows as it slides. The forces
//! are Lagrange multipliers of the forward increment, as those of [`crate::contact::face`]: at the end of the step no node is
//! inside its segment, and one that sticks does not slide. Pairs share nodes, so the forces are found by passes over them in
//! the order of their columns, each pair bringing its own condition about (projected Gauss-Seidel; Jean 1999, Comput. Methods
//! Appl. Mech. Eng. 177, 235), from the forces of the last step. Rows that lie on each other node by node are done after one
//! pass. What a force does to a node, its opposite does to the ends of the segment, by the node's place over it: momentum is
//! kept whatever the number of passes.

use crate::contact::pairing::{Bodies, Side};
use crate::model::{Model, PAIR_FIELDS};
use crate::number::math;
use crate::number::real::Real;
use crate::scenario::{LayerInterface, MAX_LAYERS};
use crate::state::{ContactWork, Pair, State, StateNodes};

/// Passes over the pairs for the normal forces, then as many for friction. What is left of a change of the forces is about a
/// tenth of it after each, and the next step goes on from there.
const PASSES: usize = 2;

/// Adds the forces between layers to those of the nodes.
#[inline(always)]
pub(crate) fn press(model: &Model, state: &mut State) {
    if !state.nodes.pairs.is_empty() {
        press_all(model, &mut state.nodes);
    }
}

/// What the forces between layers have taken over their impulse, all forces of the step being on their nodes.
#[inline(always)]
pub(crate) fn work(model: &Model, state: &mut State) -> ContactWork {
    if state.nodes.pairs.is_empty() { ContactWork::default() } else { work_of_all(model, &mut state.nodes) }
}

/// An interface that is not bonded, and the pairs of the nodes above and below it.
struct Interface<'p> {
    sides: [(Side, &'p mut [[Real; PAIR_FIELDS]]); 2],
    friction_coefficient: Real,
}

impl<'p> Interface<'p> {
    /// The interfaces whose pairs are `pairs`, from the core.
    fn all(model: &Model, pairs: &'p mut [Real]) -> impl Iterator<Item = Self> {
        let (constants, mut rows) =
            (model.constants, pairs.as_chunks_mut().0.chunks_exact_mut(model.constants.grid.stride()));
        (1..MAX_LAYERS).filter_map(move |layer| {
            let [above, below] = Side::both(constants, layer)?;
            let (of_above, of_below) = (rows.next()?, rows.next()?);
            let upper = constants.scenario.layers.get(layer)?;
            let friction_coefficient = match upper.interface {
                LayerInterface::Frictional => upper.friction_coefficient,
                LayerInterface::Separating | LayerInterface::Bonded => 0.0,
            };
            Some(Self { sides: [(above, of_above), (below, of_below)], friction_coefficient })
        })
    }

    /// Does something with every pair, the nodes above the interface before those below it.
    fn each(&mut self, mut act: impl FnMut(&Side, usize, &mut Pair)) {
        for (side, pairs) in &mut self.sides {
            for column in side.columns() {
                let Some(place) = pairs.get_mut(column) else { continue };
                let mut pair = Pair::load(place);
                act(side, column, &mut pair);
                *place = pair.store();
            }
        }
    }
}

#[inline(never)]
fn press_all(model: &Model, nodes: &mut StateNodes<&mut [Real]>) {
    let pairs = core::mem::take(&mut nodes.pairs);
    let mut bodies = Bodies { model, nodes };
    for mut interface in Interface::all(model, pairs) {
        let friction_coefficient = interface.friction_coefficient;
        interface.each(|side, column, pair| side.find(&bodies, column, pair));
        // From the forces of the last step.
        interface.each(|side, column, pair| {
            if pair.resistance == 0.0 {
                (pair.pressing, pair.rubbing) = (0.0, 0.0);
            }
            let (normal, tangent) = (pair.normal, pair.tangent());
            let force = [0, 1].map(|i: usize| pair.pressing * normal[i] + pair.rubbing * tangent[i]);
            bodies.exert(side.nodes_of(column, pair), pair, force);
        });
        for _ in 0..PASSES {
            interface.each(|side, column, pair| {
                let nodes = side.nodes_of(column, pair);
                let approach = -pair.opening - bodies.relative_velocity(nodes, pair, pair.normal);
                let pressing = math::max(0.0, pair.pressing + pair.resistance * approach);
                let change = pressing - pair.pressing;
                bodies.exert(nodes, pair, pair.normal.map(|n| change * n));
                pair.pressing = pressing;
            });
        }
        let passes = if friction_coefficient > 0.0 { PASSES } else { 0 };
        for _ in 0..passes {
            interface.each(|side, column, pair| {
                let (nodes, tangent) = (side.nodes_of(column, pair), pair.tangent());
                let sliding = bodies.relative_velocity(nodes, pair, tangent);
                let (stick, limit) = (pair.rubbing - pair.resistance * sliding, friction_coefficient * pair.pressing);
                let rubbing = if stick > limit { limit } else { math::max(-limit, stick) };
                let change = rubbing - pair.rubbing;
                bodies.exert(nodes, pair, tangent.map(|t| change * t));
                pair.rubbing = rubbing;
            });
        }
    }
    bodies.nodes.pairs = pairs;
}

#[inline(never)]
fn work_of_all(model: &Model, nodes: &mut StateNodes<&mut [Real]>) -> ContactWork {
    let pairs = core::mem::take(&mut nodes.pairs);
    let bodies = Bodies { model, nodes };
    let mut work = ContactWork::default();
    for mut interface in Interface::all(model, pairs) {
        interface.each(|side, column, pair| {
            let (nodes, dt) = (side.nodes_of(column, pair), model.constants.dt);
            work.contact_dissipation -= dt * pair.pressing * bodies.mean_velocity(nodes, pair, pair.normal);
            work.frictional_dissipation -= dt * pair.rubbing * bodies.mean_velocity(nodes, pair, pair.tangent());
        });
    }
    bodies.nodes.pairs = pairs;
    work
}
