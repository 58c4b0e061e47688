//! Patch test: a homogeneous deformation of the round mesh, whose cells are neither square nor equal.

use softanvil_kernel::scenario::{Formulation, Motion, Shape};
use softanvil_kernel::{Scenario, Simulation, StepInput, preset, step};

use crate::deformation::Gradient;
use crate::row::Check;
use crate::scenes::elastic;

/// Largest force on an interior node relative to the largest on a boundary node, after the deformation `gradient`.
///
/// # Panics
/// If the scenario is illegal or the step fails.
pub fn residual(mut scenario: Scenario, gradient: Gradient) -> f64 {
    scenario.impactor.motion = Motion::Driven;
    scenario.impactor.gap = 1.0;
    let mut simulation = Simulation::new(&scenario).expect("a legal scenario");
    simulation
        .with(|model, state| {
            let grid = model.constants.grid;
            let reference = model.reference_position();
            let displacement = state.displacement_mut();
            for i in 0..2 {
                for node in 0..grid.n_node() {
                    let deformed = gradient[i][0] * reference[0][node] + gradient[i][1] * reference[1][node];
                    displacement[i][node] = deformed - reference[i][node];
                }
            }
            let input = StepInput { driven_position: Some(1.0), ..StepInput::default() };
            step(model, state, &input).expect("a step");
            let mut largest = [0.0_f64; 2];
            for v in 0..=grid.n_v {
                for u in 0..=grid.n_u {
                    let inside = v > 0 && v < grid.n_v && u > 0 && u < grid.n_u;
                    for force in state.force() {
                        let size = force[v * grid.stride() + u].abs();
                        largest[usize::from(inside)] = largest[usize::from(inside)].max(size);
                    }
                }
            }
            assert!(largest[0] > 0.0);
            largest[1] / largest[0]
        })
        .expect("memory of the right size")
}

fn round() -> Scenario {
    let mut scenario = preset::study();
    scenario.layers[0].material = elastic(0.1e6, 0.05e6, 5e6);
    // Shorter than every chord, so that the thickness is constant and a homogeneous stress is in equilibrium.
    scenario.geometry.length = 50e-3;
    scenario
}

/// Deformations of the round mesh in plane strain.
pub fn plane_strain() -> Vec<(Scenario, Gradient)> {
    [[[1.1, 0.0], [0.0, 0.95]], [[1.0, 0.2], [0.0, 1.0]], [[1.1, 0.3], [-0.2, 0.9]]].map(|g| (round(), g)).to_vec()
}

/// Deformations of a dome and a cylinder: the only homogeneous states of a body of revolution, with the same stretch
/// along radius and hoop.
pub fn axisymmetric() -> Vec<(Scenario, Gradient)> {
    let mut dome = round();
    dome.geometry.formulation = Formulation::Axisymmetric;
    let mut block = dome.clone();
    block.geometry.shape = Shape::Block;
    let gradients = [[[1.1, 0.0], [0.0, 0.9]], [[0.8, 0.0], [0.0, 1.3]]];
    [dome, block].into_iter().flat_map(|scenario| gradients.map(|g| (scenario.clone(), g))).collect()
}

/// Lines of the table.
pub fn checks() -> Vec<Check> {
    let check = |section: &str, cases: Vec<(Scenario, Gradient)>| Check {
        problem: "patch",
        quantity: format!("force on interior nodes over that on the boundary, {section}"),
        reference: "none",
        error: cases.into_iter().map(|(scenario, gradient)| residual(scenario, gradient)).fold(0.0, f64::max),
    };
    vec![check("round mesh, plane strain", plane_strain()), check("dome and cylinder, axisymmetric", axisymmetric())]
}
