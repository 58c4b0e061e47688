//! What stands around a table: mass, sampling rate, units, and the columns of instruments that write no titles.

use super::cells::Separator;
use super::number::{self, Cell, Decimal};
use super::text::Lines;
use super::unit::{Dimension, Unit, number_and_rest};

/// A quantity that a file states.
#[derive(Clone, Debug, PartialEq)]
pub struct Fact {
    /// Value in SI units.
    pub value: f64,
    /// Line, from 1.
    pub line: usize,
    /// The words that state it.
    pub text: String,
}

/// What a file states outside of its tables.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Facts {
    /// Mass of the falling body, kg.
    pub mass: Option<Fact>,
    /// Time between two samples, s.
    pub interval: Option<Fact>,
    /// Time of the first sample, s.
    pub start: Option<f64>,
    /// Unit of the axis of time.
    pub horizontal_unit: Option<String>,
    /// Unit of the channels.
    pub vertical_unit: Option<String>,
    /// Units of the columns after the first, as LabVIEW states them.
    pub channel_units: Vec<String>,
    /// Name of the one channel.
    pub channel: Option<String>,
    /// Whether LabVIEW says that the column X_Value is time, in s.
    pub x_is_time: bool,
    /// Whether the file has one number in a line, as the channels of ISO/TS 13499 have.
    alone: bool,
}

impl Facts {
    /// The facts in `remarks` (line and text) of a file whose cells `separator` separates.
    pub fn new(remarks: &[(usize, String)], separator: Separator, decimal: Decimal) -> Self {
        let mut facts = Self { alone: separator == Separator::Alone, ..Self::default() };
        for (line, text) in remarks {
            let cells: Vec<&str> = separator.cells(text).collect();
            facts.read(*line, text, &cells, decimal);
        }
        for pair in remarks.windows(2) {
            facts.read_sequence(pair, separator, decimal);
        }
        facts
    }

    /// Adds what stands in the rows of a table, left of its numbers, as Tektronix writes it.
    pub fn add_beside(&mut self, rows: &[(usize, String)], separator: Separator, decimal: Decimal) {
        for (line, text) in rows {
            let cells: Vec<&str> = separator.cells(text).take(3).collect();
            if is_key_of_tektronix(cells.first().unwrap_or(&"")) {
                self.read(*line, &cells.join(" "), &cells, decimal);
            }
        }
    }

    /// Titles of `columns` without any: those of the layouts that state elsewhere what the columns are.
    pub fn titles(&self, rows: &[Vec<&str>], columns: usize) -> Vec<String> {
        if let (1, Some(channel)) = (columns, &self.channel) {
            let unit = self.vertical_unit.as_deref().unwrap_or_default();
            return vec![format!("{channel} [{unit}]")];
        }
        let beside = |key: &str| rows.iter().find(|row| row.first().is_some_and(|cell| cell.eq_ignore_ascii_case(key)));
        let value = |key: &str| beside(key).and_then(|row| row.get(1)).copied().unwrap_or_default();
        if columns < 5 || beside("Record Length").is_none() || beside("Sample Interval").is_none() {
            return Vec::new();
        }
        let mut titles = vec![String::new(); columns];
        titles[3] = format!("TIME [{}]", value("Horizontal Units"));
        titles[4] = format!("{} [{}]", value("Source"), value("Vertical Units"));
        titles
    }

    /// Reads one remark: a key and its value, in two cells or with a colon or an equals sign between.
    fn read(&mut self, line: usize, text: &str, cells: &[&str], decimal: Decimal) {
        let cells: Vec<&str> = match cells {
            [only] | [only, ""] => match only.split_once([':', '=']) {
                Some((key, value)) => vec![key.trim(), value.trim()],
                None => return,
            },
            _ if cells.first().is_some_and(|cell| cell.contains(':') && !cell.ends_with(':')) => {
                match text.split_once(':') {
                    Some((key, value)) => vec![key.trim(), value.trim()],
                    None => return,
                }
            }
            // Cells that blanks separate may be words of one key.
            _ => match text.split_once([':', '=']).filter(|(key, _)| key.len() > cells[0].len() + 1) {
                Some((key, value)) => vec![key.trim(), value.trim()],
                None => cells.to_vec(),
            },
        };
        let [key, value, rest @ ..] = cells.as_slice() else { return };
        let key = Key { alone: self.alone, ..Key::new(key) };
        let unit = rest.first().copied().unwrap_or_default();
        self.read_words(&key, value, rest);
        let fact = |si: f64| Fact { value: si, line, text: text.trim().chars().take(80).collect() };
        let quantity = |dimension: Dimension| quantity(&key, value, unit, dimension, decimal);
        if key.is_mass() {
            self.mass = self.mass.take().or(quantity(Dimension::Mass).filter(|mass| *mass > 0.0).map(fact));
        }
        let interval = if key.is_rate() {
            quantity(Dimension::Frequency).map(|rate| 1.0 / rate)
        } else if key.is_interval() {
            quantity(Dimension::Time).or_else(|| {
                let unit = if key.is_of_a_standard() { "s" } else { self.horizontal_unit.as_deref()? };
                Some(plain(value, decimal)? * Unit::of(Dimension::Time, unit)?.si)
            })
        } else {
            None
        };
        if let Some(interval) = interval.filter(|interval| *interval > 0.0 && interval.is_finite()) {
            self.interval.get_or_insert(fact(interval));
        }
        if key.is_start() {
            let start = quantity(Dimension::Time).or_else(|| plain(value, decimal).filter(|_| key.is_of_a_standard()));
            self.start = self.start.or(start);
        }
    }

