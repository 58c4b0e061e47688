//! Contact and friction between the surface nodes and a face that is round or has edges.
//!
//! The face is flat about its axis and rounded beside that ([`crate::scenario::Outline`]): a node's depth in the rounding is the
//! radius less its distance from the centre, and the normal is the way from there to the node. The forces are those of
//! [`crate::contact::face`], along that normal: they leave every touching node on the face at the end of the step. What they
//! and friction, along the face, do in the vertical moves the impactor. Friction is found with the normal forces before it;
//! these are then found again with its vertical part.

use crate::contact::node::{Node, add_force};
use crate::impactor::{FaceContact, Prediction};
use crate::model::Model;
use crate::number::math;
use crate::number::real::Real;
use crate::scenario::Outline;
use crate::state::{ContactWork, State, StateNodes};

/// As many as in [`crate::contact::face`].
const PASSES: usize = 4;

/// Adds the contact forces to the forces of the surface nodes and returns what they did.
#[inline(never)]
pub(super) fn contact(model: &Model, state: &mut State, prediction: &Prediction) -> ContactWork {
    let (constants, impactor) = (model.constants, &mut state.scalars.impactor);
    let mut surface = Surface { model, nodes: &mut state.nodes };
    surface.find_depths(prediction.position);
    let rise = |surface: &Surface, shear: Real| {
        let touching = Touching { surface, shear, position: prediction.position };
        prediction.settle(constants, &touching) - prediction.position
    };
    let smooth = rise(&surface, 0.0);
    let shear = surface.rub(smooth, prediction.velocity_half + smooth / constants.dt);
    let rise = rise(&surface, shear);
    let normal_force = surface.press(rise) + shear;
    let before = impactor.velocity_half;
    let rail_force = impactor.advance(model, prediction, prediction.position + rise, normal_force);
    let [contact_dissipation, frictional_dissipation] = surface.work(0.5 * (before + impactor.velocity_half));
    ContactWork { normal_force, contact_dissipation, frictional_dissipation, rail_force }
}

/// The nodes at the surface and the sum of their friction along the face, N, under a face that would be at `position`, m.
struct Touching<'t, 's, 'm, 'a> {
    surface: &'t Surface<'s, 'm, 'a>,
    shear: Real,
    position: Real,
}

impl FaceContact for Touching<'_, '_, '_, '_> {
    fn height(&self, free: Real) -> Real {
        self.position + self.surface.rise(free - self.position, self.shear)
    }
}

/// The nodes at the surface.
struct Surface<'s, 'm, 'a> {
    model: &'s Model<'m>,
    nodes: &'s mut StateNodes<&'a mut [Real]>,
}

/// A node that touches the face.
#[derive(Clone, Copy)]
struct Touch {
    /// kg.
    mass: Real,
    /// Direction out of the face, to the right and downwards.
    out: [Real; 2],
    /// Depth in the face at the end of a step without contact, m.
    depth: Real,
}

impl Touch {
    /// The force that leaves the node on a face that has risen by `rise`, m, at the end of a step of `dt`, s; 0 away from it.
    fn force(&self, rise: Real, dt: Real) -> Real {
        math::max(0.0, self.mass * (self.depth - self.out[1] * rise)) / (dt * dt)
    }
}

/// Depth of a point in a face and the direction out of it there, for a point `x` m beside its axis and `y` m above its lowest
/// point. Above the rounding the impactor has upright sides, which a node beside it may come against.
pub(super) fn depth(outline: &Outline, x: Real, y: Real) -> [Real; 3] {
    let (beyond, down) = (math::abs(x) - outline.flat, outline.radius - y);
    let side = outline.radius - beyond;
    let sign = if x < 0.0 { -1.0 } else { 1.0 };
    if outline.radius > 0.0 && down <= 0.0 && side < y {
        return [side, sign, 0.0];
    }
    if beyond <= 0.0 {
        return [y, 0.0, 1.0];
    }
    let distance = math::sqrt(beyond * beyond + down * down);
    [outline.radius - distance, sign * (beyond / distance), down / distance]
}

