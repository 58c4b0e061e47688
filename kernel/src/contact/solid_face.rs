//! Contact and friction between the surface of a solid and the face.
//!
//! As under a face that is round or has edges in the section ([`crate::contact::rounded_face`]), with a third direction: the face is
//! flat over a disc or a rectangle and rounded beyond it, and the forces along its normal leave every touching node on it at the
//! end of the step. So do those on the surface between the nodes where the face has its edge ([`crate::contact::solid_edge`]).
//! Friction stops a node along the face within the limit of Coulomb's law.

use crate::contact::friction::limited_vector;
use crate::contact::rounded_face::depth;
use crate::contact::solid_edge;
use crate::contact::solid_node::{SolidNodes, across, dot};
use crate::contact::solid_touch::Touch;
use crate::impactor::{FaceContact, ImpactorState, Prediction};
use crate::model::{Constants, Model, SOLID_TOUCH_FIELDS};
use crate::number::math;
use crate::number::real::Real;
use crate::scenario::{FaceShape, Outline};
use crate::state::{ContactWork, SolidState, StateNodes};

/// As many as in [`crate::contact::face`].
const PASSES: usize = 4;

/// What the forces on the nodes do to the face in a step.
pub(crate) struct Push {
    /// How far they raise it, m.
    rise: Real,
    /// Their upward sum on it, N.
    force: Real,
}

/// Adds the contact forces to the forces of the surface nodes. The impactor and what is shown of the contact stay as they are.
#[inline(never)]
pub(crate) fn press(model: &Model, nodes: &mut StateNodes<&mut [Real]>, prediction: &Prediction) -> Push {
    let dt = model.constants.dt;
    let (mut surface, _) = Surface::of(model, nodes);
    let has_edge = surface.find_depths(prediction.position);
    let smooth = surface.settle(prediction, 0.0, has_edge);
    let shear = surface.rub(smooth, prediction.velocity_half + smooth / dt);
    let rise = surface.settle(prediction, shear, has_edge);
    Push { rise, force: surface.press(rise) + shear }
}

/// Moves the impactor by the push of the nodes, and returns what their forces did.
#[inline(never)]
pub(crate) fn complete(
    model: &Model,
    nodes: &mut StateNodes<&mut [Real]>,
    impactor: &mut ImpactorState,
    prediction: &Prediction,
    push: &Push,
) -> ContactWork {
    let Push { rise, force: normal_force } = *push;
    let (surface, shown) = Surface::of(model, nodes);
    let before = impactor.velocity_half;
    let rail_force = impactor.advance(model, prediction, prediction.position + rise, normal_force);
    let face = 0.5 * (before + impactor.velocity_half);
    let [contact_dissipation, frictional_dissipation] = surface.work(face);
    surface.show(shown);
    ContactWork { normal_force, contact_dissipation, frictional_dissipation, rail_force }
}

/// The nodes at the surface and the sum of their friction along the face, N, under a face that would be at `position`, m.
struct Touching<'t, 's> {
    surface: &'t Surface<'s>,
    shear: Real,
    position: Real,
}

impl FaceContact for Touching<'_, '_> {
    fn height(&self, free: Real) -> Real {
        self.position + self.surface.rise(free - self.position, self.shear)
    }
}

/// The nodes at the surface.
struct Surface<'s> {
    constants: &'s Constants,
    nodes: SolidNodes<'s>,
    touches: &'s mut [[Real; SOLID_TOUCH_FIELDS]],
}

/// How far a point `x` and `z` m beside the centre of a face is beyond the edge of its flat part, m; negative inside. Faces that are
/// nowhere flat have no edge.
fn beyond_edge(constants: &Constants, [x, z]: [Real; 2]) -> Real {
    let (outline, scenario) = (&constants.outline, &constants.scenario);
    match scenario.impactor.shape {
        FaceShape::Round => math::sqrt(x * x + z * z) - outline.flat,
        FaceShape::Rectangular => {
            math::max(math::abs(x) - outline.flat, math::abs(z) - scenario.face_flat_length(outline))
        }
        FaceShape::Sphere | FaceShape::Bar => 0.0,
    }
}

