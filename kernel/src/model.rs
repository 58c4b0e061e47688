//! [`Model`]: everything about a simulation that does not change, built once in memory that the caller lends.

use crate::cfc::Coefficients;
use crate::digest::Digest;
use crate::element::{CellConstants, HoopConstants, Triangle};
use crate::error::{ModelError, ScenarioError};
use crate::lanes::LANES;
use crate::material::Laws;
use crate::mesh::{Grid, reference_position, triangles};
use crate::parameter::PARAMETERS;
use crate::real::{self, Real};
use crate::scenario::{Formulation, Interface, MAX_LAYERS, Scenario, Section, Shape};
use crate::storage::{MODEL_NODE_FIELDS, ModelMemory, Size, split_row, take};
use crate::time_step;

/// Samples of the force per second: those of the study's load cells.
pub const SAMPLING_RATE: Real = 20e3;
/// Interval between samples of the force, s.
pub const SAMPLING_INTERVAL: Real = 1.0 / SAMPLING_RATE;

/// The scalar constants of a model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constants {
    /// The scenario that the model was built from.
    pub scenario: Scenario,
    /// Counts and strides of the mesh.
    pub grid: Grid,
    /// Sizes of the memory of model and state.
    pub size: Size,
    /// Fixed time step, s.
    pub dt: Real,
    /// Steps in a sampling interval; `dt` times it is [`SAMPLING_INTERVAL`].
    pub steps_per_sample: u32,
    /// Channel filter of the contact force.
    pub channel: Coefficients,
    /// Laws of silicone and skin.
    pub laws: [Laws; MAX_LAYERS],
    /// Forces of the whole anvil per force of the meshed section: 2 in plane strain, which meshes one half.
    pub section_factor: Real,
    /// Height of the undeformed anvil's top above the origin, m.
    pub top_height: Real,
    /// Fingerprint of the scenario, which a snapshot must match.
    pub fingerprint: u64,
}

impl Constants {
    /// Mass of the impactor that belongs to the meshed section, kg.
    pub fn section_mass(&self) -> Real {
        self.scenario.impactor.mass / self.section_factor
    }

    /// Laws of a block of cells.
    pub fn laws_of(&self, block: usize) -> &Laws {
        let [silicone, skin] = &self.laws;
        if block < self.grid.n_block_silicone() { silicone } else { skin }
    }

    /// Entries of viscous history per triangle: those of the layer that has more.
    pub fn n_term(&self) -> usize {
        self.laws.iter().fold(0, |most, laws| most.max(laws.n_term()))
    }

    /// Simulated time after `step_index` steps, s: whole sampling intervals and the steps beyond them.
    pub fn time(&self, step_index: u64) -> Real {
        let per_sample = u64::from(self.steps_per_sample).max(1);
        // Signed, since processors turn only signed integers into floats at once.
        let (samples, steps) = ((step_index / per_sample) as i64, (step_index % per_sample) as i64);
        // A quotient, so that the time of a sample is the double nearest to it.
        samples as Real / SAMPLING_RATE + steps as Real * self.dt
    }

    /// Steps that cover `duration` s, rounded up to whole sampling intervals.
    pub fn steps_in(&self, duration: Real) -> u64 {
        // A duration within one part in 10^9 of a whole number of samples counts as that number.
        let samples = crate::math::ceil(duration / SAMPLING_INTERVAL * (1.0 - real::SAME));
        samples as u64 * u64::from(self.steps_per_sample)
    }
}

/// Constants of every node, one slice per quantity, rows of [`Grid::stride`].
pub(crate) struct ModelNodes<'a> {
    /// Reference x, m.
    pub reference_x: &'a [Real],
    /// Reference height above the origin, m.
    pub reference_y: &'a [Real],
    /// 1/m along x, 1/kg; 0 where fixed.
    pub inverse_mass_x: &'a [Real],
    /// 1/m along y, 1/kg; 0 where fixed.
    pub inverse_mass_y: &'a [Real],
    /// Lumped mass, kg.
    pub nodal_mass: &'a [Real],
}

