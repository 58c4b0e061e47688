//! Pictures of studies: results over the value that was changed.

use plotters::chart::{ChartBuilder, SeriesLabelPosition};
use plotters::drawing::IntoDrawingArea;
use plotters::element::{Circle, DashedPathElement, PathElement, Text};
use plotters::prelude::SVGBackend;
use plotters::style::{Color, IntoFont, TRANSPARENT, TextStyle};

use super::error::PlotError;
use super::span::Span;
use super::style::*;

/// A line of a picture.
#[derive(Clone, Debug)]
pub struct Line {
    /// What the legend calls it.
    pub label: String,
    /// Whether it is drawn in dashes.
    pub dashed: bool,
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
    let mut svg = String::new();
    {
        let area = SVGBackend::with_string(&mut svg, PANEL_SIZE).into_drawing_area();
        area.fill(&BACKGROUND)?;
        let (strip, axes) = area.split_vertically(TITLE_AREA);
        let title_at = ((MARGIN + Y_LABEL_AREA) as i32, MARGIN as i32);
        strip.draw(&Text::new(title, title_at, text(TITLE_SIZE)))?;
        let (across, upwards) = spans(x.1, lines);
        let mut chart = ChartBuilder::on(&axes)
            .margin(MARGIN)
            .margin_top(0)
            .margin_right(right_margin(lines))
            .x_label_area_size(X_LABEL_AREA)
            .y_label_area_size(Y_LABEL_AREA)
            .build_cartesian_2d(across, upwards)?;
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(GRID.stroke_width(THIN))
            .axis_style(INK.stroke_width(THIN))
            .set_all_tick_mark_size(TICK)
            .label_style(text(TICK_LABEL_SIZE))
            .axis_desc_style(text(LABEL_SIZE))
            .x_desc(x.0)
            .y_desc(y)
            .draw()?;
        for (index, line) in lines.iter().enumerate() {
            let style = colour(index).stroke_width(CURVE);
            chart.draw_series(line.points.iter().map(|point| Circle::new(*point, POINT, colour(index).filled())))?;
            let ends = |(x, y): (i32, i32)| [(x, y), (x + LEGEND_LINE as i32, y)];
            match line.dashed {
                true => chart
                    .draw_series([DashedPathElement::new(line.points.clone(), DASH.0, DASH.1, style)])?
                    .label(&line.label)
                    .legend(move |at| DashedPathElement::new(ends(at), DASH.0, DASH.1, style)),
                false => chart
                    .draw_series([PathElement::new(line.points.clone(), style)])?
                    .label(&line.label)
                    .legend(move |at| PathElement::new(ends(at), style)),
            };
        }
        chart
            .configure_series_labels()
            .position(emptier_corner(x.1, lines))
            .margin(MARGIN)
            .legend_area_size(LEGEND_LINE + MARGIN / 2)
            .background_style(BACKGROUND.mix(0.85))
            .label_font(text(LABEL_SIZE))
            .draw()?;
        area.present()?;
    }
    Ok(in_pixels(&svg, PANEL_SIZE))
}

/// Room on the right, for half of the last number of the axis, which may have many digits.
fn right_margin(lines: &[Line]) -> u32 {
    let largest = lines.iter().flat_map(|line| &line.points).fold(0.0, |largest, point| f64::max(largest, point.0));
    if largest >= 1e5 { MARGIN + 2 * TICK_LABEL_SIZE } else { MARGIN }
}

/// Axes over all points, with room for the legend above them.
fn spans(logarithmic: bool, lines: &[Line]) -> (Span, Span) {
    let range = |values: &mut dyn Iterator<Item = f64>| {
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
        if low <= high { (low, high) } else { (0.0, 1.0) }
    };
    let points = || lines.iter().flat_map(|line| line.points.iter());
    let (left, right) = range(&mut points().map(|point| point.0));
    let (bottom, top) = range(&mut points().map(|point| point.1));
    let share = (LEGEND_SHARE.0 * lines.len() as f64 + LEGEND_SHARE.1).min(0.6);
    let top = top + share / (1.0 - share) * (top - bottom).max(1e-3 * top.abs());
    let across = if logarithmic && left > 0.0 { Span::logarithmic(left, right) } else { Span::linear(left, right) };
    (across, Span::linear(bottom, top))
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

fn text(size: u32) -> TextStyle<'static> {
    TextStyle::from((FONT, size).into_font()).color(&INK)
}
