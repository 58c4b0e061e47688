//! A simulated impact beside a measured trace, both read alike, and the same impact through other instruments.

use std::fmt::Write;

use comfy_table::Table;
use serde_json::{Map, Value, json};

use crate::failure::Failure;
use crate::measurement::contact::{CLEAR_OF_NOISE, LEVEL};
use crate::measurement::curve_score::{self, CurveScore};
use crate::measurement::errors::error_percent;
use crate::measurement::quantity::{COUNT, QUANTITIES};
use crate::measurement::reading::{Reading, Record, Threshold};
use crate::measurement::series::{Sensor, Series};
use crate::output::subject::Subject;
use crate::run::{Ending, Run};
use crate::text::table::{align_right, new_plain_table, text as table_text};
use crate::text::wrap::filled;

/// Channel frequency classes of the standards, Hz.
const CLASSES: [f64; 4] = [1000.0, 600.0, 180.0, 60.0];

/// A measured trace and how near the simulated one comes to it.
pub struct TraceComparison {
    /// The measured force.
    pub measured: Series,
    /// Force from which on the measured impact lasts, N.
    pub threshold: f64,
    /// The threshold that was asked for, N, if the noise left no use of it.
    pub asked: Option<f64>,
    /// Peak force, N; none of deformation; duration, s; impulse, N s.
    pub values: [Option<f64>; COUNT],
    /// How alike the two are.
    pub score: CurveScore,
}

impl TraceComparison {
    /// Compares `record`, read by `reading`, with `measured`; `scenario_threshold`, N, is the scenario's.
    ///
    /// # Errors
    /// A trace in which nothing hits, by the threshold.
    pub fn new(
        measured: &Series,
        record: &Record,
        reading: &Reading,
        scenario_threshold: f64,
    ) -> Result<Self, Failure> {
        let peak = measured.peak();
        let asked = reading.threshold.unwrap_or(Threshold::Force(scenario_threshold)).force(peak);
        // The simulated force has the noise that was asked for.
        let own = CLEAR_OF_NOISE * reading.noise.force;
        let threshold = curve_score::clear_threshold(measured, asked.max(own));
        let score = CurveScore::new(measured, &record.series, asked).ok_or_else(|| {
            let ours = record.series.peak();
            let text = "N: nothing to compare at or above the threshold of";
            Failure::Input(format!("the peaks are {peak:.1} N measured and {ours:.1} {text} {threshold:.1} N"))
        })?;
        let (duration, impulse) = (measured.duration(threshold), measured.impulse(threshold));
        let values = [Some(peak), None, Some(duration), Some(impulse)];
        let asked = (threshold > asked).then_some(asked);
        Ok(Self { measured: measured.clone(), threshold, asked, values, score })
    }

    /// The numbers side by side, and the ratings.
    pub fn text(&self, record: &Record, ending: Ending) -> String {
        let mut table = new_plain_table(&["beside the measured trace", "measured", "Softanvil", "error"]);
        for (i, quantity) in QUANTITIES.iter().enumerate() {
            let shown = |value: f64| format!("{:.*}", quantity.decimals, value * quantity.display_scale);
            let Some(measured) = self.values[i] else { continue };
            let ours = self.simulated(record)[i];
            table.add_row([
                format!("{} ({})", quantity.label, quantity.display_unit),
                shown(measured),
                ending.marked(quantity.output, shown(ours)),
                format!("{:+.1} %", error_percent(ours, measured)),
            ]);
        }
        align_right(&mut table, 1..4);
        let score = &self.score;
        let noise = self.asked.map_or(String::new(), |asked| {
            format!(
                "! Noise reaches above {asked:.1} N: both impacts last from {:.1} N on, and a peak may be \
                 one of the noise. A filter (--cfc) takes some of it off both.\n",
                self.threshold
            )
        });
        format!(
            "{}\n{}R2 {:.4}, root mean square of the difference {:.1} % of the peak\n\
             CORA {:.3}: phase {:.3}, size {:.3}, progression {:.3}; both from {:.1} N on\n{}",
            table_text(&mut table),
            filled(&noise),
            score.r_squared,
            100.0 * score.difference,
            score.rating(),
            score.phase,
            score.size,
            score.progression,
            self.threshold,
            filled(&format!(
                "Aligned by the largest cross-correlation, {:+.3} ms from where the rising flanks have {LEVEL} of their peaks.",
                1e3 * score.alignment.beyond_flanks
            )),
        )
    }

