//! From a scenario to TOML, with unit, legal range and meaning of every line.

use softanvil_kernel::parameter::Kind;
use softanvil_kernel::{Parameter, Scenario};
use toml_edit::{ArrayOfTables, DocumentMut, Item, Table, Value};

use super::names::LAYERS;

const HEADER: &str = "\
# A scenario of Softanvil: one drop test, in SI units.
# Every line: key = value, then its unit, its legal values (both ends included) and its meaning.
# A line left out keeps the preset's value; under a law that is given, coefficients left out are 0.
# A table [[layers]] for each layer, from the core to the surface; `name` is what you call it by: silicone.c10.
# A line behind \"# \" has no effect beside the others.
";

const MATERIAL_HEADER: &str = "\
# A material of Softanvil, in SI units, for `softanvil run --material` and for a scenario file.
# Every line: key = value, then its unit, its legal values (both ends included) and its meaning.
# A line behind \"# \" has no effect beside the others.
";

/// `scenario` as a scenario file with every parameter; those that have no effect are comments.
pub fn to_toml(scenario: &Scenario) -> String {
    let parameters: Vec<_> = Parameter::of(scenario).filter(|parameter| parameter.name() != "layers.count").collect();
    let mut layers = ArrayOfTables::new();
    for layer in &scenario.layers {
        let mut table = Table::new();
        if !layer.name.is_empty() {
            table.insert("name", layer.name.as_str().into());
        }
        layers.push(table);
    }
    let mut document = DocumentMut::new();
    for row in rows(&parameters, scenario) {
        let section = match row.layer {
            Some(layer) => {
                let tables = document.entry(LAYERS).or_insert_with(|| Item::ArrayOfTables(layers.clone()));
                tables.as_array_of_tables_mut().and_then(|tables| tables.get_mut(layer))
            }
            None => document.entry(row.group).or_insert_with(|| Item::Table(Table::new())).as_table_mut(),
        };
        row.put(section);
    }
    format!("{HEADER}\n{}", comment_out(&document.to_string(), scenario, None))
}

/// The material of a layer of `scenario` as a material file, in a section of the layer's name, under `comment`.
pub fn material_to_toml(scenario: &Scenario, layer: usize, comment: &str) -> String {
    let comment: String = comment.lines().map(|line| format!("# {line}\n")).collect();
    let name = scenario.layers.get(layer).map(|layer| layer.name.as_str()).unwrap_or_default();
    let parameters: Vec<_> = Parameter::of_material(layer).collect();
    let mut document = DocumentMut::new();
    let section = document.entry(name).or_insert_with(|| Item::Table(Table::new()));
    for row in rows(&parameters, scenario) {
        row.put(section.as_table_mut());
    }
    format!("{MATERIAL_HEADER}#\n{comment}\n{}", comment_out(&document.to_string(), scenario, Some(layer)))
}

/// Turns the lines of `text` that have no effect in `scenario` into comments; all of them are of `layer`, if there is one.
fn comment_out(text: &str, scenario: &Scenario, layer: Option<usize>) -> String {
    let (mut group, mut layers, mut out) = (String::new(), 0, String::new());
    for line in text.lines() {
        if line == format!("[[{LAYERS}]]") {
            group = format!("{LAYERS}[{layers}]");
            layers += 1;
        } else if let Some(name) = line.strip_prefix('[').and_then(|line| line.strip_suffix(']')) {
            group = layer.map_or(name.to_string(), |layer| format!("{LAYERS}[{layer}]"));
        }
        let parameter = line.split_once(" = ").and_then(|(field, _)| Parameter::find(&format!("{group}.{field}")));
        if parameter.is_some_and(|parameter| parameter.without_effect(scenario).is_some()) {
            out += "# ";
        }
        out += line;
        out.push('\n');
    }
    out
}

/// The lines of `parameters`, with comments in columns.
fn rows(parameters: &[Parameter], scenario: &Scenario) -> Vec<Row> {
    let mut rows: Vec<Row> = parameters.iter().map(|parameter| Row::new(parameter, scenario)).collect();
    let widths = Widths::of(&rows);
    for row in &mut rows {
        let comment = row.comment(&widths);
        row.value.decor_mut().set_suffix(comment);
    }
    rows
}

/// One line of the file.
struct Row {
    group: &'static str,
    layer: Option<usize>,
    field: &'static str,
    value: Value,
    unit: &'static str,
    legal: String,
    description: &'static str,
}

impl Row {
    fn new(parameter: &Parameter, scenario: &Scenario) -> Self {
        let (number, (min, max)) = (parameter.get(scenario), parameter.range());
        let (value, unit, legal) = match parameter.kind() {
            Kind::Quantity => (number.into(), parameter.unit(), format!("{} to {}", short(min), short(max))),
            Kind::Count => ((number as i64).into(), "", format!("{min} to {max}")),
            Kind::Choice { labels } => {
                (labels.get(number as usize).copied().unwrap_or_default().into(), "", labels.join(" | "))
            }
        };
        let (group, layer, field) = (parameter.name().group(), parameter.layer(), parameter.name().field());
        Self { group, layer, field, value, unit, legal, description: parameter.description() }
    }

    /// Adds the line to its section.
    fn put(self, section: Option<&mut Table>) {
        if let Some(section) = section {
            section.insert(self.field, Item::Value(self.value));
        }
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
