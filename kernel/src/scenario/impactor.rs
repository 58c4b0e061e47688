//! The drop mass: how it moves, and what its face looks like.

use strum::{FromRepr, VariantNames};

use crate::features::PADS;
use crate::number::math;
use crate::number::real::Real;

/// How the impactor moves.
#[derive(Clone, Copy, Debug, FromRepr, PartialEq, Eq, VariantNames)]
#[strum(serialize_all = "snake_case")]
pub enum Motion {
    /// A free mass that falls.
    Drop,
    /// The position is given from outside at every step.
    Driven,
    /// Down at a speed to a depth, then hold; see [`crate::scenario::prescribed`].
    Prescribed,
}

/// Which of the three numbers states the drop.
#[derive(Clone, Copy, Debug, FromRepr, PartialEq, Eq, VariantNames)]
#[strum(serialize_all = "snake_case")]
pub enum DropBy {
    /// [`Impactor::drop_height`].
    Height,
    /// [`Impactor::drop_energy`].
    Energy,
    /// [`Impactor::drop_speed`].
    Speed,
}

/// What the face of the impactor looks like.
#[derive(Clone, Copy, Debug, FromRepr, PartialEq, Eq, VariantNames)]
#[strum(serialize_all = "snake_case")]
pub enum FaceShape {
    /// A flat disc of [`Impactor::face_diameter`].
    Round,
    /// A flat rectangle of [`Impactor::face_width`] by [`Impactor::face_length`].
    Rectangular,
    /// A ball of [`Impactor::face_diameter`] (axisymmetric).
    Sphere,
    /// A round bar of [`Impactor::face_diameter`] that lies along the anvil, [`Impactor::face_length`] long (plane strain).
    Bar,
}

/// The drop mass: rigid, one vertical degree of freedom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Impactor {
    /// Free, driven or prescribed.
    pub motion: Motion,
    /// Mass, kg.
    pub mass: Real,
    /// What its face looks like.
    pub shape: FaceShape,
    /// Diameter of a round face, a sphere or a bar, m.
    pub face_diameter: Real,
    /// Width of a rectangular face across the section, m.
    pub face_width: Real,
    /// Length of a rectangular face or of a bar along the anvil, m.
    pub face_length: Real,
    /// Distance of the face's centre from the centre line, m, to the right (full section).
    pub offset: Real,
    /// Height of the face above the anvil at the start, m.
    pub gap: Real,
    /// Acceleration of gravity on the impactor, m/s2.
    pub gravity: Real,
    /// Friction of the rails that guide a falling impactor, N: against its motion, and what holds it at rest.
    pub rail_friction: Real,
    /// Force of the rails against the motion of a falling impactor over its speed, N s/m.
    pub rail_damping: Real,
    /// Which of the next three counts.
    pub drop_by: DropBy,
    /// Free fall before the start, m: speed sqrt(2 g h).
    pub drop_height: Real,
    /// Kinetic energy at the start, J.
    pub drop_energy: Real,
    /// Speed at the start, m/s.
    pub drop_speed: Real,
    /// Speed of the prescribed motion, m/s, downwards.
    pub prescribed_speed: Real,
    /// Depth below the undeformed anvil at which it ends, m.
    pub prescribed_depth: Real,
    /// Time over which its speed rises at the start and falls at the end, s.
    pub prescribed_rise: Real,
}

impl Impactor {
    /// Downward speed at the start, m/s, from whichever of height, energy and speed is chosen.
    pub fn start_speed(&self) -> Real {
        match self.drop_by {
            DropBy::Height => math::sqrt(2.0 * self.gravity * self.drop_height),
            DropBy::Energy => math::sqrt(2.0 * self.drop_energy / self.mass),
            DropBy::Speed => self.drop_speed,
        }
    }

    /// Whether rails act on it while it falls.
    pub(crate) fn has_rails(&self) -> bool {
        PADS && (self.rail_friction > 0.0 || self.rail_damping > 0.0)
    }

    /// The same mass dropped with a kinetic energy of `energy` J.
    pub fn with_energy(self, energy: Real) -> Self {
        Self { drop_by: DropBy::Energy, drop_energy: energy, ..self }
    }
}
