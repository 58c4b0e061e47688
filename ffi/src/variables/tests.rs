use std::fmt::Display;

use softanvil_kernel::{OUTPUTS, Parameter, Simulation, preset};

use super::profile::Profile;

use super::*;

#[test]
fn every_row_of_the_kernels_tables_is_a_variable() {
    let table = Table::new();
    let has = |name: &dyn Display| table.rows().iter().any(|variable| variable.name == *name.to_string());
    Parameter::all().for_each(|parameter| assert!(has(&parameter.name()), "{}", parameter.name()));
    OUTPUTS.iter().for_each(|output| assert!(has(&output.name), "{}", output.name));
    assert_eq!(table.rows().iter().filter(|variable| matches!(variable.source, Source::Time)).count(), 1);
}

#[test]
fn references_and_names_are_unique() {
    let table = Table::new();
    assert!(table.rows().windows(2).all(|pair| pair[0].reference < pair[1].reference));
    for (i, variable) in table.rows().iter().enumerate() {
        assert!(table.rows()[..i].iter().all(|other| other.name != variable.name), "{}", variable.name);
    }
}

#[test]
fn references_lie_in_the_range_of_their_kind() {
    for variable in Table::new().rows() {
        let range = match variable.source {
            Source::Time => 0..1,
            Source::Parameter(parameter) => match parameter.layer() {
                Some(layer) => 7000 + 100 * layer as u32..7100 + 100 * layer as u32,
                None => 1000..1900,
            },
            Source::Points => 1900..2000,
            Source::Input(_) | Source::NextImpact => 2000..3000,
            Source::Output(_) | Source::KernelTime => 3000..4000,
            Source::TimeStep | Source::Elements | Source::SurfaceNodes => 4000..5000,
            Source::ContactActive | Source::TraceHash | Source::ImpactNumber => 5000..6000,
            Source::Profile(_) => 6000..7000,
        };
        assert!(range.contains(&variable.reference), "{}", variable.name);
    }
}

#[test]
fn lookup_finds_every_variable_and_nothing_else() {
    let table = Table::new();
    for variable in table.rows() {
        assert_eq!(table.find(variable.reference).map(|found| found.name), Some(variable.name));
    }
    for unknown in [1, 999, 1999, 6999, u32::MAX] {
        assert!(table.find(unknown).is_none());
    }
}

#[test]
fn lookup_finds_what_is_behind_a_gap() {
    let mut table = Table::new();
    let last = table.rows().iter().rposition(|variable| variable.reference < 3000).unwrap();
    let (old, new) = (table.rows[last].reference, table.rows[last].reference + 7);
    table.rows[last].reference = new;
    assert_eq!(table.find(new).map(|found| found.reference), Some(new));
    assert!((old..new).all(|gone| table.find(gone).is_none()));
}

#[test]
fn every_unit_is_defined() {
    for variable in Table::new().rows() {
        if let ValueType::Real { unit, .. } | ValueType::Array { unit } = variable.value {
            assert!(units::find(unit).is_some(), "{}: unit {unit} needs a row in units.rs", variable.name);
        }
    }
}

#[test]
fn start_values_are_legal() {
    for variable in Table::new().rows() {
        if let (Some(start), ValueType::Real { range: Some((min, max)), .. }) = (variable.start(), variable.value) {
            assert!(start >= min && start <= max, "{}", variable.name);
        }
    }
}

#[test]
fn the_token_is_stable_and_has_the_form_of_a_guid() {
    let token = token();
    assert_eq!(token, super::token());
    assert_eq!(token.as_str().len(), 38);
    assert_eq!(
        token.as_str().char_indices().filter(|(_, c)| *c == '-').map(|(i, _)| i).collect::<Vec<_>>(),
        [9, 14, 19, 24]
    );
}

#[test]
fn profiles_begin_with_the_nodes_of_the_presets_surface() {
    let simulation = softanvil_kernel::Simulation::new(&preset::study()).unwrap();
    assert_eq!(simulation.constants().grid.n_u as u64 + 1, profile::START_POINTS);
}

