//! What is said to have no effect has none, and what is not said so has one: the table of the kernel against the kernel.

use softanvil_kernel::material::{ElasticLaw, Material};
use softanvil_kernel::parameter::Kind;
use softanvil_kernel::{Parameter, Scenario, ScenarioError, Simulation, StepInput, preset};

/// Scenarios in which, together, every parameter acts and every one that can be without effect is.
fn scenarios() -> Vec<(&'static str, Scenario)> {
    let with = |given: &[(&str, f64)]| {
        let mut scenario = preset::study();
        scenario.mesh.element_size = 5e-3;
        scenario.time.duration = 4e-3;
        scenario.impactor.gap = 1e-4;
        for (name, value) in given {
            let parameter = Parameter::find_in(&scenario, name).unwrap();
            parameter.set(&mut scenario, *value).unwrap();
        }
        scenario
    };
    let terms = [
        ("silicone.prony_g_1", 0.2),
        ("silicone.prony_g_2", 0.2),
        ("silicone.prony_g_3", 0.1),
        ("silicone.prony_g_4", 0.1),
        ("silicone.prony_g_5", 0.1),
        ("silicone.maxwell_g_1", 1e5),
        ("silicone.maxwell_g_2", 1e5),
        ("silicone.maxwell_g_3", 1e5),
        ("silicone.maxwell_g_4", 1e5),
        ("silicone.maxwell_g_5", 1e5),
        ("silicone.slider_stiffness", 2e5),
        ("silicone.slider_yield_stress", 1e4),
        ("silicone.tear_stretch", 1.02),
    ];
    let ogden = [
        ("silicone.law", 3.0),
        ("silicone.ogden_mu_1", 2e5),
        ("silicone.ogden_mu_2", -1e5),
        ("silicone.ogden_mu_3", 1e4),
        ("core.interface", 0.0),
        ("impactor.drop_by", 0.0),
    ];
    let softening = [("silicone.softening_r", 1.5), ("silicone.softening_m", 1e4), ("silicone.softening_beta", 0.3)];
    let two = [
        ("layers.count", 2.0),
        ("layers[1].thickness", 1e-3),
        ("layers[1].law", 1.0),
        ("impactor.drop_by", 2.0),
        ("silicone.law", 2.0),
    ];
    let block = [("geometry.shape", 1.0), ("silicone.law", 0.0), ("silicone.volumetric_by", 0.0)];
    let axisymmetric = [("geometry.formulation", 1.0), ("time.step_by", 1.0), ("time.step", 2.5e-6)];
    let rectangular = [
        ("impactor.shape", 1.0),
        ("impactor.face_width", 0.05),
        ("impactor.face_length", 0.08),
        ("impactor.rail_friction", 10.0),
        ("impactor.rail_damping", 5.0),
    ];
    let bar = [("impactor.shape", 3.0), ("impactor.face_diameter", 0.05), ("impactor.face_length", 0.08)];
    let solid = [
        ("geometry.formulation", 2.0),
        ("geometry.shape", 1.0),
        ("geometry.length", 0.02),
        ("geometry.block_width", 0.02),
        ("silicone.law", 0.0),
    ];
    let pad = [
        ("layers.count", 2.0),
        ("layers[1].thickness", 5e-3),
        ("layers[1].width", 0.06),
        ("layers[1].interface", 1.0),
        ("layers[1].friction_coefficient", 0.2),
        ("layers[1].gap", 1e-4),
        ("silicone.width", 0.1),
    ];
    let of_law = |law: &ElasticLaw| {
        let (description, mut scenario) = (law.description(), with(&[]));
        let material = scenario.layers[0].material.with_values(*law, description.example);
        // A foam that bears the drop.
        let stiffer = if description.compressible { 20.0 } else { 1.0 };
        scenario.layers[0].material = Material { coefficients: material.coefficients.scaled(stiffer), ..material };
        (description.label, scenario)
    };
    let laws = ElasticLaw::ALL.iter().map(of_law);
    let others = [
        ("study", with(&[("impactor.drop_height", 0.2), ("impactor.drop_speed", 1.5), ("silicone.bulk_modulus", 2e7)])),
        ("all terms", with(&terms)),
        ("ogden", with(&ogden)),
        ("softening", with(&softening)),
        ("two layers", with(&two)),
        ("block", with(&block)),
        ("axisymmetric", with(&axisymmetric)),
        ("rectangular face on rails", with(&rectangular)),
        ("bar", with(&bar)),
        ("pad", with(&pad)),
        ("solid", with(&solid)),
        ("driven", with(&[("impactor.motion", 1.0)])),
        (
            "prescribed",
            with(&[("impactor.motion", 2.0), ("impactor.prescribed_speed", 2.0), ("impactor.prescribed_rise", 1e-3)]),
        ),
    ];
    others.into_iter().chain(laws).collect()
}

