//! How deep layers are in each other.

use std::ops::Range;

use nalgebra::{Vector2, Vector3};
use softanvil_kernel::scenario::{MAX_LAYERS, Section, Symmetry};
use softanvil_kernel::{Model, State};

/// How deep the deepest node of any interface between layers is inside the other layer, m, by the whole row of that: a
/// measurement that shares nothing with the search of the contact.
pub fn deepest(model: &Model, state: &State) -> f64 {
    let grid = &model.constants.grid;
    if grid.is_solid() {
        return deepest_in_solid(model, state);
    }
    let (rest, moved) = (model.reference_position(), state.displacement());
    let point =
        |row: usize, u: usize| [0, 1].map(|i| rest[i][row * grid.stride() + u] + moved[i][row * grid.stride() + u]);
    let mirrored = model.constants.scenario.geometry.section == Section::Half;
    let mut deepest = 0.0_f64;
    for layer in 1..MAX_LAYERS {
        let Some([below, above]) = grid.interface_rows(layer) else { continue };
        let (of_below, of_above) = (grid.columns_of(layer - 1), grid.columns_of(layer));
        for (nodes, of_nodes, segments, of_segments, upwards) in
            [(above, &of_above, below, &of_below, 1.0), (below, &of_below, above, &of_above, -1.0)]
        {
            let line: Vec<[f64; 2]> = (of_segments.start..=of_segments.end).map(|u| point(segments, u)).collect();
            let own = of_nodes.start..=of_nodes.end;
            deepest = own.map(|u| depth(point(nodes, u), &line, upwards, mirrored)).fold(deepest, f64::max);
        }
    }
    deepest
}

/// Depth of `point` inside the side of `line` away from `upwards`: its distance from the nearest segment, 0 on the other side
/// or past an end.
fn depth(point: [f64; 2], line: &[[f64; 2]], upwards: f64, mirrored: bool) -> f64 {
    let mut nearest = (f64::INFINITY, 0.0);
    for (index, ends) in line.windows(2).enumerate() {
        let along = [ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]];
        let from = [point[0] - ends[0][0], point[1] - ends[0][1]];
        let squared = along[0] * along[0] + along[1] * along[1];
        let part = (from[0] * along[0] + from[1] * along[1]) / squared;
        let past = (part < 0.0 && index == 0 && !mirrored) || (part > 1.0 && index + 2 == line.len());
        let held = part.clamp(0.0, 1.0);
        let away = [from[0] - held * along[0], from[1] - held * along[1]];
        let distance = away[0].hypot(away[1]);
        let side = upwards * (along[0] * from[1] - along[1] * from[0]);
        if distance < nearest.0 {
            nearest = (distance, if side < 0.0 && !past { distance } else { 0.0 });
        }
    }
    nearest.1
}

/// The same in a solid, by triangles over the whole of the other surface.
fn deepest_in_solid(model: &Model, state: &State) -> f64 {
    let grid = &model.constants.grid;
    let positions = positions(model, state);
    let symmetry = model.constants.scenario.geometry.symmetry;
    let mirrored = [symmetry == Symmetry::Quarter, symmetry != Symmetry::Full];
    let mut deepest = 0.0_f64;
    for layer in 1..MAX_LAYERS {
        let Some([below, above]) = grid.interface_rows(layer) else { continue };
        let cells = |layer| [grid.columns_of(layer), grid.slices_of(layer)];
        let surface = |row, layer, upwards| {
            let at = |u, w| positions[grid.node(u, row, w)];
            Surface { triangles: triangles(&cells(layer), at, upwards), cells: cells(layer), mirrored }
        };
        for (nodes, own, surface) in
            [(above, layer, surface(below, layer - 1, 1.0)), (below, layer - 1, surface(above, layer, -1.0))]
        {
            let [columns, slices] = cells(own);
            for w in slices.start..=slices.end {
                for u in columns.start..=columns.end {
                    deepest = deepest.max(surface.depth(positions[grid.node(u, nodes, w)]));
                }
            }
        }
    }
    deepest
}

/// Current positions of all nodes of a solid, m.
fn positions(model: &Model, state: &State) -> Vec<Vector3<f64>> {
    let ([x, y], z) = (model.reference_position(), model.reference_z());
    let ([ux, uy], [uz, ..]) = (state.displacement(), state.as_view().along_z(model));
    (0..x.len()).map(|node| Vector3::new(x[node] + ux[node], y[node] + uy[node], z[node] + uz[node])).collect()
}

/// A corner: where it is, m, and its column and slice.
type Corner = (Vector3<f64>, Vector2<f64>);

