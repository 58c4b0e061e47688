//! How the nodes of a solid are spread along z.

use crate::mesh::columns::cells_along;
use crate::number::math;
use crate::number::real::Real;
use crate::scenario::{Body, FaceShape, Outline, Scenario, Symmetry};

/// Slices of cells on one side of z = 0. In a section there are none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slices {
    /// All of them.
    pub half: usize,
    /// Those of a prism that lie under the face, to whose last nodes is the distance `face_z`.
    pub face: usize,
    /// Distance of these nodes from z = 0, m.
    pub face_z: Real,
    /// Distance of the last nodes, m.
    pub end_z: Real,
}

impl Slices {
    /// Of a section.
    pub const NONE: Self = Self { half: 0, face: 0, face_z: 0.0, end_z: 0.0 };

    /// Those of a legal solid whose half section has so many `columns`.
    pub(super) fn of(scenario: &Scenario, columns: usize) -> Self {
        if scenario.geometry.body == Body::Revolved {
            return Self { half: columns, ..Self::NONE };
        }
        let (size, end_z) = (scenario.mesh.element_size, 0.5 * scenario.geometry.length);
        let outline = Outline::of(scenario);
        let flat = match scenario.impactor.shape {
            _ if outline.radius == 0.0 => end_z,
            FaceShape::Rectangular | FaceShape::Bar => scenario.face_flat_length(&outline),
            FaceShape::Round => outline.flat,
            FaceShape::Sphere => 0.0,
        };
        // A node bears what lies halfway to its neighbours, so the last one under the face is half a cell inside its edge.
        let face_z = flat - 0.5 * size;
        if face_z < size || flat >= end_z || end_z - face_z < 0.5 * size {
            let half = cells_along(end_z, size) as usize;
            return Self { half, face: half, face_z: end_z, end_z };
        }
        let (face, rest) = (cells_along(face_z, size), cells_along(end_z - face_z, size));
        Self { half: (face + rest) as usize, face: face as usize, face_z, end_z }
    }

    /// Distance of the `number`-th nodes of a prism from z = 0, m.
    pub fn z(&self, number: usize) -> Real {
        if number <= self.face {
            return self.face_z * (number as Real / self.face.max(1) as Real);
        }
        let rest = (self.half - self.face).max(1) as Real;
        self.face_z + (self.end_z - self.face_z) * ((number - self.face) as Real / rest)
    }
}

/// Slices of cells in a mesh of this symmetry with so many on one side, and the slice of the nodes on the plane z = 0.
pub(super) fn meshed(symmetry: Symmetry, half: usize) -> [usize; 2] {
    match symmetry {
        Symmetry::Quarter | Symmetry::Half => [half, 0],
        Symmetry::Full => [2 * half, half],
    }
}

/// Direction in the plane of section and slices, and distance from the centre line as a part of that to the side, of the point
/// (`across`, `along`) of the square from -1 to 1: squares about the centre become circles, evenly spaced on each of them.
pub(super) fn on_disc(across: Real, along: Real) -> [Real; 3] {
    let (x, z) = (math::abs(across), math::abs(along));
    let radius = math::max(x, z);
    if radius == 0.0 {
        return [1.0, 0.0, 0.0];
    }
    let eighth = 0.25 * crate::number::real::consts::PI;
    let (cos, sin) = if x >= z {
        let angle = eighth * (z / x);
        (math::cos(angle), math::sin(angle))
    } else {
        let angle = eighth * (x / z);
        (math::sin(angle), math::cos(angle))
    };
    [if across < 0.0 { -cos } else { cos }, if along < 0.0 { -sin } else { sin }, radius]
}
