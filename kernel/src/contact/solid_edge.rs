//! Contact with the face on a solid between its nodes, where the face has its edge.
//!
//! The edge of the flat part of a face crosses lines of the mesh, from a node under it to one beyond. Nodes alone would bear a whole
//! cell or nothing, and the force would fall by that of a cell each time one slides from under the face. So contact is
//! integrated over the part of such a line that lies under the face, by one point in its middle: a force on its two nodes that leaves this
//! point on the face at the end of the step, or none. The point comes from the node under the face and moves along the line with the edge, so
//! that the force changes smoothly.

use crate::contact::solid_touch::Touch;
use crate::model::{Constants, SOLID_TOUCH_FIELDS};
use crate::number::math;
use crate::number::real::Real;

/// Passes over the lines (projected Gauss-Seidel). Each has nodes of its own but for those in the corners of a mesh across a round
/// edge, so that few are left to settle.
pub(super) const PASSES: usize = 3;

/// Sum of the forces at the edge, upwards on the face, N.
pub(super) fn total_force(touches: &[[Real; SOLID_TOUCH_FIELDS]]) -> Real {
    touches.iter().map(|numbers| Touch::of(*numbers).edge).map(|[x, z]| x + z).sum()
}

/// Finds the forces at the edge, one line after another, under a face that has risen by `rise`, m.
pub(super) fn press(constants: &Constants, touches: &mut [[Real; SOLID_TOUCH_FIELDS]], rise: Real) {
    let (grid, dt) = (&constants.grid, constants.dt);
    let (columns, slices, stride) = (grid.n_u, grid.n_w, grid.stride());
    let even = grid.has_even_surface();
    for slice in 0..=slices {
        for column in 0..=columns {
            let place = slice * stride + column;
            let next = [(column < columns, [column + 1, slice]), (slice < slices, [column, slice + 1])];
            for (along, (there, [u, w])) in next.into_iter().enumerate() {
                // No line of the surface goes from one layer to another.
                if there && (even || grid.surface_row(column, slice) == grid.surface_row(u, w)) {
                    press_line(touches, [place, w * stride + u], along, rise, dt);
                }
            }
        }
    }
}

/// Lifts the nodes again whose lines bear nothing any more: rounding has left something of forces that came and went.
pub(super) fn lift_free_nodes(stride: usize, touches: &mut [[Real; SOLID_TOUCH_FIELDS]]) {
    for place in 0..touches.len() {
        let edge = |place: Option<usize>| {
            place.and_then(|place| touches.get(place)).map_or([0.0; 2], |of| Touch::of(*of).edge)
        };
        let ([own_x, own_z], [before_x, _], [_, before_z]) =
            (edge(Some(place)), edge(place.checked_sub(1)), edge(place.checked_sub(stride)));
        let Some(numbers) = touches.get_mut(place).filter(|_| [own_x, own_z, before_x, before_z] == [0.0; 4]) else {
            continue;
        };
        *numbers = Touch { lowered: 0.0, ..Touch::of(*numbers) }.numbers();
    }
}

/// The same on the line between the nodes of two places, the second being the next one `along` x (0) or z (1).
fn press_line(touches: &mut [[Real; SOLID_TOUCH_FIELDS]], places: [usize; 2], along: usize, rise: Real, dt: Real) {
    let [Some(first), Some(second)] = places.map(|place| touches.get(place)) else { return };
    let Some(parts) = parts_of_point(Touch::beyond_of(first), Touch::beyond_of(second)) else { return };
    let mut ends = [Touch::of(*first), Touch::of(*second)];
    // Where a layer has no cell, a node has no mass.
    if ends.iter().any(|end| end.mass <= 0.0) {
        return;
    }
    // The second time for a node that the first has taken off the face.
    for _ in 0..2 {
        let [one, other] = ends.map(|end| end.standing(rise, dt));
        let above = parts[0] * one.above + parts[1] * other.above;
        let give = parts[0] * parts[0] * one.give + parts[1] * parts[1] * other.give;
        if give <= 0.0 {
            break;
        }
        let before = ends[0].edge[along];
        let force = math::max(0.0, before + above / give);
        ends[0].edge[along] = force;
        for (end, part) in ends.iter_mut().zip(parts) {
            end.lowered += part * (force - before) * (dt * dt) / end.mass;
        }
    }
    for (place, end) in places.into_iter().zip(ends) {
        if let Some(numbers) = touches.get_mut(place) {
            *numbers = end.numbers();
        }
    }
}

/// What the point in the middle of the covered part of a line has of each of its ends, which lie so far beyond the edge, m; none if the
/// edge does not cross the line.
fn parts_of_point(first: Real, second: Real) -> Option<[Real; 2]> {
    let half_covered = |inner: Real, outer: Real| 0.5 * (inner / (inner - outer));
    match [first > 0.0, second > 0.0] {
        [false, true] => {
            let part = half_covered(first, second);
            Some([1.0 - part, part])
        }
        [true, false] => {
            let part = half_covered(second, first);
            Some([part, 1.0 - part])
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_node_whose_line_bears_nothing_any_more_is_where_it_was() {
        let dt: Real = 1e-6;
        let mut left_over = 0;
        for i in 1..50 {
            let (part, mass) = (i as Real / 50.0, 1e-5 * math::sqrt(i as Real));
            let inside = Touch::new(mass, 0.0, [0.0, -1.0, 0.0], [1e-5, -1e-3 * part]);
            let outside = Touch::new(0.7 * mass, 0.0, [0.0, -1.0, 0.0], [2e-5, 1e-3 * (1.0 - part)]);
            let mut touches = [inside.numbers(), outside.numbers()];
            for rise in [-1e-5, -7e-6, 3e-6, 1.0] {
                press_line(&mut touches, [0, 1], 0, rise, dt);
            }
            assert_eq!(Touch::of(touches[0]).edge, [0.0; 2]);
            left_over += touches.iter().filter(|numbers| Touch::of(**numbers).lowered != 0.0).count();
            lift_free_nodes(2, &mut touches);
            assert!(touches.iter().all(|numbers| Touch::of(*numbers).lowered == 0.0));
        }
        assert!(left_over > 0, "nothing was left to lift");
    }
}
