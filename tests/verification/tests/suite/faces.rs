//! Faces that are narrower than the anvil, or round: what is refused, what counts as what, and that nothing gets into them.

use softanvil_kernel::scenario::{FaceShape, Formulation, Section};
use softanvil_kernel::{Scenario, Simulation, StepInput, preset};
use softanvil_verification::tolerance::relative_error;

fn with_face(shape: FaceShape, formulation: Formulation, diameter: f64) -> Scenario {
    let mut scenario = preset::study();
    (scenario.impactor.shape, scenario.geometry.formulation) = (shape, formulation);
    scenario.impactor.face_diameter = diameter;
    scenario.impactor = scenario.impactor.with_energy(5.0);
    scenario
}

/// The deepest that a surface node gets into the face, over the element size, and the largest residual over the energy.
fn drop(scenario: &Scenario) -> [f64; 2] {
    let mut simulation = Simulation::new(scenario).unwrap();
    let steps = simulation.constants().steps_in(scenario.time.duration);
    let (mut deepest, mut residual) = (0.0_f64, 0.0_f64);
    for _ in 0..steps {
        simulation.step(1, &StepInput::default()).unwrap();
        let energy = simulation.scalars().energy;
        residual = residual.max(energy.residual().abs() / scenario.impactor.drop_energy);
        deepest = deepest.max(depth(&mut simulation));
    }
    assert!(simulation.scalars().metrics.peak_force > 100.0);
    [deepest / scenario.mesh.element_size, residual]
}

/// How deep the deepest surface node is in the face, m.
fn depth(simulation: &mut Simulation) -> f64 {
    simulation
        .with(|model, state| {
            let (constants, view) = (model.constants, state.as_view());
            let face = constants.top_height + state.scalars.impactor.position;
            let nodes = (0..=constants.grid.n_u)
                .map(|u| softanvil_kernel::contact::surface::surface_position(model, &view, u).unwrap());
            let depth = |[x, y]: [f64; 2]| {
                let beside = (x - constants.scenario.impactor.offset).abs();
                let within = beside < constants.outline.half_width();
                if within { y - face - constants.outline.height(beside) } else { 0.0 }
            };
            nodes.map(depth).fold(0.0, f64::max)
        })
        .unwrap()
}

#[test]
fn nothing_gets_into_a_face_and_the_books_close() {
    let mut beside = with_face(FaceShape::Bar, Formulation::PlaneStrain, 40e-3);
    (beside.geometry.section, beside.impactor.offset, beside.impactor.face_length) = (Section::Full, 7e-3, 0.1);
    let mut rectangular = with_face(FaceShape::Rectangular, Formulation::PlaneStrain, 0.13);
    (rectangular.impactor.face_width, rectangular.impactor.face_length) = (40e-3, 0.1);
    for scenario in [
        with_face(FaceShape::Round, Formulation::PlaneStrain, 50e-3),
        with_face(FaceShape::Round, Formulation::Axisymmetric, 30e-3),
        with_face(FaceShape::Sphere, Formulation::Axisymmetric, 60e-3),
        rectangular,
        beside,
    ] {
        let [deepest, residual] = drop(&scenario);
        assert!(deepest < 0.01, "{:?}: {deepest} of a cell", scenario.impactor.shape);
        assert!(residual < 5e-3, "{:?}: {residual} of the energy", scenario.impactor.shape);
    }
}

fn peak(scenario: &Scenario) -> f64 {
    let mut simulation = Simulation::new(scenario).unwrap();
    simulation.run(scenario.time.duration, &StepInput::default()).unwrap();
    simulation.scalars().metrics.peak_force
}

/// A rectangle is a disc of its area over a dome; a narrow disc is a rectangle of its area and width in plane strain; a
/// longer face than the layers have no more to press.
#[test]
fn faces_count_as_they_are_said_to() {
    let disc = peak(&with_face(FaceShape::Round, Formulation::Axisymmetric, 40e-3));
    let mut rectangular = with_face(FaceShape::Rectangular, Formulation::Axisymmetric, 0.13);
    let area = std::f64::consts::PI * 20e-3 * 20e-3;
    (rectangular.impactor.face_width, rectangular.impactor.face_length) = (50e-3, area / 50e-3);
    assert!(relative_error(peak(&rectangular), disc) < 1e-6);

    let disc = peak(&with_face(FaceShape::Round, Formulation::PlaneStrain, 50e-3));
    rectangular.geometry.formulation = Formulation::PlaneStrain;
    rectangular.impactor.face_length = 0.25 * std::f64::consts::PI * 50e-3;
    assert!(relative_error(peak(&rectangular), disc) < 1e-6);

    rectangular.impactor.face_length = rectangular.geometry.length;
    let whole = peak(&rectangular);
    rectangular.impactor.face_length *= 2.0;
    assert_eq!(peak(&rectangular), whole);
}

/// A face of whatever kind that is wide enough comes to the same.
#[test]
fn a_wide_rectangular_face_is_flat() {
    let round = with_face(FaceShape::Round, Formulation::Axisymmetric, 0.13);
    let mut wide = with_face(FaceShape::Rectangular, Formulation::Axisymmetric, 0.13);
    (wide.impactor.face_width, wide.impactor.face_length) = (0.2, 0.2);
    assert_eq!(peak(&round), peak(&wide));
    // A ball that is far larger than the anvil is nearly flat.
    let ball = with_face(FaceShape::Sphere, Formulation::Axisymmetric, 10.0);
    assert!(relative_error(peak(&ball), peak(&round)) < 0.05, "{} against {}", peak(&ball), peak(&round));
}

#[test]
fn faces_that_do_not_fit_are_refused() {
    let refusal = |scenario: &Scenario| Simulation::new(scenario).err().map(|error| error.to_string());
    for (scenario, message) in [
        (
            with_face(FaceShape::Sphere, Formulation::PlaneStrain, 50e-3),
            "impactor.shape = sphere is refused: expected round, rectangular or bar with geometry.formulation = plane_strain",
        ),
        (
            with_face(FaceShape::Bar, Formulation::Axisymmetric, 50e-3),
            "impactor.shape = bar is refused: expected round, rectangular or sphere with geometry.formulation = axisymmetric",
        ),
        (
            with_face(FaceShape::Round, Formulation::PlaneStrain, 5e-3),
            "impactor.face_diameter = 0.005 m is refused: expected at least 0.006 m on this mesh, or a smaller mesh.element_size",
        ),
    ] {
        assert_eq!(refusal(&scenario).as_deref(), Some(message));
    }
}
