//! Where the energy of a drop is over time: its terms stacked, under the line of what was brought in.

use plotters::chart::SeriesLabelPosition;
use plotters::element::{PathElement, Polygon, Rectangle};
use plotters::series::LineSeries;
use plotters::style::{Color, RGBColor};
use softanvil_kernel::Output;

use super::axis::Axis;
use super::chart::{self, Area, Chart, legend_line};
use super::error::PlotError;
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
    term("energy.friction", "friction", [0, 0, 0]),
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
struct Balance {
    title: String,
    time: Vec<f64>,
    /// Sums of the terms up to each, J, by term.
    stacked: Vec<Vec<f64>>,
    external: Vec<f64>,
    /// Largest part that is unexplained, J.
    residual: f64,
}

impl Balance {
    fn of(shown: &Shown) -> Self {
        let run = shown.run;
        let values = |name: &str| of_output(run, name);
        let mut sum = vec![0.0; run.samples().len()];
        let stacked = TERMS.iter().map(|term| {
            sum.iter_mut().zip(values(term.output)).for_each(|(sum, value)| *sum += value);
            sum.clone()
        });
        let stacked = stacked.collect();
        let start = run.samples().iter().find(|s| s.metrics.contact_time > 0.0).map_or(0.0, |s| run.time(s));
        Self {
            title: shown.label.clone(),
            time: run.samples().iter().map(|sample| 1e3 * (run.time(sample) - start)).collect(),
            stacked,
            external: values(BROUGHT_IN),
            residual: values("energy.residual").into_iter().fold(0.0, |largest, r| f64::max(largest, r.abs())),
        }
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
    chart::row_of_panels(shown, |area, shown| panel(area, &Balance::of(shown)))
}

fn panel(area: &Area, balance: &Balance) -> Result<(), PlotError> {
    let title = format!("{}: energy (unexplained: at most {:.1e} J)", balance.title, balance.residual);
    let largest = |values: &[f64]| Axis::from_zero(values.iter().copied().fold(0.0, f64::max));
    let mut chart = chart::axes(area, &title, [largest(&balance.time), largest(&balance.external)], MARGIN)?;
    draw_terms(&mut chart, balance)?;
    // Above the terms, which it has to let through.
    chart::grid(&mut chart, INK.mix(0.12).stroke_width(THIN), ["time since contact (ms)", "energy (J)"])?;
    draw_sum(&mut chart, balance)?;
    chart::legend(&mut chart, SeriesLabelPosition::LowerRight)
}

/// The stacked terms that ever show, the upper ones first, so that the legend has their order.
fn draw_terms(chart: &mut Chart, balance: &Balance) -> Result<(), PlotError> {
    let none = vec![0.0; balance.time.len()];
    for (index, term) in TERMS.iter().enumerate().rev() {
        let below = index.checked_sub(1).and_then(|below| balance.stacked.get(below)).unwrap_or(&none);
        let above = &balance.stacked[index];
        if above == below {
            continue;
        }
        let colour = RGBColor(term.colour[0], term.colour[1], term.colour[2]);
        let there = balance.time.iter().copied().zip(above.iter().copied());
        let back = balance.time.iter().copied().zip(below.iter().copied()).rev();
        let inside = |(x, y): (f64, f64)| (x.max(0.0), y.max(0.0));
        let polygon = Polygon::new(there.chain(back).map(inside).collect::<Vec<_>>(), colour.filled());
        chart.draw_series([polygon])?.label(term.label).legend(move |(x, y)| {
            let half = LEGEND_LINE as i32 / 4;
            Rectangle::new([(x + half, y - half), (x + 3 * half, y + half)], colour.filled())
        });
    }
    Ok(())
}

fn draw_sum(chart: &mut Chart, balance: &Balance) -> Result<(), PlotError> {
    let points = balance.time.iter().copied().zip(balance.external.iter().copied()).filter(|(time, _)| *time >= 0.0);
    let style = INK.stroke_width(CURVE);
    chart
        .draw_series(LineSeries::new(points, style))?
        .label("brought in")
        .legend(move |at| PathElement::new(legend_line(at), style));
    Ok(())
}
