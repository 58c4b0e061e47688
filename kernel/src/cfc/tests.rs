use super::*;
extern crate std;
#[cfg(not(feature = "single"))]
use std::vec::Vec;

/// The sampling interval of the kernel, s.
const T: Real = 50e-6;

/// Round-off of a filter's output, relative.
const ROUND_OFF: Real = if cfg!(feature = "single") { 2e-5 } else { 1e-13 };
/// Of a coefficient: the two ways to a small w lose up to half a last digit over w^2 of it.
const COEFFICIENT: Real = if cfg!(feature = "single") { 5e-4 } else { 1e-11 };

fn close(a: Real, b: Real, tolerance: Real) -> bool {
    (a - b).abs() <= tolerance * b.abs()
}

/// Gain of both passes, in double precision, whose sines of a second are those of whole periods, at a whole `frequency`, dB, measured on a sine of whole periods in the middle of a long record.
#[cfg(not(feature = "single"))]
fn gain(coefficients: &Coefficients, frequency: Real) -> Real {
    let angle = |i: usize| 2.0 * PI * frequency * T * i as Real;
    let mut record: Vec<Real> = (0..60_000).map(|i| math::sin(angle(i))).collect();
    filter_both_ways(coefficients, &mut record);
    // 20,000 samples are 1 s: whole periods of every whole frequency.
    let (mut sine, mut cosine) = (0.0, 0.0);
    for i in 20_000..40_000 {
        sine += record[i] * math::sin(angle(i)) / 10_000.0;
        cosine += record[i] * math::cos(angle(i)) / 10_000.0;
    }
    assert!(cosine.abs() < 1e-9, "two passes shift no phase, but {cosine} is in quadrature");
    20.0 * libm::log10(sine)
}

/// Numbers by scipy.signal.butter(2, 2.0775 * channel_class, fs=1 / interval) of SciPy 1.17.1.
#[test]
fn coefficients_are_those_of_scipys_butterworth_filter() {
    let cases = [
        (60.0, T, 0.00037300063096279705, [1.9446330455257808, -0.9461250480496319]),
        (180.0, T, 0.003182636249274009, [1.8341964218775795, -0.8469269668746755]),
        (600.0, T, 0.029806072039817024, [1.4557282139067513, -0.5749525020660194]),
        (1000.0, T, 0.07189309706838488, [1.111586176156447, -0.39915856442998654]),
        (1000.0, 1e-4, 0.21923141721900172, [0.31189654499598524, -0.18882221387199213]),
        (180.0, 8e-5, 0.007779123258970008, [1.7354619811369012, -0.7665784741727812]),
    ];
    for (channel_class, interval, a_0, b) in cases {
        let found = Coefficients::new(channel_class, interval).unwrap();
        for (found, expected) in found.a.into_iter().zip([a_0, 2.0 * a_0, a_0]).chain(found.b.into_iter().zip(b)) {
            assert!(close(found, expected, COEFFICIENT), "class {channel_class}: {found} instead of {expected}");
        }
    }
}

/// Numbers by scipy.signal.lfilter and filtfilt(padlen=0) with the filter of class 1000 at 20 kHz, SciPy 1.17.1.
#[test]
fn passes_are_those_of_scipy() {
    let coefficients = Coefficients::new(1000.0, T).unwrap();
    let record = [2.0, 0.0, 0.0, 3.0, 10.0, -4.0, 7.0, 2.0, 0.0, 0.0, 5.0, 1.0];
    let forward = [0.21567929120515467, 1.3900356716810287, 2.8250230450495595, 3.2324497946012745, 3.32823152847553];
    let mut filter = Filter::settled(0.0);
    for (sample, expected) in record[3..].iter().zip(forward) {
        assert!(close(filter.take(&coefficients, *sample), expected, ROUND_OFF));
        assert!(close(filter.value(), expected, ROUND_OFF));
    }
    let both = [
        1.584195155180052,
        1.739005582058421,
        2.15660482318255,
        2.678352147512382,
        2.998782369076389,
        2.97761665636997,
        2.7044461952091106,
        2.3125535838616083,
        1.9569577398487847,
        1.7759577051840016,
        1.7432982253183558,
        1.7472355661634125,
    ];
    let mut filtered = record;
    filter_both_ways(&coefficients, &mut filtered);
    for (found, expected) in filtered.into_iter().zip(both) {
        assert!(close(found, expected, ROUND_OFF), "{found} instead of {expected}");
    }
}

/// Corridor of SAE J211/1, figure 1: within +0.5 and -1 dB up to the class, within +0.5 and -4 dB at 5/3 of it, and at
/// least 24 dB down per octave far above; the frequencies at -3 dB are those that crash-data software lists (100, 300,
/// 1000 and 1650 Hz), within the rounding of the list and the 2 % by which the bilinear transformation at 20 kHz moves the
/// highest of them.
#[cfg(not(feature = "single"))]
#[test]
fn both_passes_stay_in_the_corridor_of_the_standard() {
    for (channel_class, three_db) in [(60.0, 100.0), (180.0, 300.0), (600.0, 1000.0), (1000.0, 1650.0)] {
        let coefficients = Coefficients::new(channel_class, T).unwrap();
        let at = |frequency| gain(&coefficients, frequency);
        for fraction in [0.1, 0.5, 1.0] {
            assert!((-1.0..0.5).contains(&at(fraction * channel_class)), "class {channel_class}");
        }
        assert!((-4.0..0.5).contains(&at(math::round(5.0 * channel_class / 3.0))), "class {channel_class}");
        assert!((at(three_db) + 3.0).abs() < 0.25, "class {channel_class}: {} dB", at(three_db));
        assert!(at(8.0 * channel_class) < at(4.0 * channel_class) - 24.0 + 0.5, "class {channel_class}");
    }
}

#[test]
fn a_constant_passes_and_an_empty_record_is_fine() {
    let coefficients = Coefficients::new(600.0, T).unwrap();
    let mut record = [7.0; 100];
    filter_both_ways(&coefficients, &mut record);
    assert!(record.iter().all(|value| close(*value, 7.0, ROUND_OFF)));
    filter_both_ways(&coefficients, &mut []);
}

#[test]
fn classes_that_the_sampling_cannot_carry_are_refused() {
    for legal in [1e-3, 60.0, 2000.0] {
        assert!(Coefficients::new(legal, T).is_ok(), "{legal}");
    }
    for refused in [0.0, -60.0, 2001.0, Real::NAN, Real::INFINITY] {
        let error = Coefficients::new(refused, T).unwrap_err();
        assert!(error.unit == "Hz" && close(error.max, 2000.0, ROUND_OFF), "{error}");
    }
    for interval in [0.0, -T, Real::NAN, Real::INFINITY] {
        assert!(Coefficients::new(60.0, interval).is_err());
    }
}
