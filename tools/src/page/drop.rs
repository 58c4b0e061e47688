//! What the page's scripts draw of a drop, in mm, ms, N and J; whatever is long is packed into whole numbers of 16 bits.

use std::ops::Range;

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use serde_json::{Map, Value, json};
use softanvil_kernel::state::Scalars;
use softanvil_kernel::{Constants, OUTPUTS, Output, SAMPLING_INTERVAL};

use crate::measurement::quantity::QUANTITIES;
use crate::output::material_summary;
use crate::output::subject::warnings;
use crate::page::parameters;
use crate::paper;
use crate::plot::curve::{self, Curve};
use crate::plot::{Balance, Shown, TERMS, style};
use crate::run::{self, MARK, Run};
use crate::section::animation::DISPLACEMENT;
use crate::section::{Animation, Frame, Levels, Mesh, SHADES, SLAB};
use crate::text::number::four_digits;

/// Milliseconds in a second, millimetres in a metre.
const MILLI: f64 = 1e3;
/// Time shown before the contact and after the impact, s.
const AROUND: f64 = 0.5e-3;
/// Part of the peak force below which nothing is seen of it in a picture.
const UNSEEN: f64 = 0.01;
/// Most frames of the section, and most samples of the energies: what is between them is drawn by interpolation.
const MOST_FRAMES: usize = 100;
const MOST_SAMPLES: usize = 160;
/// Time after the contact of the first moment, ms.
const EARLY: f64 = 0.5;
/// Part of the peak force at the last moment.
const FAINT: f64 = 0.1;

/// Everything that the scripts need of a run, which is called `label` and described by `about`; beside the experiment, if it is
/// one of the paper's drops.
pub fn of(label: &str, about: &str, run: &Run, animation: &Animation) -> Map<String, Value> {
    let mut all = pictures(label, about, run, animation);
    all.append(&mut outcome(run));
    all
}

/// Whether these samples are all that the pictures of a drop show, and more: only its numbers wait for the end of the run.
pub fn is_shown(constants: &Constants, samples: &[Scalars]) -> bool {
    faint(constants, samples) > 0.0 && shown_samples(constants, samples) < samples.len()
}

/// How many of the samples the pictures show: until a little after the impact, which is over where the force stays below what
/// is measured and what is seen. The layer may still rest against the face then, for as long as the impact took.
pub fn shown_samples(constants: &Constants, samples: &[Scalars]) -> usize {
    let faint = faint(constants, samples);
    let last = samples.iter().rposition(|sample| sample.sampler.last.contact_force > faint);
    let after = 1 + (AROUND / SAMPLING_INTERVAL).round() as usize;
    last.map_or(samples.len(), |last| samples.len().min(last + 1 + after))
}

/// The force that counts as none, N.
fn faint(constants: &Constants, samples: &[Scalars]) -> f64 {
    let peak = samples.iter().map(|sample| sample.sampler.last.contact_force).fold(0.0, f64::max);
    constants.scenario.measurement.force_threshold.min(UNSEEN * peak)
}

/// What the end of a run may still change when its pictures are whole: its numbers, how it ended, and its digest.
pub fn outcome(run: &Run) -> Map<String, Value> {
    object(json!({
        "hash": run.trace_hash(),
        "ending": run.ending().key(),
        "remark": one_line(&run::remark(run)),
        "numbers": numbers(run),
    }))
}

/// The same of a run that goes on.
pub fn outcome_so_far(run: &Run) -> Map<String, Value> {
    let remark = format!("The run goes on: numbers marked {MARK} are those so far.");
    object(json!({ "hash": null, "ending": null, "remark": remark, "numbers": numbers(run), "more": true }))
}

/// The rest: the scenario, and what is drawn of the run.
pub fn pictures(label: &str, about: &str, run: &Run, animation: &Animation) -> Map<String, Value> {
    let run = &run.first(shown_samples(&run.constants, run.samples()));
    let paper = paper::case_of(&run.constants.scenario);
    let shown = [Shown { label: label.to_string(), run, experiment: paper.map(|case| case.experiment), band: None }];
    let force_time = rounded(curve::force_time(&shown));
    let force_deformation = rounded(curve::force_deformation(&shown));
    object(json!({
        "about": about,
        "scenario": parameters::values(&run.constants.scenario),
        "triangles": run.constants.grid.n_elem(),
        "words": words(run),
        "instants": force_time.as_ref().zip(force_deformation.as_ref()).map(|(time, path)| instants(time, path)),
        "force_time": force_time,
        "force_deformation": force_deformation,
        "energy": balance(&shown[0]),
        "section": animation.mesh().map(|mesh| section(run, animation, mesh)),
    }))
}

