//! A measured trace beside a drop.

use serde_json::{Value, json};
use softanvil_records::trace::Options;
use softanvil_tools::measurement::measured::Measured;
use softanvil_tools::measurement::quantity::{MAX_DEFORMATION, QUANTITIES};
use softanvil_tools::output::subject::Subject;
use softanvil_tools::plot::curve::Curve;

/// The trace in `bytes` of the file called `name`, in the time of `beside`, the force of the drop over time: from where both
/// reach the threshold of the scenario. With it its numbers, in SI, and how the file was understood.
///
/// # Errors
/// A file that is not understood.
pub fn read(subject: &Subject, name: &str, bytes: &[u8], beside: &Curve) -> Result<Value, String> {
    let measured = Measured::of(name, bytes, &Options::default(), &subject.scenario.impactor)?;
    let threshold = subject.scenario.measurement.force_threshold;
    let series = &measured.series;
    let onset = series.onset(threshold).ok_or_else(|| {
        format!("{name}: no force reaches {threshold} N, the threshold of the scenario (measurement.force_threshold)")
    })?;
    let lead = 1e-3 * reached(&beside.points, threshold);
    let curve = Curve { label: name.to_string(), points: series.since(onset - lead, threshold), measured: None };
    let values =
        [Some(series.peak()), measured.deformation, Some(series.duration(threshold)), Some(series.impulse(threshold))];
    debug_assert!(values.len() == QUANTITIES.len() && MAX_DEFORMATION == 1);
    let numbers = QUANTITIES.iter().zip(values).filter_map(|(quantity, value)| {
        let text = format!("{:.*}", quantity.decimals, value? * quantity.display_scale);
        Some((quantity.output.to_string(), json!({ "text": text, "value": value })))
    });
    Ok(json!({
        "curve": curve,
        "numbers": numbers.collect::<serde_json::Map<_, _>>(),
        "understood": measured.understood.to_string(),
    }))
}

/// When a force over time, ms and N, first reaches `threshold`, ms; 0 if it never does.
fn reached(points: &[(f64, f64)], threshold: f64) -> f64 {
    let pair = points.windows(2).find(|pair| pair[1].1 >= threshold && pair[1].1 > 0.0);
    pair.map_or(0.0, |pair| {
        let [(t0, f0), (t1, f1)] = [pair[0], pair[1]];
        t0 + (t1 - t0) * ((threshold - f0) / (f1 - f0)).clamp(0.0, 1.0)
    })
}