/// Reference, type in FMI 2.0 and 3.0, causality, variability, initial, start of one variable of each kind.
type Facts = (u32, [&'static str; 2], &'static str, &'static str, Option<&'static str>, Option<f64>);

#[test]
fn what_a_master_knows_of_each_kind_of_variable() {
    let count = references::of_parameter(Parameter::find("layers.count").unwrap());
    let motion = references::of_parameter(Parameter::find("impactor.motion").unwrap());
    let facts: [Facts; 14] = [
        (references::TIME, ["Real", "Float64"], "independent", "continuous", None, None),
        (1007, ["Real", "Float64"], "parameter", "fixed", Some("exact"), Some(5.0)),
        (count, ["Integer", "Int32"], "parameter", "fixed", Some("exact"), Some(1.0)),
        (motion, ["Enumeration"; 2], "parameter", "fixed", Some("exact"), Some(0.0)),
        (references::EXTERNAL_FORCE, ["Real", "Float64"], "input", "continuous", None, Some(0.0)),
        (references::DRIVEN_POSITION, ["Real", "Float64"], "input", "continuous", None, Some(2e-3)),
        (3000, ["Real", "Float64"], "output", "continuous", Some("calculated"), None),
        (references::KERNEL_TIME, ["Real", "Float64"], "output", "continuous", Some("calculated"), None),
        (references::TIME_STEP, ["Real", "Float64"], "calculatedParameter", "fixed", Some("calculated"), None),
        (references::ELEMENTS, ["Integer", "Int32"], "calculatedParameter", "fixed", Some("calculated"), None),
        (references::CONTACT_ACTIVE, ["Boolean"; 2], "output", "discrete", Some("calculated"), None),
        (references::TRACE_HASH, ["String"; 2], "output", "discrete", Some("calculated"), None),
        (references::SURFACE_POINTS, ["UInt64"; 2], "structuralParameter", "fixed", Some("exact"), Some(25.0)),
        (references::SURFACE_X, ["Float64"; 2], "output", "continuous", Some("calculated"), None),
    ];
    let table = Table::new();
    for (reference, names, causality, variability, initial, start) in facts {
        let variable = table.find(reference).unwrap();
        assert_eq!([Version::Fmi2, Version::Fmi3].map(|version| variable.value.name(version)), names, "{reference}");
        assert_eq!((variable.causality(), variable.variability()), (causality, variability), "{reference}");
        assert_eq!((variable.initial(), variable.start()), (initial, start), "{reference}");
        let is_of_3 = reference == references::SURFACE_X || reference == references::SURFACE_POINTS;
        assert_eq!([Version::Fmi2, Version::Fmi3].map(|version| variable.is_in(version)), [!is_of_3, true]);
    }
}

#[test]
fn units_are_made_of_those_of_the_si() {
    let base = |name: &str| units::find(name).unwrap().base;
    let times = |a: &str, b: &str| core::array::from_fn(|i| base(a)[i] + base(b)[i]);
    let over = |a: &str, b: &str| core::array::from_fn(|i| base(a)[i] - base(b)[i]);
    assert_eq!([base("kg"), base("m"), base("s")], [[1, 0, 0], [0, 1, 0], [0, 0, 1]]);
    assert_eq!(base("1"), [0; 3]);
    assert_eq!([base("m/s"), base("m/s2")], [over("m", "s"), over("m/s", "s")]);
    assert_eq!([base("N"), base("J"), base("N.s")], [times("kg", "m/s2"), times("N", "m"), times("N", "s")]);
    assert_eq!([base("Hz"), base("1/s")], [over("1", "s"); 2]);
    let area = times("m", "m");
    let volume: [i32; 3] = core::array::from_fn(|i| area[i] + base("m")[i]);
    let of_area = core::array::from_fn(|i| base("Pa")[i] + area[i]);
    let of_volume = core::array::from_fn(|i| base("kg/m3")[i] + volume[i]);
    assert_eq!([of_area, of_volume], [base("N"), base("kg")]);
    assert!(units::find("lbf").is_none());
    for unit in units::UNITS {
        assert_eq!(units::find(unit.name).map(|found| found.name), Some(unit.name));
    }
}

/// A row of the table with another value in one place.
fn with(change: impl Fn(&mut Variable)) -> u64 {
    let mut table = Table::new();
    let row = table.rows.iter().position(|variable| variable.reference == 1007).unwrap();
    change(&mut table.rows[row]);
    super::digest::digest(0, table.rows())
}

#[test]
fn the_digest_tells_whatever_a_master_can_see() {
    let unchanged = with(|_| {});
    assert_eq!(unchanged, Table::new().digest());
    let other = Parameter::find("impactor.gap").unwrap();
    let layers = ["layers[0].c10", "layers[1].c10"].map(|name| Parameter::find(name).unwrap());
    let digests = [
        unchanged,
        with(|variable| variable.reference += 1),
        with(|variable| variable.name = other.name()),
        with(|variable| variable.name = layers[0].name()),
        with(|variable| variable.name = layers[1].name()),
        with(|variable| variable.description = ""),
        with(|variable| variable.source = Source::Parameter(other)),
        with(|variable| variable.value = ValueType::Real { unit: "kg", range: Some((0.0, 1.0)) }),
        with(|variable| variable.value = ValueType::Real { unit: "kg", range: Some((0.0, 2.0)) }),
        with(|variable| variable.value = ValueType::Real { unit: "g", range: Some((0.0, 1.0)) }),
        with(|variable| variable.value = ValueType::Integer { range: None }),
        with(|variable| variable.value = ValueType::Enumeration { labels: &["ab", "c"] }),
        with(|variable| variable.value = ValueType::Enumeration { labels: &["a", "bc"] }),
        super::digest::digest(1, Table::new().rows()),
    ];
    for (i, digest) in digests.iter().enumerate() {
        assert!(!digests[..i].contains(digest), "{i}");
    }
}

/// The values of a profile at `points` points.
fn profile_of(simulation: &mut Simulation, shows: Profile, points: u64) -> Vec<f64> {
    let read = |model: &softanvil_kernel::Model, state: &mut softanvil_kernel::State| {
        let view = state.as_view();
        (0..points).map(|point| shows.at(model, &view, point, points)).collect()
    };
    simulation.with(read).unwrap()
}

#[test]
fn points_of_a_profile_are_spread_evenly_over_the_surface_at_rest() {
    // A quarter of a circle of 37.5 mm of core and 15 mm of silicone, in 24 equal parts, and their chords.
    let radius = 52.5e-3;
    let node = |number: f64| {
        let (sine, cosine) = (core::f64::consts::FRAC_PI_2 * number / 24.0).sin_cos();
        [radius * sine, radius * (cosine - 1.0)]
    };
    let mut simulation = Simulation::new(&preset::study()).unwrap();
    for points in [2, 4, 7, 25, 49, 100] {
        for (axis, shows) in [Profile::X, Profile::Height].into_iter().enumerate() {
            for (i, found) in profile_of(&mut simulation, shows, points).into_iter().enumerate() {
                let place = 24.0 * i as f64 / (points - 1) as f64;
                let (before, part) = (place.floor(), place.fract());
                let expected = (1.0 - part) * node(before)[axis] + part * node(before + 1.0)[axis];
                assert!((found - expected).abs() < 1e-15, "{points}: {i}, {found} m of {expected} m");
            }
        }
        assert!(profile_of(&mut simulation, Profile::ContactPressure, points).iter().all(|pressure| *pressure == 0.0));
    }
}

#[test]
fn under_the_face_the_surface_is_as_low_as_the_face_and_pressed() {
    let mut simulation = Simulation::new(&preset::study()).unwrap();
    simulation.run(4e-3, &softanvil_kernel::StepInput::default()).unwrap();
    let face = simulation.scalars().impactor.position;
    assert!(face < -1e-3, "{face} m");
    for points in [25, 49] {
        let height = profile_of(&mut simulation, Profile::Height, points);
        let pressure = profile_of(&mut simulation, Profile::ContactPressure, points);
        assert!((height[0] - face).abs() < 1e-5, "{} m under {face} m", height[0]);
        assert!(pressure[0] > 1e3 && pressure.iter().all(|pressure| *pressure >= 0.0));
        // Every other point of 49 is a node, and what is between them the mean of its neighbours.
        if points == 49 {
            for values in [&height, &pressure, &profile_of(&mut simulation, Profile::X, points)] {
                let between = |i: usize| 0.5 * (values[i - 1] + values[i + 1]);
                let scale = values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
                assert!((1..48).step_by(2).all(|i| (values[i] - between(i)).abs() < 1e-12 * scale));
            }
        }
    }
}
