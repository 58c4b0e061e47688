//! What every picture with axes has: its title, its grid with labels, its legend.

use std::ops::Range;

use plotters::chart::{ChartBuilder, ChartContext, SeriesLabelPosition};
use plotters::coord::Shift;
use plotters::drawing::{DrawingArea, IntoDrawingArea};
use plotters::element::Text;
use plotters::prelude::{Cartesian2d, SVGBackend};
use plotters::style::{Color, IntoFont, ShapeStyle, TRANSPARENT, TextStyle};

use super::axis::Axis;
use super::error::PlotError;
use super::look::Place;
use super::style::*;

/// A part of a picture.
pub type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
/// A pair of axes.
pub type Chart<'a> = ChartContext<'a, SVGBackend<'a>, Cartesian2d<Axis, Axis>>;

/// An SVG of this size, in drawing units, that `draw` fills.
///
/// # Errors
/// What the drawing library refuses.
pub fn svg(size: (u32, u32), draw: impl FnOnce(&Area) -> Result<(), PlotError>) -> Result<String, PlotError> {
    let mut svg = String::new();
    {
        let area = SVGBackend::with_string(&mut svg, size).into_drawing_area();
        area.fill(&BACKGROUND)?;
        draw(&area)?;
        area.present()?;
    }
    Ok(in_pixels(&svg, size))
}

/// An SVG of `panels` from left to right, each drawn by `draw`.
///
/// # Errors
/// What the drawing library refuses.
pub fn row_of_panels<T>(panels: &[T], draw: impl Fn(&Area, &T) -> Result<(), PlotError>) -> Result<String, PlotError> {
    svg((PANEL_SIZE.0 * panels.len() as u32, PANEL_SIZE.1), |area| {
        area.split_evenly((1, panels.len())).iter().zip(panels).try_for_each(|(part, panel)| draw(part, panel))
    })
}

/// Writes the title on `area`, if it has any, and makes the axes below it, with a margin on the right.
///
/// # Errors
/// What the drawing library refuses.
pub fn axes<'a>(area: &Area<'a>, title: &str, [x, y]: [Axis; 2], right: u32) -> Result<Chart<'a>, PlotError> {
    let (strip, axes) = area.split_vertically(if title.is_empty() { MARGIN } else { TITLE_AREA });
    let title_at = ((MARGIN + Y_LABEL_AREA) as i32, MARGIN as i32);
    if !title.is_empty() {
        strip.draw(&Text::new(title.to_string(), title_at, text(TITLE_SIZE)))?;
    }
    let chart = ChartBuilder::on(&axes)
        .margin(if title.is_empty() { 0 } else { MARGIN })
        .margin_top(0)
        .margin_right(right)
        .x_label_area_size(X_LABEL_AREA)
        .y_label_area_size(Y_LABEL_AREA)
        .build_cartesian_2d(x, y)?;
    Ok(chart)
}

/// Draws the grid, in `style`, and the axes with their quantities and units.
///
/// # Errors
/// What the drawing library refuses.
pub fn grid(chart: &mut Chart, style: ShapeStyle, [x, y]: [&str; 2]) -> Result<(), PlotError> {
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(style)
        .axis_style(INK.stroke_width(THIN))
        .set_all_tick_mark_size(TICK)
        .label_style(text(TICK_LABEL_SIZE))
        .axis_desc_style(text(LABEL_SIZE))
        .x_desc(x)
        .y_desc(y)
        .draw()?;
    Ok(())
}

/// Where the axes of `chart` are.
pub fn place(chart: &Chart) -> Place {
    let (x, y) = chart.plotting_area().get_pixel_range();
    let pixels = |range: Range<i32>| [range.start, range.end].map(|unit| f64::from(unit) / f64::from(UNITS));
    let [left_right, top_bottom] = [pixels(x), pixels(y)];
    let (across, up) =
        (chart.plotting_area().as_coord_spec().get_x_range(), chart.plotting_area().as_coord_spec().get_y_range());
    Place {
        pixels: [left_right, [top_bottom[1], top_bottom[0]]],
        values: [[across.start, across.end], [up.start, up.end]],
    }
}

/// The style of a grid under what is drawn.
pub fn grid_style() -> ShapeStyle {
    GRID.stroke_width(THIN)
}

/// Draws the legend of everything that has a label.
///
/// # Errors
/// What the drawing library refuses.
pub fn legend(chart: &mut Chart, position: SeriesLabelPosition) -> Result<(), PlotError> {
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

/// The line of a curve in the legend.
pub fn legend_line((x, y): (i32, i32)) -> [(i32, i32); 2] {
    [(x, y), (x + LEGEND_LINE as i32, y)]
}

/// Text of this size.
pub fn text(size: u32) -> TextStyle<'static> {
    TextStyle::from((FONT, size).into_font()).color(&INK)
}
