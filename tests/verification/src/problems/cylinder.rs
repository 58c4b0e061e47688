//! The study's virtual material tests: a cylinder compressed to half its height, and held.

use softanvil_kernel::material::{Elastic, Material, MooneyRivlin};
use softanvil_kernel::preset;
use softanvil_kernel::scenario::{Formulation, Interface, Scenario, Shape};
use softanvil_specimen::{Compression, Ends, Point, STUDY_RATES, compress};

use crate::body::{Body, Pressure};
use crate::order::over_cells;
use crate::row::Row;
use crate::scenes::elastic;
use crate::statics::{Supports, solve};

/// Time of the hold, s, as in the study.
pub const HOLD: f64 = 5.0;

/// Cells over the height of the bonded cylinder.
pub const CELLS: [u32; 3] = [4, 8, 16];

/// Periods of vibration in the time of the travel; the default is the first of these or more.
pub const PERIODS: [f64; 3] = [10.0, 20.0, 40.0];

/// A law of five parameters.
const LAW: MooneyRivlin = MooneyRivlin { c10: 0.1e6, c01: 0.05e6, c11: 0.03e6, c20: 0.004e6, c02: 0.01e6 };

/// The law of the cylinder with a term for each rate of the study.
pub fn viscoelastic() -> Material {
    Material {
        prony_g: [0.25, 0.2, 0.15, 0.0, 0.0],
        prony_tau: [0.2, 2.0, 30.0, 1.0, 1.0],
        ..elastic(0.0, 0.0, 7.25e6).with(LAW)
    }
}

/// The silicone of the study; without a slider, which the reference below does not know.
pub fn study_silicone() -> Material {
    preset::study().layers[0].material
}

/// Nominal stresses of a homogeneous uniaxial compression at the times and strains of `curve`, compression positive, Pa.
///
/// The deviatoric Kirchhoff stress along the axis is 2/3 (A - T) with A and T the derivatives of the isochoric energy in the
/// logarithms of the stretches along and across, by the closed form of the law; each term of the series relaxes it, and the
/// jacobian follows from no stress across.
pub fn uniaxial(material: &Material, curve: &[Point]) -> Vec<f64> {
    let (mut time, mut elastic) = (0.0, 0.0);
    let mut overstress = [0.0; 5];
    let mut stresses = Vec::new();
    for point in curve {
        let (stretch, dt) = (1.0 - point.strain, point.time - time);
        let relaxed = |deviator: f64| -> [f64; 5] {
            std::array::from_fn(|k| {
                let part = dt / material.prony_tau[k];
                let ratio = material.prony_g[k] / material.prony_g_inf();
                overstress[k] * (-part).exp() + ratio * (-(-part).exp_m1()) / part * (deviator - elastic)
            })
        };
        let axial = |jacobian: f64| -> (f64, f64) {
            let deviator = deviator(material, stretch, jacobian);
            (deviator, deviator + relaxed(deviator).iter().sum::<f64>())
        };
        let bulk = material.effective_bulk_modulus();
        // The stress across, -q/2 + J K (J - 1), rises with the jacobian.
        let (mut low, mut high) = (0.2, 1.5);
        for _ in 0..100 {
            let jacobian = 0.5 * (low + high);
            if bulk * jacobian * (jacobian - 1.0) < 0.5 * axial(jacobian).1 { low = jacobian } else { high = jacobian }
        }
        let (deviator, total) = axial(low);
        overstress = relaxed(deviator);
        (time, elastic) = (point.time, deviator);
        stresses.push(-1.5 * total / stretch);
    }
    stresses
}

/// Deviatoric Kirchhoff stress of the long-term law along the axis, Pa, at an axial stretch and a jacobian.
fn deviator(m: &Material, stretch: f64, jacobian: f64) -> f64 {
    let along = stretch * jacobian.powf(-1.0 / 3.0);
    let across = along.powf(-0.5);
    let [axial, lateral, _] = Elastic::new(m).principal_stress([along, across, across]);
    2.0 / 3.0 * (axial - lateral)
}

