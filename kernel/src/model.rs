//! [`Model`]: everything about a simulation that does not change, built once in memory that the caller lends.

use crate::cfc::Coefficients;
use crate::element::{CellConstants, HoopConstants};
use crate::material::Laws;
use crate::math;
use crate::mesh::Grid;
use crate::real::{self, Real};
use crate::sampling::SAMPLING_RATE;
use crate::scenario::{MAX_LAYERS, Scenario, Shape};
use crate::storage::Size;

/// The scalar constants of a model.
///
/// ```
/// use softanvil_kernel::{Simulation, preset};
///
/// let anvil = Simulation::new(&preset::study())?;
/// let constants = anvil.constants();
/// // A millisecond has twenty sampling intervals of 50 us, each a whole number of steps.
/// let steps = constants.steps_in(1e-3);
/// assert_eq!(steps, 20 * u64::from(constants.steps_per_sample));
/// assert_eq!(constants.time(steps), 1e-3);
/// assert!((steps as f64 * constants.dt - 1e-3).abs() < 1e-15);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
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
    /// Smallest principal stretch in the section that the step was chosen for; 1 where the step was given.
    pub design_stretch: Real,
    /// Steps in a sampling interval; `dt` times it is [`crate::SAMPLING_INTERVAL`].
    pub steps_per_sample: u32,
    /// Channel filter of the contact force.
    pub channel: Coefficients,
    /// Laws of silicone and skin.
    pub laws: [Laws; MAX_LAYERS],
    /// Forces of the whole anvil per force of the meshed section: 2 in plane strain, which meshes one half.
    pub section_factor: Real,
    /// Height of the undeformed anvil's top above the origin, m.
    pub top_height: Real,
    /// Fingerprint of the scenario and of the positions of the nodes at rest, which a snapshot must match.
    pub fingerprint: u64,
}

impl Constants {
    /// Goes over to steps of `dt` s, `steps_per_sample` of them in a sampling interval.
    pub(crate) fn set_step(&mut self, dt: Real, steps_per_sample: u32) {
        (self.dt, self.steps_per_sample) = (dt, steps_per_sample);
        for (laws, layer) in self.laws.iter_mut().zip(self.scenario.layers()) {
            *laws = Laws::new(layer.material, dt);
        }
    }

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
        // The rate is a whole number, the interval is rounded.
        let samples = duration * SAMPLING_RATE;
        let nearest = math::round(samples);
        // A duration within rounding of a whole number of samples counts as that number.
        let is_whole = math::abs(samples - nearest) <= real::SAME_DURATION * samples;
        let samples = if is_whole { nearest } else { math::ceil(samples) };
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
///
/// ```
/// use softanvil_kernel::element::{CellConstants, CellHistory, HoopConstants};
/// use softanvil_kernel::lanes::Deviator;
/// use softanvil_kernel::{Model, ModelMemory, Scalars, Size, State, StateMemory, StepInput, preset, steps};
///
/// let scenario = preset::study();
/// let size = Size::of(&scenario)?;
/// let (mut constants, mut nodes) = (None, vec![0.0; size.model_nodes]);
/// let mut cells = vec![CellConstants::ZERO; size.model_cells];
/// let mut hoops = vec![HoopConstants::ZERO; size.model_hoops];
/// let of_model = ModelMemory { constants: &mut constants, nodes: &mut nodes, cells: &mut cells, hoops: &mut hoops };
/// let (mut scalars, mut nodes) = (Scalars::BLANK, vec![0.0; size.state_nodes]);
/// let mut cells = vec![CellHistory::REST; size.state_cells];
/// let mut viscous = vec![Deviator::ZERO; size.state_viscous];
/// let mut of_state = StateMemory { scalars: &mut scalars, nodes: &mut nodes, cells: &mut cells, viscous: &mut viscous };
///
/// let model = Model::new(&scenario, of_model, &mut of_state)?;
/// let mut state = State::new(&model, of_state)?;
/// let count = model.constants.steps_in(scenario.time.duration);
/// steps(&model, &mut state, count, &StepInput::default())?;
/// assert_eq!(state.time(&model), scenario.time.duration);
/// let peak = state.scalars.metrics.peak_force;
/// assert!(peak > 5000.0 && peak < 6000.0, "{peak} N");
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
pub struct Model<'a> {
    /// Scalar constants.
    pub constants: &'a Constants,
    pub(crate) nodes: ModelNodes<'a>,
    pub(crate) cells: &'a [CellConstants],
    pub(crate) hoops: &'a [HoopConstants],
}

impl<'a> Model<'a> {
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

/// Radius of the curved core surface, m; none for a flat one.
pub(crate) fn core_radius(scenario: &Scenario) -> Option<Real> {
    match scenario.geometry.shape {
        Shape::Round => Some(scenario.geometry.core_radius),
        Shape::Block => None,
    }
}
