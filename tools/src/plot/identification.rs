//! Pictures of test data with everything that was fitted to them, one for each kind of test.

use plotters::coord::ranged1d::Ranged;
use plotters::element::{Circle, DashedPathElement, PathElement, Text};
use plotters::style::{Color, RGBColor, ShapeStyle};
use softanvil_identify::law::{Mode, stress};
use softanvil_identify::relaxation::read::Load;
use softanvil_kernel::material::ElasticLaw;

use super::axis::Axis;
use super::chart::{self, Area, Chart, legend_line, text};
use super::error::PlotError;
use super::style::*;
use crate::identification::files::Curves;
use crate::identification::{Identification, Relaxed};

/// Radius of a measured point, which are many.
const POINT: u32 = 3 * UNITS;
/// Width of the legend beside the axes, and height of its entries.
const LEGEND_WIDTH: u32 = 230 * UNITS;
/// See [`LEGEND_WIDTH`].
const LEGEND_STEP: u32 = 26 * UNITS;
/// Width of the chosen curve, which stands out.
const CHOSEN: u32 = 2 * CURVE;
/// Points of a fitted curve.
const CURVE_POINTS: usize = 200;
/// A stress above this many kPa is shown in MPa.
const KILO_LIMIT: f64 = 2000.0;

/// What a picture shows.
struct Picture {
    title: String,
    x: (Axis, String),
    y: (Axis, String),
    measured: Vec<(f64, f64)>,
    fitted: Vec<Line>,
}

/// A fitted curve.
struct Line {
    label: String,
    colour: RGBColor,
    dashed: bool,
    chosen: bool,
    points: Vec<(f64, f64)>,
}

/// Name and SVG of each picture.
///
/// # Errors
/// What the drawing library refuses.
pub fn pictures(identification: &Identification) -> Result<Vec<(&'static str, String)>, PlotError> {
    let mut pictures = Vec::new();
    for curves in &identification.curves {
        pictures.push((curves.data.mode.name(), draw(&of_curves(identification, curves))?));
    }
    if let Some(relaxed) = &identification.relaxed {
        pictures.push(("relaxation", draw(&of_relaxation(relaxed))?));
    }
    Ok(pictures)
}

fn of_curves(identification: &Identification, curves: &Curves) -> Picture {
    let points = &curves.data.points;
    let mode = curves.data.mode;
    let rest = if mode == Mode::SimpleShear { 0.0 } else { 1.0 };
    let (low, high) =
        points.iter().fold((rest, rest), |(low, high): (f64, f64), point| (low.min(point.0), high.max(point.0)));
    let largest = points.iter().fold(0.0, |largest, point| f64::max(largest, point.1.abs()));
    let (scale, unit) = if largest > 1e3 * KILO_LIMIT { (1e-6, "MPa") } else { (1e-3, "kPa") };
    let shown = |(stretch, stress): (f64, f64)| (100.0 * (stretch - rest), scale * stress);
    let stretches: Vec<f64> = (0..=CURVE_POINTS).map(|k| low + (high - low) * k as f64 / CURVE_POINTS as f64).collect();
    let mut families: Vec<ElasticLaw> = Vec::new();
    let mut fitted = Vec::new();
    for (index, fit) in identification.fits.iter().enumerate() {
        let behind = families.iter().filter(|family| **family == fit.law.family).count();
        families.push(fit.law.family);
        let chosen = index == identification.chosen;
        let suffix = if chosen { ", chosen" } else { "" };
        let volume = identification.volume;
        let isochoric: Vec<f64> = stretches.iter().map(|l| volume.isochoric(mode, (*l, 0.0)).0).collect();
        let stresses = stress::nominal(&fit.elastic(), mode, &isochoric);
        let real = |state: (f64, f64)| volume.real(mode, state);
        fitted.push(Line {
            label: format!("{}{suffix}", fit.law.label),
            colour: shade(colour(fit.law.family as usize), behind),
            dashed: behind > 0 && !chosen,
            chosen,
            points: isochoric.into_iter().zip(stresses).map(real).map(shown).collect(),
        });
    }
    let measured: Vec<_> = points.iter().copied().map(shown).collect();
    let (bottom, top) = measured.iter().fold((0.0_f64, 0.0_f64), |(b, t), point| (b.min(point.1), t.max(point.1)));
    let (x, y) = (Axis::linear(100.0 * (low - rest), 100.0 * (high - rest)), Axis::linear(bottom, top));
    let name = mode.name().replace('-', " ");
    let strain = if mode == Mode::SimpleShear { "amount of shear (%)" } else { "engineering strain (%)" };
    Picture {
        title: format!("{}{}: test and fitted laws", name[..1].to_uppercase(), &name[1..]),
        x: (x, strain.into()),
        y: (y, format!("nominal stress ({unit})")),
        measured,
        fitted,
    }
}

/// The colour of a law that `behind` others of its family precede in the ranking: every further one is darker.
fn shade(colour: RGBColor, behind: usize) -> RGBColor {
    let darker = |part: u8| (f64::from(part) * 0.62_f64.powi(behind as i32)) as u8;
    RGBColor(darker(colour.0), darker(colour.1), darker(colour.2))
}

