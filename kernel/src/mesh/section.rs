//! Where the nodes of a section rest, and how thick it is.

use crate::mesh::Grid;
use crate::number::math;
use crate::number::real::Real;
use crate::number::real::consts::{FRAC_PI_2, PI};
use crate::scenario::{Formulation, Scenario, Shape};

/// Position of node (u, v) at rest, m.
pub fn reference_position(scenario: &Scenario, grid: &Grid, u: usize, v: usize) -> [Real; 2] {
    let geometry = &scenario.geometry;
    let across = (u as Real - grid.centre as Real) / (grid.n_u - grid.centre) as Real;
    let depth = height_over_core(scenario, grid, v);
    match geometry.shape {
        Shape::Round => {
            let radius = geometry.core_radius + depth;
            let angle = FRAC_PI_2 * across;
            [radius * math::sin(angle), radius * math::cos(angle)]
        }
        Shape::Block => [0.5 * geometry.block_width * across, depth],
    }
}

/// Height of row `v` of nodes over the core at rest, m.
fn height_over_core(scenario: &Scenario, grid: &Grid, v: usize) -> Real {
    let mut below = 0.0;
    for (place, layer) in scenario.layers.iter().enumerate() {
        let rows = grid.rows_of(place);
        if v <= rows.end {
            return below + layer.thickness * (v.saturating_sub(rows.start) as Real / rows.len() as Real);
        }
        below += layer.thickness;
    }
    below
}

/// Reference volume per area of section at `x` from the centre line, m: the out-of-plane thickness in plane
/// strain, the circumference when axisymmetric.
pub fn out_of_plane(scenario: &Scenario, x: Real) -> Real {
    let geometry = &scenario.geometry;
    match (geometry.formulation, geometry.shape) {
        (Formulation::Axisymmetric, _) => 2.0 * PI * x,
        (Formulation::PlaneStrain, Shape::Block) => geometry.length,
        (Formulation::PlaneStrain, Shape::Round) => {
            let radius = 0.5 * scenario.impactor.face_diameter;
            let x = x - scenario.impactor.offset;
            let chord = 2.0 * math::sqrt(math::max(0.0, radius * radius - x * x));
            if chord < geometry.length { chord } else { geometry.length }
        }
    }
}
