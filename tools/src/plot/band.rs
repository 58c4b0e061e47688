//! Bands about the curves of a panel.

use plotters::element::{Polygon, Rectangle};
use plotters::style::Color;

use super::chart::Chart;
use super::error::PlotError;
use super::shown::Shown;
use super::style::*;

/// How much of its colour a band has.
const OPACITY: f64 = 0.2;
/// Half the height of a band in the legend.
const LEGEND_HALF: i32 = 5 * UNITS as i32;

/// A band as corners: along its upper end, and back along the lower one.
pub type Corners = Vec<(f64, f64)>;

/// The band of a run over time since contact, in ms and N; without corners where there is none.
pub fn of(shown: &Shown) -> Corners {
    let Some(band) = shown.band else { return Vec::new() };
    let at = |(i, force): (usize, &f64)| (1e3 * band.interval * i as f64, *force);
    let back = band.low.iter().enumerate().rev().map(at);
    band.high.iter().enumerate().map(at).chain(back).collect()
}

/// Draws the bands in the colours of their curves, all under one label.
pub fn draw(chart: &mut Chart, bands: &[Corners]) -> Result<(), PlotError> {
    let mut labelled = false;
    for (index, corners) in bands.iter().enumerate().filter(|(_, corners)| !corners.is_empty()) {
        let drawn = chart.draw_series([Polygon::new(corners.clone(), colour(index).mix(OPACITY))])?;
        if !labelled {
            drawn.label("90 % band").legend(|(x, y)| {
                let corners = [(x, y - LEGEND_HALF), (x + LEGEND_LINE as i32, y + LEGEND_HALF)];
                Rectangle::new(corners, INK.mix(OPACITY).filled())
            });
        }
        labelled = true;
    }
    Ok(())
}