fn of_relaxation(relaxed: &Relaxed) -> Picture {
    let data = &relaxed.test.relaxation;
    let largest = data.loads.iter().fold(0.0, |a, b| f64::max(a, *b));
    let kilo = if largest > 1e3 * KILO_LIMIT { (1e-6, "MPa") } else { (1e-3, "kPa") };
    let (scale, unit, quantity) = match relaxed.test.load {
        Load::Force => (1.0, "N", "force"),
        Load::Normalised => (1.0, "1", "normalised load"),
        Load::Stress => (kilo.0, kilo.1, "nominal stress"),
        Load::Modulus => (kilo.0, kilo.1, "modulus"),
    };
    let first = data.times.iter().copied().find(|time| *time > 0.0).unwrap_or(1.0);
    let last = data.times.last().copied().unwrap_or(10.0);
    let times: Vec<f64> =
        (0..=CURVE_POINTS).map(|k| first * (last / first).powf(k as f64 / CURVE_POINTS as f64)).collect();
    let line = |(index, prony): (usize, &softanvil_identify::relaxation::prony::Prony)| {
        let chosen = index == relaxed.choice.chosen;
        let plural = if prony.terms.len() == 1 { "" } else { "s" };
        let suffix = if chosen { ", chosen" } else { "" };
        let loads = prony.predict(&data.history, &times);
        Line {
            label: format!("{} term{plural}{suffix}", prony.terms.len()),
            colour: if chosen { colour(0) } else { OTHERS[index % OTHERS.len()] },
            dashed: !chosen,
            chosen,
            points: times.iter().copied().zip(loads.iter().map(|load| scale * load)).collect(),
        }
    };
    let measured: Vec<_> =
        data.times.iter().zip(&data.loads).filter(|(t, _)| **t > 0.0).map(|(t, load)| (*t, scale * load)).collect();
    Picture {
        title: "Relaxation: test and Prony series".into(),
        x: (Axis::logarithmic(first, last), "time (s)".into()),
        y: (Axis::linear(0.0, scale * largest), format!("{quantity} ({unit})")),
        measured,
        fitted: relaxed.choice.series.iter().enumerate().map(line).collect(),
    }
}

/// Colours of the series that were not chosen.
const OTHERS: [RGBColor; 5] = [
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
];

fn draw(picture: &Picture) -> Result<String, PlotError> {
    chart::svg((PANEL_SIZE.0 + LEGEND_WIDTH, PANEL_SIZE.1), |area| draw_on(area, picture))
}

fn draw_on(area: &Area, picture: &Picture) -> Result<(), PlotError> {
    let (area, legend) = area.split_horizontally(PANEL_SIZE.0);
    let mut chart = chart::axes(&area, &picture.title, [picture.x.0.clone(), picture.y.0.clone()], MARGIN)?;
    chart::grid(&mut chart, chart::grid_style(), [&picture.x.1, &picture.y.1])?;
    // The chosen curve above the others, the points above all.
    picture.fitted.iter().filter(|line| !line.chosen).try_for_each(|line| draw_line(&mut chart, line))?;
    picture.fitted.iter().filter(|line| line.chosen).try_for_each(|line| draw_line(&mut chart, line))?;
    draw_measured(&mut chart, &picture.measured)?;
    draw_legend(&legend, picture)
}

/// The legend beside the axes, where it hides no curve, in the order of the ranking.
fn draw_legend(area: &Area, picture: &Picture) -> Result<(), PlotError> {
    let entry = |index: usize| [0, (TITLE_AREA + MARGIN + LEGEND_STEP * index as u32) as i32];
    let label = |text_of: &str, [x, y]: [i32; 2]| {
        let at = (x + (LEGEND_LINE + MARGIN / 2) as i32, y - LABEL_SIZE as i32 / 2);
        area.draw(&Text::new(text_of.to_string(), at, text(LABEL_SIZE)))
    };
    let [x, y] = entry(0);
    area.draw(&Circle::new((x + LEGEND_LINE as i32 / 2, y), POINT, test_style()))?;
    label("test", [x, y])?;
    for (index, line) in picture.fitted.iter().enumerate() {
        let [x, y] = entry(index + 1);
        let ends = legend_line((x, y));
        let style = line.style();
        match line.dashed {
            true => area.draw(&DashedPathElement::new(ends, DASH.0, DASH.1, style))?,
            false => area.draw(&PathElement::new(ends, style))?,
        }
        label(&line.label, [x, y])?;
    }
    Ok(())
}

/// The measured points; of those that would cover each other, the first.
fn draw_measured(chart: &mut Chart, points: &[(f64, f64)]) -> Result<(), PlotError> {
    let mut last: Option<(i32, i32)> = None;
    let shown: Vec<_> = points
        .iter()
        .copied()
        .filter(|point| {
            let at = chart.backend_coord(point);
            let apart = last.is_none_or(|(x, y)| (at.0 - x).abs().max((at.1 - y).abs()) > 2 * POINT as i32);
            if apart {
                last = Some(at);
            }
            apart
        })
        .collect();
    chart.draw_series(shown.into_iter().map(|point| Circle::new(point, POINT, test_style())))?;
    Ok(())
}

fn test_style() -> ShapeStyle {
    INK.stroke_width(3 * UNITS / 2)
}

impl Line {
    fn style(&self) -> ShapeStyle {
        self.colour.stroke_width(if self.chosen { CHOSEN } else { CURVE })
    }
}

fn draw_line(chart: &mut Chart, line: &Line) -> Result<(), PlotError> {
    let style = line.style();
    // What leaves the picture upwards or downwards is left out, not drawn over the title.
    let range = Ranged::range(chart.as_coord_spec().y_spec());
    for points in line.points.split(|point| !(range.start..=range.end).contains(&point.1)).filter(|p| p.len() > 1) {
        match line.dashed {
            true => {
                let points = points.to_vec();
                chart.draw_series([DashedPathElement::new(points, DASH.0, DASH.1, style)])?;
            }
            false => {
                chart.draw_series([PathElement::new(points.to_vec(), style)])?;
            }
        }
    }
    Ok(())
}
