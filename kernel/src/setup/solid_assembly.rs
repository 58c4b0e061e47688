//! From a scenario to the arrays of a solid: tetrahedra, masses, supports.

use nalgebra::Vector3;

use crate::element::{SOLID_BLOCK_PACKS, SolidConstants, store_cell};
use crate::error::ModelError;
use crate::mesh::{Grid, cell_nodes};
use crate::model::{MODEL_NODE_FIELDS, split_row};
use crate::number::pack::{LANES, ZERO};
use crate::number::real::Real;
use crate::scenario::{Body, Ends, Interface, Scenario, Symmetry};
use crate::setup::numbers::{Positions, put};

/// Fills the numbers of the nodes of a model, those of the tetrahedra among them.
///
/// # Errors
/// A tetrahedron without volume.
pub(super) fn build_solid(
    scenario: &Scenario,
    grid: &Grid,
    position: Positions,
    mut numbers: &mut [Real],
) -> Result<(), ModelError> {
    let n = grid.n_node();
    numbers.fill(0.0);
    let [x, y, inverse_x, inverse_y, mass]: [&mut [Real]; MODEL_NODE_FIELDS] =
        core::array::from_fn(|_| split_row(&mut numbers, n).unwrap_or_default());
    let [z, inverse_z] = [(); 2].map(|()| split_row(&mut numbers, n).unwrap_or_default());
    let blocks: &mut [SolidConstants] = numbers.as_chunks_mut::<LANES>().0.as_chunks_mut().0;
    build_tetrahedra(scenario, grid, position, blocks, mass)?;
    for v in 0..grid.node_rows() {
        for w in 0..grid.node_slices() {
            for u in 0..=grid.n_u {
                let node = grid.node(u, v, w);
                let [px, py, pz] = position([u, v, w]);
                let fixed = fixed_directions(scenario, grid, [u, v, w]);
                let mass = mass.get(node).copied().unwrap_or_default();
                for (row, place) in [&mut *x, &mut *y, &mut *z].into_iter().zip([px, py, pz]) {
                    put(row, node, place);
                }
                for (row, fixed) in [&mut *inverse_x, &mut *inverse_y, &mut *inverse_z].into_iter().zip(fixed) {
                    put(row, node, if fixed || mass <= 0.0 { 0.0 } else { 1.0 / mass });
                }
            }
        }
    }
    Ok(())
}

/// Fills the constants of the tetrahedra, and gives an eighth of each cell's mass to each of its corners.
fn build_tetrahedra(
    scenario: &Scenario,
    grid: &Grid,
    position: Positions,
    blocks: &mut [SolidConstants],
    mass: &mut [Real],
) -> Result<(), ModelError> {
    for (index, block) in blocks.iter_mut().enumerate() {
        *block = [ZERO; SOLID_BLOCK_PACKS];
        let ([v, w], place) = grid.solid_place(index);
        let density = scenario.layers.get(grid.layer_of_row(v)).map_or(0.0, |layer| layer.material.density);
        for l in 0..LANES {
            let u = place * LANES + l;
            if !grid.has_cell(u, v, w) {
                continue;
            }
            let nodes = cell_nodes(grid, [u, v, w]);
            let corners = nodes.map(|node| Vector3::from(position(node)));
            // Paths go down the rows, which turns them left-handed, and each mirroring turns them over.
            let handed = if (u < grid.centre) == (w < grid.centre_w) { -1.0 } else { 1.0 };
            let volume = store_cell(&corners, handed, l, block)
                .map_err(|t| ModelError::NoVolume { element: grid.element_index(index, l, t) })?;
            for [u, v, w] in nodes {
                if let Some(mass) = mass.get_mut(grid.node(u, v, w)) {
                    *mass += 0.125 * density * volume;
                }
            }
        }
    }
    Ok(())
}

/// Planes of symmetry are not left, held ends do not move along z, a bonded core does not move at all.
fn fixed_directions(scenario: &Scenario, grid: &Grid, [u, v, w]: [usize; 3]) -> [bool; 3] {
    let geometry = &scenario.geometry;
    let bonded = v == 0 && scenario.core.interface == Interface::Bonded;
    let is_prism = geometry.body == Body::Prism;
    let end = w == grid.n_w || (w == 0 && geometry.symmetry == Symmetry::Full);
    let held = is_prism && geometry.ends == Ends::Held && end;
    let across = u == 0 && geometry.symmetry == Symmetry::Quarter;
    let along = w == 0 && geometry.symmetry != Symmetry::Full;
    [bonded || across, bonded, bonded || along || held]
}
