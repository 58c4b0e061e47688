//! Where the energy of a drop is over time: its terms stacked, under the line of what was brought in.

use plotters::chart::SeriesLabelPosition;
use plotters::coord::ranged1d::Ranged;
use plotters::element::{PathElement, Polygon, Rectangle};
use plotters::style::{Color, RGBColor};
use serde::{Deserialize, Serialize};
use softanvil_kernel::Output;

use super::axis::Axis;
use super::chart::{self, Area, Chart, legend_line};
use super::error::PlotError;
use super::look::{Look, Place, within};
use super::shown::Shown;
use super::style::*;
use crate::run::Run;

/// A term of the balance.
#[derive(Debug)]
pub struct Term {
    /// Name of the kernel's output.
    pub output: &'static str,
    /// Name for people.
    pub label: &'static str,
    /// Colour.
    pub colour: [u8; 3],
}

const fn term(output: &'static str, label: &'static str, colour: [u8; 3]) -> Term {
    Term { output, label, colour }
}

/// The terms whose sum is the energy brought in, from the bottom up: lost, stored, moving.
pub static TERMS: [Term; 11] = [
    term("energy.guide", "rails", [96, 96, 160]),
    term("energy.friction", "friction", [136, 96, 200]),
    term("energy.contact", "catching nodes", [148, 103, 60]),
    term("energy.tear", "tearing", [128, 128, 128]),
    term("energy.softening", "softening", [170, 170, 120]),
    term("energy.slider_dissipation", "damping sliders", [204, 121, 167]),
    term("energy.viscous", "viscous", [213, 94, 0]),
    term("energy.slider_stored", "damping springs", [240, 228, 66]),
    term("energy.elastic", "elastic", [0, 158, 115]),
    term("energy.layer_kinetic", "layer, kinetic", [86, 180, 233]),
    term("energy.impactor_kinetic", "impactor, kinetic", [0, 114, 178]),
];

/// The line of the sum.
pub const BROUGHT_IN: &str = "energy.external";

/// Times since contact, ms, and what each output was then.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct Balance {
    /// What it is of.
    pub title: String,
    /// Times since contact, ms.
    pub time: Vec<f64>,
    /// Those of [`TERMS`] that ever show, by their place there, and their values, J.
    pub terms: Vec<(usize, Vec<f64>)>,
    /// What was brought in, J.
    pub external: Vec<f64>,
    /// Largest part that is unexplained, J.
    pub residual: f64,
}

impl Balance {
    /// That of a run.
    pub fn of(shown: &Shown) -> Self {
        let run = shown.run;
        let values = |name: &str| of_output(run, name);
        let terms = TERMS.iter().enumerate().map(|(place, term)| (place, values(term.output)));
        let start = run.samples().iter().find(|s| s.metrics.contact_time > 0.0).map_or(0.0, |s| run.time(s));
        Self {
            title: shown.label.clone(),
            time: run.samples().iter().map(|sample| 1e3 * (run.time(sample) - start)).collect(),
            terms: terms.filter(|(_, values)| values.iter().any(|energy| *energy != 0.0)).collect(),
            external: values(BROUGHT_IN),
            residual: values("energy.residual").into_iter().fold(0.0, |largest, r| f64::max(largest, r.abs())),
        }
    }

    /// Points of `values` from the contact on.
    fn points(&self, values: &[f64]) -> Vec<(f64, f64)> {
        let inside = |(x, y): (f64, f64)| (x.max(0.0), y.max(0.0));
        self.time.iter().copied().zip(values.iter().copied()).map(inside).collect()
    }
}

/// An output at every sample of `run`.
pub fn of_output(run: &Run, name: &str) -> Vec<f64> {
    let Some(output) = Output::find(name) else { return Vec::new() };
    run.samples().iter().map(|sample| (output.read)(&run.constants, sample)).collect()
}

/// One panel for each run, from left to right.
///
/// # Errors
/// What the drawing library refuses.
pub fn draw(shown: &[Shown]) -> Result<String, PlotError> {
    chart::row_of_panels(shown, |area, shown| panel(area, &Balance::of(shown), &Look::FILE).map(|_| ()))
}

/// Draws `balance` on all of `area`; returns where the axes are.
pub fn panel(area: &Area, balance: &Balance, look: &Look) -> Result<Place, PlotError> {
    let title = format!("{}: energy (unexplained: at most {:.1e} J)", balance.title, balance.residual);
    let largest = |values: &[f64]| Axis::from_zero(values.iter().copied().fold(0.0, f64::max));
    let across = match look.window {
        Some([low, high]) => Axis::linear(low.max(0.0), high),
        None => largest(&balance.time),
    };
    let window = look.window.map(|_| [across.range().start, across.range().end]);
    let title = if look.lettered { title.as_str() } else { "" };
    let mut chart = chart::axes(area, title, [across, largest(&balance.external)], MARGIN)?;
    draw_terms(&mut chart, balance, window)?;
    // Above the terms, which it has to let through.
    chart::grid(&mut chart, INK.mix(0.12).stroke_width(THIN), ["time since contact (ms)", "energy (J)"])?;
    draw_sum(&mut chart, balance, window)?;
    if look.lettered {
        chart::legend(&mut chart, SeriesLabelPosition::LowerRight)?;
    }
    Ok(chart::place(&chart))
}

/// The stacked terms, the upper ones first, so that the legend has their order. A thin line bounds each, for those who see no
/// colours.
fn draw_terms(chart: &mut Chart, balance: &Balance, window: Option<[f64; 2]>) -> Result<(), PlotError> {
    let mut sum = vec![0.0; balance.time.len()];
    let mut layers = Vec::new();
    for (place, values) in &balance.terms {
        let below = balance.points(&sum);
        sum.iter_mut().zip(values).for_each(|(sum, value)| *sum += value);
        layers.extend(TERMS.get(*place).map(|term| (term, below, balance.points(&sum))));
    }
    for (term, below, above) in layers.into_iter().rev() {
        let colour = RGBColor(term.colour[0], term.colour[1], term.colour[2]);
        let pieces = within(&above, window).into_iter().zip(within(&below, window));
        let edges: Vec<_> = within(&above, window);
        let areas = pieces.map(|(there, back)| {
            Polygon::new(there.into_iter().chain(back.into_iter().rev()).collect::<Vec<_>>(), colour.filled())
        });
        chart.draw_series(areas)?.label(term.label).legend(move |(x, y)| {
            let half = LEGEND_LINE as i32 / 4;
            Rectangle::new([(x + half, y - half), (x + 3 * half, y + half)], colour.filled())
        });
        chart.draw_series(edges.into_iter().map(|edge| PathElement::new(edge, INK.stroke_width(THIN))))?;
    }
    Ok(())
}

fn draw_sum(chart: &mut Chart, balance: &Balance, window: Option<[f64; 2]>) -> Result<(), PlotError> {
    let points = balance.time.iter().copied().zip(balance.external.iter().copied()).filter(|(time, _)| *time >= 0.0);
    let pieces = within(&points.collect::<Vec<_>>(), window);
    let style = INK.stroke_width(CURVE);
    chart
        .draw_series(pieces.into_iter().map(|piece| PathElement::new(piece, style)))?
        .label("brought in")
        .legend(move |at| PathElement::new(legend_line(at), style));
    Ok(())
}
