//! The face of the impactor as the section sees it.

use crate::features::PADS;
use crate::number::math;
use crate::number::real::Real;
use crate::number::real::consts::PI;
use crate::scenario::{Body, FaceShape, Formulation, Scenario, Shape};

/// The outline of the face in the section: flat over some width about the impactor's axis, and rounded on both sides of it.
///
/// A face that covers the anvil has no rounding: its edges touch nothing. A flat one that is narrower ends in edges of
/// [`EDGE_RADIUS`], because under a sharp edge the pressure has no bound, and a node that passes one would be released at once.
///
/// ```
/// use softanvil_kernel::preset;
/// use softanvil_kernel::scenario::{FaceShape, Formulation, Outline};
///
/// let mut scenario = preset::study();
/// assert_eq!(Outline::of(&scenario), Outline { flat: 65e-3, radius: 0.0 });
/// scenario.impactor.face_diameter = 50e-3;
/// assert_eq!(Outline::of(&scenario), Outline { flat: 24e-3, radius: 1e-3 });
/// scenario.geometry.formulation = Formulation::Axisymmetric;
/// scenario.impactor.shape = FaceShape::Sphere;
/// let ball = Outline::of(&scenario);
/// assert_eq!(ball, Outline { flat: 0.0, radius: 25e-3 });
/// assert!((ball.height(15e-3) - 5e-3).abs() < 1e-12);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outline {
    /// Half of the width of the flat part, m.
    pub flat: Real,
    /// Radius of the rounding beside it, m; 0 where there is none.
    pub radius: Real,
}

/// Radius of the edges of a flat face that is narrower than the anvil, m.
pub const EDGE_RADIUS: Real = 1e-3;

/// Largest radius of an edge, as a part of half the face's width.
const LARGEST_EDGE: Real = 0.1;

/// A face covers the anvil if it reaches past its side by this factor.
const FACE_MARGIN: Real = 1.02;

impl Outline {
    /// That of the face of a legal `scenario`.
    pub fn of(scenario: &Scenario) -> Self {
        let half = scenario.face_half_width();
        if !PADS && !scenario.geometry.formulation.is_solid() {
            return Self { flat: half, radius: 0.0 };
        }
        match scenario.impactor.shape {
            FaceShape::Sphere | FaceShape::Bar => Self { flat: 0.0, radius: half },
            FaceShape::Round | FaceShape::Rectangular if scenario.face_covers() => Self { flat: half, radius: 0.0 },
            FaceShape::Round | FaceShape::Rectangular => {
                let largest = LARGEST_EDGE * half;
                let radius = if EDGE_RADIUS < largest { EDGE_RADIUS } else { largest };
                Self { flat: half - radius, radius }
            }
        }
    }

    /// Half of the width of the face, m.
    pub fn half_width(&self) -> Real {
        self.flat + self.radius
    }

    /// Height of the face above its lowest point at `x` from the impactor's axis, m; beside it, that of its side.
    pub fn height(&self, x: Real) -> Real {
        let beyond = math::max(0.0, math::abs(x) - self.flat);
        self.radius - math::sqrt(math::max(0.0, self.radius * self.radius - beyond * beyond))
    }
}

impl Scenario {
    /// Half of the width of the impactor in the section, m. A rectangular face counts as a disc of its area over a dome.
    pub fn face_half_width(&self) -> Real {
        let impactor = &self.impactor;
        match (impactor.shape, self.geometry.formulation) {
            (FaceShape::Rectangular, Formulation::Axisymmetric) => {
                math::sqrt(impactor.face_width * impactor.face_length / PI)
            }
            (FaceShape::Rectangular, _) => 0.5 * impactor.face_width,
            (FaceShape::Round | FaceShape::Sphere | FaceShape::Bar, _) => 0.5 * impactor.face_diameter,
        }
    }

    /// Whether a flat face reaches past the sides of the anvil.
    pub fn face_covers(&self) -> bool {
        let side = match self.geometry.shape {
            Shape::Round => self.geometry.core_radius + self.height(),
            Shape::Block => 0.5 * self.geometry.block_width,
        };
        let (across, offset) = (self.face_half_width(), math::abs(self.impactor.offset));
        across >= FACE_MARGIN * side + offset && self.face_covers_length(side + offset)
    }

    /// Whether a flat face that reaches past the sides of a solid, `side` m beside its centre, reaches past its ends as well.
    fn face_covers_length(&self, side: Real) -> bool {
        let (geometry, impactor) = (&self.geometry, &self.impactor);
        if !geometry.formulation.is_solid() {
            return true;
        }
        let end = match geometry.body {
            Body::Prism => 0.5 * geometry.length,
            Body::Revolved => side,
        };
        match impactor.shape {
            FaceShape::Rectangular => 0.5 * impactor.face_length >= FACE_MARGIN * end,
            _ => {
                let (radius, corner) = (0.5 * impactor.face_diameter, math::sqrt(side * side + end * end));
                radius >= FACE_MARGIN * if geometry.body == Body::Prism { corner } else { side }
            }
        }
    }

    /// Half of the length of the flat part of a rectangular face or of a bar along z, m.
    pub(crate) fn face_flat_length(&self, outline: &Outline) -> Real {
        let half = 0.5 * self.impactor.face_length;
        if self.impactor.shape == FaceShape::Bar { half } else { half - outline.radius }
    }
}
