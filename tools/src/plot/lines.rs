//! Lines through marked points: results over the value that was changed.

use plotters::chart::SeriesLabelPosition;
use plotters::element::{Circle, PathElement};
use plotters::style::Color;

use super::axis::Axis;
use super::chart::{self, legend_line};
use super::error::PlotError;
use super::style::*;

/// A line of a picture.
#[derive(Clone, Debug)]
pub struct Line {
    /// What the legend calls it.
    pub label: String,
    /// Its points, which are marked.
    pub points: Vec<(f64, f64)>,
}

/// Radius of a marked point.
const POINT: u32 = 4 * UNITS;
/// Part of the axes' height that the legend takes for each line, and around them.
const LEGEND_SHARE: (f64, f64) = (0.066, 0.04);

/// Draws `lines` over the quantity `x` (with whether its axis is logarithmic).
///
/// # Errors
/// What the drawing library refuses.
pub fn draw(title: &str, x: (&str, bool), y: &str, lines: &[Line]) -> Result<String, PlotError> {
    chart::svg(PANEL_SIZE, |area| {
        let mut chart = chart::axes(area, title, axes(x.1, lines), right_margin(lines))?;
        chart::grid(&mut chart, chart::grid_style(), [x.0, y])?;
        for (index, line) in lines.iter().enumerate() {
            let style = colour(index).stroke_width(CURVE);
            chart.draw_series(line.points.iter().map(|point| Circle::new(*point, POINT, colour(index).filled())))?;
            chart
                .draw_series([PathElement::new(line.points.clone(), style)])?
                .label(&line.label)
                .legend(move |at| PathElement::new(legend_line(at), style));
        }
        chart::legend(&mut chart, emptier_corner(x.1, lines))
    })
}

/// Room on the right, for half of the last number of the axis, which may have many digits.
fn right_margin(lines: &[Line]) -> u32 {
    let largest = lines.iter().flat_map(|line| &line.points).fold(0.0, |largest, point| f64::max(largest, point.0));
    if largest >= 1e5 { MARGIN + 2 * TICK_LABEL_SIZE } else { MARGIN }
}

/// Axes over all points, with room for the legend above them.
fn axes(logarithmic: bool, lines: &[Line]) -> [Axis; 2] {
    let range = |values: &mut dyn Iterator<Item = f64>| {
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
        if low <= high { (low, high) } else { (0.0, 1.0) }
    };
    let points = || lines.iter().flat_map(|line| line.points.iter());
    let (left, right) = range(&mut points().map(|point| point.0));
    let (bottom, top) = range(&mut points().map(|point| point.1));
    let share = (LEGEND_SHARE.0 * lines.len() as f64 + LEGEND_SHARE.1).min(0.6);
    let top = top + share / (1.0 - share) * (top - bottom).max(1e-3 * top.abs());
    let across = if logarithmic && left > 0.0 { Axis::logarithmic(left, right) } else { Axis::linear(left, right) };
    [across, Axis::linear(bottom, top)]
}

/// The upper corner on the side where the lines stay lower.
fn emptier_corner(logarithmic: bool, lines: &[Line]) -> SeriesLabelPosition {
    let place = |x: f64| if logarithmic { x.ln() } else { x };
    let points: Vec<(f64, f64)> =
        lines.iter().flat_map(|line| line.points.iter().map(|point| (place(point.0), point.1))).collect();
    let (left, right) = points.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, r), p| (l.min(p.0), r.max(p.0)));
    let highest = |side: &dyn Fn(f64) -> bool| {
        points.iter().filter(|point| side(point.0)).map(|point| point.1).fold(f64::NEG_INFINITY, f64::max)
    };
    let middle = 0.5 * (left + right);
    match highest(&|x| x < middle) < highest(&|x| x >= middle) {
        true => LEGEND_UPPER_LEFT,
        false => SeriesLabelPosition::UpperRight,
    }
}
