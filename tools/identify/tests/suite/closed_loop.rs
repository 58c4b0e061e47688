//! The loop closed: coefficients fitted to a curve, put into the kernel's virtual cylinder, give the curve back; and a
//! curve from the virtual cylinder gives the coefficients back.

use softanvil_identify::law::fit::{Fit, Settings};
use softanvil_identify::law::{DataSet, Law, Mode};
use softanvil_kernel::material::Material;
use softanvil_specimen::{Compression, compress};

use crate::tolerance::CLOSED_LOOP;

fn settings() -> Settings {
    Settings::plain((0.5, 1.5))
}

/// (stretch, nominal stress) of the study's compression of a cylinder.
fn virtual_test(material: Material) -> Vec<(f64, f64)> {
    let nearly_incompressible = Material { poissons_ratio: 0.4995, ..material };
    let curve = compress(&nearly_incompressible, &Compression { cells: 4, ..Compression::study(0.67) }).unwrap();
    curve.iter().map(|point| (1.0 - point.strain, -point.stress)).collect()
}

fn interpolate(curve: &[(f64, f64)], stretch: f64) -> f64 {
    let after = curve.iter().position(|point| point.0 <= stretch).unwrap_or(curve.len() - 1).max(1);
    let (a, b) = (curve[after - 1], curve[after]);
    a.1 + (b.1 - a.1) * (stretch - a.0) / (b.0 - a.0)
}

/// The test: a stiffening compression curve, 0.18 MPa at small strain, that no law of the fit has exactly.
fn measured() -> Vec<(f64, f64)> {
    let stress = |e: f64| -0.18e6 * e * (1.0 + 0.8 * e + 2.5 * e * e + 6.0 * e.powi(4));
    (1..=50).map(|k| f64::from(k) / 100.0).map(|e| (1.0 - e, stress(e))).collect()
}

#[test]
fn fitted_coefficients_give_the_curve_back() {
    let points = measured();
    let data = [DataSet { mode: Mode::Uniaxial, points: points.clone() }];
    for name in ["mooney_rivlin_3", "yeoh_3", "ogden_2"] {
        let fit = Fit::new(Law::find(name).unwrap(), &data, &settings()).unwrap();
        let curve = virtual_test(fit.law.material(&fit.values));
        let largest = points.iter().fold(0.0, |a, point| f64::max(a, point.1.abs()));
        let square = |point: &(f64, f64)| (interpolate(&curve, point.0) - point.1).powi(2);
        let rms = (points.iter().map(square).sum::<f64>() / points.len() as f64).sqrt();
        // What the law leaves by itself is no error of the loop.
        let limit = fit.statistics.rms + CLOSED_LOOP * largest;
        println!("{name}: rms {rms:.0} Pa, of the law {:.0} Pa, of {largest:.0} Pa", fit.statistics.rms);
        assert!(rms < limit, "{name}: {rms} of {largest}, law alone {}", fit.statistics.rms);
    }
}

#[test]
fn a_virtual_curve_gives_the_coefficients_back() {
    let law = Law::find("mooney_rivlin_2").unwrap();
    let truth = [0.02e6, 0.012e6];
    let curve = virtual_test(law.material(&truth));
    let points = curve.into_iter().filter(|point| point.0 < 0.97).collect();
    let fit = Fit::new(law, &[DataSet { mode: Mode::Uniaxial, points }], &settings()).unwrap();
    let modulus = fit.shear_modulus() / (2.0 * (truth[0] + truth[1]));
    println!("{:?}: shear modulus {modulus:.4} of the truth", fit.values);
    assert!((modulus - 1.0).abs() < CLOSED_LOOP, "{modulus}");
}