impl Surface<'_, '_, '_> {
    fn columns(&self) -> core::ops::RangeInclusive<usize> {
        0..=self.model.constants.grid.n_u
    }

    fn index(&self, column: usize) -> usize {
        self.model.constants.grid.surface_node(column, 0)
    }

    fn touch(&self, column: usize) -> Option<Touch> {
        let [depth, x, y, mass] = *self.nodes.rounding.as_chunks().0.get(column)?;
        Some(Touch { mass, out: [x, y], depth })
    }

    /// How deep every node is at the end of a step without contact, in a face at `height`, m.
    fn find_depths(&mut self, height: Real) {
        let constants = self.model.constants;
        for column in self.columns() {
            let Some(node) = Node::of(self.model, self.nodes, self.index(column)) else { continue };
            let velocity = node.next_velocity(constants.dt);
            let [x, y] = [0, 1].map(|i| node.position[i] + constants.dt * velocity[i]);
            let (x, y) = (x - constants.scenario.impactor.offset, y - (constants.top_height + height));
            let [depth, x, y] = depth(&constants.outline, x, y);
            let mass = self.model.nodes.nodal_mass.get(self.index(column)).copied().unwrap_or_default();
            if let Some(place) = self.nodes.rounding.as_chunks_mut().0.get_mut(column) {
                *place = [depth, x, y, mass];
            }
        }
    }

    /// By how much the contact raises a face, m, that would rise by `free` without it and without the vertical force `shear`, N.
    ///
    /// It is the root r of M (r - free) = dt^2 shear + sum m_i n_i max(0, d_i - n_i r), n_i the vertical part of the normal:
    /// found as in [`crate::contact::face`].
    fn rise(&self, free: Real, shear: Real) -> Real {
        let constants = self.model.constants;
        let mass = constants.moved_mass() / constants.symmetry_factor;
        let start = free + shear * (constants.dt * constants.dt) / mass;
        let mut rise = start;
        for _ in 0..PASSES {
            let (mut masses, mut moments) = (0.0, 0.0);
            for touch in self.columns().filter_map(|column| self.touch(column)) {
                if touch.depth > touch.out[1] * rise {
                    masses += touch.mass * touch.out[1] * touch.out[1];
                    moments += touch.mass * touch.out[1] * (touch.depth - touch.out[1] * start);
                }
            }
            rise = start + moments / (mass + masses);
        }
        rise
    }

    /// Finds the friction on the nodes under a face that has risen by `rise`, m, and moves at `velocity`, m/s; returns its
    /// upward part on the face, N.
    fn rub(&mut self, rise: Real, velocity: Real) -> Real {
        let (dt, coefficient) = (self.model.constants.dt, self.model.constants.scenario.face.friction_coefficient);
        let mut total = 0.0;
        for column in self.columns() {
            let Some(touch) = self.touch(column) else { continue };
            let Some(node) = Node::of(self.model, self.nodes, self.index(column)) else { continue };
            let ([out_x, out_y], [x, y]) = (touch.out, node.next_velocity(dt));
            // Along the face, to the right.
            let sliding = x * out_y + (y - velocity) * out_x;
            let limit = if node.inverse_mass[0] > 0.0 { coefficient * touch.force(rise, dt) } else { 0.0 };
            let stick = -touch.mass * sliding / dt;
            let friction = if stick > limit { limit } else { math::max(-limit, stick) };
            total -= friction * out_x;
            if let Some(place) = self.nodes.contact[1].get_mut(column) {
                *place = friction;
            }
        }
        total
    }

    /// Adds the forces on the nodes under a face that has risen by `rise`, m; returns the upward part of the normal ones on the
    /// face, N.
    fn press(&mut self, rise: Real) -> Real {
        let dt = self.model.constants.dt;
        let mut total = 0.0;
        for column in self.columns() {
            let (Some(touch), index) = (self.touch(column), self.index(column)) else { continue };
            let (normal, [x, y]) = (touch.force(rise, dt), touch.out);
            let friction = self.nodes.contact[1].get(column).copied().unwrap_or_default();
            add_force(self.nodes, index, [normal * x + friction * y, friction * x - normal * y]);
            total += normal * y;
            if let Some(place) = self.nodes.contact[0].get_mut(column) {
                *place = normal;
            }
        }
        total
    }

    /// The energy that the normal forces take over their impulse, J, then that of friction, from a face whose mean velocity is
    /// `face`, m/s. Leaves the forces on the nodes downwards and outwards, N.
    fn work(&mut self, face: Real) -> [Real; 2] {
        let dt = self.model.constants.dt;
        let mut total = [0.0; 2];
        for column in self.columns() {
            let Some(touch) = self.touch(column) else { continue };
            let Some(node) = Node::of(self.model, self.nodes, self.index(column)) else { continue };
            let ([out_x, out_y], after) = (touch.out, node.next_velocity(dt));
            let [x, y] = [0, 1].map(|i| 0.5 * (node.velocity[i] + after[i]));
            let [normal, friction] = &mut self.nodes.contact;
            let (Some(down), Some(right)) = (normal.get_mut(column), friction.get_mut(column)) else { continue };
            let (pressing, rubbing) = (*down, *right);
            total[0] -= dt * pressing * (x * out_x - (y - face) * out_y);
            total[1] -= dt * rubbing * (x * out_y + (y - face) * out_x);
            (*down, *right) = (pressing * out_y - rubbing * out_x, pressing * out_x + rubbing * out_y);
        }
        total
    }
}