/// Largest difference of a frictionless test from the closed form, over the largest stress; of a test with a hold, in the
/// hold.
pub fn frictionless_error(material: &Material, test: &Compression) -> f64 {
    let curve = compress(material, test).expect("a legal test");
    let reference = uniaxial(material, &curve);
    let largest = reference.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
    let from = if test.hold > 0.0 { 1.05 * test.travel_time() } else { 0.0 };
    let judged = curve.iter().zip(&reference).filter(|(p, _)| p.time >= from);
    judged.fold(0.0_f64, |a, (p, r)| a.max((p.stress - r).abs())) / largest
}

/// Nominal stress at half height of an elastic cylinder between bonded plates, Pa, by the kernel's steps.
pub fn bonded_stress(cells: u32) -> f64 {
    let test = Compression { ends: Ends::Bonded, cells, hold: 0.2, ..Compression::study(STUDY_RATES[2]) };
    let curve = compress(&bonded_material(), &test).expect("a legal test");
    // The mean over the hold, in which what vibrates averages out.
    let held: Vec<&Point> = curve.iter().filter(|p| p.strain >= test.strain * (1.0 - 1e-9)).collect();
    held.iter().map(|p| p.stress).sum::<f64>() / held.len() as f64
}

/// The same in equilibrium, by Newton's method on the same mesh.
pub fn bonded_equilibrium(cells: u32) -> f64 {
    let test = Compression::study(STUDY_RATES[2]);
    let mut scenario: Scenario = preset::study();
    scenario.geometry.shape = Shape::Block;
    scenario.geometry.formulation = Formulation::Axisymmetric;
    scenario.layers[0].thickness = test.height;
    scenario.geometry.block_width = test.diameter;
    scenario.core.interface = Interface::Bonded;
    scenario.impactor.motion = softanvil_kernel::scenario::Motion::Driven;
    scenario.impactor.gap = 1.0;
    scenario.layers[0].material = bonded_material();
    scenario.mesh.element_size = test.height / f64::from(cells);
    let grid = softanvil_kernel::mesh::Grid::new(&scenario).expect("a legal mesh");
    let position = |u, v| softanvil_kernel::mesh::reference_position(&scenario, &grid, u, v);
    let mut body = Body::new(&scenario, &position, Pressure::Patch);
    let mut supports = Supports::none(&body);
    for v in 0..=grid.n_v {
        supports.prescribed[body.node(0, v)][0] = Some(0.0);
    }
    for u in 0..=grid.n_u {
        supports.prescribed[body.node(u, 0)] = [Some(0.0); 2];
        supports.prescribed[body.node(u, grid.n_v)] = [Some(0.0), Some(-test.strain * test.height)];
    }
    let force = solve(&mut body, &supports, 20).force;
    let top: f64 = (0..=grid.n_u).map(|u| -force[body.node(u, grid.n_v)][1]).sum();
    body.constants().symmetry_factor * top / test.area()
}

fn bonded_material() -> Material {
    elastic(0.1e6, 0.05e6, 1.67e6)
}

/// Rows of the table.
pub fn rows() -> Vec<Row> {
    let mut rows = Vec::new();
    for rate in STUDY_RATES {
        rows.push(inertia(format!("stress to 50 % at {rate} 1/s, frictionless"), &Compression::study(rate)));
    }
    rows.push(inertia(format!("relaxation at 50 % for {HOLD} s, frictionless"), &Compression::study_relaxation(HOLD)));
    rows
}

/// The error of a test over the periods of vibration in its travel.
fn inertia(quantity: String, test: &Compression) -> Row {
    let errors = PERIODS.map(|periods| frictionless_error(&viscoelastic(), &Compression { periods, ..*test }));
    Row {
        problem: "cylinder",
        quantity,
        reference: "homogeneous compression".into(),
        meshes: PERIODS.iter().map(|n| format!("{n} periods")).collect(),
        order: Some(over_cells(&PERIODS.map(|n| n as usize), &errors)),
        errors: errors.to_vec(),
    }
}