impl<'a> ModelNodes<'a> {
    /// Cuts `memory` into rows of `n` numbers, one per node; none if it is too short.
    #[inline(always)]
    fn cut(mut memory: &'a [Real], n: usize) -> Option<Self> {
        let mut row = || {
            let (row, rest) = memory.split_at_checked(n)?;
            memory = rest;
            Some(row)
        };
        Some(Self {
            reference_x: row()?,
            reference_y: row()?,
            inverse_mass_x: row()?,
            inverse_mass_y: row()?,
            nodal_mass: row()?,
        })
    }
}

/// The immutable part of a simulation. One model may serve any number of states at once.
pub struct Model<'a> {
    /// Scalar constants.
    pub constants: &'a Constants,
    pub(crate) nodes: ModelNodes<'a>,
    pub(crate) cells: &'a [CellConstants],
    pub(crate) hoops: &'a [HoopConstants],
}

impl<'a> Model<'a> {
    /// Builds the model of `scenario` in `memory`, whose size [`Size::of`] tells.
    ///
    /// # Errors
    /// A refused scenario, a mesh or step out of bounds, or too little memory; see [`ModelError`].
    pub fn new(scenario: &Scenario, memory: ModelMemory<'a>) -> Result<Self, ModelError> {
        let grid = Grid::new(scenario)?;
        Self::with_positions(scenario, &|u, v| reference_position(scenario, &grid, u, v), memory)
    }

    /// Builds a model whose nodes rest at `position(u, v)`, m, instead of on the scenario's shape: distorted or graded
    /// meshes, other domains. The corners of each cell must run counter-clockwise from (u, v).
    ///
    /// # Errors
    /// As [`Model::new`], and a cell without area.
    pub fn with_positions(
        scenario: &Scenario,
        position: &dyn Fn(usize, usize) -> [Real; 2],
        memory: ModelMemory<'a>,
    ) -> Result<Self, ModelError> {
        let size = Size::of(scenario)?;
        let grid = Grid::new(scenario)?;
        let nodes = take(memory.nodes, size.model_nodes, "model nodes")?;
        let cells = take(memory.cells, size.model_cells, "model cells")?;
        let hoops = take(memory.hoops, size.model_hoops, "model hoops")?;
        build_cells(scenario, &grid, position, cells, hoops)?;
        build_nodes(scenario, &grid, position, cells, nodes);
        let steps_per_sample = time_step::steps_per_sample(scenario, &grid, cells, hoops)?;
        let dt = SAMPLING_INTERVAL / steps_per_sample as Real;
        let channel = Coefficients::new(scenario.measurement.channel_class, SAMPLING_INTERVAL);
        let constants = Constants {
            scenario: *scenario,
            grid,
            size,
            dt,
            steps_per_sample,
            channel: channel.map_err(ScenarioError::Parameter)?,
            laws: scenario.layers().map(|layer| Laws::new(layer.material, dt)),
            section_factor: section_factor(scenario),
            top_height: position(grid.centre, grid.n_v)[1],
            fingerprint: fingerprint(scenario),
        };
        Ok(Self::view(memory.constants.insert(constants), nodes, cells, hoops))
    }

    /// A model over memory that [`Model::new`] filled for the same `constants`.
    #[inline(always)]
    pub fn view(
        constants: &'a Constants,
        nodes: &'a [Real],
        cells: &'a [CellConstants],
        hoops: &'a [HoopConstants],
    ) -> Self {
        match ModelNodes::cut(nodes, constants.grid.n_node()) {
            Some(nodes) => Self { constants, nodes, cells, hoops },
            None => Self::without_nodes(constants, cells, hoops),
        }
    }

    /// A model over too little memory, which sizes exclude.
    #[cold]
    #[inline(never)]
    fn without_nodes(constants: &'a Constants, cells: &'a [CellConstants], hoops: &'a [HoopConstants]) -> Self {
        let nodes = ModelNodes {
            reference_x: &[],
            reference_y: &[],
            inverse_mass_x: &[],
            inverse_mass_y: &[],
            nodal_mass: &[],
        };
        Self { constants, nodes, cells, hoops }
    }

    /// Positions of the nodes at rest, m, in rows of [`Grid::stride`] from the core to the surface, the first
    /// `n_u + 1` of each row in use.
    pub fn reference_position(&self) -> [&[Real]; 2] {
        [self.nodes.reference_x, self.nodes.reference_y]
    }

