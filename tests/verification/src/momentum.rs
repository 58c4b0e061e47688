//! Masses of the nodes, from what the fields show.

use softanvil_kernel::Model;
use softanvil_kernel::mesh::{CORNERS, out_of_plane};

/// Mass of each node, kg, laid out as [`Model::reference_position`]: a quarter of each cell's, whose area the corners span; in
/// plane strain with one thickness for each triangle as the kernel takes it, at its middle.
pub fn masses(model: &Model) -> Vec<f64> {
    let (grid, scenario) = (&model.constants.grid, &model.constants.scenario);
    let [x, y] = model.reference_position();
    let mut masses = vec![0.0; x.len()];
    for (u, v) in (0..grid.n_v).flat_map(|v| (0..grid.n_u).map(move |u| (u, v))) {
        if !grid.has_cell(u, v, 0) {
            continue;
        }
        let nodes = CORNERS.map(|(du, dv)| (grid.node_row(v) + dv) * grid.stride() + u + du);
        let density = scenario.layers[grid.layer_of_row(v)].material.density;
        let volume: f64 = softanvil_kernel::mesh::triangles(grid, u, v)
            .into_iter()
            .map(|corners| {
                let [a, b, c] = corners.map(|corner| [x[nodes[corner]], y[nodes[corner]]]);
                let area = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
                area * out_of_plane(scenario, (a[0] + b[0] + c[0]) / 3.0)
            })
            .sum();
        nodes.iter().for_each(|node| masses[*node] += 0.25 * density * volume);
    }
    masses
}
