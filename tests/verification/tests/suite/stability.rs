//! The limit of the time step against the eigenvalues of the cells, and that a step beyond it is refused and found.
//!
//! Source: central differences are stable for dt <= 2 / omega; omega^2 of a cell, a quarter of its mass at each corner, by
//! nalgebra, from a stiffness by central differences of the kernel's nodal forces.

use nalgebra::{SMatrix, SymmetricEigen};
use softanvil_kernel::material::NeoHookean;
use softanvil_kernel::sampling::SMALLEST_STEP;
use softanvil_kernel::scenario::{Formulation, StepBy};
use softanvil_kernel::step::MONITOR_PERIOD;
use softanvil_kernel::{
    InstructionSet, Model, ModelError, Scenario, Simulation, State, StepError, StepInput, step_with,
};
use softanvil_verification::body::{Body as Mesh, Pressure};
use softanvil_verification::deformation::Samples;
use softanvil_verification::scenes::{elastic, grid};
use softanvil_verification::tolerance::{NAMED_LIMIT_LEAST, STABLE_STEP, relative_error};

/// Cells along and across the row: not a whole number of blocks, several steps for a round of the monitor.
const CELLS: [usize; 2] = [11, 8];
/// C10 of the neo-Hookean material, Pa.
const C10: f64 = 0.1e6;
/// Its bulk modulus, Pa.
const BULK: f64 = 0.9e6;

/// Displacement of the central differences, m: a strain of 10^-5, whose square is the error.
const DISPLACEMENT: f64 = 1e-8;

/// A body of distorted cells.
struct Body {
    scenario: Scenario,
    /// The same nodes, to be asked for forces.
    mesh: Mesh,
    /// Nodes at rest, m, row by row.
    nodes: Vec<[f64; 2]>,
}

impl Body {
    fn new(formulation: Formulation) -> Self {
        let material = elastic(0.0, 0.0, BULK).with(NeoHookean { c10: C10 });
        let mut scenario = grid(CELLS[0], CELLS[1], material);
        scenario.geometry.formulation = formulation;
        let mut samples = Samples::new(3);
        let mut shifted = |n: usize| 1e-3 * (n as f64 + 0.3 * samples.number());
        let nodes = (0..=CELLS[1]).flat_map(|v| (0..=CELLS[0]).map(move |u| (u, v)));
        let nodes: Vec<[f64; 2]> = nodes.map(|(u, v)| [shifted(u + 2), shifted(v)]).collect();
        let mesh = Mesh::new(&scenario, &|u, v| nodes[v * (CELLS[0] + 1) + u], Pressure::Patch);
        Self { scenario, mesh, nodes }
    }

    fn position(&self, u: usize, v: usize) -> [f64; 2] {
        self.nodes[v * (CELLS[0] + 1) + u]
    }

    fn simulation(&self, step: f64) -> Result<Simulation, ModelError> {
        let mut scenario = self.scenario.clone();
        scenario.time.step_by = StepBy::Given;
        scenario.time.step = step;
        Simulation::with_positions(&scenario, &|u, v| self.position(u, v))
    }

    /// The largest stable step of cell (u, v), s, where its corners have gone by `gradient`.
    fn limit(&self, u: usize, v: usize, gradient: &[[f64; 2]; 2]) -> f64 {
        let corners = [(u, v), (u + 1, v), (u + 1, v + 1), (u, v + 1)].map(|(u, v)| self.position(u, v));
        let forces = |direction: usize, by: f64| {
            let mut displacement = corners.map(|rest| {
                let moved = applied(gradient, rest);
                [moved[0] - rest[0], moved[1] - rest[1]]
            });
            displacement[direction / 2][direction % 2] += by;
            self.mesh.cell_forces(&displacement, u, v)
        };
        let mut stiffness = SMatrix::<f64, 8, 8>::zeros();
        for direction in 0..8 {
            let (plus, minus) = (forces(direction, DISPLACEMENT), forces(direction, -DISPLACEMENT));
            for i in 0..8 {
                stiffness[(i, direction)] = (plus[i / 2][i % 2] - minus[i / 2][i % 2]) / (2.0 * DISPLACEMENT);
            }
        }
        let largest = SymmetricEigen::new(0.5 * (stiffness + stiffness.transpose())).eigenvalues.max();
        2.0 / (largest / (0.25 * self.scenario.layers[0].material.density * self.volume(&corners))).sqrt()
    }

    /// Volume of a cell, m3: the area of its quadrilateral times the length of the block, or, by Pappus, of the way around of
    /// the centres of the triangles into which the diagonal from corner 1 to corner 3 cuts it.
    fn volume(&self, corners: &[[f64; 2]; 4]) -> f64 {
        let [a, b, c, d] = *corners;
        let volume = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| {
            let area = 0.5 * double_area(a, b, c);
            match self.scenario.geometry.formulation {
                Formulation::PlaneStrain | Formulation::Solid => area * self.scenario.geometry.length,
                Formulation::Axisymmetric => area * 2.0 * std::f64::consts::PI * (a[0] + b[0] + c[0]) / 3.0,
            }
        };
        volume(a, b, d) + volume(b, c, d)
    }

    /// The smallest limit of all cells at rest, s.
    fn limit_at_rest(&self) -> f64 {
        let cells = (0..CELLS[1]).flat_map(|v| (0..CELLS[0]).map(move |u| (u, v)));
        cells.fold(f64::INFINITY, |least, (u, v)| least.min(self.limit(u, v, &[[1.0, 0.0], [0.0, 1.0]])))
    }