    /// Volume of all triangles of the section, m3.
    pub fn reference_volume(&self) -> Real {
        self.cells
            .iter()
            .flat_map(|cell| &cell.triangle)
            .flat_map(|triangle| &triangle.reference_volume)
            .fold(0.0, |sum, volume| sum + volume)
    }
}

fn fingerprint(scenario: &Scenario) -> u64 {
    let mut digest = Digest::new();
    for parameter in PARAMETERS {
        digest.number(parameter.get(scenario));
    }
    digest.value()
}

/// Forces of the whole anvil per force of what is meshed.
fn section_factor(scenario: &Scenario) -> Real {
    match (scenario.geometry.formulation, scenario.geometry.section) {
        (Formulation::PlaneStrain, Section::Half) => 2.0,
        _ => 1.0,
    }
}

fn build_cells(
    scenario: &Scenario,
    grid: &Grid,
    position: &dyn Fn(usize, usize) -> [Real; 2],
    cells: &mut [CellConstants],
    hoops: &mut [HoopConstants],
) -> Result<(), ModelError> {
    let blocks = grid.blocks_per_row().max(1);
    cells.fill(CellConstants::ZERO);
    hoops.fill(HoopConstants::ZERO);
    for (block, cell) in cells.iter_mut().enumerate() {
        for l in 0..LANES {
            let (u, v) = ((block % blocks) * LANES + l, block / blocks);
            if u >= grid.n_u {
                continue;
            }
            let corners = CORNERS.map(|(du, dv)| position(u + du, v + dv));
            let nodes = triangles(grid, u, v);
            cell.rising[l] = if nodes[0] == RISING { 1.0 } else { 0.0 };
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

/// Offsets (u, v) of a cell's corners.
const CORNERS: [(usize, usize); 4] = [(0, 0), (1, 0), (1, 1), (0, 1)];

fn build_nodes(
    scenario: &Scenario,
    grid: &Grid,
    position: &dyn Fn(usize, usize) -> [Real; 2],
    cells: &[CellConstants],
    mut nodes: &mut [Real],
) {
    nodes.fill(0.0);
    let n = grid.n_node();
    let [x, y, inverse_x, inverse_y, mass]: [&mut [Real]; MODEL_NODE_FIELDS] =
        core::array::from_fn(|_| split_row(&mut nodes, n).unwrap_or_default());
    lump_mass(scenario, grid, cells, mass);
    for v in 0..=grid.n_v {
        for u in 0..=grid.n_u {
            let node = v * grid.stride() + u;
            let fixed = fixed_directions(scenario, u, v);
            let [px, py] = position(u, v);
            put(x, node, px);
            put(y, node, py);
            let inverse_mass = 1.0 / mass.get(node).copied().unwrap_or_default();
            put(inverse_x, node, if fixed[0] { 0.0 } else { inverse_mass });
            put(inverse_y, node, if fixed[1] { 0.0 } else { inverse_mass });
        }
    }
}

/// Sets one number; nothing past the end, which the sizes exclude.
fn put(row: &mut [Real], node: usize, value: Real) {
    if let Some(place) = row.get_mut(node) {
        *place = value;
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
    let [silicone, skin] = scenario.layers().map(|layer| layer.material.density);
    for v in 0..grid.n_v {
        let density = if v < grid.n_v_silicone { silicone } else { skin };
        for u in 0..grid.n_u {
            let Some(cell) = cells.get(v * grid.blocks_per_row() + u / LANES) else { continue };
            let [a, b] = &cell.triangle;
            let quarter = 0.25 * density * (a.reference_volume[u % LANES] + b.reference_volume[u % LANES]);
            for (du, dv) in CORNERS {
                if let Some(mass) = mass.get_mut((v + dv) * grid.stride() + u + du) {
                    *mass += quarter;
                }
            }
        }
    }
}

/// Radius of the curved core surface, m; none for a flat one.
pub(crate) fn core_radius(scenario: &Scenario) -> Option<Real> {
    match scenario.geometry.shape {
        Shape::Round => Some(scenario.geometry.core_radius),
        Shape::Block => None,
    }
}
