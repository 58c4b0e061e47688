//! What the page's scripts draw, in mm, ms, N and J; whatever is long is packed into whole numbers of 16 bits.

use std::ops::Range;

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use serde_json::{Value, json};

use crate::measurement::quantity::{MAX_DEFORMATION, PEAK_FORCE};
use crate::paper::Case;
use crate::plot::curve::{self, Curve, Measured};
use crate::plot::{self, Term, style};
use crate::report::{Content, Reported, shown};
use crate::run;
use crate::section::SLAB;
use crate::section::animation::DISPLACEMENT;
use crate::section::{Animation, Frame, Levels, Mesh, SHADES};

/// Milliseconds in a second, millimetres in a metre.
const MILLI: f64 = 1e3;
/// Samples shown before the contact and after it.
const AROUND: usize = 10;

/// Everything that the scripts need.
pub fn of(content: &Content) -> Value {
    let Some(mesh) = content.drops.first().and_then(|drop| drop.animation.mesh()) else { return Value::Null };
    let impactor = &mesh.constants.scenario.impactor;
    let animations = || content.drops.iter().map(|drop| drop.animation);
    let displacements = animations().flat_map(Animation::frames).flat_map(|frame| frame.values(DISPLACEMENT));
    let displacement = quantum(displacements.copied());
    let ranges = SHADES.each_ref().map(|shade| {
        let ranges = animations().map(|animation| animation.range(shade));
        ranges.fold([0.0, 0.0], |[a, b]: [f64; 2], [low, high]| [a.min(low), b.max(high)])
    });
    let stresses = ranges.map(|[low, high]| quantum([low, high].into_iter()));
    let terms = terms(content);
    let times = curve::force_time(&shown(content));
    let loops = curve::force_deformation(&shown(content));
    let drops = content.drops.iter().zip(times.iter().zip(&loops)).enumerate();
    json!({
        "mesh": mesh_data(mesh),
        "impactor": {
            "outline": mesh.impactor().into_iter().map(|[x, y]| [round(MILLI * (impactor.offset + x), 4), round(MILLI * y, 4)])
                .collect::<Vec<_>>(),
            "gap": MILLI * impactor.gap,
            "slab": MILLI * SLAB,
        },
        "displacement_quantum": MILLI * displacement,
        "shades": SHADES.iter().zip(ranges).zip(stresses).map(|((shade, range), quantum)| {
            let levels = Levels::new(range);
            json!({
                "label": shade.label,
                "unit": levels.unit,
                "quantum": quantum * levels.scale,
                "bounds": levels.bounds.iter().map(|bound| bound * levels.scale).collect::<Vec<_>>(),
                "texts": levels.bounds.iter().map(|bound| levels.text(*bound)).collect::<Vec<_>>(),
                "colours": (0..levels.bands()).map(|band| levels.colour(band)).collect::<Vec<_>>(),
                "zero": levels.zero(),
            })
        }).collect::<Vec<_>>(),
        "terms": terms.iter().map(|term| json!({
            "label": term.label, "colour": hex(term.colour)
        })).collect::<Vec<_>>(),
        "animations": drops.map(|(number, (drop, (time, path)))| {
            let mut value = animation_data(drop.animation, displacement, &stresses);
            value["label"] = format!("{}{}", drop.label, run::suffix(drop.run)).into();
            value["colour"] = hex({ let c = style::colour(number); [c.0, c.1, c.2] }).into();
            value["curve"] = curve_data(time, path);
            value["measured"] = drop.paper.map_or(Value::Null, |case| measured(case, time));
            value["energy"] = energy(drop, &terms);
            value
        }).collect::<Vec<_>>(),
    })
}

fn hex([r, g, b]: [u8; 3]) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
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

/// Numbers of the frames that are shown: those in contact, and some around them.
fn range(animation: &Animation) -> Range<usize> {
    let loaded =
        animation.frames().iter().rposition(|frame| frame.scalars.sampler.last.contact_force > 0.0).unwrap_or(0);
    animation.contact().saturating_sub(AROUND)..animation.frames().len().min(loaded + 1 + AROUND)
}

