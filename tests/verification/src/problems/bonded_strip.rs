//! Bonded rubber strip and disc in compression: apparent modulus against the shape factor.

use softanvil_kernel::scenario::{Formulation, Interface, Motion};
use softanvil_kernel::{Scenario, Simulation};

use crate::body::{Body, Pressure};
use crate::memo::Memo;
use crate::order::extrapolate;
use crate::relaxation::press_slowly;
use crate::row::{Row, name};
use crate::scenes::{block, grid, neo_hookean};
use crate::statics::{Equilibrium, Supports, linear, solve};

/// Shape factors, loaded area over free area.
pub const SHAPE_FACTORS: [f64; 4] = [0.5, 1.0, 2.0, 5.0];

/// Shear modulus, Pa.
pub const SHEAR_MODULUS: f64 = 1e5;
/// Close to the incompressible limit; what is left is in the reference.
const BULK_MODULUS: f64 = 1e4 * SHEAR_MODULUS;
const THICKNESS: f64 = 10e-3;

/// Gent and Lindley's apparent modulus over Young's modulus, with the bulk modulus in series.
pub fn reference(formulation: Formulation, shape_factor: f64) -> f64 {
    let young = 3.0 * SHEAR_MODULUS;
    let incompressible = match formulation {
        Formulation::PlaneStrain | Formulation::Solid => 4.0 / 3.0 * (1.0 + shape_factor.powi(2)),
        Formulation::Axisymmetric => 1.0 + 2.0 * shape_factor.powi(2),
    };
    1.0 / (1.0 / incompressible + young / BULK_MODULUS)
}

/// Half width or radius over thickness.
fn half_width(formulation: Formulation, shape_factor: f64) -> f64 {
    match formulation {
        Formulation::PlaneStrain | Formulation::Solid => shape_factor,
        Formulation::Axisymmetric => 2.0 * shape_factor,
    }
}

/// Linear compression of a strip or disc between bonded faces.
pub struct Compression {
    /// The strip.
    pub body: Body,
    /// Its equilibrium.
    pub equilibrium: Equilibrium,
}

/// Mean strain of a [`Compression`].
const STRAIN: f64 = 1e-6;

/// A strip or disc with `n` cells through the thickness in the linear limit.
pub fn compression(formulation: Formulation, shape_factor: f64, bulk_modulus: f64, n: usize) -> Compression {
    let half = half_width(formulation, shape_factor);
    let n_u = (half * n as f64).round() as usize;
    let mut scenario = grid(n_u, n, neo_hookean(SHEAR_MODULUS, bulk_modulus));
    scenario.geometry.formulation = formulation;
    let position = |u: usize, v: usize| [half * THICKNESS * u as f64 / n_u as f64, THICKNESS * v as f64 / n as f64];
    let mut body = Body::new(&scenario, &position, Pressure::Patch);
    let mut supports = Supports::none(&body);
    for v in 0..=n {
        supports.prescribed[body.node(0, v)][0] = Some(0.0);
    }
    for u in 0..=n_u {
        supports.prescribed[body.node(u, 0)] = [Some(0.0); 2];
        supports.prescribed[body.node(u, n)] = [Some(0.0), Some(-STRAIN * THICKNESS)];
    }
    let equilibrium = linear(&mut body, &supports);
    Compression { body, equilibrium }
}

/// Apparent modulus over Young's modulus in the linear limit, with `n` cells through the thickness.
pub fn apparent_modulus(formulation: Formulation, shape_factor: f64, n: usize) -> f64 {
    let Compression { body, equilibrium } = compression(formulation, shape_factor, BULK_MODULUS, n);
    let [n_u, _] = body.cells();
    let total: f64 = (0..=n_u).map(|u| -equilibrium.force[body.node(u, n)][1]).sum();
    let half = half_width(formulation, shape_factor) * THICKNESS;
    let area = match formulation {
        Formulation::PlaneStrain | Formulation::Solid => half * body.constants().scenario.geometry.length,
        Formulation::Axisymmetric => std::f64::consts::PI * half.powi(2),
    };
    total / (area * STRAIN * 3.0 * SHEAR_MODULUS)
}

