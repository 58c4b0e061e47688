//! One set of axes with its curves, measured values and legend.

use plotters::chart::SeriesLabelPosition;
use plotters::element::{Circle, DashedPathElement, PathElement};
use plotters::series::LineSeries;
use plotters::style::{Color, RGBColor, ShapeStyle};

use super::axis::Axis;
use super::chart::{self, Area, Chart, legend_line};
use super::curve::{Curve, Measured};
use super::error::PlotError;
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
    /// The curves.
    pub curves: Vec<Curve>,
}

/// Draws `panel` on all of `area`.
pub fn draw(area: &Area, panel: &Panel) -> Result<(), PlotError> {
    let (x_end, y_end) = extent(&panel.curves);
    let mut chart = chart::axes(area, panel.title, [Axis::from_zero(x_end), Axis::from_zero(y_end)], MARGIN)?;
    chart::grid(&mut chart, chart::grid_style(), [panel.x_description, panel.y_description])?;
    for (index, curve) in panel.curves.iter().enumerate() {
        draw_curve(&mut chart, curve, colour(index))?;
    }
    draw_measured(&mut chart, panel)?;
    chart::legend(&mut chart, panel.legend_at.clone())
}

fn line(colour: RGBColor, width: u32) -> ShapeStyle {
    colour.stroke_width(width)
}

/// The largest coordinates.
fn extent(curves: &[Curve]) -> (f64, f64) {
    let corners = curves.iter().filter_map(|curve| curve.measured.as_ref().map(Measured::corner));
    curves
        .iter()
        .flat_map(|curve| curve.points.iter().copied())
        .chain(corners)
        .fold((0.0, 0.0), |largest: (f64, f64), point| (largest.0.max(point.0), largest.1.max(point.1)))
}

fn draw_curve(chart: &mut Chart, curve: &Curve, colour: RGBColor) -> Result<(), PlotError> {
    let style = line(colour, CURVE);
    chart
        .draw_series(LineSeries::new(curve.points.iter().copied(), style))?
        .label(&curve.label)
        .legend(move |at| PathElement::new(legend_line(at), style));
    Ok(())
}

/// The measured values of all curves, each in its curve's colour, under one label.
fn draw_measured(chart: &mut Chart, panel: &Panel) -> Result<(), PlotError> {
    let mut labelled = false;
    for (index, curve) in panel.curves.iter().enumerate() {
        let style = line(colour(index), CURVE);
        match curve.measured {
            None => continue,
            Some(Measured::Level { over, force }) => {
                let points = over.map(|x| (x, force));
                let drawn = chart.draw_series([DashedPathElement::new(points, DASH.0, DASH.1, style)])?;
                if !labelled {
                    drawn
                        .label(panel.measured_label)
                        .legend(|at| DashedPathElement::new(legend_line(at), DASH.0, DASH.1, line(INK, CURVE)));
                }
            }
            Some(Measured::Point(x, y)) => {
                let drawn = chart.draw_series([Circle::new((x, y), MARKER, style)])?;
                if !labelled {
                    drawn
                        .label(panel.measured_label)
                        .legend(|(x, y)| Circle::new((x + LEGEND_LINE as i32 / 2, y), MARKER, line(INK, CURVE)));
                }
            }
        }
        labelled = true;
    }
    Ok(())
}
