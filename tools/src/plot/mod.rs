//! Pictures of runs, as SVG whose text is text: force over time, and force over deformation.

mod axis;
pub mod curve;
mod energy;
mod identification;
mod panel;
mod span;
mod study;
pub mod style;

use plotters::chart::SeriesLabelPosition;
use plotters::drawing::IntoDrawingArea;
use plotters::prelude::SVGBackend;

pub use energy::{BROUGHT_IN, TERMS, Term, draw as energy, of_output};
pub use identification::pictures as identification;
pub use study::{Line as StudyLine, draw as study};

use crate::quantity::COUNT;
use crate::run::Run;
use curve::Curve;
use panel::Panel;
use style::{BACKGROUND, LEGEND_UPPER_LEFT, PANEL_SIZE, UNITS};

/// What a picture shows of one run.
pub struct Shown<'a> {
    /// What the legend calls it.
    pub label: String,
    /// The run.
    pub run: &'a Run,
    /// What the experiment measured, in SI and in the order of [`crate::quantity::QUANTITIES`].
    pub experiment: Option<[f64; COUNT]>,
}

/// Why a picture could not be drawn.
#[derive(Debug, thiserror::Error)]
#[error("the picture cannot be drawn: {0}")]
pub struct PlotError(String);

impl PlotError {
    /// The reason that a library gives.
    pub(crate) fn new(reason: impl ToString) -> Self {
        Self(reason.to_string())
    }
}

impl<E: std::error::Error + Send + Sync> From<plotters::drawing::DrawingAreaErrorKind<E>> for PlotError {
    fn from(error: plotters::drawing::DrawingAreaErrorKind<E>) -> Self {
        Self::new(error)
    }
}

/// Name and unit of the force that the kernel's own pictures show.
pub const CONTACT_FORCE: &str = "contact force (N)";

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
    Panel {
        title,
        x_description: "time since contact (ms)",
        y_description: CONTACT_FORCE,
        measured_label: "experiment: peak",
        legend_at: SeriesLabelPosition::UpperRight,
        curves: curve::force_time(shown),
    }
}

fn deformation_panel<'a>(title: &'a str, shown: &[Shown]) -> Panel<'a> {
    Panel {
        title,
        x_description: "deformation (mm)",
        y_description: CONTACT_FORCE,
        measured_label: "experiment: maxima",
        legend_at: LEGEND_UPPER_LEFT,
        curves: curve::force_deformation(shown),
    }
}

/// One picture of panels from left to right.
fn draw(panels: &[Panel]) -> Result<String, PlotError> {
    let size = (PANEL_SIZE.0 * panels.len() as u32, PANEL_SIZE.1);
    let mut svg = String::new();
    {
        let area = SVGBackend::with_string(&mut svg, size).into_drawing_area();
        area.fill(&BACKGROUND)?;
        for (part, panel) in area.split_evenly((1, panels.len())).iter().zip(panels) {
            panel::draw(part, panel)?;
        }
        area.present()?;
    }
    Ok(in_pixels(&svg, size))
}

/// The picture at its size in pixels; the view box keeps the drawing units.
fn in_pixels(svg: &str, (width, height): (u32, u32)) -> String {
    let attributes = |scale: u32| format!("width=\"{}\" height=\"{}\"", width / scale, height / scale);
    svg.replacen(&attributes(1), &attributes(UNITS), 1)
}
