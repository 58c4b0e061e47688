//! Where the nodes of a section rest, and how thick it is.

use crate::mesh::Grid;
use crate::mesh::columns::half_angle;
use crate::number::math;
use crate::number::real::Real;
use crate::number::real::consts::PI;
use crate::scenario::{FaceShape, Formulation, Scenario, Shape};

/// Position of node (u, v) at rest, m.
pub fn reference_position(scenario: &Scenario, grid: &Grid, u: usize, v: usize) -> [Real; 2] {
    let geometry = &scenario.geometry;
    let across = grid.across(u);
    let depth = height_over_core(scenario, grid, v);
    match geometry.shape {
        Shape::Round => {
            let radius = geometry.core_radius + depth;
            let angle = half_angle(scenario) * across;
            [radius * math::sin(angle), radius * math::cos(angle)]
        }
        Shape::Block => [scenario.half_block_width() * across, depth],
    }
}

/// Height of row `v` of nodes over the core at rest, m.
pub(super) fn height_over_core(scenario: &Scenario, grid: &Grid, v: usize) -> Real {
    let mut below = 0.0;
    for (place, layer) in scenario.layers.iter().enumerate() {
        let rows = grid.rows_of(place);
        let (first, count) = (grid.node_row(rows.start), rows.end.saturating_sub(rows.start));
        below += scenario.gap_below(place);
        if v <= first + count {
            return below + layer.thickness * (v.saturating_sub(first) as Real / count as Real);
        }
        below += layer.thickness;
    }
    below
}

/// Reference volume per area of section at `x` from the centre line, m: the out-of-plane thickness in plane
/// strain, the circumference when axisymmetric.
///
/// In plane strain it is as much of the length of the layers as the face covers: the chord of a round face at `x`, or, if
/// that ends within the section, the length of a rectangle of its area and width; the length of a rectangular face or of a bar.
/// A block under a round face has its whole length.
pub fn out_of_plane(scenario: &Scenario, x: Real) -> Real {
    let (geometry, impactor) = (&scenario.geometry, &scenario.impactor);
    let covered = match (geometry.formulation, impactor.shape, geometry.shape) {
        (Formulation::Axisymmetric, ..) => return 2.0 * PI * x,
        // A solid has its volume of its own.
        (formulation, ..) if formulation.is_solid() => return 1.0,
        (_, FaceShape::Rectangular | FaceShape::Bar, _) => impactor.face_length,
        (_, FaceShape::Round | FaceShape::Sphere, Shape::Block) => geometry.length,
        (_, FaceShape::Round | FaceShape::Sphere, Shape::Round) if scenario.face_covers() => {
            let (radius, x) = (0.5 * impactor.face_diameter, x - impactor.offset);
            2.0 * math::sqrt(math::max(0.0, radius * radius - x * x))
        }
        (_, FaceShape::Round | FaceShape::Sphere, Shape::Round) => 0.25 * PI * impactor.face_diameter,
    };
    if covered < geometry.length { covered } else { geometry.length }
}
