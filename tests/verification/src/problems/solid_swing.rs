//! Swinging cube: a solid on rollers that swings in a divergence-free mode, through the kernel's own steps.

use std::f64::consts::{FRAC_PI_2, PI};

use softanvil_kernel::scenario::Interface;
use softanvil_kernel::{Model, Simulation, State, StepInput, step};

use crate::memo::Memo;
use crate::order::over_cells;
use crate::row::Row;
use crate::scenes::neo_hookean;
use crate::solid::nodes;
use crate::solid_body::solid_grid;

/// Side of the cube, m.
const SIDE: f64 = 0.1;
/// Amplitude over side: the linear solution is exact to this order.
const AMPLITUDE: f64 = 1e-6;
const SHEAR_MODULUS: f64 = 6e6;
const DENSITY: f64 = 1100.0;
/// Parts of the three directions in the mode: without a sum, so that no volume changes, and no two alike.
const PARTS: [f64; 3] = [1.0, -3.0, 2.0];

/// Cells per side.
pub const CELLS: [usize; 3] = [8, 12, 16];

/// Poisson's ratios of the study.
pub const POISSONS_RATIOS: [f64; 2] = [0.45, 0.499];

/// Periods after which the error is taken, as of the swinging plate.
const PERIODS: f64 = 1.25;

/// A node in memory, and its displacement over the amplitude in time.
struct Node {
    place: usize,
    mode: [f64; 3],
    /// Directions along a face that holds them, those at x, y or z = `SIDE`.
    held: [bool; 3],
}

fn mode_of(model: &Model) -> Vec<Node> {
    let ([x, y], z, grid) = (model.reference_position(), model.reference_z(), model.constants.grid);
    let ends = [grid.n_u, grid.n_v, grid.n_w];
    let of = |node: [usize; 3]| {
        let place = grid.node(node[0], node[1], node[2]);
        let angle = [x[place], y[place], z[place]].map(|component| FRAC_PI_2 * component / SIDE);
        let along = |i: usize| (0..3).map(|j| if i == j { angle[j].sin() } else { angle[j].cos() }).product::<f64>();
        let at_end: [bool; 3] = core::array::from_fn(|i| node[i] == ends[i]);
        let held = core::array::from_fn(|i| (0..3).any(|j| j != i && at_end[j]));
        Node { place, mode: core::array::from_fn(|i| PARTS[i] * along(i)), held }
    };
    nodes(model).map(of).collect()
}

/// Puts a node somewhere, and gives it a velocity.
fn place(model: &Model, state: &mut State, node: &Node, direction: usize, [displacement, velocity]: [f64; 2]) {
    if direction < 2 {
        state.displacement_mut()[direction][node.place] = displacement;
        state.velocity_mut()[direction][node.place] = velocity;
    } else {
        let [uz, vz] = state.along_z_mut(model);
        (uz[node.place], vz[node.place]) = (displacement, velocity);
    }
}

/// Root mean square error of the displacement over the amplitude after `PERIODS` periods with Poisson's ratio `nu` on `n` cells per
/// side.
pub fn error(nu: f64, n: usize) -> f64 {
    static KNOWN: Memo<(u64, usize), f64> = Memo::new();
    KNOWN.get((nu.to_bits(), n), || {
        let bulk = 2.0 * SHEAR_MODULUS * (1.0 + nu) / (3.0 * (1.0 - 2.0 * nu));
        let mut scenario = solid_grid([n, n, n], neo_hookean(SHEAR_MODULUS, bulk));
        scenario.core.interface = Interface::Sliding;
        scenario.layers[0].material.density = DENSITY;
        let position = |node: [usize; 3]| node.map(|i| SIDE * i as f64 / n as f64);
        let mut simulation = Simulation::with_node_positions(&scenario, &position).expect("a legal solid");
        simulation.with(swing).expect("memory of the right size")
    })
}

fn swing(model: &Model, state: &mut State) -> f64 {
    let (dt, nodes) = (model.constants.dt, mode_of(model));
    let omega = 3.0_f64.sqrt() * FRAC_PI_2 / SIDE * (SHEAR_MODULUS / DENSITY).sqrt();
    // The mode at its largest, with the velocity that the exact motion has on average over the step before.
    let rising = AMPLITUDE * SIDE * (1.0 - (omega * dt).cos()) / dt;
    let each = || nodes.iter().flat_map(|node| (0..3).map(move |i| (node, i)));
    each()
        .for_each(|(node, i)| place(model, state, node, i, [AMPLITUDE * SIDE, rising].map(|part| part * node.mode[i])));
    let held: Vec<_> = each().filter(|(node, i)| node.held[*i]).collect();
    let steps = (PERIODS * 2.0 * PI / omega / dt).round() as u64;
    let input = StepInput { driven_position: Some(model.constants.scenario.impactor.gap), ..StepInput::default() };
    for _ in 0..steps {
        step(model, state, &input).expect("a step");
        held.iter().for_each(|(node, i)| place(model, state, node, *i, [0.0; 2]));
    }
    let now = AMPLITUDE * SIDE * (omega * dt * steps as f64).cos();
    let ([ux, uy], [uz, ..]) = (state.displacement(), state.as_view().along_z(model));
    let squares = each().map(|(node, i)| ([ux, uy, uz][i][node.place] - now * node.mode[i]).powi(2));
    (squares.sum::<f64>() / nodes.len() as f64).sqrt() / (AMPLITUDE * SIDE)
}

/// Rows of the table.
pub fn rows() -> Vec<Row> {
    let row = |nu: f64| {
        let errors: Vec<f64> = CELLS.iter().map(|n| error(nu, *n)).collect();
        Row {
            problem: "solid_swing",
            quantity: format!("displacement, nu = {nu}"),
            reference: "closed form".into(),
            meshes: CELLS.iter().map(|n| format!("{n} x {n} x {n}")).collect(),
            order: Some(over_cells(&CELLS, &errors)),
            errors,
        }
    };
    POISSONS_RATIOS.map(row).into()
}
