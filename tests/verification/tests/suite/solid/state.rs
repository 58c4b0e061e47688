//! States of a solid: snapshots, instruction sets, threads, a new start, the next impact, energies.

use softanvil_kernel::material::Material;
use softanvil_kernel::scenario::{Body, Formulation, Interface, StepBy, Symmetry};
use softanvil_kernel::step::{critical_time_step, critical_time_step_with};
use softanvil_kernel::{InstructionSet, Scenario, Simulation, StepError, StepInput, preset, step_with};
use softanvil_verification::tolerance::ENERGY_RESIDUAL;

/// A coarse solid of the study.
fn anvil() -> Scenario {
    let mut scenario = preset::study();
    scenario.geometry.formulation = Formulation::Solid;
    (scenario.geometry.length, scenario.mesh.element_size, scenario.impactor.gap) = (40e-3, 7.5e-3, 0.0);
    scenario
}

/// With all mechanisms.
fn with_everything() -> Scenario {
    let mut scenario = anvil();
    let material = &mut scenario.layers[0].material;
    (material.maxwell_g[0], material.maxwell_beta[0]) = (5e4, 1e3);
    (material.slider_stiffness, material.slider_yield_stress) = (2e5, 1e4);
    (material.softening_r, material.softening_m) = (2.0, 1e5);
    (material.tear_stretch, material.tear_width, material.tear_residual) = (1.1, 1.0, 0.7);
    scenario
}

fn new(scenario: &Scenario) -> Simulation {
    Simulation::new(scenario).expect("a legal solid")
}

#[test]
fn snapshots_and_resets_go_on_with_the_same_bits() {
    let input = StepInput::default();
    let mut whole = new(&with_everything());
    whole.run(4e-3, &input).unwrap();
    let mut half = new(&with_everything());
    half.run(2e-3, &input).unwrap();
    let saved = half.save().unwrap();
    half.run(1e-3, &input).unwrap();
    half.restore(&saved).unwrap();
    half.run(2e-3, &input).unwrap();
    assert_eq!(half.scalars(), whole.scalars());
    assert_eq!(half.save().unwrap(), whole.save().unwrap());
    half.reset().unwrap();
    half.run(4e-3, &input).unwrap();
    assert_eq!(half.save().unwrap(), whole.save().unwrap());
}

#[test]
fn every_instruction_set_gives_the_same_bits() {
    let start = {
        let mut start = new(&with_everything());
        start.run(1e-3, &StepInput::default()).unwrap();
        start
    };
    let after = |set| {
        let mut anvil = start.clone();
        let steps = |model: &softanvil_kernel::Model, state: &mut softanvil_kernel::State| {
            (0..40).try_for_each(|_| step_with(set, model, state, &StepInput::default()))?;
            Ok::<_, StepError>(critical_time_step_with(set, model, state))
        };
        let (limit, element) = anvil.with(steps).unwrap().unwrap();
        (limit.to_bits(), element, anvil.save().unwrap())
    };
    for set in InstructionSet::ALL.into_iter().filter(|set| set.available()) {
        assert_eq!(after(set), after(InstructionSet::Baseline), "{set:?}");
    }
}

/// A mesh that several cores share, whose nodes move in several parts, with this part of the step that is stable at rest.
fn large(part: f64) -> Scenario {
    let mut scenario = with_everything();
    (scenario.geometry.length, scenario.mesh.element_size) = (60e-3, 3e-3);
    (scenario.time.step_by, scenario.time.step) = (StepBy::Given, 1e-7);
    let at_rest = new(&scenario).with(|model, state| critical_time_step(model, state).0).unwrap();
    scenario.time.step = part * at_rest;
    scenario
}

/// What `of` gives on so many threads.
fn on_threads<R: Send>(threads: usize, of: impl FnOnce() -> R + Send) -> R {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(of)
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let start = new(&large(0.5));
    let run = || {
        let mut anvil = start.clone();
        anvil.run(0.5e-3, &StepInput::default()).unwrap();
        let limit = anvil.with(|model, state| critical_time_step(model, state)).unwrap();
        (limit, anvil.save().unwrap())
    };
    let alone = on_threads(1, run);
    for threads in [2, 3] {
        assert!(on_threads(threads, run) == alone, "{threads} threads");
    }
}

