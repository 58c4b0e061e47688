//! The report as one HTML file, which needs nothing but itself.

mod data;

use minijinja::{Environment, Value, context};

use super::{About, Content};
use crate::failure::Failure;
use crate::measurement::quantity::QUANTITIES;
use crate::output::table;
use crate::paper;
use crate::paper::validation::TableComparison;
use crate::scenario_file;

const PAGE: &str = include_str!("../../assets/report/page.html");
const CSS: &str = include_str!("../../assets/report/page.css");
const SECTION_JS: &str = include_str!("../../assets/report/section.js");
const CHARTS_JS: &str = include_str!("../../assets/report/charts.js");
const PLAYER_JS: &str = include_str!("../../assets/report/player.js");
const UPLOT_JS: &str = include_str!("../../assets/uplot/uPlot.iife.min.js");
const UPLOT_CSS: &str = include_str!("../../assets/uplot/uPlot.min.css");
const UPLOT_LICENCE: &str = include_str!("../../assets/uplot/LICENSE");

/// The page.
///
/// # Errors
/// What the template library refuses.
pub fn html(content: &Content) -> Result<Vec<u8>, Failure> {
    render(content)
        .map(String::into_bytes)
        .map_err(|error| Failure::Failed(format!("the page cannot be made: {error}")))
}

fn render(content: &Content) -> Result<String, minijinja::Error> {
    let mut environment = Environment::new();
    // The name makes the library escape what it fills in.
    environment.add_template("page.html", PAGE)?;
    let percent = |value: f64| format!("{value:.1}");
    let constants = content.drops.first().map(|drop| &drop.run.constants);
    let validation = match content.about {
        About::Validation(validation) => Some(validation),
        About::Own(_) => None,
    };
    environment.get_template("page.html")?.render(context! {
        version => env!("CARGO_PKG_VERSION"),
        head => content.head(),
        numbers => content.numbers(),
        triangles => constants.map(|constants| constants.grid.n_elem()),
        step => constants.map(|constants| format!("{:.3}", constants.dt * 1e6)),
        validation => validation.map(|validation| context! {
            preset => validation.preset.name,
            description => validation.preset.description,
            fitted => validation.preset.fitted.to_string(),
            mean_error => percent(validation.mean_error()),
            peak_error => percent(validation.peak_error()),
            ls_dyna_mean_error => percent(validation.ls_dyna_mean_error()),
            ls_dyna_peak_error => percent(validation.ls_dyna_peak_error()),
            ls_dyna_fitted => paper::FITTED.to_string(),
            rows => validation.cases.iter().flat_map(rows).collect::<Vec<_>>(),
            notes => table::notes(validation),
        }),
        residual => format!("{:.1e}", largest_residual(content)),
        scenario => scenario_file::to_toml(&content.scenario()),
        // No tag can end the script.
        data => data::of(content).to_string().replace('<', "\\u003c"),
        css => CSS,
        section_js => SECTION_JS,
        charts_js => CHARTS_JS,
        player_js => PLAYER_JS,
        uplot_js => UPLOT_JS,
        uplot_css => UPLOT_CSS,
        uplot_licence => UPLOT_LICENCE,
    })
}

fn largest_residual(content: &Content) -> f64 {
    let samples = content.drops.iter().flat_map(|drop| drop.run.samples());
    samples.fold(0.0, |largest, sample| f64::max(largest, sample.energy.residual().abs()))
}

/// The rows of the table for one energy.
fn rows(case: &TableComparison) -> Vec<Value> {
    let (ls_dyna_errors, errors) = (case.ls_dyna_errors(), case.softanvil_errors());
    let row = |(i, quantity): (usize, &crate::measurement::quantity::Quantity)| {
        let text = |value: f64, decimals: usize| format!("{:.*}", decimals, value * quantity.display_scale);
        context! {
            first => i == 0,
            energy => if i == 0 { format!("{} J", case.paper.energy) } else { String::new() },
            quantity => format!("{} ({})", quantity.label, quantity.display_unit),
            experiment => text(case.paper.experiment[i], paper::DECIMALS[i]),
            ls_dyna => text(case.paper.ls_dyna[i], paper::DECIMALS[i]),
            ls_dyna_error => format!("{:+.1} %", ls_dyna_errors[i]),
            softanvil => case.run.ending().marked(quantity.output, text(case.record.values[i], quantity.decimals)),
            softanvil_error => format!("{:+.1} %", errors[i]),
        }
    };
    QUANTITIES.iter().enumerate().map(row).collect()
}