/// Bulk modulus of the strip under the kernel's own face, Pa: softer, to need fewer steps.
const PRESSED_BULK_MODULUS: f64 = 20.0 * SHEAR_MODULUS;

/// A strip of shape factor 1, bonded below, under a face with friction.
fn pressed(n: usize, friction: f64) -> Scenario {
    let mut scenario = block(2.0 * THICKNESS, THICKNESS, neo_hookean(SHEAR_MODULUS, PRESSED_BULK_MODULUS));
    scenario.core.interface = Interface::Bonded;
    scenario.mesh.element_size = THICKNESS / n as f64;
    scenario.impactor.motion = Motion::Driven;
    scenario.impactor.gap = 0.0;
    scenario.face.friction_coefficient = friction;
    scenario
}

/// Force of the kernel's face that sticks by friction, and of a bonded face, N, at 1 % compression.
pub fn stuck_and_bonded(n: usize) -> [f64; 2] {
    let depth = 0.01 * THICKNESS;
    let scenario = pressed(n, 10.0);
    let mut simulation = Simulation::new(&scenario).expect("a legal scenario");
    let stuck = press_slowly(&mut simulation, depth, 20e-3, 4e-3);
    let position = |u: usize, v: usize| [THICKNESS * u as f64 / n as f64, THICKNESS * v as f64 / n as f64];
    let mut body = Body::new(&scenario, &position, Pressure::Patch);
    let mut supports = Supports::none(&body);
    for i in 0..=n {
        supports.prescribed[body.node(0, i)][0] = Some(0.0);
    }
    for u in 0..=n {
        supports.prescribed[body.node(u, 0)] = [Some(0.0); 2];
        supports.prescribed[body.node(u, n)] = [Some(0.0), Some(-depth)];
    }
    let force = solve(&mut body, &supports, 2).force;
    let bonded: f64 = (0..=n).map(|u| -force[body.node(u, n)][1]).sum();
    [stuck, 2.0 * bonded]
}

/// Cells through the thickness.
pub const CELLS: [usize; 3] = [8, 16, 32];

/// Apparent moduli over `CELLS`, with their limit and order.
pub fn converged(formulation: Formulation, shape_factor: f64) -> ([f64; 3], f64, f64) {
    static KNOWN: Memo<(Formulation, u64), ([f64; 3], f64, f64)> = Memo::new();
    KNOWN.get((formulation, shape_factor.to_bits()), || computed(formulation, shape_factor))
}

fn computed(formulation: Formulation, shape_factor: f64) -> ([f64; 3], f64, f64) {
    let moduli = CELLS.map(|n| apparent_modulus(formulation, shape_factor, n));
    let (limit, order) = extrapolate(CELLS.map(|n| 1.0 / n as f64), moduli);
    (moduli, limit, order)
}

/// Rows of the table.
pub fn rows() -> Vec<Row> {
    let mut rows = Vec::new();
    for formulation in [Formulation::PlaneStrain, Formulation::Axisymmetric] {
        for shape_factor in SHAPE_FACTORS {
            let (moduli, limit, order) = converged(formulation, shape_factor);
            let row = |quantity: &str, reference: &str, value: f64, order: Option<f64>| Row {
                problem: "bonded_strip",
                quantity: format!("{quantity}, {}, S = {shape_factor}", name(formulation)),
                reference: reference.into(),
                meshes: CELLS.map(|n| format!("{n} cells")).into(),
                errors: moduli.iter().map(|modulus| modulus / value - 1.0).collect(),
                order,
            };
            rows.push(row("apparent modulus", "own limit", limit, Some(order)));
            let gent = reference(formulation, shape_factor);
            rows.push(row("apparent modulus", "Gent-Lindley (approximate)", gent, None));
        }
    }
    rows
}