    /// Our four numbers, duration and impulse over the same part of the trace as the measured ones.
    fn simulated(&self, record: &Record) -> [f64; COUNT] {
        let [peak, deformation, mut duration, _] = record.values;
        let threshold = if self.asked.is_some() { self.threshold } else { record.threshold };
        if self.asked.is_some() {
            duration = record.series.duration(threshold);
        }
        [peak, deformation, duration, record.series.impulse(threshold)]
    }

    fn json(&self, record: &Record) -> Value {
        let ours = self.simulated(record);
        let mut numbers = Map::new();
        for (i, quantity) in QUANTITIES.iter().enumerate() {
            if let Some(measured) = self.values[i] {
                let error = error_percent(ours[i], measured);
                let row = json!({ "measured": measured, "simulated": ours[i], "error_percent": error });
                numbers.insert(quantity.key.into(), row);
            }
        }
        let score = &self.score;
        json!({
            "threshold": self.threshold,
            "threshold_asked_for": self.asked,
            "alignment": {
                "by": "cross_correlation",
                "lag": score.alignment.lag,
                "beyond_flanks": score.alignment.beyond_flanks,
            },
            "numbers": numbers,
            "r_squared": score.r_squared,
            "root_mean_square_difference": score.difference,
            "cora": {
                "rating": score.rating(),
                "phase": score.phase,
                "size": score.size,
                "progression": score.progression,
            },
        })
    }
}

/// The four numbers as both sensors and every class give them, and as they were asked for.
pub fn channels(run: &Run, reading: &Reading, record: &Record) -> String {
    let titles = QUANTITIES.iter().map(|quantity| format!("{}\n({})", quantity.label, quantity.display_unit));
    let header: Vec<String> = std::iter::once("force".into()).chain(titles).collect();
    let mut table = new_plain_table(&header.iter().map(String::as_str).collect::<Vec<_>>());
    for (name, values) in each_channel(run, reading) {
        add(&mut table, name, &values, run.ending());
    }
    add(&mut table, format!("read: {reading}"), &record.values, run.ending());
    align_right(&mut table, 1..1 + COUNT);
    let mut text = format!("{}\n", table_text(&mut table));
    let _ = writeln!(text, "The impact lasts at forces from {:.1} N on.", record.threshold);
    if reading.noise != crate::measurement::reading::Noise::NONE {
        let noise = &reading.noise;
        let _ = writeln!(
            text,
            "Errors in what is read: {} N in every sample, {} % in the calibration, seed {}.",
            noise.force,
            100.0 * noise.calibration,
            noise.seed
        );
    }
    text
}

fn each_channel(run: &Run, reading: &Reading) -> impl Iterator<Item = (String, [f64; COUNT])> {
    let channels = [Sensor::Contact, Sensor::Core]
        .into_iter()
        .flat_map(|sensor| std::iter::once(None).chain(CLASSES.map(Some)).map(move |class| (sensor, class)));
    channels.filter_map(move |(sensor, channel_class)| {
        let channel = Reading { sensor, channel_class, threshold: reading.threshold, ..Reading::PLAIN };
        Some((channel.to_string(), channel.take(run).ok()?.values))
    })
}

fn add(table: &mut Table, name: String, values: &[f64; COUNT], ending: Ending) {
    let shown = QUANTITIES.iter().zip(values).map(|(quantity, value)| {
        ending.marked(quantity.output, format!("{:.*}", quantity.decimals, value * quantity.display_scale))
    });
    table.add_row(std::iter::once(name).chain(shown));
}

/// The same for other programs.
pub fn json(
    run: &Run,
    subject: &Subject,
    reading: &Reading,
    record: &Record,
    comparison: Option<&TraceComparison>,
) -> Value {
    let touched = run.ending() != Ending::NoContact;
    let by_key = |values: &[f64; COUNT]| -> Map<String, Value> {
        let pairs = QUANTITIES.iter().zip(values);
        pairs.map(|(quantity, value)| (quantity.key.into(), touched.then_some(*value).into())).collect()
    };
    let mut object = Map::new();
    object.insert("drop".into(), subject.json());
    object.extend(by_key(&record.values));
    object.extend(crate::output::json::of_ending(run));
    object.insert("warnings".into(), crate::output::subject::warnings(&run.constants, run.end()).into());
    object.insert("force".into(), if reading.sensor == Sensor::Core { "core" } else { "contact" }.into());
    object.insert("channel_class".into(), reading.channel_class.into());
    object.insert("threshold".into(), record.threshold.into());
    let channels: Map<String, Value> =
        each_channel(run, reading).map(|(name, values)| (name, by_key(&values).into())).collect();
    object.insert("channels".into(), channels.into());
    if let Some(comparison) = comparison {
        object.insert("comparison".into(), comparison.json(record));
    }
    object.insert("trace_hash".into(), run.trace_hash().into());
    Value::Object(object)
}
