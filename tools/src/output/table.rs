//! Results as tables for people.

use softanvil_kernel::preset::Fitted;
use softanvil_kernel::scenario::StepBy;
use softanvil_kernel::{Constants, OUTPUTS, Output};

use crate::measurement::errors::error_percent;
use crate::measurement::quantity::{COUNT, QUANTITIES, Quantity};
use crate::measurement::reading::Threshold;
use crate::measurement::series::{Sensor, Series};
use crate::output::bands;
use crate::output::mesh_quality::{MeshQuality, mesh_quality};
use crate::paper;
use crate::paper::validation::{TableComparison, Validation};
use crate::run::Run;
use crate::text::number::four_digits;
use crate::text::table::{FIXED_BLANK, align_right, new_plain_table, new_table, text};
use crate::text::wrap::filled;

/// The paper's table: experiment, LS-DYNA and Softanvil side by side, 80 characters wide.
pub fn of_validation(validation: &Validation) -> String {
    let mut table = new_table(&["energy", "quantity", "experiment", "LS-DYNA", "error", "Softanvil", "error"]);
    for case in &validation.cases {
        table.add_row(case_row(case));
    }
    let means = |mean: f64, peak: f64, fitted: &Fitted| {
        unbroken(format!("{mean:.1} %\n{peak:.1} %\n{} / {}", fitted.parameters, fitted.numbers))
    };
    table.add_row([
        "all",
        &unbroken("mean |error|\nthe same, peak force\nfitted (see below)".into()),
        "",
        "",
        &means(validation.ls_dyna_mean_error(), validation.ls_dyna_peak_error(), &paper::FITTED),
        "",
        &means(validation.mean_error(), validation.peak_error(), &validation.preset.fitted),
    ]);
    align_right(&mut table, 2..7);
    let remarks: String = validation.cases.iter().map(|case| crate::run::remark(&case.run)).collect();
    format!("{}\n{remarks}{}{}", text(&mut table), bands::of_validation(validation), notes(validation))
}

/// What the numbers of the table rest on.
pub fn notes(validation: &Validation) -> String {
    let mut notes = format!(
        "Errors are against the experiment. Fitted: parameters / numbers of this table.\n\
         Softanvil: {}.\nLS-DYNA: {}: {}.\nExperiment, LS-DYNA: {}.\n",
        validation.preset.fitted,
        paper::FITTED,
        paper::FITTED_HOW,
        paper::SOURCE
    );
    notes = filled(&notes);
    if let Some(TableComparison { run, .. }) = validation.cases.first() {
        let scenario = Threshold::Force(run.constants.scenario.measurement.force_threshold);
        let threshold = validation.reading.threshold.unwrap_or(scenario);
        notes += &format!(
            "Softanvil: preset {}, {}; {};\nimpact duration at forces from {threshold} on.\n\
             The preset is\n{}.\n",
            validation.preset.name,
            elements(&run.constants),
            validation.reading,
            validation.preset.description,
        );
        if validation.formulation != (validation.preset.scenario)().geometry.formulation {
            notes += "The parameters are those that were fitted in the preset's own formulation.\n";
        }
        notes += &core_peaks(validation);
        notes += &filled(&bands::misses(validation));
    }
    notes
}

/// What load cells under the core would read, beside the contact force.
fn core_peaks(validation: &Validation) -> String {
    let peaks = validation.cases.iter().map(|case| {
        let [contact, core] = [Sensor::Contact, Sensor::Core].map(|sensor| Series::of_run(&case.run, sensor).peak());
        format!("{core:.0} N ({:+.1} %)", error_percent(core, contact))
    });
    let peaks = peaks.collect::<Vec<_>>().join(", ");
    format!("Core reaction, which load cells see, and its excess over the contact force:\n{peaks}.\n")
}

/// One row with a line per quantity.
/// Lines of a cell that stand beside those of other cells, and so must not break.
fn unbroken(lines: String) -> String {
    lines.replace(' ', &FIXED_BLANK.to_string())
}

