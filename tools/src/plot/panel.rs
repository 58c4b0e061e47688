//! One set of axes with its curves, measured values and legend.

use plotters::chart::SeriesLabelPosition;
use plotters::coord::ranged1d::Ranged;
use plotters::element::{Circle, DashedPathElement};

use super::axis::Axis;
use super::band::{self, Corners};
use super::chart::{self, Area, Chart, legend_line};
use super::curve::{Curve, Measured};
use super::error::PlotError;
use super::look::{Look, Place, within};
use super::strokes::{self, line};
use super::style::*;

/// What a panel shows.
pub struct Panel<'a> {
    /// Above the axes.
    pub title: &'a str,
    /// Quantity and unit of the horizontal axis.
    pub x_description: &'static str,
    /// Quantity and unit of the vertical axis.
    pub y_description: &'a str,
    /// What the legend calls the measured values.
    pub measured_label: &'static str,
    /// Where the curves leave room for the legend.
    pub legend_at: SeriesLabelPosition,
    /// Bands about them, those that there are; a window shows none.
    pub bands: Vec<Corners>,
    /// The curves.
    pub curves: Vec<Curve>,
}

/// Draws `panel` on all of `area`; returns where its axes are.
pub fn draw(area: &Area, panel: &Panel, look: &Look) -> Result<Place, PlotError> {
    let title = if look.lettered { panel.title } else { "" };
    let [across, up] = axes(panel, look);
    let window = look.window.map(|_| [across.range().start, across.range().end]);
    let mut chart = chart::axes(area, title, [across, up], MARGIN)?;
    chart::grid(&mut chart, chart::grid_style(), [panel.x_description, panel.y_description])?;
    if window.is_none() {
        band::draw(&mut chart, &panel.bands)?;
    }
    for (index, curve) in panel.curves.iter().enumerate() {
        strokes::draw(&mut chart, &curve.points, (index, &curve.label), window)?;
    }
    draw_measured(&mut chart, panel, window)?;
    if look.lettered {
        chart::legend(&mut chart, panel.legend_at.clone())?;
    }
    Ok(chart::place(&chart))
}

/// The axes: from zero over everything, or over what a window shows.
fn axes(panel: &Panel, look: &Look) -> [Axis; 2] {
    let (x_end, y_end) = extent(panel);
    let Some([low, high]) = look.window else { return [Axis::from_zero(x_end), Axis::from_zero(y_end)] };
    let across = Axis::linear(low, high);
    let (low, high) = (across.range().start, across.range().end);
    let shown = panel.curves.iter().flat_map(|curve| within(&curve.points, Some([low, high]))).flatten();
    let (bottom, top) = shown.fold((f64::INFINITY, 0.0), |(b, t): (f64, f64), (_, y)| (b.min(y), t.max(y)));
    let up = if bottom < top { Axis::linear(bottom.max(0.0), top) } else { Axis::from_zero(y_end) };
    [across, up]
}

/// The largest coordinates.
fn extent(panel: &Panel) -> (f64, f64) {
    let corners = panel.curves.iter().filter_map(|curve| curve.measured.as_ref().map(Measured::corner));
    panel
        .curves
        .iter()
        .flat_map(|curve| curve.points.iter().copied())
        .chain(panel.bands.iter().flatten().copied())
        .chain(corners)
        .fold((0.0, 0.0), |largest: (f64, f64), point| (largest.0.max(point.0), largest.1.max(point.1)))
}

/// The measured values of all curves, each in its curve's colour, under one label; those that a window shows whole.
fn draw_measured(chart: &mut Chart, panel: &Panel, window: Option<[f64; 2]>) -> Result<(), PlotError> {
    let is_shown = |x: f64| window.is_none_or(|[low, high]| (low..=high).contains(&x));
    let up = chart::place(chart).values[1];
    let mut labelled = false;
    for (index, curve) in panel.curves.iter().enumerate() {
        let style = line(colour(index), CURVE);
        match curve.measured {
            Some(Measured::Level { over, force }) if over.iter().all(|x| is_shown(*x)) && force <= up[1] => {
                let points = over.map(|x| (x, force));
                let drawn = chart.draw_series([DashedPathElement::new(points, DASH.0, DASH.1, style)])?;
                if !labelled {
                    drawn
                        .label(panel.measured_label)
                        .legend(|at| DashedPathElement::new(legend_line(at), DASH.0, DASH.1, line(INK, CURVE)));
                }
            }
            Some(Measured::Point(x, y)) if is_shown(x) && y <= up[1] => {
                let drawn = chart.draw_series([Circle::new((x, y), MARKER, style)])?;
                if !labelled {
                    drawn
                        .label(panel.measured_label)
                        .legend(|(x, y)| Circle::new((x + LEGEND_LINE as i32 / 2, y), MARKER, line(INK, CURVE)));
                }
            }
            _ => continue,
        }
        labelled = true;
    }
    Ok(())
}