    fn read_words(&mut self, key: &Key, value: &str, rest: &[&str]) {
        let said = || Some(value.trim().to_string()).filter(|value| !value.is_empty());
        match key.words.as_str() {
            "horizontal units" | "x unit" | "x units" => self.horizontal_unit = said(),
            "vertical units" | "unit" | "y unit" | "y units" => self.vertical_unit = said(),
            "channel code" => self.channel = said(),
            "name of the channel" => self.channel = self.channel.take().or(said()),
            "y unit label" => {
                self.channel_units = std::iter::once(&value).chain(rest).map(|unit| unit.trim().into()).collect();
            }
            "x dimension" => self.x_is_time = value.eq_ignore_ascii_case("time"),
            _ => {}
        }
    }

    /// Start and increment as Rigol writes them: titles, and under them the numbers in a row that begins with Sequence.
    fn read_sequence(&mut self, pair: &[(usize, String)], separator: Separator, decimal: Decimal) {
        let [titles, values] = [&pair[0], &pair[1]].map(|(_, text)| separator.cells(text).collect::<Vec<_>>());
        if !values.first().is_some_and(|cell| cell.eq_ignore_ascii_case("sequence")) {
            return;
        }
        let value = |title: &str| {
            let index = titles.iter().position(|cell| cell.eq_ignore_ascii_case(title))?;
            plain(values.get(index)?, decimal)
        };
        if let Some(increment) = value("Increment").filter(|increment| *increment > 0.0) {
            let text = format!("Increment {increment}");
            self.interval = Some(Fact { value: increment, line: pair[1].0, text });
            self.start = value("Start");
        }
    }
}

/// Whether `cells` are the second line of Rigol's, which says that the first column counts.
pub fn is_sequence(cells: &[String]) -> bool {
    cells.first().is_some_and(|cell| cell.eq_ignore_ascii_case("sequence"))
}

/// Separator and decimal sign that the head of a LabVIEW measurement file states.
pub fn notation_of_labview(lines: &Lines) -> Option<(Separator, Decimal)> {
    if !lines.get(1).trim_start().starts_with("LabVIEW Measurement") {
        return None;
    }
    let stated = |key: &str| {
        let value = |line: &str| Some(line.strip_prefix(key)?.get(1..)?.trim_end_matches('\t').to_string());
        (1..=lines.len().min(40)).find_map(|number| value(lines.get(number)))
    };
    let separator = match stated("Separator").as_deref() {
        Some("Comma" | "comma") => b',',
        Some("Semicolon" | "semicolon") => b';',
        _ => b'\t',
    };
    let comma = stated("Decimal_Separator").is_some_and(|sign| sign.starts_with(','));
    Some((Separator::Sign(separator), if comma { Decimal::Comma } else { Decimal::Point }))
}

/// Whether the first line is one of Tektronix's, with metadata on the left of the numbers.
pub fn is_tektronix(line: &str) -> bool {
    line.starts_with("Record Length,") && Separator::Sign(b',').cells(line).count() >= 5
}

fn is_key_of_tektronix(cell: &str) -> bool {
    ["Record Length", "Sample Interval", "Horizontal Units", "Vertical Units"]
        .iter()
        .any(|key| cell.eq_ignore_ascii_case(key))
}

fn plain(value: &str, decimal: Decimal) -> Option<f64> {
    match number::read(value, decimal) {
        Cell::Number(number) => Some(number),
        _ => match number::read(value, Decimal::Point) {
            Cell::Number(number) => Some(number),
            _ => None,
        },
    }
}

/// The quantity of `dimension` that a value states with its unit beside it, in the next cell, or in the brackets of its key.
fn quantity(key: &Key, value: &str, unit: &str, dimension: Dimension, decimal: Decimal) -> Option<f64> {
    let of = |text: &str| Unit::of(dimension, text.trim().trim_matches(['[', ']', '(', ')']));
    if let Some(number) = plain(value, decimal) {
        return Some(number * of(unit).or_else(|| of(&key.unit))?.si);
    }
    let value = if decimal == Decimal::Comma { value.replace(',', ".") } else { value.to_string() };
    let (number, rest) = number_and_rest(&value)?;
    Some(number * of(rest)?.si)
}