    /// Puts all nodes where `gradient` takes them.
    fn place(&self, model: &Model, state: &mut State, gradient: &[[f64; 2]; 2]) {
        let stride = model.constants.grid.stride();
        for (u, v) in (0..=CELLS[1]).flat_map(|v| (0..=CELLS[0]).map(move |u| (u, v))) {
            let rest = self.position(u, v);
            let moved = applied(gradient, rest);
            let [x, y] = state.displacement_mut();
            (x[v * stride + u], y[v * stride + u]) = (moved[0] - rest[0], moved[1] - rest[1]);
        }
    }

    /// Puts all nodes where `gradient` takes them, and steps until a round of the monitor is over.
    fn steps(&self, set: InstructionSet, step: f64, gradient: &[[f64; 2]; 2]) -> Result<(), StepError> {
        let mut simulation = self.simulation(step).expect("a legal step");
        let run = simulation.with(|model, state| {
            self.place(model, state, gradient);
            let input = StepInput { driven_position: Some(self.scenario.impactor.gap), ..StepInput::default() };
            (0..MONITOR_PERIOD).try_for_each(|_| step_with(set, model, state, &input))
        });
        run.expect("memory of the right size")
    }
}

fn double_area(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
}

fn applied(f: &[[f64; 2]; 2], x: [f64; 2]) -> [f64; 2] {
    [f[0][0] * x[0] + f[0][1] * x[1], f[1][0] * x[0] + f[1][1] * x[1]]
}

fn sets() -> impl Iterator<Item = InstructionSet> {
    InstructionSet::ALL.into_iter().filter(|set| set.available())
}

#[test]
fn the_limit_at_rest_is_that_of_the_highest_frequency_of_a_cell() {
    for formulation in [Formulation::PlaneStrain, Formulation::Axisymmetric] {
        let body = Body::new(formulation);
        let expected = body.limit_at_rest();
        match body.simulation(1.01 * expected).err() {
            Some(ModelError::StepTooLarge { limit, .. }) => {
                assert!(relative_error(limit, expected) < STABLE_STEP, "{formulation:?}: {limit} s, {expected} s");
            }
            other => panic!("{formulation:?}: {other:?}"),
        }
    }
}

/// The tangents of the kernel are majorants, so its limit is a bound: below that of the cell, and not far. That it is one of
/// whole meshes is shown in `frequency.rs`.
#[test]
fn a_deformed_cell_is_refused_with_a_bound_of_its_own_limit() {
    let (squeezed, shear) = (0.5_f64, 0.4);
    let sheared = [[squeezed, shear], [0.0, 1.0 / squeezed]];
    let ring = [[squeezed, 0.0], [0.0, squeezed.powi(-2)]];
    for (formulation, gradient) in [(Formulation::PlaneStrain, sheared), (Formulation::Axisymmetric, ring)] {
        let body = Body::new(formulation);
        let step = 0.99 * body.limit_at_rest();
        for set in sets() {
            match body.steps(set, step, &gradient) {
                Err(StepError::Unstable { element, limit, step: told, time: 0.0 }) => {
                    let cell = element as usize / 2;
                    let ratio = limit / body.limit(cell % CELLS[0], cell / CELLS[0], &gradient);
                    assert!(ratio < 1.0 + STABLE_STEP && ratio > NAMED_LIMIT_LEAST, "{formulation:?}: {ratio}");
                    assert!(limit < told, "{limit} s, {told} s");
                }
                other => panic!("{formulation:?}, {set:?}: {other:?}"),
            }
        }
    }
}

/// A body is squeezed past the limit of its smallest cells, and let go. Wherever the monitor is in its round, what grows there
/// is found before it is worth a tenth of the energy that was put in.
#[test]
fn an_instability_is_found_before_the_monitor_comes_round() {
    let body = Body::new(Formulation::PlaneStrain);
    let run = |set, step: f64, first: u64, steps: u64| {
        let mut simulation = body.simulation(step).expect("a legal step");
        let found = simulation.with(|model, state| {
            body.place(model, state, &[[1.0, 0.0], [0.0, 0.7]]);
            state.scalars.step_index = first;
            let input = StepInput { driven_position: Some(body.scenario.impactor.gap), ..StepInput::default() };
            let error = (0..steps).find_map(|_| step_with(set, model, state, &input).err());
            (error, state.scalars.energy.elastic, state.scalars.energy.layer_kinetic)
        });
        found.expect("memory of the right size")
    };
    let (_, put_in, _) = run(InstructionSet::Baseline, SMALLEST_STEP, 0, 1);
    for (set, first) in sets().flat_map(|set| (0..MONITOR_PERIOD as u64).map(move |first| (set, first))) {
        let (error, elastic, kinetic) = run(set, 0.99 * body.limit_at_rest(), first, MONITOR_PERIOD as u64);
        assert!(matches!(error, Some(StepError::Unstable { .. })), "{set:?} from step {first}: {error:?}");
        // What grows is kinetic energy, and elastic energy above what there was.
        assert!(
            elastic + kinetic < 1.1 * put_in,
            "{set:?} from step {first}: {elastic} J and {kinetic} J of {put_in} J"
        );
    }
}

#[test]
fn a_turned_body_is_as_stable_as_one_at_rest() {
    let body = Body::new(Formulation::PlaneStrain);
    let (sin, cos) = 0.8_f64.sin_cos();
    for set in sets() {
        body.steps(set, 0.99 * body.limit_at_rest(), &[[cos, -sin], [sin, cos]]).expect("a stable run");
    }
}
