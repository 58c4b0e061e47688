//! Pictures of runs, as SVG whose text is text: force over time, and force over deformation.

mod axis;
mod band;
mod chart;
pub mod curve;
mod energy;
mod error;
#[cfg(feature = "command-line")]
mod identification;
mod lines;
mod look;
mod panel;
#[cfg(feature = "command-line")]
pub mod picture_format;
mod shown;
mod strokes;
pub mod style;

use plotters::chart::SeriesLabelPosition;

pub use energy::{BROUGHT_IN, Balance, TERMS, Term, draw as energy, of_output};
pub use error::PlotError;
#[cfg(feature = "command-line")]
pub use identification::pictures as identification;
pub use lines::{Line, draw as lines};
pub use look::Bare;
pub use shown::Shown;

use crate::measurement::series::CONTACT_FORCE;
use curve::Curve;
use look::{Look, Place};
use panel::Panel;
use style::LEGEND_UPPER_LEFT;

/// Contact force over time since contact.
///
/// # Errors
/// What the drawing library refuses.
pub fn force_time(title: &str, shown: &[Shown]) -> Result<String, PlotError> {
    draw(&[time_panel(title, shown)])
}

/// Contact force over deformation.
///
/// # Errors
/// What the drawing library refuses.
pub fn force_deformation(title: &str, shown: &[Shown]) -> Result<String, PlotError> {
    draw(&[deformation_panel(title, shown)])
}

/// Forces over time since each began, under the name and unit of the vertical axis: points of ms and N, with what the legend
/// calls them.
///
/// # Errors
/// What the drawing library refuses.
pub fn forces(title: &str, y_description: &str, curves: Vec<(String, Vec<(f64, f64)>)>) -> Result<String, PlotError> {
    let curves = curves.into_iter().map(|(label, points)| Curve { label, points, measured: None }).collect();
    draw(&[Panel {
        title,
        x_description: "time since the threshold (ms)",
        y_description,
        measured_label: "",
        legend_at: SeriesLabelPosition::UpperRight,
        bands: Vec::new(),
        curves,
    }])
}

/// Both, side by side.
///
/// # Errors
/// What the drawing library refuses.
pub fn force_time_and_deformation(shown: &[Shown]) -> Result<String, PlotError> {
    draw(&[time_panel("Force over time", shown), deformation_panel("Force over deformation", shown)])
}

fn time_panel<'a>(title: &'a str, shown: &[Shown]) -> Panel<'a> {
    Panel { bands: shown.iter().map(band::of).collect(), ..time_panel_of(title, curve::force_time(shown)) }
}

fn time_panel_of(title: &str, curves: Vec<Curve>) -> Panel<'_> {
    Panel {
        title,
        x_description: "time since contact (ms)",
        y_description: CONTACT_FORCE,
        measured_label: "experiment: peak",
        legend_at: SeriesLabelPosition::UpperRight,
        bands: Vec::new(),
        curves,
    }
}

fn deformation_panel<'a>(title: &'a str, shown: &[Shown]) -> Panel<'a> {
    deformation_panel_of(title, curve::force_deformation(shown))
}

fn deformation_panel_of(title: &str, curves: Vec<Curve>) -> Panel<'_> {
    Panel {
        title,
        x_description: "deformation (mm)",
        y_description: CONTACT_FORCE,
        measured_label: "experiment: maxima",
        legend_at: LEGEND_UPPER_LEFT,
        bands: Vec::new(),
        curves,
    }
}

/// One picture of panels from left to right.
fn draw(panels: &[Panel]) -> Result<String, PlotError> {
    chart::row_of_panels(panels, |area, panel| panel::draw(area, panel, &Look::FILE).map(|_| ()))
}

/// A picture of a page.
#[derive(Clone, Debug)]
pub enum Picture {
    /// Forces over time.
    ForceTime(Vec<Curve>),
    /// Forces over deformation.
    ForceDeformation(Vec<Curve>),
    /// Where the energy is.
    Energy(Balance),
}

/// `picture` without title and legend, in so many pixels, with the part of its horizontal axis that `window` has.
///
/// # Errors
/// What the drawing library refuses.
pub fn bare(picture: Picture, size: [u32; 2], window: Option<[f64; 2]>) -> Result<Bare, PlotError> {
    let look = Look::bare(size, window);
    let mut place = Place::default();
    let svg = chart::svg(look.size, |area| {
        place = match picture {
            Picture::ForceTime(curves) => panel::draw(area, &time_panel_of("", curves), &look)?,
            Picture::ForceDeformation(curves) => panel::draw(area, &deformation_panel_of("", curves), &look)?,
            Picture::Energy(balance) => energy::panel(area, &balance, &look)?,
        };
        Ok(())
    })?;
    Ok(Bare { svg, place })
}