fn case_row(case: &TableComparison) -> [String; 7] {
    let lines = |line: &dyn Fn(usize, &Quantity) -> String| {
        unbroken(QUANTITIES.iter().enumerate().map(|(i, quantity)| line(i, quantity)).collect::<Vec<_>>().join("\n"))
    };
    let values = |values: &[f64; COUNT], decimals: &dyn Fn(usize) -> usize| {
        lines(&|i, quantity| format!("{:.*}", decimals(i), values[i] * quantity.display_scale))
    };
    let percent = |errors: [f64; COUNT]| lines(&|i, _| format!("{:+.1} %", errors[i]));
    [
        format!("{} J", case.paper.energy),
        lines(&|_, quantity| format!("{} ({})", quantity.label, quantity.display_unit)),
        values(&case.paper.experiment, &|i| paper::DECIMALS[i]),
        values(&case.paper.ls_dyna, &|i| paper::DECIMALS[i]),
        percent(case.ls_dyna_errors()),
        lines(&|i, quantity| {
            let value = case.record.values[i] * quantity.display_scale;
            case.run.ending().marked(quantity.output, format!("{value:.*}", quantity.decimals))
        }),
        percent(case.softanvil_errors()),
    ]
}

/// The results and the energies at the end of a run.
pub fn of_run(run: &Run) -> String {
    let mut table = new_plain_table(&["result", "value", "unit", "meaning"]);
    let ending = run.ending();
    for output in OUTPUTS {
        let name = match output.name.split_once('.') {
            // The remark above the table says so in words.
            Some(("result", "complete")) => continue,
            Some(("result", field)) => field.replace('_', " "),
            Some(("energy", term)) => format!("energy, {}", term.replace('_', " ")),
            _ => continue,
        };
        let (unit, scale) = display_unit(output);
        let value = ending.marked(output.name, four_digits(run.result(output) * scale));
        table.add_row([&name, &value, unit, output.description]);
    }
    align_right(&mut table, 1..2);
    text(&mut table) + "\n"
}

/// A row for each impact on the same anvil.
pub fn of_impacts(earlier: &[Run], last: &Run, rest: f64) -> String {
    let mut header = vec!["impact".to_string()];
    let shown = || IMPACT_RESULTS.iter().filter_map(|name| Output::find(name));
    header.extend(shown().map(|output| {
        let (unit, _) = display_unit(output);
        let name = output.name.rsplit('.').next().unwrap_or_default().replace('_', " ");
        if unit == "1" { name } else { format!("{name} {unit}") }
    }));
    let mut table = new_table(&header.iter().map(String::as_str).collect::<Vec<_>>());
    for (number, run) in earlier.iter().chain([last]).enumerate() {
        let ending = run.ending();
        let values = shown().map(|output| {
            let (_, scale) = display_unit(output);
            ending.marked(output.name, four_digits(run.result(output) * scale))
        });
        table.add_row([(number + 1).to_string()].into_iter().chain(values));
    }
    align_right(&mut table, 0..1 + IMPACT_RESULTS.len());
    format!("{} impacts with a rest of {} s between them:\n{}\n", earlier.len() + 1, rest, text(&mut table))
}

/// What is told of each of several impacts.
pub const IMPACT_RESULTS: [&str; 4] =
    ["result.peak_force", "result.max_deformation", "result.impact_duration", "result.restitution"];

/// What a run was made with, in a sentence.
pub fn settings(run: &Run) -> String {
    let text = format!(
        "{}, {} steps of {:.4} us{}, trace {}",
        elements(&run.constants),
        run.end().step_index,
        run.constants.dt * 1e6,
        chosen_for(&run.constants),
        run.trace_hash()
    );
    filled(&text).trim_end().to_string()
}

/// How many elements of which kind there are; of tetrahedra their quality, because flat ones may hide among them.
fn elements(constants: &Constants) -> String {
    let grid = &constants.grid;
    if !grid.is_solid() {
        return format!("{} triangles", grid.n_elem());
    }
    let MeshQuality { smallest, mean } = mesh_quality(&constants.scenario, grid);
    format!("{} tetrahedra (quality {mean:.2}, at least {smallest:.2}; 1 is regular)", grid.n_elem())
}

/// What the step was chosen for; nothing if it was given.
fn chosen_for(constants: &Constants) -> String {
    match constants.scenario.time.step_by {
        StepBy::SafetyFactor => format!(" (chosen for a stretch of {:.2})", constants.design_stretch),
        StepBy::Given => String::new(),
    }
}

/// Unit for people and its factor: lengths and times of an impact read best in thousandths.
fn display_unit(output: &Output) -> (&'static str, f64) {
    match output.unit {
        "m" => ("mm", 1e3),
        "s" => ("ms", 1e3),
        "1" => ("", 1.0),
        "N.s" => ("N s", 1.0),
        unit => (unit, 1.0),
    }
}
