//! Pictures of runs, as SVG whose text is text: force over time, and force over deformation.

mod axis;
pub mod curve;
mod energy;
mod error;
mod identification;
mod panel;
pub mod picture_format;
mod shown;
mod span;
mod study;
pub mod style;

use plotters::chart::SeriesLabelPosition;
use plotters::drawing::IntoDrawingArea;
use plotters::prelude::SVGBackend;

pub use energy::{BROUGHT_IN, TERMS, Term, draw as energy, of_output};
pub use error::PlotError;
pub use identification::pictures as identification;
pub use shown::Shown;
pub use study::{Line as StudyLine, draw as study};

use crate::measurement::series::CONTACT_FORCE;
use curve::Curve;
use panel::Panel;
use style::{BACKGROUND, LEGEND_UPPER_LEFT, PANEL_SIZE, in_pixels};

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
