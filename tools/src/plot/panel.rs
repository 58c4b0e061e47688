//! One set of axes with its curves, measured values and legend.

use plotters::chart::{ChartBuilder, ChartContext, SeriesLabelPosition};
use plotters::coord::Shift;
use plotters::drawing::DrawingArea;
use plotters::element::{Circle, DashedPathElement, PathElement, Text};
use plotters::prelude::{Cartesian2d, SVGBackend};
use plotters::series::LineSeries;
use plotters::style::{Color, IntoFont, RGBColor, ShapeStyle, TRANSPARENT, TextStyle};

use super::axis::Axis;
use super::curve::{Curve, Measured};
use super::error::PlotError;
use super::style::*;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Chart<'a> = ChartContext<'a, SVGBackend<'a>, Cartesian2d<Axis, Axis>>;

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
    let (strip, axes) = area.split_vertically(TITLE_AREA);
    let title_at = ((MARGIN + Y_LABEL_AREA) as i32, MARGIN as i32);
    strip.draw(&Text::new(panel.title, title_at, text(TITLE_SIZE)))?;
    let mut chart = ChartBuilder::on(&axes)
        .margin(MARGIN)
        .margin_top(0)
        .x_label_area_size(X_LABEL_AREA)
        .y_label_area_size(Y_LABEL_AREA)
        .build_cartesian_2d(Axis::new(x_end), Axis::new(y_end))?;
    draw_axes(&mut chart, panel)?;
    for (index, curve) in panel.curves.iter().enumerate() {
        draw_curve(&mut chart, curve, colour(index))?;
    }
    draw_measured(&mut chart, panel)?;
    draw_legend(&mut chart, panel.legend_at.clone())
}

fn text(size: u32) -> TextStyle<'static> {
    TextStyle::from((FONT, size).into_font()).color(&INK)
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

fn draw_axes(chart: &mut Chart, panel: &Panel) -> Result<(), PlotError> {
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(line(GRID, THIN))
        .axis_style(line(INK, THIN))
        .set_all_tick_mark_size(TICK)
        .label_style(text(TICK_LABEL_SIZE))
        .axis_desc_style(text(LABEL_SIZE))
        .x_desc(panel.x_description)
        .y_desc(panel.y_description)
        .draw()?;
    Ok(())
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

fn legend_line((x, y): (i32, i32)) -> [(i32, i32); 2] {
    [(x, y), (x + LEGEND_LINE as i32, y)]
}

fn draw_legend(chart: &mut Chart, position: SeriesLabelPosition) -> Result<(), PlotError> {
    chart
        .configure_series_labels()
        .position(position)
        .margin(MARGIN)
        .legend_area_size(LEGEND_LINE + MARGIN / 2)
        .background_style(BACKGROUND.mix(0.85))
        .label_font(text(LABEL_SIZE))
        .draw()?;
    Ok(())
}
