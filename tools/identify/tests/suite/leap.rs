//! The foam "leap" (data/foam): its fit by compression, tension and shear together.

use std::path::Path;

use softanvil_identify::data::curve::{self, Options};
use softanvil_identify::law::fit::{Fit, Settings, Weighting, predict};
use softanvil_identify::law::foam::search;
use softanvil_identify::law::parts::Part;
use softanvil_identify::law::{DataSet, FOAMS, Law, Mode};
use softanvil_kernel::preset::elastomeric_foam;

use crate::tolerance::FREE_STRETCH;

fn points(name: &str, shear: bool) -> Vec<(f64, f64)> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/foam").join(name);
    let curve = curve::read(name, &std::fs::read(path).unwrap(), &Options { shear, ..Options::default() }).unwrap();
    let rest = if shear { 1.0 } else { 0.0 };
    curve.repeats[0].points.iter().map(|point| (point.stretch - rest, point.stress)).collect()
}

fn data() -> Vec<DataSet> {
    let uniaxial = [points("compression.csv", false), points("tension.csv", false)].concat();
    let shear = points("shear.csv", true);
    vec![DataSet { mode: Mode::Uniaxial, points: uniaxial }, DataSet { mode: Mode::SimpleShear, points: shear }]
}

fn settings() -> Settings {
    Settings { weighting: Weighting::Tests, ..Settings::plain((0.2, 1.5)) }
}

/// Root mean squares over the largest stresses of compression, tension and shear, %, to a tenth.
fn misfits(values: &[f64], data: &[DataSet]) -> Vec<f64> {
    let measured: Vec<f64> = data.iter().flat_map(|set| set.points.iter().map(|point| point.1)).collect();
    let law = FOAMS.iter().find(|law| law.parameters.len() == values.len()).unwrap();
    let stresses = predict(law, values, data);
    let parts = Part::list(data);
    parts.iter().map(|part| (1e3 * part.misfit(&stresses, &measured).relative()).round() / 10.0).collect()
}

/// Source: a plain least-squares fit of two terms, made elsewhere, with 1.2, 6.2 and 1.2 %.
#[test]
fn two_terms_are_as_near_as_a_plain_least_squares_fit() {
    let data = data();
    let fit = Fit::new(Law::find("foam_2").unwrap(), &data, &settings()).unwrap();
    let misfits = misfits(&fit.values, &data);
    assert!(misfits.iter().zip([1.2, 6.2, 1.2]).all(|(found, legal)| *found <= legal), "{misfits:?}");
    assert!(fit.is_stable && fit.is_usable() && fit.values[0] > 0.0 && fit.values[3] > 0.0, "{:?}", fit.values);
}

/// What the documents of the preset's foam say of it.
#[test]
fn the_preset_s_foam_is_that_fit_rounded() {
    let foam = elastomeric_foam();
    let names = ["foam_mu_1", "foam_alpha_1", "foam_nu_1", "foam_mu_2", "foam_alpha_2", "foam_nu_2"];
    let values: Vec<f64> = names.iter().map(|name| foam.coefficient(name).unwrap()).collect();
    assert_eq!(misfits(&values, &data()), [0.9, 6.2, 1.2]);
}

/// The stresses by which the search goes, with their own solution for the free stretch, are the kernel's.
#[test]
fn the_search_s_stresses_are_the_kernel_s() {
    let ranges = [(Mode::Uniaxial, 0.15, 1.6), (Mode::Planar, 0.3, 1.4), (Mode::Equibiaxial, 0.4, 1.3)];
    let ranges = ranges.into_iter().chain([(Mode::SimpleShear, -0.8, 0.8)]);
    let set = |(mode, low, high): (Mode, f64, f64)| {
        let stretch = |k: u32| low + (high - low) * f64::from(k) / 40.0;
        DataSet { mode, points: (0..=40).map(|k| (stretch(k), 0.0)).collect() }
    };
    let data: Vec<DataSet> = ranges.map(set).collect();
    for (name, values) in [
        ("foam_1", &[1e5, 8.0, 0.0][..]),
        ("foam_2", &[113.4e3, 11.9, 0.123, 2.44e3, -0.189, 0.499]),
        ("foam_3", &[5e4, 16.0, 0.2, 2e4, -3.0, 0.45, 1e4, 1.5, 0.1]),
    ] {
        let (kernel, own) = (predict(Law::find(name).unwrap(), values, &data), search::predict(values, &data));
        for (k, (kernel, own)) in kernel.iter().zip(&own).enumerate() {
            assert!((kernel - own).abs() <= FREE_STRETCH * kernel.abs().max(1.0), "{name} {k}: {kernel} {own}");
        }
    }
}

/// Compression alone does not tell the ratio, which is then taken as known and has no error.
#[test]
fn a_known_ratio_is_no_parameter_of_the_fit() {
    let data = [DataSet { mode: Mode::Uniaxial, points: points("compression.csv", false) }];
    let known = Settings { poissons_ratio: Some(0.0), ..settings() };
    let fit = Fit::new(Law::find("foam_2").unwrap(), &data, &known).unwrap();
    assert_eq!((fit.values[2], fit.values[5], fit.statistics.n_parameter), (0.0, 0.0, 4));
    assert!(fit.statistics.standard_errors[2] == 0.0 && fit.statistics.standard_errors[0] > 0.0);
    assert!(misfits(&fit.values, &data)[0] < 2.0, "{:?}", misfits(&fit.values, &data));
}
