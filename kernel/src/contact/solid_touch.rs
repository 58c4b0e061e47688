//! What a surface node of a solid has to do with the face in a step.

use crate::model::SOLID_TOUCH_FIELDS;
use crate::number::math;
use crate::number::real::Real;

/// Where a node stands at the end of a step.
pub(super) struct Standing {
    /// Height above the face, m: its depth in it.
    pub above: Real,
    /// By how much a force downwards lowers it, m/N: by nothing while the face holds it.
    pub give: Real,
}

/// A node that touches the face, or may.
#[derive(Clone, Copy)]
pub(super) struct Touch {
    /// kg; 0 in padding.
    pub mass: Real,
    /// Depth in the face at the end of a step without contact, m; once it is known, the normal force, N.
    pub depth: Real,
    /// Direction out of the face.
    pub out: [Real; 3],
    /// Friction along the face, N.
    pub friction: [Real; 3],
    /// Height above the lowest point of the face at the end of a step without contact, m.
    pub height: Real,
    /// Distance beyond the edge of the flat part of the face, m; negative inside.
    pub beyond: Real,
    /// Forces at the edge on the lines to the next node along x and along z, N.
    pub edge: [Real; 2],
    /// By how much these and those of the lines from other nodes lower it in the step, m.
    pub lowered: Real,
}

impl Touch {
    /// Of a node before any force of the step.
    pub fn new(mass: Real, depth: Real, out: [Real; 3], [height, beyond]: [Real; 2]) -> Self {
        Self { mass, depth, out, friction: [0.0; 3], height, beyond, edge: [0.0; 2], lowered: 0.0 }
    }

    pub fn of(numbers: [Real; SOLID_TOUCH_FIELDS]) -> Self {
        let [mass, depth, ox, oy, oz, fx, fy, fz, height, beyond, ex, ez, lowered] = numbers;
        Self { mass, depth, out: [ox, oy, oz], friction: [fx, fy, fz], height, beyond, edge: [ex, ez], lowered }
    }

    /// [`Self::beyond`] alone.
    pub fn beyond_of(&[_, _, _, _, _, _, _, _, _, beyond, ..]: &[Real; SOLID_TOUCH_FIELDS]) -> Real {
        beyond
    }

    pub fn numbers(&self) -> [Real; SOLID_TOUCH_FIELDS] {
        let ([ox, oy, oz], [fx, fy, fz], [ex, ez]) = (self.out, self.friction, self.edge);
        [self.mass, self.depth, ox, oy, oz, fx, fy, fz, self.height, self.beyond, ex, ez, self.lowered]
    }

    /// What the forces at the edge leave of the depth, m.
    pub fn depth_left(&self) -> Real {
        self.depth + self.out[1] * self.lowered
    }

    /// The force that leaves the node on a face that has risen by `rise`, m, at the end of a step of `dt`, s; 0 away from it.
    pub fn force(&self, rise: Real, dt: Real) -> Real {
        math::max(0.0, self.mass * (self.depth_left() + self.out[1] * rise)) / (dt * dt)
    }

    /// Where it stands under a face that has risen by `rise`, m, at the end of a step of `dt`, s.
    pub fn standing(&self, rise: Real, dt: Real) -> Standing {
        let (down, held) = (-self.out[1], math::max(0.0, self.depth_left() + self.out[1] * rise));
        let above = self.height - rise - self.lowered - held * down;
        let yields = if held > 0.0 { 1.0 - down * down } else { 1.0 };
        Standing { above, give: yields * (dt * dt) / self.mass }
    }

    /// Its part of the forces at the edge, downwards, N.
    fn edge_force(&self, dt: Real) -> Real {
        self.mass * self.lowered / (dt * dt)
    }

    /// The normal force `own`, N, with the part of those at the edge: its direction and size, N.
    pub fn pressed(&self, own: Real, dt: Real) -> ([Real; 3], Real) {
        let at_edge = self.edge_force(dt);
        if at_edge == 0.0 {
            return (self.out, own);
        }
        let [x, y, z] = self.out.map(|part| own * part);
        let force = [x, y - at_edge, z];
        let size = math::sqrt(x * x + force[1] * force[1] + z * z);
        (if size > 0.0 { force.map(|part| part / size) } else { self.out }, size)
    }

    /// The normal force and the part of those at the edge, N, once the depth is the normal force.
    pub fn normal_force(&self, dt: Real) -> [Real; 3] {
        let [x, y, z] = self.out.map(|part| self.depth * part);
        [x, y - self.edge_force(dt), z]
    }
}
