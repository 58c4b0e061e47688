//! Longitudinal waves in a bar along y: free vibration, speed of a front, and the stress behind it.

use std::f64::consts::{FRAC_PI_2, PI};

use softanvil_kernel::scenario::Interface;
use softanvil_kernel::{Model, Scenario, Simulation, State, StepInput, step};

use crate::order::over_cells;
use crate::row::Row;
use crate::scenes::{grid, neo_hookean};

const LENGTH: f64 = 0.1;
const SHEAR_MODULUS: f64 = 1e6;
const BULK_MODULUS: f64 = 4e6;
const DENSITY: f64 = 1000.0;
/// Strain of the waves: the linear solution is exact to this order.
const STRAIN: f64 = 1e-6;

/// What the sides of the bar do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sides {
    /// No lateral strain: modulus M = K + 4 G / 3.
    Fixed,
    /// No lateral stress in the section, plane strain out of it: modulus E / (1 - nu^2).
    Free,
}

impl Sides {
    fn modulus(self) -> f64 {
        let (g, k) = (SHEAR_MODULUS, BULK_MODULUS);
        match self {
            Sides::Fixed => k + 4.0 * g / 3.0,
            Sides::Free => 4.0 * g * (g + 3.0 * k) / (3.0 * k + 4.0 * g),
        }
    }

    /// Speed of long waves, m/s.
    pub fn speed(self) -> f64 {
        (self.modulus() / DENSITY).sqrt()
    }

    /// Half of the bar's width, m: slender where the sides move, so that lateral inertia stays out.
    fn half_width(self) -> f64 {
        match self {
            Sides::Fixed => LENGTH / 16.0,
            Sides::Free => LENGTH / 60.0,
        }
    }
}

/// A bar of `n` cells along its length, on rollers.
fn bar(sides: Sides, n: usize) -> Simulation {
    let across = 2;
    let mut scenario: Scenario = grid(across, n, neo_hookean(SHEAR_MODULUS, BULK_MODULUS));
    scenario.core.interface = Interface::Sliding;
    scenario.layers[0].material.density = DENSITY;
    scenario.impactor.gap = 0.0;
    let position = |u: usize, v: usize| [sides.half_width() * u as f64 / across as f64, LENGTH * v as f64 / n as f64];
    Simulation::with_positions(&scenario, &position).expect("a legal mesh")
}

fn advance(sides: Sides, model: &Model, state: &mut State, driven_position: f64) {
    step(model, state, &StepInput { driven_position: Some(driven_position), ..StepInput::default() }).expect("a step");
    if sides == Sides::Fixed {
        state.displacement_mut()[0].fill(0.0);
        state.velocity_mut()[0].fill(0.0);
    }
}

/// Period of the first free vibration with one end on rollers, over its reference 4 L / c.
pub fn period(sides: Sides, n: usize) -> f64 {
    let reference = 4.0 * LENGTH / sides.speed();
    let lateral = match sides {
        Sides::Fixed => 0.0,
        // nu / (1 - nu) in terms of G and K.
        Sides::Free => (3.0 * BULK_MODULUS - 2.0 * SHEAR_MODULUS) / (3.0 * BULK_MODULUS + 4.0 * SHEAR_MODULUS),
    };
    let measured = bar(sides, n).with(|model, state| {
        let grid = model.constants.grid;
        let (wave, amplitude) = (FRAC_PI_2 / LENGTH, STRAIN * LENGTH);
        let [x, y] = model.reference_position();
        for node in 0..grid.n_node() {
            let [ux, uy] = state.displacement_mut();
            uy[node] = amplitude * (wave * y[node]).sin();
            ux[node] = -lateral * x[node] * amplitude * wave * (wave * y[node]).cos();
        }
        let tip = grid.n_v * grid.stride();
        let mut crossings = Vec::new();
        while crossings.len() < 3 {
            let before = state.displacement()[1][tip];
            let time = state.time(model);
            advance(sides, model, state, 1.0);
            let after = state.displacement()[1][tip];
            if before * after < 0.0 {
                crossings.push(time + model.constants.dt * before / (before - after));
            }
        }
        crossings[2] - crossings[0]
    });
    measured.expect("memory of the right size") / reference
}

/// A front driven by the face.
#[derive(Clone, Copy, Debug)]
pub struct Front {
    /// Speed between two stations over its reference.
    pub speed: f64,
    /// Mean contact stress behind the front over rho c v.
    pub stress: f64,
}

/// The front that a face driven at constant speed after a smooth start sends down the bar.
pub fn front(sides: Sides, n: usize) -> Front {
    let (c, v) = (sides.speed(), STRAIN * sides.speed());
    let transit = LENGTH / c;
    // The start takes a quarter of the transit, so that the front is long against the width and the cells.
    let start = 0.25 * transit;
    let found = bar(sides, n).with(|model, state| {
        let grid = model.constants.grid;
        let stations = [3 * grid.n_v / 4, grid.n_v / 4].map(|row| row * grid.stride());
        let mut passed = [0.0; 2];
        let (mut impulse, mut time_sum) = (0.0, 0.0);
        let dt = model.constants.dt;
        while state.time(model) < 1.5 * transit {
            let time = state.time(model) + dt;
            advance(sides, model, state, -v * driven_distance(time, start));
            // All of the front has passed both stations, and its reflection is not yet back at the lower one.
            if time < 1.1 * transit {
                passed = stations.map(|node| -state.displacement()[1][node]);
            }
            // Behind the front, before its reflection is back at the face.
            if time > 2.0 * start {
                impulse += dt * state.scalars.force.contact;
                time_sum += dt;
            }
        }
        let area = 2.0 * sides.half_width() * model.constants.scenario.geometry.length;
        // What the upper station is ahead is the speed behind the front times the mean delay of the front.
        let delay = (passed[0] - passed[1]) / v;
        Front { speed: 0.5 * LENGTH / delay / c, stress: impulse / time_sum / area / (DENSITY * c * v) }
    });
    found.expect("memory of the right size")
}

/// Distance over speed of a face whose speed rises as a raised cosine within `start`, then stays.
fn driven_distance(time: f64, start: f64) -> f64 {
    if time < start { 0.5 * (time - start / PI * (PI * time / start).sin()) } else { time - 0.5 * start }
}

/// Cells along the bar.
pub const CELLS: [usize; 4] = [16, 32, 64, 128];

/// Rows of the table over `cells` along the bar.
pub fn rows(cells: &[usize]) -> Vec<Row> {
    let mut rows = Vec::new();
    for (sides, name) in [(Sides::Fixed, "sides fixed"), (Sides::Free, "sides free")] {
        let fronts: Vec<Front> = cells.iter().map(|n| front(sides, *n)).collect();
        let mut row = |quantity: &str, reference: &str, errors: Vec<f64>, ordered: bool| {
            rows.push(Row {
                problem: "bar_wave",
                quantity: format!("{quantity}, {name}"),
                reference: reference.into(),
                meshes: cells.iter().map(|n| format!("{n} cells")).collect(),
                order: ordered.then(|| over_cells(cells, &errors)),
                errors,
            });
        };
        let periods = cells.iter().map(|n| period(sides, *n) - 1.0).collect();
        row("period of free vibration", "4 L / c", periods, sides == Sides::Fixed);
        row("speed of a front", "c", fronts.iter().map(|f| f.speed - 1.0).collect(), false);
        row("stress behind it", "rho c v", fronts.iter().map(|f| f.stress - 1.0).collect(), false);
    }
    rows
}
