//! `documentation/index.html`: a written page with tables generated from the variable table.

use softanvil::variables::{Table, ValueType, Variable, Version};

const PAGE: &str = include_str!("../assets/index.html");

/// The page of an FMU of a version of the standard. What stands between `<!-- fmi3 -->` and `<!-- end -->` is for FMI 3.0
/// alone, and so for FMI 2.0.
pub fn page(version: Version) -> String {
    let table = Table::new();
    let rows = |causality: &[&str]| -> String {
        let of_kind = table.rows().iter().filter(|v| v.is_in(version) && causality.contains(&v.causality()));
        of_kind.map(row).collect()
    };
    let (keep, drop) = match version {
        Version::Fmi2 => ("<!-- fmi2 -->", "<!-- fmi3 -->"),
        Version::Fmi3 => ("<!-- fmi3 -->", "<!-- fmi2 -->"),
    };
    without(PAGE, drop)
        .replace(keep, "")
        .replace("<!-- end -->", "")
        .replace("<!-- version -->", env!("CARGO_PKG_VERSION"))
        .replace("<!-- parameters -->", &rows(&["parameter", "structuralParameter"]))
        .replace("<!-- inputs -->", &rows(&["input"]))
        .replace("<!-- outputs -->", &rows(&["output", "calculatedParameter"]))
}

/// The page without the parts that begin with `mark`.
fn without(page: &str, mark: &str) -> String {
    let mut parts = page.split(mark);
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |text, part| text + part.split_once("<!-- end -->").map_or("", |(_, rest)| rest))
}

fn row(variable: &Variable) -> String {
    let (unit, legal) = match variable.value {
        ValueType::Real { unit, range } => (unit, range.map(|(min, max)| format!("{min:?} to {max:?}"))),
        ValueType::Enumeration { labels } => (
            "",
            Some(labels.iter().enumerate().map(|(i, label)| format!("{i} {label}")).collect::<Vec<_>>().join(", ")),
        ),
        ValueType::Array { unit } => (unit, None),
        ValueType::Size { range: (min, max) } => ("", Some(format!("{min} to {max}"))),
        ValueType::Integer { range: Some((min, max)) } => ("", Some(format!("{min} to {max}"))),
        ValueType::Integer { range: None } | ValueType::Boolean | ValueType::String => ("", None),
    };
    let cells = [
        variable.reference.to_string(),
        format!("<code>{}</code>", escape(&variable.name.to_string())),
        escape(unit),
        variable.start().map(|start| start_of(variable, start)).unwrap_or_default(),
        escape(&legal.unwrap_or_default()),
        escape(variable.description),
    ];
    format!("<tr>{}</tr>\n", cells.map(|cell| format!("<td>{cell}</td>")).concat())
}

fn start_of(variable: &Variable, start: f64) -> String {
    match variable.value {
        ValueType::Boolean => (start != 0.0).to_string(),
        _ => format!("{start:?}"),
    }
}

fn escape(text: &str) -> String {
    quick_xml::escape::escape(text).into_owned()
}
