//! `documentation/index.html`: a written page with tables generated from the variable table.

use softanvil::variables::{Table, ValueType, Variable};

const PAGE: &str = include_str!("../assets/index.html");

/// The page.
pub fn page() -> String {
    let table = Table::new();
    let rows = |causality: &[&str]| -> String {
        let of_kind = table.rows().iter().filter(|variable| causality.contains(&variable.causality()));
        of_kind.map(row).collect()
    };
    PAGE.replace("<!-- version -->", env!("CARGO_PKG_VERSION"))
        .replace("<!-- parameters -->", &rows(&["parameter"]))
        .replace("<!-- inputs -->", &rows(&["input"]))
        .replace("<!-- outputs -->", &rows(&["output", "calculatedParameter"]))
}

fn row(variable: &Variable) -> String {
    let (unit, legal) = match variable.value {
        ValueType::Real { unit, range } => (unit, range.map(|(min, max)| format!("{min:?} to {max:?}"))),
        ValueType::Enumeration { labels } => (
            "",
            Some(labels.iter().enumerate().map(|(i, label)| format!("{i} {label}")).collect::<Vec<_>>().join(", ")),
        ),
        ValueType::Integer | ValueType::Boolean | ValueType::String => ("", None),
    };
    let cells = [
        variable.reference.to_string(),
        format!("<code>{}</code>", escape(variable.name)),
        escape(unit),
        variable.start().map(|start| format!("{start:?}")).unwrap_or_default(),
        escape(&legal.unwrap_or_default()),
        escape(variable.description),
    ];
    format!("<tr>{}</tr>\n", cells.map(|cell| format!("<td>{cell}</td>")).concat())
}

fn escape(text: &str) -> String {
    quick_xml::escape::escape(text).into_owned()
}