/// The step that the monitor ends moves nothing, on one thread or two.
#[test]
fn a_step_above_the_limit_leaves_impactor_and_contact() {
    let start = new(&large(0.99));
    let fail = || {
        let mut anvil = start.clone();
        let seen = |anvil: &mut Simulation| {
            let scalars = anvil.scalars();
            let told = (scalars.impactor, scalars.force, scalars.energy, scalars.step_index);
            (told, anvil.with(|_, state| state.as_view().contact_force().map(<[_]>::to_vec)))
        };
        loop {
            let before = seen(&mut anvil);
            if let Err(error) = anvil.step(1, &StepInput::default()) {
                assert!(matches!(error, StepError::Unstable { .. }), "{error}");
                assert_eq!(seen(&mut anvil), before);
                return (error.to_string(), anvil.scalars().step_index);
            }
        }
    };
    let alone = on_threads(1, fail);
    assert!(alone.1 > 0);
    assert_eq!(on_threads(2, fail), alone);
}

/// A core that separates does not rub, whatever coefficient stands in the scenario.
#[test]
fn a_core_that_separates_does_not_rub() {
    let drop = |interface, coefficient| {
        let mut scenario = anvil();
        (scenario.core.interface, scenario.core.friction_coefficient) = (interface, coefficient);
        let mut drop = new(&scenario);
        drop.run(6e-3, &StepInput::default()).unwrap();
        assert!(drop.scalars().energy.residual().abs() < ENERGY_RESIDUAL * drop.scalars().energy.external);
        drop.scalars().sampler.trace_hash
    };
    let separating = drop(Interface::Separating, 0.3);
    assert_eq!(separating, drop(Interface::Frictional, 0.0));
    assert_ne!(separating, drop(Interface::Frictional, 0.3));
    assert_ne!(separating, drop(Interface::Sliding, 0.3));
}

/// A quarter, a half and the whole are one and the same drop.
#[test]
fn symmetry_changes_nothing_but_the_cost() {
    for body in [Body::Prism, Body::Revolved] {
        let peak = |symmetry| {
            let mut scenario = anvil();
            (scenario.geometry.body, scenario.geometry.symmetry) = (body, symmetry);
            let mut anvil = new(&scenario);
            anvil.run(5e-3, &StepInput::default()).unwrap();
            anvil.scalars().metrics.peak_force
        };
        let quarter = peak(Symmetry::Quarter);
        for symmetry in [Symmetry::Half, Symmetry::Full] {
            assert!((peak(symmetry) / quarter - 1.0).abs() < 1e-9, "{body:?}, {symmetry:?}");
        }
    }
}

/// The books close, whatever takes the energy.
#[test]
fn energies_add_up() {
    let foam = |scenario: &mut Scenario| {
        let law = softanvil_kernel::material::ElasticLaw::Hyperfoam;
        let material = scenario.layers[0].material.with_values(law, law.description().example);
        scenario.layers[0].material = Material { coefficients: material.coefficients.scaled(20.0), ..material };
    };
    let bonded = |scenario: &mut Scenario| scenario.core.interface = Interface::Bonded;
    let offset = |scenario: &mut Scenario| {
        (scenario.geometry.symmetry, scenario.impactor.offset) = (Symmetry::Half, 10e-3);
        scenario.impactor.face_diameter = 50e-3;
    };
    let changes: [&dyn Fn(&mut Scenario); 4] = [&|_| {}, &foam, &bonded, &offset];
    for (number, change) in changes.into_iter().enumerate() {
        let mut scenario = with_everything();
        change(&mut scenario);
        let mut anvil = new(&scenario);
        anvil.run(8e-3, &StepInput::default()).unwrap();
        let energy = anvil.scalars().energy;
        assert!(energy.residual().abs() < 2e-3 * energy.external, "change {number}: {energy:?}");
        assert!(energy.softening > 0.0 && energy.slider_dissipation > 0.0, "change {number}: {energy:?}");
    }
}

/// What has softened and torn is pressed deeper the next time.
#[test]
fn the_next_impact_meets_what_the_last_one_left() {
    let mut anvil = new(&with_everything());
    anvil.run(8e-3, &StepInput::default()).unwrap();
    let first = anvil.scalars().metrics.max_deformation;
    anvil.next_impact(60.0).unwrap();
    anvil.run(8e-3, &StepInput::default()).unwrap();
    let second = anvil.scalars().metrics.max_deformation;
    assert!(second > 1.001 * first, "{second} m after {first} m");
}

/// The free sides of a block fold as the mass comes back, by which the limit of the step falls once more: the step is chosen for that.
#[test]
fn a_block_holds_its_step_on_the_way_back() {
    let mut scenario = (preset::PRESETS.iter().find(|preset| preset.name == "block").unwrap().scenario)();
    scenario.geometry.formulation = Formulation::Solid;
    scenario.impactor = scenario.impactor.with_energy(9.8);
    // The limit was passed at 5.8 ms.
    new(&scenario).run(6.5e-3, &StepInput::default()).unwrap();
}
