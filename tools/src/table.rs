//! Results as tables for people.

use std::io::IsTerminal;
use std::ops::Range;

use comfy_table::presets::{ASCII_HORIZONTAL_ONLY, UTF8_HORIZONTAL_ONLY};
use comfy_table::{CellAlignment, ColumnConstraint, ContentArrangement, LineStyle, Table, TableStyle, Width};
use softanvil_kernel::preset::Fitted;
use softanvil_kernel::scenario::StepBy;
use softanvil_kernel::{Constants, OUTPUTS, Output};

use crate::paper;
use crate::quantity::{COUNT, QUANTITIES, Quantity};
use crate::reading::Threshold;
use crate::run::Run;
use crate::series::{Sensor, Series};
use crate::validation::{Comparison, Validation, error_percent};

/// The study's table: experiment, LS-DYNA and Softanvil side by side, 80 characters wide.
pub fn of_validation(validation: &Validation) -> String {
    let mut table = new_table(&["energy", "quantity", "experiment", "LS-DYNA", "error", "Softanvil", "error"]);
    for case in &validation.cases {
        table.add_row(case_row(case));
    }
    let means = |mean: f64, peak: f64, fitted: &Fitted| {
        format!("{mean:.1} %\n{peak:.1} %\n{} / {}", fitted.parameters, fitted.numbers)
    };
    table.add_row([
        "all",
        "mean |error|\nthe same, peak force\nfitted (see below)",
        "",
        "",
        &means(validation.ls_dyna_mean_error(), validation.ls_dyna_peak_error(), &paper::FITTED),
        "",
        &means(validation.mean_error(), validation.peak_error(), &validation.preset.fitted),
    ]);
    align_right(&mut table, 2..7);
    let remarks: String = validation.cases.iter().map(|case| crate::ending::remark(&case.run)).collect();
    format!("{}\n{remarks}{}", text(&mut table), notes(validation))
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
    if let Some(Comparison { run, .. }) = validation.cases.first() {
        let scenario = Threshold::Force(run.constants.scenario.measurement.force_threshold);
        let threshold = validation.reading.threshold.unwrap_or(scenario);
        notes += &format!(
            "Softanvil: preset {}, {} triangles; {};\nimpact duration at forces from {threshold} on.\n\
             The preset is\n{}.\n",
            validation.preset.name,
            run.constants.grid.n_elem(),
            validation.reading,
            validation.preset.description,
        );
        notes += &core_peaks(validation);
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
fn case_row(case: &Comparison) -> [String; 7] {
    let lines = |line: &dyn Fn(usize, &Quantity) -> String| {
        QUANTITIES.iter().enumerate().map(|(i, quantity)| line(i, quantity)).collect::<Vec<_>>().join("\n")
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

/// What a run was made with, in a sentence.
pub fn settings(run: &Run) -> String {
    let grid = &run.constants.grid;
    let text = format!(
        "{} triangles, {} steps of {:.4} us{}, trace {}",
        grid.n_elem(),
        run.end().step_index,
        run.constants.dt * 1e6,
        chosen_for(&run.constants),
        run.trace_hash()
    );
    filled(&text).trim_end().to_string()
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

/// `value` with four significant digits, in powers of ten where it is small.
pub fn four_digits(value: f64) -> String {
    let magnitude = value.abs();
    if magnitude > 0.0 && magnitude < 1e-2 {
        return format!("{value:.3e}");
    }
    let power = if magnitude > 0.0 { magnitude.log10().floor() as i32 } else { 0 };
    format!("{value:.*}", usize::try_from(3 - power).unwrap_or_default())
}

/// Characters of a line where no terminal says how many it has.
const WIDTH: u16 = 80;

/// `text` with line breaks at blanks, so that no line is longer than `WIDTH` where that is possible.
pub fn filled(text: &str) -> String {
    let mut filled = String::new();
    for line in text.lines() {
        let mut length = 0;
        for word in line.split(' ') {
            let width = word.chars().count();
            if length > 0 && length + 1 + width > usize::from(WIDTH) {
                filled.push('\n');
                length = 0;
            } else if length > 0 {
                filled.push(' ');
                length += 1;
            }
            filled += word;
            length += width;
        }
        filled.push('\n');
    }
    filled
}

/// Lines of tables: as drawn for a terminal, plain for what reads a pipe or a file.
fn style() -> TableStyle {
    if std::io::stdout().is_terminal() { UTF8_HORIZONTAL_ONLY } else { ASCII_HORIZONTAL_ONLY }
}

/// A table with these titles and no line between its rows.
pub(crate) fn new_plain_table(header: &[&str]) -> Table {
    let mut table = new_table(header);
    table.load_style(style().row_separator(LineStyle::none()));
    table
}

/// An empty table with this header, which fits the terminal, or `WIDTH` characters.
pub fn new_table(header: &[&str]) -> Table {
    let mut table = Table::new();
    table.load_style(style()).set_header(header).set_content_arrangement(ContentArrangement::Dynamic);
    if !std::io::stdout().is_terminal() {
        table.set_width(WIDTH);
    }
    // One space after each cell and one between the columns are enough.
    for column in table.column_iter_mut() {
        column.set_padding((0, 1));
    }
    table
}

/// A blank at which no line of a table breaks; [`text`] makes an ordinary one of it.
pub const FIXED_BLANK: char = '\u{a0}';

/// The text of a table, in which no word is cut: a table of too many words for the width is wider.
pub fn text(table: &mut Table) -> String {
    let mut longest: Vec<usize> = Vec::new();
    for row in table.header().into_iter().chain(table.row_iter()) {
        for (column, cell) in row.cell_iter().enumerate() {
            let words = cell.content().split([' ', '\n']).map(|word| word.chars().count()).max().unwrap_or_default();
            longest.resize(longest.len().max(column + 1), 0);
            longest[column] = longest[column].max(words);
        }
    }
    // Where even the words alone are too wide, the columns come closer: one blank between them stays.
    let needed = longest.iter().map(|longest| longest + 2).sum::<usize>();
    let crowded = table.width().is_some_and(|width| needed > usize::from(width));
    for (column, longest) in table.column_iter_mut().zip(longest) {
        if crowded {
            column.set_padding((0, 0));
        }
        let width = longest as u16 + column.padding_width();
        column.set_constraint(ColumnConstraint::LowerBoundary(Width::Fixed(width)));
    }
    table.trim_fmt().replace(FIXED_BLANK, " ")
}

/// Aligns columns of numbers to the right.
pub fn align_right(table: &mut Table, columns: Range<usize>) {
    for column in table.column_iter_mut().take(columns.end).skip(columns.start) {
        column.set_cell_alignment(CellAlignment::Right);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_lines_are_broken_at_blanks_and_short_ones_stay() {
        let long = format!("{} {}", "a".repeat(50), "b".repeat(40));
        assert_eq!(filled(&long), format!("{}\n{}\n", "a".repeat(50), "b".repeat(40)));
        assert_eq!(filled("a  b\n\nc"), "a  b\n\nc\n");
        let word = "x".repeat(90);
        assert_eq!(filled(&word), format!("{word}\n"));
    }

    #[test]
    fn values_show_four_significant_digits() {
        for (value, text) in [
            (5302.54, "5303"),
            (16.412, "16.41"),
            (0.77317, "0.7732"),
            (-0.018984, "-0.01898"),
            (1.438e-4, "1.438e-4"),
            (0.0, "0.000"),
            (123456.7, "123457"),
        ] {
            assert_eq!(four_digits(value), text);
        }
    }
}
