//! Force of the bonded round layer under a frictionless face, quasi-static, at 5 mm deflection.

use softanvil_kernel::mesh::{Grid, reference_position};
use softanvil_kernel::scenario::{Formulation, Interface, Motion};
use softanvil_kernel::{Scenario, Simulation, preset};

use crate::body::{Body, Pressure};
use crate::memo::Memo;
use crate::order::against_last;
use crate::relaxation::press_slowly;
use crate::row::{Row, name};
use crate::scenes::elastic;
use crate::statics::{Equilibrium, Face, Supports, press};

/// Deflection, m.
pub const DEFLECTION: f64 = 5e-3;

/// Increments to it; the force at each is a point of the curve.
const INCREMENTS: u32 = 20;

/// Element sizes, m, the default first, the reference last.
pub const SIZES: [f64; 5] = [3e-3, 1.5e-3, 1e-3, 0.75e-3, 0.375e-3];

/// Bulk moduli, Pa: nearly incompressible, and the study's.
pub const BULK_MODULI: [f64; 2] = [8e6, 1.67e6];

/// The layer with bulk modulus `bulk_modulus`, Pa, in elements of `element_size` m.
pub fn scenario(formulation: Formulation, bulk_modulus: f64, element_size: f64) -> Scenario {
    let mut scenario = preset::study();
    scenario.geometry.formulation = formulation;
    // Shorter than every chord, so that the thickness is constant.
    scenario.geometry.length = 50e-3;
    scenario.impactor.motion = Motion::Driven;
    scenario.impactor.gap = 0.0;
    scenario.core.interface = Interface::Bonded;
    scenario.face.friction_coefficient = 0.0;
    scenario.layers[0].material = elastic(0.1e6, 0.06e6, bulk_modulus);
    scenario.mesh.element_size = element_size;
    scenario
}

/// Contact forces in equilibrium up to the deflection, N.
pub fn static_forces(scenario: &Scenario) -> Vec<f64> {
    let grid = Grid::new(scenario).expect("a legal mesh");
    let mut body = Body::new(scenario, &|u, v| reference_position(scenario, &grid, u, v), Pressure::Patch);
    let mut supports = Supports::none(&body);
    for v in 0..=grid.n_v {
        supports.prescribed[body.node(0, v)][0] = Some(0.0);
    }
    for u in 0..=grid.n_u {
        supports.prescribed[body.node(u, 0)] = [Some(0.0); 2];
    }
    let face = Face { height: body.constants().top_height - DEFLECTION };
    let equilibria = press(&mut body, &supports, &face, INCREMENTS);
    let force = |at: &Equilibrium| (0..=grid.n_u).map(|u| -at.force[body.node(u, grid.n_v)][1]).sum::<f64>();
    equilibria.iter().map(|at| body.constants().symmetry_factor * force(at)).collect()
}

/// Contact force that the kernel's own steps settle at, N.
pub fn settled_force(scenario: &Scenario) -> f64 {
    let mut simulation = Simulation::new(scenario).expect("a legal scenario");
    press_slowly(&mut simulation, DEFLECTION, 50e-3, 4e-3)
}

/// Forces over element sizes.
#[derive(Clone)]
pub struct Study {
    /// Contact forces at the full deflection, N.
    pub forces: Vec<f64>,
    /// Differences of the force-deflection curve from that of the last size, root mean square over the last force.
    ///
    /// The edge of the contact moves from node to node, which makes the force at one deflection waver about its trend;
    /// over a curve the wavering shows as what it is, part of the error.
    pub errors: Vec<f64>,
    /// Order of the errors.
    pub order: f64,
}

/// The study over `sizes`, m; the last one gives the reference.
pub fn study(formulation: Formulation, bulk_modulus: f64, sizes: &[f64]) -> Study {
    static KNOWN: Memo<(Formulation, u64, Vec<u64>), Study> = Memo::new();
    KNOWN.get((formulation, bulk_modulus.to_bits(), sizes.iter().map(|size| size.to_bits()).collect()), || {
        computed_study(formulation, bulk_modulus, sizes)
    })
}

fn computed_study(formulation: Formulation, bulk_modulus: f64, sizes: &[f64]) -> Study {
    let curves: Vec<Vec<f64>> =
        sizes.iter().map(|size| static_forces(&scenario(formulation, bulk_modulus, *size))).collect();
    let reference = &curves[sizes.len() - 1];
    let last = reference[reference.len() - 1];
    let difference = |curve: &Vec<f64>| {
        let sum: f64 = curve.iter().zip(reference).map(|(a, b)| (a - b).powi(2)).sum();
        (sum / reference.len() as f64).sqrt() / last
    };
    let errors: Vec<f64> = curves[..sizes.len() - 1].iter().map(difference).collect();
    Study {
        forces: curves.iter().map(|curve| curve[curve.len() - 1]).collect(),
        order: against_last(sizes, &errors),
        errors,
    }
}

/// Rows of the table.
pub fn rows() -> Vec<Row> {
    let sizes = &SIZES;
    let mut rows = Vec::new();
    for formulation in [Formulation::PlaneStrain, Formulation::Axisymmetric] {
        for bulk in BULK_MODULI {
            let study = study(formulation, bulk, sizes);
            rows.push(Row {
                problem: "contact_convergence",
                quantity: format!("force to 5 mm, {}, K = {} MPa", name(formulation), bulk / 1e6),
                reference: format!("{} mm elements", 1e3 * sizes[sizes.len() - 1]),
                meshes: sizes[..sizes.len() - 1].iter().map(|size| format!("{} mm", 1e3 * size)).collect(),
                errors: study.errors,
                order: Some(study.order),
            });
        }
    }
    rows
}