/// Time since contact, ms.
fn since_contact(animation: &Animation, frame: &Frame) -> f64 {
    round(MILLI * animation.since_contact(frame), 4)
}

fn animation_data(animation: &Animation, displacement: f64, stresses: &[f64; 2]) -> Value {
    let range = range(animation);
    let frames = animation.frames().get(range.clone()).unwrap_or_default();
    let each = |value: &dyn Fn(&Frame) -> f64| frames.iter().map(value).collect::<Vec<_>>();
    let instants = animation.instants().into_iter().filter(|instant| range.contains(&instant.frame));
    json!({
        "time": each(&|frame| since_contact(animation, frame)),
        "force": each(&|frame| round(frame.scalars.sampler.last.contact_force, 2)),
        "deformation": each(&|frame| round(MILLI * frame.scalars.impactor.deformation(), 4)),
        "face": each(&|frame| round(MILLI * frame.face(), 4)),
        "displacement": packed(frames.iter().flat_map(|frame| frame.values(DISPLACEMENT).to_vec()), displacement),
        "shades": SHADES.iter().zip(stresses).map(|(shade, quantum)| {
            packed(frames.iter().flat_map(|frame| animation.shaded(frame, shade)), *quantum)
        }).collect::<Vec<_>>(),
        "instants": instants.map(|instant| json!({
            "label": instant.label, "frame": instant.frame - range.start
        })).collect::<Vec<_>>(),
    })
}

fn curve_data(time: &Curve, path: &Curve) -> Value {
    json!({
        "time": time.points.iter().map(|point| round(point.0, 4)).collect::<Vec<_>>(),
        "force": time.points.iter().map(|point| round(point.1, 2)).collect::<Vec<_>>(),
        "deformation": path.points.iter().map(|point| round(point.0, 4)).collect::<Vec<_>>(),
    })
}

fn measured(case: &Case, time: &Curve) -> Value {
    let over = match time.measured {
        Some(Measured::Level { over, .. }) => over,
        _ => [0.0, 0.0],
    };
    json!({
        "force": case.experiment[PEAK_FORCE],
        "deformation": MILLI * case.experiment[MAX_DEFORMATION],
        "over": over,
    })
}

/// The terms of the balance that occur in any of the runs.
fn terms(content: &Content) -> Vec<&'static Term> {
    let occurs = |term: &&Term| {
        content.drops.iter().any(|drop| plot::of_output(drop.run, term.output).iter().any(|e| *e != 0.0))
    };
    plot::TERMS.iter().filter(occurs).collect()
}

fn energy(drop: &Reported, terms: &[&Term]) -> Value {
    let animation = drop.animation;
    let numbers = |name: &str| plot::of_output(drop.run, name).into_iter().map(|e| round(e, 5)).collect::<Vec<_>>();
    json!({
        "time": animation.frames().iter().map(|frame| since_contact(animation, frame)).collect::<Vec<_>>(),
        "terms": terms.iter().map(|term| numbers(term.output)).collect::<Vec<_>>(),
        "external": numbers(plot::BROUGHT_IN),
    })
}

/// The unit in which the largest of `values` is the largest number of 16 bits.
fn quantum(values: impl Iterator<Item = f64>) -> f64 {
    let largest = values.fold(0.0, |largest, value| f64::max(largest, value.abs()));
    if largest > 0.0 { largest / f64::from(i16::MAX) } else { 1.0 }
}

/// Whole multiples of `quantum`, little-endian, as base64.
fn packed(values: impl Iterator<Item = f64>, quantum: f64) -> String {
    let bytes = values.flat_map(|value| ((value / quantum).round() as i16).to_le_bytes());
    BASE64_STANDARD.encode(bytes.collect::<Vec<_>>())
}

fn round(value: f64, decimals: i32) -> f64 {
    let scale = 10f64.powi(decimals);
    (value * scale).round() / scale
}
