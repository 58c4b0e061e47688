//! From a scenario to the arrays of a model: cells, masses, supports.

use crate::cfc::Coefficients;
use crate::element::{CellConstants, HoopConstants, Triangle};
use crate::error::{ModelError, ScenarioError};
use crate::material::MaterialModel;
use crate::mesh::{CORNERS, Grid, triangles};
use crate::model::{Constants, MODEL_NODE_FIELDS, ModelArrays, Size, history_packs, split_row};
use crate::number::digest::Digest;
use crate::number::pack::LANES;
use crate::number::real::Real;
use crate::sampling::SAMPLING_INTERVAL;
use crate::scenario::parameter::Parameter;
use crate::scenario::preset::elastic_silicone;
use crate::scenario::{Formulation, Interface, Outline, Scenario, Section, Symmetry};
use crate::setup::numbers::{Positions, put};
use crate::setup::solid_assembly::build_solid;

/// Fills `arrays` with the model of `scenario` whose nodes rest at `position([u, v, w])`, m, and `place` with its constants, for steps
/// of a sampling interval until [`Constants::set_step`] says otherwise; without a [`fingerprint`]. Apart, so that what it needs leaves the stack.
///
/// # Errors
/// A cell without area, too little memory, or a channel that is refused.
#[inline(never)]
pub(crate) fn assemble<'c>(
    scenario: &Scenario,
    grid: Grid,
    position: Positions,
    arrays: &mut ModelArrays,
    place: &'c mut Option<Constants>,
) -> Result<&'c mut Constants, ModelError> {
    let size = Size::of_grid(scenario, &grid);
    let ModelArrays { nodes, cells, hoops } = arrays.first(&size)?;
    if grid.is_solid() {
        build_solid(scenario, &grid, position, nodes)?;
    } else {
        build_cells(scenario, &grid, position, cells, hoops)?;
        build_nodes(scenario, &grid, position, cells, nodes);
    }
    let channel = Coefficients::new(scenario.measurement.channel_class, SAMPLING_INTERVAL);
    // Of no material in particular until the step is set.
    let none = MaterialModel::new(&elastic_silicone(), SAMPLING_INTERVAL);
    let constants = place.insert(Constants {
        scenario: scenario.clone(),
        grid,
        size,
        dt: SAMPLING_INTERVAL,
        design_stretch: 1.0,
        steps_per_sample: 1,
        channel: channel.map_err(ScenarioError::Parameter)?,
        laws: core::array::from_fn(|_| none.clone()),
        symmetry_factor: symmetry_factor(scenario),
        outline: Outline::of(scenario),
        top_height: position([grid.centre, grid.node_rows() - 1, grid.centre_w])[1],
        solid_history_packs: if grid.is_solid() { history_packs(scenario) } else { 0 },
        fingerprint: 0,
    });
    constants.set_step(SAMPLING_INTERVAL, 1);
    Ok(constants)
}

/// Digest of the parameters and of where the nodes of the filled `nodes` rest, which need not follow from them.
pub(crate) fn fingerprint(scenario: &Scenario, grid: &Grid, nodes: &[Real]) -> u64 {
    let mut digest = Digest::new();
    for parameter in Parameter::of(scenario) {
        digest.number(parameter.get(scenario));
    }
    let n = grid.n_node();
    nodes.iter().take(REFERENCE_FIELDS * n).for_each(|coordinate| digest.number(*coordinate));
    if grid.is_solid() {
        let along_z = nodes.iter().skip(MODEL_NODE_FIELDS * n).take(n);
        along_z.for_each(|coordinate| digest.number(*coordinate));
    }
    digest.value()
}

/// Coordinates at rest come first among the numbers of the nodes: x, then y.
const REFERENCE_FIELDS: usize = 2;

/// Forces of the whole anvil per force of what is meshed.
fn symmetry_factor(scenario: &Scenario) -> Real {
    let geometry = &scenario.geometry;
    if geometry.formulation.is_solid() {
        return match geometry.symmetry {
            Symmetry::Quarter => 4.0,
            Symmetry::Half => 2.0,
            Symmetry::Full => 1.0,
        };
    }
    match (geometry.formulation, geometry.section) {
        (Formulation::PlaneStrain, Section::Half) => 2.0,
        _ => 1.0,
    }
}

