use std::fmt::Display;

use softanvil_kernel::{OUTPUTS, Parameter, preset};

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
            Source::Input(_) => 2000..3000,
            Source::Output(_) | Source::KernelTime => 3000..4000,
            Source::TimeStep | Source::Elements | Source::SurfaceNodes => 4000..5000,
            Source::ContactActive | Source::TraceHash => 5000..6000,
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