fn object(value: Value) -> Map<String, Value> {
    match value {
        Value::Object(map) => map,
        _ => Map::new(),
    }
}

/// Colours, dashes and marks of runs, and the terms of the balance: what a legend beside a picture shows.
pub fn legend() -> Value {
    let runs = (0..4).map(|run| {
        let colour = style::colour(run);
        json!({
            "colour": hex([colour.0, colour.1, colour.2]),
            "dash": style::dash(run).map(|(length, gap)| [length / style::UNITS, gap / style::UNITS]),
            "mark": style::mark(run),
        })
    });
    json!({
        "runs": runs.collect::<Vec<_>>(),
        "terms": TERMS.iter().map(|term| json!({ "label": term.label, "colour": hex(term.colour) })).collect::<Vec<_>>(),
        "shades": SHADES.iter().map(|shade| json!({ "label": shade.label, "key": shade.key })).collect::<Vec<_>>(),
    })
}

/// Bands of colour over stresses, Pa, from the lowest to the highest that are shown.
pub fn levels(range: [f64; 2]) -> Value {
    let levels = Levels::new(range);
    json!({
        "unit": levels.unit,
        "bounds": levels.bounds,
        "texts": levels.bounds.iter().map(|bound| levels.text(*bound)).collect::<Vec<_>>(),
        "colours": (0..levels.bands()).map(|band| levels.colour(band)).collect::<Vec<_>>(),
        "zero": levels.zero(),
    })
}

fn hex([r, g, b]: [u8; 3]) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// What a reader has to know before the numbers.
fn words(run: &Run) -> Vec<String> {
    let layers = run.constants.scenario.layers.iter().enumerate();
    let unphysical = layers.filter(|(_, layer)| layer.material.poissons_ratio_0() < 0.0).map(|(place, layer)| {
        format!(
            "{}: Poisson's ratio at once is {:.2}, as of no silicone, because the fit chose so small a bulk modulus; \
             take the colours of the section for those of the fit. The preset study-incompressible has a physical one.",
            material_summary::name(place, layer),
            layer.material.poissons_ratio_0()
        )
    });
    warnings(&run.constants, run.end()).into_iter().chain(unphysical).collect()
}

fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The results, those of the paper's table first, in the units of people.
fn numbers(run: &Run) -> Vec<Value> {
    let row = |output: &Output, label: &str, unit: &str, text: String| {
        json!({
            "output": output.name,
            "label": label,
            "unit": unit,
            "text": run.ending().marked(output.name, text),
            "value": run.result(output),
        })
    };
    let first = QUANTITIES.iter().filter_map(|quantity| {
        let output = Output::find(quantity.output)?;
        let text = format!("{:.*}", quantity.decimals, run.result(output) * quantity.display_scale);
        Some(row(output, quantity.label, quantity.display_unit, text))
    });
    let is_first = |output: &&Output| QUANTITIES.iter().any(|quantity| quantity.output == output.name);
    let others = OUTPUTS.iter().filter(|output| output.name.starts_with("result.") && output.name != "result.complete");
    let others = others.filter(|output| !is_first(output));
    first
        .chain(others.map(|output| row(output, output.description, output.unit, four_digits(run.result(output)))))
        .collect()
}

fn rounded(curves: Vec<Curve>) -> Option<Curve> {
    let mut curve = curves.into_iter().next()?;
    curve.points.iter_mut().for_each(|point| *point = (round(point.0, 4), round(point.1, 2)));
    Some(curve)
}

/// The balance with so few samples as a picture shows.
fn balance(shown: &Shown) -> Balance {
    let mut balance = Balance::of(shown);
    let every = balance.time.len().div_ceil(MOST_SAMPLES).max(1);
    let thinned = |values: &mut Vec<f64>, decimals| {
        *values = values.iter().step_by(every).map(|value| round(*value, decimals)).collect();
    };
    thinned(&mut balance.time, 4);
    thinned(&mut balance.external, 5);
    balance.terms.iter_mut().for_each(|(_, values)| thinned(values, 5));
    balance
}

fn section(run: &Run, animation: &Animation, mesh: &Mesh) -> Value {
    let zero = start(run);
    let frames =
        animation.frames().get(shown_frames(animation.frames(), zero, run.time(run.end()))).unwrap_or_default();
    let every = frames.len().div_ceil(MOST_FRAMES).max(1);
    let frames: Vec<&Frame> = frames.iter().step_by(every).collect();
    let displacement = packed(frames.iter().flat_map(|frame| frame.values(DISPLACEMENT)).copied().collect());
    json!({
        "mesh": mesh_data(mesh),
        "impactor": impactor(mesh),
        "time": frames.iter().map(|frame| round(MILLI * (frame.time - zero), 4)).collect::<Vec<_>>(),
        "face": frames.iter().map(|frame| round(MILLI * frame.face(), 4)).collect::<Vec<_>>(),
        "displacement": displacement,
        "shades": SHADES.iter().map(|shade| {
            packed(frames.iter().flat_map(|frame| animation.shaded(frame, shade)).collect())
        }).collect::<Vec<_>>(),
    })
}