/// What a user can see of a run; a refused scenario by its reason.
fn run(scenario: &Scenario) -> String {
    let mut simulation = match Simulation::new(scenario) {
        Ok(simulation) => simulation,
        Err(error) => return error.to_string(),
    };
    let steps = simulation.constants().steps_in(scenario.time.duration);
    let mut stopped = None;
    for step in 0..steps {
        let time = (step + 1) as f64 * simulation.constants().dt;
        let input = StepInput { driven_position: Some(-time), ..StepInput::default() };
        if let Err(error) = simulation.step(1, &input) {
            stopped = Some(error);
            break;
        }
    }
    let scalars = simulation.scalars();
    format!("{:x} {:?} {:?} {stopped:?}", scalars.sampler.trace_hash, scalars.metrics, scalars.sampler.filter)
}

/// Another legal value.
fn other(parameter: &Parameter, scenario: &Scenario) -> f64 {
    let (value, (min, max)) = (parameter.get(scenario), parameter.range());
    match parameter.kind() {
        Kind::Choice { .. } | Kind::Count if value == max => min,
        Kind::Choice { .. } | Kind::Count => value + 1.0,
        // Coefficients that are 0 are made to be seen.
        Kind::Quantity if value == 0.0 && parameter.unit() == "Pa" => 5e4,
        Kind::Quantity if value == 0.0 => min + 1e-3 * (max - min),
        Kind::Quantity => (0.9 * value).clamp(min, max),
    }
}

#[test]
fn what_has_no_effect_changes_nothing_and_the_rest_does() {
    let scenarios = scenarios();
    let unchanged: Vec<String> = scenarios.iter().map(|(_, scenario)| run(scenario)).collect();
    for parameter in Parameter::all() {
        let mut acted = false;
        for ((name, scenario), unchanged) in scenarios.iter().zip(&unchanged) {
            let mut changed = scenario.clone();
            let set = parameter.set(&mut changed, other(&parameter, scenario));
            if parameter.layer().is_some_and(|layer| layer >= scenario.layers.len()) {
                assert!(matches!(set, Err(ScenarioError::NoEffect(_))), "{} in {name}", parameter.name());
                continue;
            }
            set.unwrap();
            // A choice may bring others into play; a value has no effect by what is chosen beside it.
            if parameter.without_effect(&changed).is_some() {
                assert_eq!(&run(&changed), unchanged, "{} in {name}", parameter.name());
            } else if !acted {
                acted = &run(&changed) != unchanged;
            }
        }
        // The parameters of the layers above are those of the first, but for how a layer sits on another one, and a duration is
        // how long is looked.
        let name = parameter.name().to_string();
        let lies_on = ["interface", "].friction_coefficient", "gap"].iter().any(|of| name.ends_with(of));
        let seen_elsewhere = match parameter.layer() {
            Some(0) => lies_on,
            Some(1) => !lies_on,
            Some(_) => true,
            None => name == "time.duration",
        };
        assert!(acted || seen_elsewhere, "{} acts nowhere", parameter.name());
    }
}