fn build_cells(
    scenario: &Scenario,
    grid: &Grid,
    position: Positions,
    cells: &mut [CellConstants],
    hoops: &mut [HoopConstants],
) -> Result<(), ModelError> {
    let blocks = grid.blocks_per_row().max(1);
    cells.fill(CellConstants::ZERO);
    hoops.fill(HoopConstants::ZERO);
    for (block, cell) in cells.iter_mut().enumerate() {
        for l in 0..LANES {
            let (u, v) = ((block % blocks) * LANES + l, block / blocks);
            if !grid.has_cell(u, v, 0) {
                continue;
            }
            let corners = CORNERS.map(|(du, dv)| {
                let [x, y, _] = position([u + du, grid.node_row(v) + dv, 0]);
                [x, y].into()
            });
            let nodes = triangles(grid, u, v);
            cell.diagonal[l] = if nodes[0] == RISING { 1.0 } else { 0.0 };
            let pair = nodes.map(|nodes| Triangle::new(scenario, &corners, nodes));
            let volume = pair[0].volume + pair[1].volume;
            for (t, triangle) in pair.iter().enumerate() {
                if triangle.volume.is_nan() || triangle.volume <= 0.0 {
                    return Err(ModelError::NoArea { element: grid.element_index(block, l, t) });
                }
                triangle.store(l, &mut cell.triangle[t], volume);
                if let Some(hoop) = hoops.get_mut(block) {
                    for a in 0..4 {
                        hoop.weight[t][a][l] = triangle.hoop[a];
                    }
                }
            }
        }
    }
    Ok(())
}

/// Corners of the first triangle of a cell whose diagonal rises.
const RISING: [usize; 3] = [0, 1, 2];

fn build_nodes(scenario: &Scenario, grid: &Grid, position: Positions, cells: &[CellConstants], mut nodes: &mut [Real]) {
    nodes.fill(0.0);
    let n = grid.n_node();
    let [x, y, inverse_x, inverse_y, mass]: [&mut [Real]; MODEL_NODE_FIELDS] =
        core::array::from_fn(|_| split_row(&mut nodes, n).unwrap_or_default());
    lump_mass(scenario, grid, cells, mass);
    for v in 0..grid.node_rows() {
        for u in 0..=grid.n_u {
            let node = v * grid.stride() + u;
            let fixed = fixed_directions(scenario, u, v);
            let [px, py, _] = position([u, v, 0]);
            put(x, node, px);
            put(y, node, py);
            // Beside a layer that is narrower than others there are nodes of no cell, which nothing moves.
            let mass = mass.get(node).copied().unwrap_or_default();
            let inverse_mass = if mass > 0.0 { 1.0 / mass } else { 0.0 };
            put(inverse_x, node, if fixed[0] { 0.0 } else { inverse_mass });
            put(inverse_y, node, if fixed[1] { 0.0 } else { inverse_mass });
        }
    }
}

/// The centre line of a half section moves only along y; a bonded core not at all.
fn fixed_directions(scenario: &Scenario, u: usize, v: usize) -> [bool; 2] {
    let bonded = v == 0 && scenario.core.interface == Interface::Bonded;
    let centre = u == 0 && scenario.geometry.section == Section::Half;
    [centre || bonded, bonded]
}

/// A quarter of each cell's mass to each of its corners, whichever way its diagonal runs: even masses have the lowest
/// highest frequency.
fn lump_mass(scenario: &Scenario, grid: &Grid, cells: &[CellConstants], mass: &mut [Real]) {
    for v in 0..grid.n_v {
        let density = scenario.layers.get(grid.layer_of_row(v)).map_or(0.0, |layer| layer.material.density);
        for u in 0..grid.n_u {
            let Some(cell) = cells.get(v * grid.blocks_per_row() + u / LANES) else { continue };
            let [a, b] = &cell.triangle;
            let quarter = 0.25 * density * (a.reference_volume[u % LANES] + b.reference_volume[u % LANES]);
            for (du, dv) in CORNERS {
                if let Some(mass) = mass.get_mut((grid.node_row(v) + dv) * grid.stride() + u + du) {
                    *mass += quarter;
                }
            }
        }
    }
}
