//! Columns that a user names.

use std::str::FromStr;

use crate::ReadError;
use crate::column::{Column, Kind};
use crate::series::Table;
use crate::unit::{Dimension, Unit, number_and_rest};

/// A column that a user names, with its unit if the file does not state it: `Fz [kN]`, `3 [ms]` (the third), `[lbf]`, or
/// `CH1 [250 N/V]` for a sensor.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Choice(String);

impl FromStr for Choice {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.trim() {
            "" => {
                Err("expected the title of a column or its number, and its unit in brackets, such as \"Fz [kN]\""
                    .into())
            }
            text => Ok(Self(text.into())),
        }
    }
}

impl Choice {
    /// The column of `kind` that this names in `table`.
    pub(super) fn column(&self, table: &Table, kind: Kind, option: &str) -> Result<Column, ReadError> {
        let refuse = |reason: String| ReadError::file(format!("{option} \"{}\" is refused: {reason}", self.0));
        let (name, unit) = self.parts(table);
        let index = match name {
            "" => match table.of(kind).collect::<Vec<_>>().as_slice() {
                [only] => only.index,
                found => {
                    let reason = format!("{} columns of {}: name one of them", found.len(), kind.example().0);
                    return Err(refuse(reason));
                }
            },
            name => index_of(table, name).map_err(refuse)?,
        };
        let title = table.titles.get(index).map_or("", String::as_str);
        match unit {
            Some(unit) => scaled(index, title, kind, unit).map_err(refuse),
            None => Ok(Column::named(index, title, kind, None).map_err(refuse)?),
        }
    }

    /// The name and the unit; the whole is a name if a column has this title.
    fn parts(&self, table: &Table) -> (&str, Option<&str>) {
        let text = self.0.as_str();
        if table.titles.iter().any(|title| title.trim().eq_ignore_ascii_case(text)) {
            return (text, None);
        }
        match text.strip_suffix(']').and_then(|text| text.rsplit_once('[')) {
            Some((name, unit)) => (name.trim(), Some(unit.trim())),
            None => (text, None),
        }
    }
}

/// The column whose title, or title without its unit, is `name`, or whose number it is.
fn index_of(table: &Table, name: &str) -> Result<usize, String> {
    let bare = |title: &str| {
        let end = title.find(['[', '(']).unwrap_or(title.len());
        title[..end].trim().to_string()
    };
    let matching = |of: &dyn Fn(&str) -> String| -> Vec<usize> {
        let same = |title: &String| of(title).eq_ignore_ascii_case(name);
        table.titles.iter().enumerate().filter(|(_, title)| same(title)).map(|(index, _)| index).collect()
    };
    let whole = matching(&|title| title.trim().to_string());
    let found = if whole.is_empty() { matching(&bare) } else { whole };
    match (found.as_slice(), name.parse::<usize>()) {
        ([only], _) => Ok(*only),
        ([], Ok(number)) if (1..=table.titles.len()).contains(&number) => Ok(number - 1),
        ([], _) => {
            let listed = table.titles.iter().map(|title| format!("\"{title}\"")).collect::<Vec<_>>().join(", ");
            Err(format!("expected one of {listed}, or a number from 1 to {}", table.titles.len()))
        }
        _ => Err(format!("{} columns have this title: expected the number of one, from 1", found.len())),
    }
}

/// A column in a unit, or in so many of it: N, 50 N, or 250 N/V of a column in V.
fn scaled(index: usize, title: &str, kind: Kind, unit: &str) -> Result<Column, String> {
    let plain = Column::named(index, title, kind, Some(unit));
    let Some((number, rest)) = number_and_rest(unit) else { return plain };
    let rest = ["/V", "/Volt", "/mV"].iter().find_map(|end| rest.strip_suffix(end).map(|rest| (rest, &end[1..])));
    let (text, per) =
        rest.map_or((number_and_rest(unit).map_or("", |found| found.1), None), |(rest, per)| (rest, Some(per)));
    let volts = ["mv", "v", "volt", "volts"];
    let own = title.find(['[', '(']).map(|at| title[at + 1..].trim_end_matches([']', ')']).to_lowercase());
    let differs =
        |per: &str| own.as_ref().is_some_and(|own| volts.contains(&own.as_str()) && (own == "mv") != (per == "mV"));
    if per.is_some_and(differs) {
        return Err(format!("the column is in {}", own.unwrap_or_default()));
    }
    // A sensitivity is one of a signal, not of what a title already states in the unit of the load.
    if let (Some(_), Ok(Column { unit: Some(own), .. })) = (per, Column::named(index, title, kind, None)) {
        return Err(format!("the column is in {own}: expected one in V or mV, or its unit alone"));
    }
    let dimension = kind.dimension().unwrap_or(Dimension::Ratio);
    match Unit::of(dimension, text) {
        Some(found) if number > 0.0 && number.is_finite() => {
            let column = Column::named(index, title, kind, Some(text))?;
            Ok(Column { si: Some(number * found.si), unit: Some(unit.into()), ..column })
        }
        _ => plain,
    }
}