/// The key of a remark.
struct Key {
    /// In lower case, without signs and units.
    words: String,
    /// What stands in brackets.
    unit: String,
    /// Whether the file has one number in a line.
    alone: bool,
}

impl Key {
    fn new(text: &str) -> Self {
        let (name, unit) = match text.find(['[', '(']).zip(text.rfind([']', ')'])) {
            Some((start, end)) if start < end => (&text[..start], &text[start + 1..end]),
            _ => (text, ""),
        };
        let words: Vec<String> = name
            .to_lowercase()
            .split(|c: char| !c.is_alphanumeric())
            .filter(|word| !word.is_empty())
            .map(String::from)
            .collect();
        Self { words: words.join(" "), unit: unit.into(), alone: false }
    }

    fn has(&self, parts: &[&str]) -> bool {
        parts.iter().any(|part| self.words.contains(part))
    }

    /// The mass that falls, not that of a specimen.
    fn is_mass(&self) -> bool {
        let mass = self
            .words
            .split(' ')
            .any(|word| ["mass", "masse", "masa", "weight", "gewicht", "poids", "peso"].contains(&word))
            || self.has(&["fallmasse", "fallgewicht", "stoßmasse"]);
        mass && !self.has(&["specimen", "sample", "probe", "density", "éprouvette", "probeta", "silicone", "anvil"])
    }

    fn is_rate(&self) -> bool {
        let sampled =
            ["sampl", "abtast", "échantillonnage", "echantillonnage", "muestreo", "scan", "acquisition", "daq"];
        let rate = ["rate", "freq", "fréq", "frec", "taux", "tasa"];
        self.has(&sampled) && self.has(&rate) && !self.has(&["interval"]) || self.words == "rate" || self.words == "fs"
    }

    fn is_interval(&self) -> bool {
        self.has(&[
            "sampling interval",
            "sample interval",
            "sample period",
            "sampling period",
            "abtastintervall",
            "sample time",
        ]) || self.is_of_a_standard() && !self.is_start()
    }

    fn is_start(&self) -> bool {
        matches!(self.words.as_str(), "time of first sample" | "x0" | "wf start offset")
    }

    /// Whether the key is one that a specification states in s.
    fn is_of_a_standard(&self) -> bool {
        let of_labview = ["delta x", "wf increment", "x0", "wf start offset"];
        let of_iso = ["sampling interval", "time of first sample"];
        of_labview.contains(&self.words.as_str()) || self.alone && of_iso.contains(&self.words.as_str())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn facts(text: &str, separator: Separator, decimal: Decimal) -> Facts {
        let remarks: Vec<(usize, String)> = text.lines().zip(1..).map(|(line, number)| (number, line.into())).collect();
        Facts::new(&remarks, separator, decimal)
    }

    #[test]
    fn mass_and_rate_are_found_in_any_notation() {
        let comma = Separator::Sign(b',');
        for (text, separator, decimal) in [
            ("Mass,5.0,kg\nSample rate,20,kHz", comma, Decimal::Point),
            ("Mass [kg],5\nSample Rate (Hz),20000", comma, Decimal::Point),
            ("Masse: 5 kg\nAbtastrate: 20 kHz", Separator::Sign(b';'), Decimal::Comma),
            ("Fallmasse;5,0;kg\nAbtastfrequenz;20;kHz", Separator::Sign(b';'), Decimal::Comma),
            ("drop mass = 5000 g\nsampling interval = 50 us", Separator::Blanks, Decimal::Point),
            ("Mass\t5 kg\nDelta_X\t5.0E-5\t5.0E-5", Separator::Sign(b'\t'), Decimal::Point),
            ("Mass :5 kg\nSampling interval   :5.0E-5", Separator::Alone, Decimal::Point),
            ("Mass,5 kg\nHorizontal Units,s\nSample Interval,5e-05", comma, Decimal::Point),
        ] {
            let found = facts(text, separator, decimal);
            assert!((found.mass.unwrap().value - 5.0).abs() < 1e-12, "{text}");
            assert!((found.interval.unwrap().value - 5e-5).abs() < 1e-17, "{text}");
        }
    }

    #[test]
    fn what_has_no_unit_or_is_no_mass_that_falls_is_left() {
        for text in ["Mass,5", "Specimen mass,12,g", "Sample rate,20", "Mass density,5,kg", "Massachusetts: 5 kg"] {
            let found = facts(text, Separator::Sign(b','), Decimal::Point);
            assert_eq!((found.mass, found.interval), (None, None), "{text}");
        }
    }
}
