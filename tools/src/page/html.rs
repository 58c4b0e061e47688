//! The page as one HTML file, which needs nothing but itself.

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use minijinja::{Environment, Value, context};
use serde_json::json;

use crate::failure::Failure;
use crate::measurement::quantity::{QUANTITIES, Quantity};
use crate::output::table;
use crate::paper;
use crate::paper::validation::{TableComparison, Validation};

const PAGE: &str = include_str!("../../assets/page/page.html");
const CSS: &str = include_str!("../../assets/page/page.css");
/// The kernel for the page, compressed: what `tools/page/build.sh` makes of `tools/page`.
const KERNEL: &[u8] = include_bytes!("../../assets/page/softanvil.wasm.gz");
/// What page and worker share.
const KERNEL_JS: &str = include_str!("../../assets/page/kernel.js");
const WORKER_JS: &str = include_str!("../../assets/page/worker.js");
/// The scripts of the page; each uses those before it when it is read, and all of them when it runs.
const PAGE_JS: [&str; 9] = [
    include_str!("../../assets/page/simulator.js"),
    include_str!("../../assets/page/drops.js"),
    include_str!("../../assets/page/section.js"),
    include_str!("../../assets/page/plot.js"),
    include_str!("../../assets/page/files.js"),
    include_str!("../../assets/page/controls.js"),
    include_str!("../../assets/page/results.js"),
    include_str!("../../assets/page/player.js"),
    include_str!("../../assets/page/page.js"),
];

/// What a page begins with.
#[derive(Debug, Default)]
pub struct Start {
    /// Title.
    pub title: &'static str,
    /// What stands above the drops, for people; empty if nothing does.
    pub head: String,
    /// Their numbers, for people.
    pub numbers: String,
    /// A scenario file; empty if there is none.
    pub scenario: String,
    /// The drops: objects with `preset`, `toml`, `given`, `name`, and `data` of [`super::drop::of`] if it is there.
    pub drops: Vec<serde_json::Value>,
}

/// The page, with the paper's table above it where there is one.
///
/// # Errors
/// What the template library refuses.
pub fn html(start: &Start, validation: Option<&Validation>) -> Result<Vec<u8>, Failure> {
    render(start, validation)
        .map(String::into_bytes)
        .map_err(|error| Failure::Failed(format!("the page cannot be made: {error}")))
}

fn render(start: &Start, validation: Option<&Validation>) -> Result<String, minijinja::Error> {
    let mut environment = Environment::new();
    // The name makes the library escape what it fills in.
    environment.add_template("page.html", PAGE)?;
    environment.get_template("page.html")?.render(context! {
        version => env!("CARGO_PKG_VERSION"),
        title => start.title,
        head => &start.head,
        numbers => &start.numbers,
        scenario => &start.scenario,
        validation => validation.map(comparison),
        // No tag can end the script.
        start => json!(start.drops).to_string().replace('<', "\\u003c"),
        kernel => BASE64_STANDARD.encode(KERNEL),
        css => CSS,
        scripts => context! { kernel => KERNEL_JS, worker => WORKER_JS, page => PAGE_JS },
    })
}

/// The paper's table beside ours.
fn comparison(validation: &Validation) -> Value {
    let percent = |value: f64| format!("{value:.1}");
    context! {
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
    }
}

/// The rows of the table for one energy.
fn rows(case: &TableComparison) -> Vec<Value> {
    let (ls_dyna_errors, errors) = (case.ls_dyna_errors(), case.softanvil_errors());
    let row = |(i, quantity): (usize, &Quantity)| {
        let text = |value: f64, decimals: usize| format!("{:.*}", decimals, value * quantity.display_scale);
        context! {
            first => i == 0,
            energy => format!("{} J", case.paper.energy),
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
