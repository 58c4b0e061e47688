//! From a scenario to TOML, with unit, legal range and meaning of every line.

use softanvil_kernel::parameter::Kind;
use softanvil_kernel::{PARAMETERS, Parameter, Scenario};
use toml_edit::{DocumentMut, Item, Table, Value};

use super::split;

const HEADER: &str = "\
# A scenario of Softanvil: one drop test, in SI units.
# Every line: key = value, then its unit, its legal values (both ends included) and its meaning.
# A line left out keeps the preset's value; under a law that is given, coefficients left out are 0.
# A line behind \"# \" has no effect beside the others.
";

const MATERIAL_HEADER: &str = "\
# A material of Softanvil, in SI units, for `softanvil run --material` and for a scenario file.
# Every line: key = value, then its unit, its legal values (both ends included) and its meaning.
# A line behind \"# \" has no effect beside the others.
";

/// `scenario` as a scenario file with every parameter; those that have no effect are comments.
pub fn to_toml(scenario: &Scenario) -> String {
    format!("{HEADER}\n{}", sections(scenario, |_| true))
}

/// The material in `group` of `scenario` as a material file, under `comment`.
pub fn material_to_toml(scenario: &Scenario, group: &str, comment: &str) -> String {
    let comment: String = comment.lines().map(|line| format!("# {line}\n")).collect();
    format!("{MATERIAL_HEADER}#\n{comment}\n{}", sections(scenario, |name| name == group))
}

/// The sections of `scenario` whose group is wanted.
fn sections(scenario: &Scenario, wanted: impl Fn(&str) -> bool) -> String {
    let parameters = PARAMETERS.iter().filter(|parameter| wanted(split(parameter.name).0));
    let rows: Vec<Row> = parameters.map(|parameter| Row::new(parameter, scenario)).collect();
    let widths = Widths::of(&rows);
    let mut document = DocumentMut::new();
    for row in rows {
        let section = document.entry(row.group).or_insert_with(|| Item::Table(Table::new()));
        if let Some(section) = section.as_table_mut() {
            let comment = row.comment(&widths);
            let mut value = row.value;
            value.decor_mut().set_suffix(comment);
            section.insert(row.field, Item::Value(value));
        }
    }
    comment_out(&document.to_string(), scenario)
}

/// Turns the lines of `text` that have no effect in `scenario` into comments.
fn comment_out(text: &str, scenario: &Scenario) -> String {
    let (mut group, mut out) = ("", String::new());
    for line in text.lines() {
        group = line.strip_prefix('[').and_then(|line| line.strip_suffix(']')).unwrap_or(group);
        let parameter = line.split_once(" = ").and_then(|(field, _)| Parameter::find(&format!("{group}.{field}")));
        if parameter.is_some_and(|parameter| parameter.without_effect(scenario).is_some()) {
            out += "# ";
        }
        out += line;
        out.push('\n');
    }
    out
}

/// One line of the file.
struct Row {
    group: &'static str,
    field: &'static str,
    value: Value,
    unit: &'static str,
    legal: String,
    description: &'static str,
}

impl Row {
    fn new(parameter: &'static Parameter, scenario: &Scenario) -> Self {
        let (group, field) = split(parameter.name);
        let (value, unit, legal) = match &parameter.kind {
            Kind::Real { unit, min, max, .. } => {
                (parameter.get(scenario).into(), *unit, format!("{} to {}", short(*min), short(*max)))
            }
            Kind::Choice { labels, read, .. } => {
                (labels.get(read(scenario)).copied().unwrap_or_default().into(), "", labels.join(" | "))
            }
        };
        Self { group, field, value, unit, legal, description: parameter.description }
    }

    /// Characters of `key = value`.
    fn width(&self) -> usize {
        self.field.len() + " = ".len() + self.value.to_string().trim().len()
    }

    fn comment(&self, widths: &Widths) -> String {
        let gap = widths.assignment - self.width();
        let (unit, legal) = (widths.unit, widths.legal);
        format!("{:gap$}  # {:unit$}  {:legal$}  {}", "", self.unit, self.legal, self.description)
    }
}

/// Widths of the columns.
struct Widths {
    assignment: usize,
    unit: usize,
    legal: usize,
}

impl Widths {
    fn of(rows: &[Row]) -> Self {
        let widest = |width: fn(&Row) -> usize| rows.iter().map(width).max().unwrap_or_default();
        Self {
            assignment: widest(Row::width),
            unit: widest(|row| row.unit.len()),
            legal: widest(|row| row.legal.len()),
        }
    }
}

/// A bound, in powers of ten where that is shorter.
fn short(bound: f64) -> String {
    let (plain, power) = (format!("{bound}"), format!("{bound:e}"));
    if power.len() < plain.len() { power } else { plain }
}
