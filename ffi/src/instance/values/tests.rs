use std::format;
use std::string::ToString;
use std::vec::Vec;

use softanvil_kernel::{Parameter, StepInput, preset};

use crate::variables::references;
use crate::variables::references::{CONTACT_ACTIVE, ELEMENTS, KERNEL_TIME, SURFACE_NODES, SURFACE_POINTS, SURFACE_X};

use super::*;

const FORCE: u32 = 3000;
const MASS: u32 = 1007;

fn reference(name: &str) -> u32 {
    references::of_parameter(Parameter::find(name).unwrap())
}

fn ready(version: Version) -> Instance {
    let mut instance = Instance::new(version);
    instance.enter_initialization();
    instance.exit_initialization().unwrap();
    instance
}

#[test]
fn arrays_and_their_length_are_of_fmi_3_alone() {
    let (of_2, of_3) = (Instance::new(Version::Fmi2), Instance::new(Version::Fmi3));
    for array in [SURFACE_X, SURFACE_POINTS] {
        assert_eq!(of_3.variable(array).unwrap().reference, array);
        assert!(matches!(of_2.variable(array), Err(Error::Unknown { reference }) if reference == array));
    }
    assert_eq!([of_3.length(SURFACE_X), of_3.length(SURFACE_POINTS), of_3.length(MASS)], [Ok(25), Ok(1), Ok(1)]);
    assert_eq!(of_3.length(999), Err(Error::Unknown { reference: 999 }));
}

#[test]
fn the_times_are_those_of_master_and_kernel() {
    let mut instance = ready(Version::Fmi2);
    let dt = instance.real(references::TIME_STEP).unwrap();
    assert!(dt > 1e-7 && dt < 5e-5, "{dt}");
    instance.do_step(0.0, 10.25 * dt).unwrap();
    assert!((instance.real(references::TIME).unwrap() - 10.25 * dt).abs() < 1e-15);
    assert!((instance.real(KERNEL_TIME).unwrap() - 10.0 * dt).abs() < 1e-15);
}

#[test]
fn the_study_has_240_triangles_under_25_nodes() {
    let mut instance = ready(Version::Fmi2);
    assert_eq!([instance.integer(ELEMENTS), instance.integer(SURFACE_NODES)], [Ok(240), Ok(25)]);
}

#[test]
fn the_results_are_those_of_the_same_drop_in_the_kernel() {
    let mut simulation = Simulation::new(&preset::study()).unwrap();
    let mut instance = ready(Version::Fmi3);
    let mut has_touched = false;
    for sample in 0..300 {
        let input = StepInput::default();
        simulation.run(50e-6, &input).unwrap();
        instance.do_step(instance.time(), 50e-6).unwrap();
        let force = instance.real(FORCE).unwrap();
        assert_eq!(Some(force), simulation.output("contact.force"), "sample {sample}");
        let of_step = simulation.output("contact.force_step").unwrap();
        assert_eq!(instance.boolean(CONTACT_ACTIVE), Ok(of_step > 0.0));
        has_touched |= of_step > 0.0;
    }
    assert!(has_touched && instance.boolean(CONTACT_ACTIVE) == Ok(false));
    let hash = format!("{:016x}", simulation.scalars().sampler.trace_hash);
    assert_eq!(instance.text(references::TRACE_HASH).unwrap(), hash.as_bytes());
}

#[test]
fn a_profile_has_as_many_values_as_points_and_a_quantity_one() {
    let mut instance = ready(Version::Fmi3);
    let mut read = |reference| {
        let mut values = Vec::new();
        instance.reals(reference, &mut |value| values.push(value)).map(|()| values)
    };
    assert_eq!(read(MASS), Ok([5.0].to_vec()));
    let x = read(SURFACE_X).unwrap();
    assert_eq!((x.len(), x[0]), (25, 0.0));
    assert!(x.windows(2).all(|pair| pair[0] < pair[1]));
    assert!(matches!(read(CONTACT_ACTIVE), Err(Error::Type { is: "Boolean", asked: "Float64", .. })));
}

#[test]
fn numbers_are_written_in_sixteen_digits() {
    assert_eq!(&hexadecimal(0x0123_4567_89ab_cdef), b"0123456789abcdef");
    assert_eq!(&hexadecimal(0xf000_0000_0000_000a), b"f00000000000000a");
    assert_eq!(&hexadecimal(0), b"0000000000000000");
}

#[test]
fn a_choice_is_read_and_set_by_its_number() {
    let law = reference("layers[0].law");
    for version in [Version::Fmi2, Version::Fmi3] {
        let mut instance = Instance::new(version);
        for number in [0, 2, 1] {
            instance.set_choices([(law, number)].into_iter()).unwrap();
            assert_eq!(instance.choice(law), Ok(number as i32));
        }
        assert!(matches!(instance.set_choices([(law, 1000)].into_iter()), Err(Error::Value(_))));
        assert!(matches!(instance.set_choices([(MASS, 1)].into_iter()), Err(Error::Type { .. })));
        assert!(matches!(instance.choice(MASS), Err(Error::Type { is: "Real" | "Float64", asked: "Enumeration", .. })));
        assert_eq!(instance.choice(law), Ok(1));
    }
}