/// Depth of a point in the face and the direction out of it there, for a point `x` and `z` m beside its centre and `y` m above its
/// lowest point.
fn depth_in_face(constants: &Constants, [x, y, z]: [Real; 3]) -> (Real, [Real; 3]) {
    let (outline, impactor) = (&constants.outline, &constants.scenario.impactor);
    // From the flat part.
    let beyond = match impactor.shape {
        FaceShape::Round | FaceShape::Sphere => {
            let radius = math::sqrt(x * x + z * z);
            if radius <= outline.flat { [0.0; 2] } else { [x, z].map(|way| way * (1.0 - outline.flat / radius)) }
        }
        FaceShape::Rectangular | FaceShape::Bar => {
            [past(x, outline.flat), past(z, constants.scenario.face_flat_length(outline))]
        }
    };
    if impactor.shape == FaceShape::Bar && beyond[1] != 0.0 {
        return (FAR_AWAY, [0.0, -1.0, 0.0]);
    }
    let distance = math::sqrt(beyond[0] * beyond[0] + beyond[1] * beyond[1]);
    let [depth, aside, down] = depth(&Outline { flat: 0.0, ..*outline }, distance, y);
    if distance > 0.0 {
        (depth, [aside * (beyond[0] / distance), -down, aside * (beyond[1] / distance)])
    } else {
        (depth, [0.0, -down, 0.0])
    }
}

/// No depth at all, m.
const FAR_AWAY: Real = -1e30;

/// The way from the nearest place that is `half` or less beside the centre.
fn past(place: Real, half: Real) -> Real {
    let beyond = math::max(0.0, math::abs(place) - half);
    if place < 0.0 { -beyond } else { beyond }
}

