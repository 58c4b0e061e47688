//! Faces that are narrower than a deep elastic block: a ball against Hertz's point contact, a flat punch against the closed form
//! of Boussinesq and Sneddon, a bar against Hertz's line contact.
//!
//! Source: Johnson, Contact Mechanics (1985): F = 4/3 E* R^(1/2) d^(3/2); F = 2 E* a d; a^2 = 4 F' R / (pi E*), p0 = 2 F' / (pi a).

use softanvil_kernel::contact::surface;
use softanvil_kernel::scenario::{FaceShape, Formulation, Interface, Outline};
use softanvil_kernel::{Scenario, Simulation};

use crate::order::{extrapolate, over_cells};
use crate::relaxation::press_slowly;
use crate::row::Row;
use crate::scenes::{block, neo_hookean};

const SHEAR_MODULUS: f64 = 1e6;
const POISSONS_RATIO: f64 = 0.3;
/// Plane strain modulus of a block under a rigid face, Pa.
const MODULUS: f64 = 2.0 * SHEAR_MODULUS / (1.0 - POISSONS_RATIO);
/// Radius of the ball and of the bar, m.
const RADIUS: f64 = 1.0;
/// Radius of the punch, m, two hundred times that of its edges.
const PUNCH: f64 = 0.2;
/// Half width of the contact that a ball and a bar are pressed to, m.
const CONTACT: f64 = 20e-3;
/// Width and depth of the block over the half width of the contact.
const EXTENT: f64 = 60.0;
/// Cells beside the fine ones under the contact over those under it.
const COARSER: usize = 2;

/// Cells under half of the contact of the regular study.
pub const CELLS: [usize; 3] = [4, 8, 16];

/// A face on a block.
#[derive(Clone, Copy, Debug)]
pub struct Indentation {
    /// Force, N, over the closed form for its depth; of a bar the largest pressure over that for its force.
    pub ratio: f64,
    /// Half width of the contact over that of the closed form.
    pub half_width: f64,
}

/// `shape` on a block with `n` cells under half of the contact.
pub fn indent(shape: FaceShape, n: usize) -> Indentation {
    let (formulation, half) = match shape {
        FaceShape::Bar => (Formulation::PlaneStrain, CONTACT),
        FaceShape::Sphere => (Formulation::Axisymmetric, CONTACT),
        _ => (Formulation::Axisymmetric, PUNCH),
    };
    let mut scenario = scenario(shape, formulation, half);
    // As the kernel places it, the last node under the flat part is half a cell inside its edge.
    let under = |flat: f64| flat * n as f64 / (n as f64 + 0.5);
    let fine = if shape == FaceShape::Round { under(Outline::of(&scenario).flat) } else { half };
    let beside = COARSER * n;
    scenario.mesh.element_size = fine / n as f64;
    scenario.geometry.block_width = 2.0 * (fine + beside as f64 * scenario.mesh.element_size);
    let across = stations(n, beside, fine, EXTENT * half);
    let up = stations(n, beside, fine, EXTENT * half);
    let rows = n + beside;
    scenario.layers[0].rows = rows;
    let position = |u: usize, v: usize| [across[u], EXTENT * half - up[rows - v]];
    let mut simulation = Simulation::with_positions(&scenario, &position).expect("a legal mesh");
    assert_eq!(simulation.constants().grid.n_u, rows);
    let depth = if shape == FaceShape::Round { 1e-3 * PUNCH } else { half * half / RADIUS };
    // Of the block's slowest vibration, a shear wave through its depth and back twice.
    let period = 4.0 * EXTENT * half / (SHEAR_MODULUS / scenario.layers[0].material.density).sqrt();
    let force = press_slowly(&mut simulation, depth, period, 0.1 * period);
    let load = force / scenario.geometry.length;
    let expected = match shape {
        FaceShape::Bar => (4.0 * load * RADIUS / (std::f64::consts::PI * MODULUS)).sqrt(),
        _ => half,
    };
    let half_width = simulation.scalars().contact_half_width / expected;
    let ratio = match shape {
        FaceShape::Sphere => force / (4.0 / 3.0 * MODULUS * RADIUS.sqrt() * depth.powf(1.5)),
        FaceShape::Bar => pressure(&mut simulation) / (2.0 * load / (std::f64::consts::PI * expected)),
        _ => force / (2.0 * MODULUS * PUNCH * depth),
    };
    Indentation { ratio, half_width }
}

fn scenario(shape: FaceShape, formulation: Formulation, half: f64) -> Scenario {
    let bulk = 2.0 * SHEAR_MODULUS * (1.0 + POISSONS_RATIO) / (3.0 * (1.0 - 2.0 * POISSONS_RATIO));
    let mut scenario = block(2.0 * half, 1.0, neo_hookean(SHEAR_MODULUS, bulk));
    scenario.geometry.formulation = formulation;
    scenario.core.interface = Interface::Bonded;
    scenario.impactor.shape = shape;
    scenario.impactor.face_diameter = if shape == FaceShape::Round { 2.0 * PUNCH } else { 2.0 * RADIUS };
    (scenario.impactor.gap, scenario.impactor.face_length, scenario.geometry.length) = (0.0, 1.0, 1.0);
    scenario.layers[0].thickness = 0.5;
    scenario.time.design_compression = 0.01;
    scenario
}

/// Distances of `n` even cells to `fine` m and of `beside` more, each larger than the one before by the same factor, to `end` m.
fn stations(n: usize, beside: usize, fine: f64, end: f64) -> Vec<f64> {
    let cell = fine / n as f64;
    let reach = |ratio: f64| (1..=beside).map(|i| cell * ratio.powi(i as i32)).sum::<f64>();
    let (mut low, mut high) = (1.0, 10.0);
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if fine + reach(middle) < end { low = middle } else { high = middle }
    }
    let mut stations: Vec<f64> = (0..=n).map(|i| fine * i as f64 / n as f64).collect();
    for i in 1..=beside {
        stations.push(stations[n + i - 1] + cell * low.powi(i as i32));
    }
    stations
}

/// Contact pressure on the axis, Pa.
fn pressure(simulation: &mut Simulation) -> f64 {
    simulation
        .with(|model, state| surface::contact_pressure(model, &state.as_view(), 0).expect("a column"))
        .expect("memory of the right size")
}

/// Rows of the table over `cells` under half of the contact.
pub fn rows(cells: &[usize; 3]) -> Vec<Row> {
    let row = |shape, quantity: &str, reference: &str| {
        let ratios = cells.map(|n| indent(shape, n).ratio);
        let order = match shape {
            // Of the punch the error; of the ball what the extent of the block leaves stays.
            FaceShape::Round => Some(over_cells(cells, &ratios.map(|ratio| ratio - 1.0))),
            FaceShape::Sphere => Some(extrapolate(cells.map(|n| 1.0 / n as f64), ratios).1),
            _ => None,
        };
        Row {
            problem: "indentation",
            quantity: quantity.into(),
            reference: reference.into(),
            meshes: cells.iter().map(|n| format!("{n} cells under half of the contact")).collect(),
            order,
            errors: ratios.iter().map(|ratio| ratio - 1.0).collect(),
        }
    };
    vec![
        row(FaceShape::Round, "force on a flat punch", "2 E* a d, half space"),
        row(FaceShape::Sphere, "force on a ball", "4/3 E* R^(1/2) d^(3/2), half space"),
        row(FaceShape::Bar, "largest pressure under a bar", "2 F' / (pi a), half space"),
    ]
}