#[test]
fn counts_are_set_beside_choices_in_fmi_2_alone() {
    let count = reference("layers.count");
    let (mut of_2, mut of_3) = (Instance::new(Version::Fmi2), Instance::new(Version::Fmi3));
    of_2.set_choices([(count, 3)].into_iter()).unwrap();
    assert_eq!(of_2.integer(count), Ok(3));
    let refused = of_3.set_choices([(count, 3)].into_iter()).unwrap_err();
    assert_eq!(refused.to_string(), "layers.count is of type Int32, not Enumeration");
    let refused = of_2.set_choices([(MASS, 3)].into_iter()).unwrap_err();
    assert_eq!(refused.to_string(), "impactor.mass is of type Real, not Integer");
    of_3.set_counts([(count, 3)].into_iter()).unwrap();
    assert_eq!(of_3.integer(count), Ok(3));
    for (instance, name) in [(&mut of_2, "Integer"), (&mut of_3, "Int32")] {
        let refused = instance.set_counts([(MASS, 3)].into_iter()).unwrap_err();
        assert!(refused.to_string().ends_with(&format!("not {name}")), "{refused}");
        let refused = instance.integer(MASS).unwrap_err();
        assert!(refused.to_string().ends_with(&format!("not {name}")), "{refused}");
    }
}

#[test]
fn lengths_are_set_in_configuration_mode_and_nothing_else_is() {
    let mut instance = Instance::new(Version::Fmi3);
    assert!(matches!(instance.set_sizes([(SURFACE_POINTS, 7)].into_iter()), Err(Error::Structural { .. })));
    instance.enter(Mode::Configuration).unwrap();
    for size in [2, 7, 10_000] {
        instance.set_sizes([(SURFACE_POINTS, size)].into_iter()).unwrap();
        assert_eq!([instance.size(SURFACE_POINTS), instance.length(SURFACE_X).map(|n| n as u64)], [Ok(size); 2]);
    }
    for size in [0, 1, 10_001, u64::MAX] {
        let Err(Error::Value(error)) = instance.set_sizes([(SURFACE_POINTS, size)].into_iter()) else {
            panic!("{size}")
        };
        assert_eq!([error.value, error.min, error.max], [size as f64, 2.0, 10_000.0]);
    }
    assert!(matches!(instance.set_sizes([(MASS, 7)].into_iter()), Err(Error::Type { asked: "UInt64", .. })));
    assert!(matches!(instance.set_reals([(MASS, 4.0)].into_iter()), Err(Error::Structural { .. })));
    assert!(matches!(instance.size(MASS), Err(Error::Type { asked: "UInt64", .. })));
    assert_eq!(instance.size(SURFACE_POINTS), Ok(10_000));
}

#[test]
fn what_cannot_be_set_or_read_is_refused_for_its_reason() {
    let instance = Instance::new(Version::Fmi3);
    assert_eq!(instance.refuse_to_set(999, "Boolean"), Error::Unknown { reference: 999 });
    assert!(matches!(instance.refuse_to_set(MASS, "Boolean"), Error::Type { is: "Float64", asked: "Boolean", .. }));
    let refused = instance.refuse_to_set(CONTACT_ACTIVE, "Boolean");
    assert!(matches!(refused, Error::ReadOnly { causality: "output", .. }), "{refused}");
    assert_eq!(instance.refuse_to_get(999, "Binary"), Error::Unknown { reference: 999 });
    assert!(matches!(instance.refuse_to_get(MASS, "Binary"), Error::Type { is: "Float64", asked: "Binary", .. }));
}

#[test]
fn parameters_are_fixed_and_inputs_are_not_once_the_drop_has_begun() {
    let force = references::EXTERNAL_FORCE;
    let mut instance = ready(Version::Fmi2);
    let refused = instance.set_reals([(MASS, 4.0)].into_iter()).unwrap_err();
    assert!(matches!(refused, Error::Fixed { value: 4.0, unit: "kg", .. }), "{refused}");
    instance.set_reals([(force, 12.5)].into_iter()).unwrap();
    assert_eq!([instance.real(force), instance.real(MASS)], [Ok(12.5), Ok(5.0)]);
    assert!(matches!(instance.set_reals([(force, 1e300)].into_iter()), Err(Error::Value(_))));
    let refused = instance.set_reals([(references::TIME, 1.0)].into_iter()).unwrap_err();
    assert!(matches!(refused, Error::ReadOnly { causality: "independent", .. }), "{refused}");
    let refused = instance.real(CONTACT_ACTIVE).unwrap_err();
    assert_eq!(refused.to_string(), "contact.active is of type Boolean, not Real");
}

#[test]
fn results_stay_readable_after_the_end() {
    let mut instance = ready(Version::Fmi2);
    instance.do_step(0.0, 5e-3).unwrap();
    let force = instance.real(FORCE).unwrap();
    assert!(force > 100.0, "{force} N");
    instance.terminate();
    assert_eq!(instance.real(FORCE), Ok(force));
    assert!(matches!(instance.set_reals([(MASS, 4.0)].into_iter()), Err(Error::Fixed { .. })));
}
