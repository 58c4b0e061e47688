//! Lines and marks of the runs, which can be told apart in grey as well as in colour.

use plotters::element::{DashedPathElement, Drawable, PathElement, PointCollection};
use plotters::style::{Color, RGBColor, ShapeStyle};
use plotters_backend::{DrawingBackend, DrawingErrorKind};

use super::chart::Chart;
use super::error::PlotError;
use super::look::within;
use super::style::*;

/// A point in drawing units.
type Units = (i32, i32);

/// A line of this colour and width.
pub fn line(colour: RGBColor, width: u32) -> ShapeStyle {
    colour.stroke_width(width)
}

/// Draws the line of the run with this index through `points`, with marks, as far as the window shows them.
pub fn draw(
    chart: &mut Chart,
    points: &[(f64, f64)],
    (index, label): (usize, &str),
    window: Option<[f64; 2]>,
) -> Result<(), PlotError> {
    let (style, pieces) = (line(colour(index), CURVE), within(points, window));
    let marks = marks(&pieces, index);
    let drawn = match dash(index) {
        None => chart.draw_series(pieces.into_iter().map(|piece| PathElement::new(piece, style)))?,
        Some((length, gap)) => {
            chart.draw_series(pieces.into_iter().map(|piece| DashedPathElement::new(piece, length, gap, style)))?
        }
    };
    drawn.label(label).legend(move |(x, y)| Marked { at: [(x, y)], index, beside_line: true });
    chart.draw_series(marks)?;
    Ok(())
}

/// The marks of the run with this index along `pieces`.
fn marks(pieces: &[Vec<(f64, f64)>], index: usize) -> Vec<Marked<(f64, f64)>> {
    let shown: Vec<_> = pieces.iter().flatten().copied().collect();
    let every = (shown.len() / MARKS).max(1);
    // Where curves run together their marks stand beside each other.
    let first = every / 2 + index * every / 4;
    shown.into_iter().skip(first).step_by(every).map(|at| Marked { at: [at], index, beside_line: false }).collect()
}

/// The mark of a run, in a legend in the middle of its line, which begins there.
struct Marked<C> {
    at: [C; 1],
    index: usize,
    beside_line: bool,
}

impl<'a, C> PointCollection<'a, C> for &'a Marked<C> {
    type Point = &'a C;
    type IntoIter = &'a [C; 1];

    fn point_iter(self) -> &'a [C; 1] {
        &self.at
    }
}

impl<C, DB: DrawingBackend> Drawable<DB> for Marked<C> {
    fn draw<I: Iterator<Item = Units>>(
        &self,
        mut points: I,
        backend: &mut DB,
        size: (u32, u32),
    ) -> Result<(), DrawingErrorKind<DB::ErrorType>> {
        let Some((x, y)) = points.next() else { return Ok(()) };
        if !self.beside_line {
            return draw_mark((x, y), self.index, backend);
        }
        let (ends, style) = ([(x, y), (x + LEGEND_LINE as i32, y)], line(colour(self.index), CURVE));
        match dash(self.index) {
            None => backend.draw_path(ends, &style)?,
            Some((length, gap)) => {
                DashedPathElement::new(ends, length, gap, style).draw(ends.into_iter(), backend, size)?;
            }
        }
        draw_mark((x + LEGEND_LINE as i32 / 2, y), self.index, backend)
    }
}

fn draw_mark<DB: DrawingBackend>(
    (x, y): Units,
    index: usize,
    backend: &mut DB,
) -> Result<(), DrawingErrorKind<DB::ErrorType>> {
    let (radius, filled, stroke) = (MARK as i32, colour(index).filled(), line(colour(index), CURVE));
    match mark(index) {
        Mark::Circle => backend.draw_circle((x, y), MARK, &filled, true),
        Mark::Square => backend.draw_rect((x - radius, y - radius), (x + radius, y + radius), &filled, true),
        Mark::Triangle => {
            let corners = [(x - radius - 4, y + radius), (x + radius + 4, y + radius), (x, y - radius - 8)];
            backend.fill_polygon(corners, &filled)
        }
        Mark::Cross => {
            backend.draw_path([(x - radius, y - radius), (x + radius, y + radius)], &stroke)?;
            backend.draw_path([(x - radius, y + radius), (x + radius, y - radius)], &stroke)
        }
    }
}
