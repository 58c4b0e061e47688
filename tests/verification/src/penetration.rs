//! How deep layers are in each other.

use softanvil_kernel::scenario::{MAX_LAYERS, Section};
use softanvil_kernel::{Model, State};

/// How deep the deepest node of any interface between layers is inside the other layer, m, by the whole row of that: a
/// measurement that shares nothing with the search of the contact.
pub fn deepest(model: &Model, state: &State) -> f64 {
    let grid = &model.constants.grid;
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
