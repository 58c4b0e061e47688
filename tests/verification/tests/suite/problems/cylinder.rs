//! The study's material tests on a virtual cylinder: compression at three rates, relaxation, and bonded ends.
//!
//! Source: homogeneous uniaxial compression of a compressible body, whose jacobian follows from no stress across, with
//! the exact recurrence of a Prony series for a piecewise linear elastic stress, e.g. Simo and Hughes, Computational
//! Inelasticity (1998). What is left is the inertia of a test in 40 periods of the specimen's vibration.

use softanvil_specimen::{Compression, Error, STUDY_RATES, compress};
use softanvil_verification::problems::cylinder::{
    CELLS, HOLD, bonded_equilibrium, bonded_stress, frictionless_error, study_silicone, viscoelastic,
};
use softanvil_verification::tolerance::{CYLINDER, CYLINDER_BONDED, CYLINDER_STUDY, relative_error};

#[test]
fn compression_and_relaxation_follow_the_closed_form() {
    let relaxation = Compression::study_relaxation(HOLD);
    for test in STUDY_RATES.map(Compression::study).into_iter().chain([relaxation]) {
        let error = frictionless_error(&viscoelastic(), &test);
        assert!(error < CYLINDER, "{test:?}: {error:e}");
        let error = frictionless_error(&study_silicone(), &test);
        assert!(error < CYLINDER_STUDY, "the study's silicone, {test:?}: {error:e}");
    }
}

/// The inertia of the shortened test is what is off: it falls with the periods in the travel.
#[test]
fn the_error_of_the_shortened_time_falls_with_its_length() {
    let error = |periods| frictionless_error(&viscoelastic(), &Compression { periods, ..Compression::study(0.67) });
    let (short, long) = (error(10.0), error(40.0));
    assert!(long < 0.3 * short, "{short:e} and {long:e}");
}

#[test]
fn bonded_ends_come_to_the_equilibrium_of_their_mesh() {
    let (mut before, mut stresses) = (f64::MAX, Vec::new());
    for cells in CELLS {
        let (stress, equilibrium) = (bonded_stress(cells), bonded_equilibrium(cells));
        assert!(relative_error(stress, equilibrium) < CYLINDER_BONDED, "{cells} cells: {stress} and {equilibrium} Pa");
        // Linear elements are too stiff.
        assert!(stress < before, "{cells} cells: {stress} Pa");
        stresses.push(stress);
        before = stress;
    }
    assert!(relative_error(stresses[1], stresses[2]) < relative_error(stresses[0], stresses[1]), "{stresses:?}");
}

/// The real time of a test is only that of its material: what has no memory gives the same stress at every rate.
#[test]
fn points_run_in_real_time_to_the_end_of_the_hold() {
    for (rate, hold) in [(0.0067, 0.0), (0.67, 5.0), (0.67, 300.0)] {
        let test = Compression { hold, ..Compression::study(rate) };
        let curve = compress(&viscoelastic(), &test).expect("a legal test");
        assert!(curve.is_sorted_by(|a, b| a.time < b.time && a.strain <= b.strain));
        let end = curve[curve.len() - 1];
        // The smooth start takes a twentieth more.
        let wanted = 1.05 * test.travel_time() + hold;
        assert!((end.time - wanted).abs() < 0.02 * wanted, "{} s of {wanted} s", end.time);
        assert!((end.strain - test.strain).abs() < 1e-3 * test.strain);
    }
}

#[test]
fn a_test_that_makes_no_sense_is_refused_by_name() {
    let good = Compression::study(0.67);
    for (test, name) in [
        (Compression { strain: 1.0, ..good }, "strain"),
        (Compression { strain_rate: 0.0, ..good }, "strain_rate"),
        (Compression { height: f64::NAN, ..good }, "height"),
        (Compression { hold: -1.0, ..good }, "hold"),
        (Compression { cells: 0, ..good }, "cells"),
        (Compression { periods: 0.0, ..good }, "periods"),
    ] {
        match compress(&viscoelastic(), &test) {
            Err(Error::Test { name: refused, .. }) => assert_eq!(refused, name),
            other => panic!("{name}: {other:?}"),
        }
    }
}