impl<'s> Surface<'s> {
    /// The nodes of a state, and where the forces on them are left: downwards, along x and along z, N.
    fn of(model: &'s Model, nodes: &'s mut StateNodes<&mut [Real]>) -> (Self, [&'s mut [Real]; 3]) {
        let constants = model.constants;
        let StateNodes {
            displacement: [ux, uy], velocity: [vx, vy], force: [fx, fy], contact, rounding, solid, ..
        } = nodes;
        let solid = SolidState::of(&constants.grid, constants.solid_history_packs, solid);
        let nodes =
            SolidNodes::new(model, [ux, uy, solid.displacement], [vx, vy, solid.velocity], [fx, fy, solid.force]);
        let [down, along_x] = contact;
        (Self { constants, nodes, touches: rounding.as_chunks_mut().0 }, [down, along_x, solid.friction])
    }

    /// Index of the surface node of every place, slice by slice.
    fn indices(&self) -> impl Fn(usize) -> usize + use<> {
        let grid = self.constants.grid;
        let (even, stride) = (grid.has_even_surface(), grid.stride().max(1));
        let first = (grid.node_rows() - 1) * grid.plane();
        move |place| if even { first + place } else { grid.surface_node(place % stride, place / stride) }
    }

    /// How deep every node is at the end of a step without contact, in a face at `height`, m; whether the edge of the face lies
    /// among the nodes.
    fn find_depths(&mut self, height: Real) -> bool {
        let (constants, index) = (self.constants, self.indices());
        let mut sides = [false; 2];
        for (place, numbers) in self.touches.iter_mut().enumerate() {
            let Some(node) = self.nodes.node(index(place)) else { continue };
            let velocity = node.next_velocity(constants.dt);
            let [x, y, z] = core::array::from_fn(|i| node.position[i] + constants.dt * velocity[i]);
            let beside = [x - constants.scenario.impactor.offset, y - (constants.top_height + height), z];
            let (depth, out) = depth_in_face(constants, beside);
            let beyond = beyond_edge(constants, [beside[0], z]);
            sides[usize::from(beyond > 0.0)] = true;
            *numbers = Touch::new(node.mass, depth, out, [beside[1], beyond]).numbers();
        }
        sides == [true; 2]
    }

    /// By how much the contact raises the face, m, with the upward friction `shear` on it, N.
    fn settle(&mut self, prediction: &Prediction, shear: Real, has_edge: bool) -> Real {
        let rise = self.settle_on(prediction, shear, has_edge);
        if !has_edge {
            return rise;
        }
        // What the edge adds hardly moves the face, which is so much heavier than the nodes.
        for _ in 0..solid_edge::PASSES {
            solid_edge::press(self.constants, self.touches, rise);
        }
        solid_edge::lift_free_nodes(self.constants.grid.stride(), self.touches);
        self.settle_on(prediction, shear, has_edge)
    }

    /// The same with the forces at the edge as they are.
    fn settle_on(&self, prediction: &Prediction, shear: Real, has_edge: bool) -> Real {
        let shear = if has_edge { shear + solid_edge::total_force(self.touches) } else { shear };
        let touching = Touching { surface: self, shear, position: prediction.position };
        prediction.settle(self.constants, &touching) - prediction.position
    }

    /// By how much the contact raises a face, m, that would rise by `free` without it and without the vertical force `shear`, N; as
    /// in [`crate::contact::rounded_face`].
    fn rise(&self, free: Real, shear: Real) -> Real {
        let constants = self.constants;
        let mass = constants.moved_mass() / constants.symmetry_factor;
        let start = free + shear * (constants.dt * constants.dt) / mass;
        let mut rise = start;
        for _ in 0..PASSES {
            let (mut masses, mut moments) = (0.0, 0.0);
            for touch in self.touches.iter().map(|numbers| Touch::of(*numbers)) {
                let (down, depth) = (-touch.out[1], touch.depth_left());
                if depth > down * rise {
                    masses += touch.mass * down * down;
                    moments += touch.mass * down * (depth - down * start);
                }
            }
            let found = start + moments / (mass + masses);
            if found == rise {
                break;
            }
            rise = found;
        }
        rise
    }

    /// Finds the friction on the nodes under a face that has risen by `rise`, m, and moves at `velocity`, m/s; returns its
    /// upward part on the face, N.
    fn rub(&mut self, rise: Real, velocity: Real) -> Real {
        let (dt, index) = (self.constants.dt, self.indices());
        let coefficient = self.constants.scenario.face.friction_coefficient;
        let mut total = 0.0;
        for (place, numbers) in self.touches.iter_mut().enumerate() {
            let mut touch = Touch::of(*numbers);
            let (out, normal) = touch.pressed(touch.force(rise, dt), dt);
            let limit = coefficient * normal;
            if limit <= 0.0 {
                continue;
            }
            let Some(node) = self.nodes.node(index(place)) else { continue };
            let [x, y, z] = node.next_velocity(dt);
            let stick = across(&[x, y - velocity, z], &out).map(|sliding| -touch.mass * sliding / dt);
            touch.friction = limited_vector(stick, limit);
            total -= touch.friction[1];
            *numbers = touch.numbers();
        }
        total
    }

    /// Adds the forces on the nodes under a face that has risen by `rise`, m, and keeps the normal one in the place of the depth;
    /// returns the upward part of the normal ones on the face, N.
    fn press(&mut self, rise: Real) -> Real {
        let (dt, index) = (self.constants.dt, self.indices());
        let mut total = 0.0;
        for (place, numbers) in self.touches.iter_mut().enumerate() {
            let mut touch = Touch::of(*numbers);
            touch.depth = touch.force(rise, dt);
            let normal = touch.normal_force(dt);
            // A node that the friction of the others has let go keeps its own, of which the face has the reaction.
            if normal != [0.0; 3] || touch.friction != [0.0; 3] {
                let force = core::array::from_fn(|i| normal[i] + touch.friction[i]);
                self.nodes.add_force(index(place), force);
                total -= normal[1];
            }
            *numbers = touch.numbers();
        }
        total
    }

    /// The energy that the normal forces take over their impulse, J, then that of friction, from a face whose mean velocity is
    /// `face`, m/s.
    fn work(&self, face: Real) -> [Real; 2] {
        let (dt, index) = (self.constants.dt, self.indices());
        let mut total = [0.0; 2];
        for (place, touch) in self.touches.iter().map(|numbers| Touch::of(*numbers)).enumerate() {
            let normal = touch.normal_force(dt);
            if normal == [0.0; 3] && touch.friction == [0.0; 3] {
                continue;
            }
            let Some(node) = self.nodes.node(index(place)) else { continue };
            let after = node.next_velocity(dt);
            let mut mean: [Real; 3] = core::array::from_fn(|i| 0.5 * (node.velocity[i] + after[i]));
            mean[1] -= face;
            total[0] -= dt * dot(&mean, &normal);
            total[1] -= dt * dot(&touch.friction, &mean);
        }
        total
    }

    /// Leaves the forces on the nodes downwards, along x and along z, N.
    fn show(&self, [down, along_x, along_z]: [&mut [Real]; 3]) {
        let places = down.iter_mut().zip(along_x.iter_mut()).zip(along_z);
        for (touch, ((down, x), z)) in self.touches.iter().map(|numbers| Touch::of(*numbers)).zip(places) {
            let normal = touch.normal_force(self.constants.dt);
            let [fx, fy, fz]: [Real; 3] = core::array::from_fn(|i| normal[i] + touch.friction[i]);
            (*down, *x, *z) = (-fy, fx, fz);
        }
    }
}
