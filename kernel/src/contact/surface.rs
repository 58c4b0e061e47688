//! What the surface under the face shows: contact width and pressure profile.

use crate::mesh::out_of_plane;
use crate::model::Model;
use crate::number::real::Real;
use crate::scenario::Formulation;
use crate::state::StateView;

/// Current position of the surface node of `column`, m, of a solid in the plane z = 0; none past the last column.
pub fn surface_position(model: &Model, state: &StateView, column: usize) -> Option<[Real; 2]> {
    let grid = &model.constants.grid;
    if column > grid.n_u {
        return None;
    }
    let node = centre_node(model, column);
    let [x, y] = model.reference_position();
    let [ux, uy] = state.displacement();
    Some([x.get(node)? + ux.get(node)?, y.get(node)? + uy.get(node)?])
}

/// Half of the width over which the face touches the surface, m; 0 without contact.
///
/// The edge of the contact is taken midway between the last node that touches and the next.
pub fn contact_half_width(model: &Model, state: &StateView) -> Real {
    let forces = centre_forces(model, state);
    let touching = |force: &Real| *force > 0.0;
    let Some(last) = forces.iter().rposition(touching) else { return 0.0 };
    let edge = |column: usize, next: Option<usize>| {
        let x = surface_position(model, state, column).map_or(0.0, |p| p[0]);
        next.and_then(|n| surface_position(model, state, n)).map_or(x, |p| 0.5 * (x + p[0]))
    };
    let right = edge(last, Some(last + 1));
    if model.constants.grid.centre == 0 {
        return right;
    }
    let first = forces.iter().position(touching).unwrap_or(last);
    0.5 * (right - edge(first, first.checked_sub(1)))
}

/// The surface node of `column`, of a solid that in the plane z = 0.
fn centre_node(model: &Model, column: usize) -> usize {
    let grid = &model.constants.grid;
    grid.surface_node(column, grid.centre_w)
}

/// Normal forces of the face on the surface nodes, N, by column, of a solid in the plane z = 0.
fn centre_forces<'a>(model: &Model, state: &StateView<'a>) -> &'a [Real] {
    let grid = &model.constants.grid;
    let first = grid.centre_w * grid.stride();
    state.contact_force()[0].get(first..=first + grid.n_u).unwrap_or_default()
}

/// Contact pressure at the surface node of `column`, Pa: its normal force over the current area that belongs to it, from
/// midway to the node before to midway to the node after.
///
/// Of a solid in the plane z = 0, over a quarter of each of the cells about the node.
pub fn contact_pressure(model: &Model, state: &StateView, column: usize) -> Option<Real> {
    if model.constants.grid.is_solid() {
        return solid_contact_pressure(model, state, model.constants.grid.centre_w, column);
    }
    let x = surface_position(model, state, column)?[0];
    let middle = |other: Option<usize>| {
        other.and_then(|c| surface_position(model, state, c)).map_or(x, |position| 0.5 * (x + position[0]))
    };
    let (left, right) = (middle(column.checked_sub(1)), middle(Some(column + 1)));
    let scenario = &model.constants.scenario;
    let area = match scenario.geometry.formulation {
        Formulation::Axisymmetric => crate::number::real::consts::PI * (right * right - left * left),
        _ => out_of_plane(scenario, x) * (right - left),
    };
    let force = *state.contact_force()[0].get(column)?;
    Some(if area > 0.0 { force / area } else { 0.0 })
}

/// Contact pressure at the surface node of `column` in `slice` of a solid, Pa: its normal force over a quarter of each of the cells
/// about it as they are now, in the plane of the face.
pub(crate) fn solid_contact_pressure(model: &Model, state: &StateView, slice: usize, column: usize) -> Option<Real> {
    let grid = &model.constants.grid;
    let [x, _] = model.reference_position();
    let ([ux, _], [uz, ..], z) = (state.displacement(), state.along_z(model), model.reference_z());
    let row = grid.surface_row(column, slice);
    let place = |u: usize, w: usize| {
        let node = grid.node(u, row, w);
        Some([x.get(node)? + ux.get(node)?, z.get(node)? + uz.get(node)?])
    };
    let mut area = 0.0;
    for (u, w) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
        let (Some(u), Some(w)) = ((column + u).checked_sub(1), (slice + w).checked_sub(1)) else { continue };
        // Of the layer of the node, and under no other one.
        if u < grid.n_u && w < grid.n_w && grid.surface_row_of_cell(u, w) == row {
            let [a, b, c, d] = [place(u, w)?, place(u + 1, w)?, place(u + 1, w + 1)?, place(u, w + 1)?];
            // Half the product of the diagonals.
            area += 0.125 * ((c[0] - a[0]) * (d[1] - b[1]) - (c[1] - a[1]) * (d[0] - b[0]));
        }
    }
    let force = *state.contact_force()[0].get(slice * grid.stride() + column)?;
    Some(if area > 0.0 { force / area } else { 0.0 })
}