/// Moments worth looking at, in their order, by the force over time and over deformation, whose points are of the same samples:
/// what they are, and their times, ms.
fn instants(force_time: &Curve, force_deformation: &Curve) -> Vec<Value> {
    let (forces, depths) = (&force_time.points, &force_deformation.points);
    let largest = |values: &mut dyn Iterator<Item = f64>| {
        values.enumerate().max_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(place, _)| place)
    };
    let hardest = largest(&mut forces.iter().map(|point| point.1));
    let deepest = largest(&mut depths.iter().map(|point| point.0));
    let faint = FAINT * forces.get(hardest).map_or(0.0, |point| point.1);
    let released = forces.iter().skip(deepest).find(|point| point.1 <= faint);
    let time = |place: usize| forces.get(place).map(|point| point.0);
    let found = [
        (format!("{EARLY} ms after contact"), Some(EARLY)),
        ("peak force".into(), time(hardest)),
        ("maximum compression".into(), time(deepest)),
        ("force down to a tenth".into(), released.map(|point| point.0)),
    ];
    let mut found: Vec<_> = found.into_iter().filter_map(|(label, time)| Some((label, time?))).collect();
    found.sort_by(|a, b| a.1.total_cmp(&b.1));
    found.into_iter().map(|(label, time)| json!({ "label": label, "time": time })).collect()
}

/// The time from which the pictures count, s: that at which forces are drawn that act just before contact.
fn start(run: &Run) -> f64 {
    let touching = run.samples().iter().position(|sample| sample.sampler.last.contact_force > 0.0);
    let last = touching.and_then(|first| run.samples().get(first.saturating_sub(1)));
    last.map_or(0.0, |sample| run.time(sample) - 0.5 * SAMPLING_INTERVAL)
}

/// Numbers of the frames from [`AROUND`] before the contact to the end of what is shown, s.
fn shown_frames(frames: &[Frame], zero: f64, end: f64) -> Range<usize> {
    let first = frames.iter().position(|frame| frame.time >= zero - AROUND).unwrap_or(0);
    first..frames.iter().rposition(|frame| frame.time <= end).map_or(frames.len(), |last| last + 1).max(first + 1)
}

fn impactor(mesh: &Mesh) -> Value {
    let impactor = &mesh.constants.scenario.impactor;
    let outline = mesh.impactor().into_iter();
    json!({
        "outline": outline.map(|[x, y]| [round(MILLI * (impactor.offset + x), 4), round(MILLI * y, 4)]).collect::<Vec<_>>(),
        "gap": MILLI * impactor.gap,
        "slab": MILLI * SLAB,
    })
}

fn mesh_data(mesh: &Mesh) -> Value {
    let in_mm = |value: f64| round(MILLI * value, 4);
    json!({
        "half": mesh.is_half(),
        "top": in_mm(mesh.constants.top_height),
        "reach": in_mm(mesh.reach()),
        "x": mesh.reference.iter().map(|point| in_mm(point[0])).collect::<Vec<_>>(),
        "y": mesh.reference.iter().map(|point| in_mm(point[1])).collect::<Vec<_>>(),
        "triangles": mesh.triangles,
        "outlines": mesh.outlines(),
        "core": mesh.core().into_iter().map(|point| point.map(in_mm)).collect::<Vec<_>>(),
    })
}

/// Whole multiples of a quantum, of which the largest of `values` is the largest number of 16 bits, little-endian, as base64; the
/// quantum, and the lowest and the highest value.
fn packed(values: Vec<f64>) -> Value {
    let [low, high] =
        values.iter().fold([0.0, 0.0], |[low, high]: [f64; 2], value| [low.min(*value), high.max(*value)]);
    let largest = high.max(-low);
    let quantum = if largest > 0.0 { largest / f64::from(i16::MAX) } else { 1.0 };
    let bytes: Vec<u8> = values.iter().flat_map(|value| ((value / quantum).round() as i16).to_le_bytes()).collect();
    json!({ "quantum": quantum, "low": low, "high": high, "values": BASE64_STANDARD.encode(bytes) })
}

fn round(value: f64, decimals: i32) -> f64 {
    let scale = 10f64.powi(decimals);
    (value * scale).round() / scale
}