/// Parts of a side of a cell: by fewer than four, twisted cells alone would be off by a hundredth of their size.
const PARTS: usize = 4;

/// A part of a surface.
struct Triangle {
    corners: [Corner; 3],
    normal: Vector3<f64>,
    /// How far a point of it is at most from its first corner, m.
    size: f64,
}

/// Two triangles for each part of a cell in these columns and slices, with the normal that points `upwards` (1) or downwards (-1).
fn triangles(
    [columns, slices]: &[Range<usize>; 2],
    at: impl Fn(usize, usize) -> Vector3<f64>,
    upwards: f64,
) -> Vec<Triangle> {
    // Between the nodes the surface is bilinear.
    let corner = |u: usize, w: usize| {
        let part = |number: usize| (number % PARTS) as f64 / PARTS as f64;
        let along = |w: usize| at(u / PARTS, w).lerp(&at(u.div_ceil(PARTS), w), part(u));
        let place = along(w / PARTS).lerp(&along(w.div_ceil(PARTS)), part(w));
        (place, Vector2::new(u as f64, w as f64) / PARTS as f64)
    };
    let [columns, slices] = [columns, slices].map(|cells| PARTS * cells.start..PARTS * cells.end);
    let mut triangles = Vec::new();
    for (u, w) in slices.flat_map(|w| columns.clone().map(move |u| (u, w))) {
        let [a, b, c, d] = [corner(u, w), corner(u + 1, w), corner(u, w + 1), corner(u + 1, w + 1)];
        for corners in [[a, b, d], [a, d, c]] {
            let [first, second] = [1, 2].map(|corner| corners[corner].0 - corners[0].0);
            let normal = second.cross(&first).normalize() * upwards;
            triangles.push(Triangle { corners, normal, size: first.norm().max(second.norm()) });
        }
    }
    triangles
}

/// One side of an interface of a solid.
struct Surface {
    triangles: Vec<Triangle>,
    cells: [Range<usize>; 2],
    mirrored: [bool; 2],
}

impl Surface {
    /// As [`depth`], of a point and the nearest triangle.
    fn depth(&self, point: Vector3<f64>) -> f64 {
        let squares = self.triangles.iter().map(|triangle| (point - triangle.corners[0].0).norm_squared());
        // The nearest place is no farther away than the nearest corner, but for round-off.
        let mut nearest = (squares.fold(f64::MAX, f64::min).sqrt() * (1.0 + 1e-12) + f64::MIN_POSITIVE, 0.0);
        for Triangle { corners, normal, size } in &self.triangles {
            let ([a, b, c], from) = (corners.map(|(place, _)| place), point - corners[0].0);
            if from.norm_squared() > (nearest.0 + size) * (nearest.0 + size) {
                continue;
            }
            let height = from.dot(normal);
            let parts = parts_in(&[a, b, c], &(point - height * normal));
            let distance = if parts.iter().all(|part| *part >= 0.0) {
                height.abs()
            } else {
                [[a, b], [b, c], [c, a]].map(|ends| to_segment(&point, ends)).into_iter().fold(f64::MAX, f64::min)
            };
            if distance < nearest.0 {
                let place: Vector2<f64> = corners.iter().zip(parts).map(|((_, place), part)| place * part).sum();
                nearest = (distance, if height < 0.0 && !self.is_past(place) { distance } else { 0.0 });
            }
        }
        nearest.1
    }

    /// Whether a column and slice lie beyond an end that is none by symmetry.
    fn is_past(&self, place: Vector2<f64>) -> bool {
        (0..2).any(|i| {
            place[i] > self.cells[i].end as f64 || (place[i] < self.cells[i].start as f64 && !self.mirrored[i])
        })
    }
}

/// How much of each corner a point in the plane of a triangle is; negative beyond the side opposite to it.
fn parts_in([a, b, c]: &[Vector3<f64>; 3], point: &Vector3<f64>) -> [f64; 3] {
    let normal = (b - a).cross(&(c - a));
    let part = |one: &Vector3<f64>, next: &Vector3<f64>| {
        (next - one).cross(&(point - one)).dot(&normal) / normal.norm_squared()
    };
    [part(b, c), part(c, a), part(a, b)]
}

fn to_segment(point: &Vector3<f64>, [a, b]: [Vector3<f64>; 2]) -> f64 {
    let part = ((point - a).dot(&(b - a)) / (b - a).norm_squared()).clamp(0.0, 1.0);
    (point - a - part * (b - a)).norm()
}
