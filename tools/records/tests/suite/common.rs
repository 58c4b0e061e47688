//! The impact that the files are made of, and what must come back.

use softanvil_records::ReadError;
use softanvil_records::trace::{self, Expected, Options, Trace};

/// Mass, kg, and speed, m/s, of the drop that the impact is of.
pub const EXPECTED: Expected = Expected { mass: 5.0, speed: 2.425 };

/// Times, s, and forces, N, of half a sine of 8 ms and 4000 N that begins at 3 ms, sampled at 20 kHz for 30 ms.
pub fn impact() -> Vec<(f64, f64)> {
    (0..=600).map(|i| (5e-5 * f64::from(i), half_sine(5e-5 * f64::from(i) - 3e-3))).collect()
}

/// The force, N, at `time`, s, after the touch.
pub fn half_sine(time: f64) -> f64 {
    if (0.0..8e-3).contains(&time) { 4e3 * (std::f64::consts::PI * time / 8e-3).sin() } else { 0.0 }
}

/// Rows of the impact.
pub fn rows(row: impl Fn(usize, f64, f64) -> String) -> String {
    impact().into_iter().enumerate().map(|(index, (time, force))| row(index, time, force) + "\n").collect()
}

/// Reads `text` with `options`.
pub fn read(text: &str, options: &Options) -> Result<Trace, ReadError> {
    trace::read("drop.csv", text.as_bytes(), options, Some(&EXPECTED))
}

/// Why `text` is refused.
pub fn refusal(text: &str, options: &Options) -> String {
    read(text, options).err().unwrap_or_else(|| panic!("{}", &text[..text.len().min(200)])).to_string()
}

/// Checks that `trace` is the impact from its first sample on, to `tolerance` N.
pub fn assert_impact(trace: &Trace, tolerance: f64, what: &str) {
    let expected = impact();
    assert!(trace.times.len() >= 400, "{what}: {} samples", trace.times.len());
    for (index, (time, force)) in trace.times.iter().zip(&trace.forces).enumerate() {
        let (expected_time, expected_force) = expected[index];
        assert!((time - expected_time).abs() < 1e-9, "{what}: sample {index} at {time} s");
        assert!((force - expected_force).abs() <= tolerance, "{what}: {force} for {expected_force} N at {time} s");
    }
}
