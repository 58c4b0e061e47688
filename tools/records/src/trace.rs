//! The force over time of an impact, from a file of a drop tower or a load cell.

mod choice;
mod cut;
mod plausible;
mod record;

use std::sync::Arc;

use serde_json::json;

use super::ReadError;
use super::channel::Filter;
use super::column::{Column, Kind};
use super::impact::{Contact, Given, MIN_BEFORE};
use super::series::{Table, noted};
use super::sheet::{self, Sheet};
use super::understood::Understood;
use super::unit::{Dimension, parse_quantity};
pub use choice::Choice;
use cut::Cut;
use plausible::{SMALL_OFFSET, step};
use record::{Channels, Clock, Record, Samples};
pub use record::{Expected, Options, Trace};

/// The mass with its unit in `text`, kg.
///
/// # Errors
/// What is legal.
pub fn mass(text: &str) -> Result<f64, String> {
    parse_quantity(text, Dimension::Mass)
}

/// The sampling rate with its unit in `text`, Hz.
///
/// # Errors
/// What is legal.
pub fn rate(text: &str) -> Result<f64, String> {
    parse_quantity(text, Dimension::Frequency)
}

/// The side that `text` names, + or -, as 1 or -1.
///
/// # Errors
/// What is legal.
pub fn sign(text: &str) -> Result<f64, String> {
    match text {
        "+" => Ok(1.0),
        "-" => Ok(-1.0),
        _ => Err("expected + or -".into()),
    }
}

/// Reads the impact in `bytes` of the file called `name`; `expected` tells what is plausible.
///
/// # Errors
/// What cannot be understood, or in two ways, with the option that decides.
pub fn read(name: &str, bytes: &[u8], options: &Options, expected: Option<&Expected>) -> Result<Trace, ReadError> {
    let sheet = Arc::new(sheet::parse(bytes, &options.layout)?);
    let mut order: Vec<usize> = (0..sheet.tables.len()).collect();
    order.sort_by_key(|index| std::cmp::Reverse(sheet.tables[*index].len()));
    let mut refused = None;
    for index in order {
        match channels(&sheet, index, options) {
            Ok(channels) => return Record { name, options, expected, channels }.trace(),
            Err(error) => refused = refused.or(Some(error)),
        }
    }
    Err(refused.unwrap_or_else(|| ReadError::file("no table")))
}

fn channels(sheet: &Arc<Sheet>, index: usize, options: &Options) -> Result<Channels, ReadError> {
    let body = &sheet.tables[index];
    let named = options.force.is_some() || options.acceleration.is_some();
    let numbers: Vec<String> = (1..=body.columns).map(|number| format!("column {number}")).collect();
    let untitled = body.titles.is_empty();
    if untitled && !named {
        let reason = format!(
            "the {} columns have no titles: name them by number, such as --time \"1 [s]\" --force-column \"2 [N]\"",
            body.columns
        );
        return Err(ReadError::file(reason));
    }
    let table = Table::of_body(sheet, index, untitled.then_some(numbers.as_slice()), 0)?;
    let load = load(&table, options)?;
    let time = clock(&table, &load, options)?;
    let displacement = match &options.displacement {
        Some(choice) => Some(choice.column(&table, Kind::Displacement, "--displacement")?),
        None => {
            let mut found = table.of(Kind::Displacement).filter(|column| column.si.is_some());
            found.next().filter(|_| found.next().is_none()).cloned()
        }
    };
    let stated = options.force.is_some() || options.acceleration.is_some() || options.time.is_some();
    Ok(Channels { table, load, time, displacement, stated })
}

/// The column of the force, or of the acceleration if there is none.
fn load(table: &Table, options: &Options) -> Result<Column, ReadError> {
    let given = [
        (&options.force, Kind::Force, "--force-column"),
        (&options.acceleration, Kind::Acceleration, "--acceleration"),
    ];
    for (choice, kind, option) in given {
        if let Some(choice) = choice {
            return with_unit(choice.column(table, kind, option)?, option);
        }
    }
    // The first note is how the file was taken apart.
    let passed_over = table.notes.get(1..).unwrap_or_default();
    for (kind, option) in [(Kind::Force, "--force-column"), (Kind::Acceleration, "--acceleration")] {
        let all: Vec<&Column> = table.of(kind).collect();
        // An unfiltered channel beside filtered ones.
        let unfiltered: Vec<&Column> =
            all.iter().copied().filter(|column| matches!(column.filter, None | Some(Filter::Unfiltered))).collect();
        match (all.as_slice(), unfiltered.as_slice()) {
            ([], _) => {}
            ([only], _) | (_, [only]) => return with_unit((*only).clone(), option),
            _ => {
                let reason = format!(
                    "{} columns of {}: {}; name one, as in {option} \"{}\"{}",
                    all.len(),
                    kind.example().0,
                    titles(&all),
                    all[0].title,
                    noted(passed_over)
                );
                return Err(ReadError::file(reason));
            }
        }
    }
    let listed = table.titles.iter().map(|title| format!("\"{title}\"")).collect::<Vec<_>>().join(", ");
    let reason = format!(
        "no column of force or acceleration understood among {listed}: name it with its unit, as in --force-column \"TITLE [N]\" or \
         --acceleration \"TITLE [g]\"{}{}",
        noted(&table.unclear),
        noted(passed_over)
    );
    Err(ReadError::file(reason))
}

fn titles(columns: &[&Column]) -> String {
    columns.iter().map(|column| format!("\"{}\"", column.title)).collect::<Vec<_>>().join(", ")
}

/// `column`, which states its unit.
fn with_unit(column: Column, option: &str) -> Result<Column, ReadError> {
    if column.si.is_some() {
        return Ok(column);
    }
    let (unit, others) = match column.kind {
        Kind::Time => ("ms", "s, us"),
        Kind::Force => ("N", "kN, lbf, kgf"),
        Kind::Acceleration => ("g", "m/s2"),
        _ => ("mm", "m, in"),
    };
    let (title, kind) = (&column.title, column.kind.example().0);
    let example = format!("as in {option} \"{title} [{unit}]\" (or {others})");
    Err(ReadError::file(format!("column \"{title}\" has no unit of {kind}: state it, {example}")))
}

/// Where the times of `load` come from.
fn clock(table: &Table, load: &Column, options: &Options) -> Result<Clock, ReadError> {
    let facts = &table.sheet().facts;
    if let Some(rate) = options.rate {
        return Ok(Clock::Rate(0.0, 1.0 / rate, format!("--rate {rate} Hz")));
    }
    if let Some(choice) = &options.time {
        let column = choice.column(table, Kind::Time, "--time")?;
        return Ok(Clock::Column(with_unit(column, "--time")?));
    }
    let times: Vec<&Column> = table.of(Kind::Time).collect();
    // Of several, the one before the channel: pairs stand side by side.
    let column = times.iter().rfind(|column| column.index < load.index).or(times.first());
    match (column, &facts.interval) {
        (Some(column), _) => Ok(Clock::Column(with_unit((*column).clone(), "--time")?)),
        (None, Some(fact)) => {
            Ok(Clock::Rate(facts.start.unwrap_or_default(), fact.value, format!("line {}: {}", fact.line, fact.text)))
        }
        (None, None) => Err(ReadError::file(
            "no column of time and no sampling rate: name the column, as in --time \"TITLE [ms]\", or give --rate \"20 kHz\"",
        )),
    }
}

impl Record<'_> {
    fn trace(self) -> Result<Trace, ReadError> {
        let mut understood = Understood::default();
        let factor = self.factor(&mut understood)?;
        let given = Given { sign: self.options.sign, offset: self.options.offset.map(|offset| offset / factor) };
        let mut impacts = Vec::new();
        for series in &self.channels.table.series {
            let samples = self.samples(&series.rows)?;
            let contact = Contact::find(&samples.times, &samples.loads, given)?;
            impacts.push((samples, contact));
        }
        let count: usize = impacts.iter().map(|(_, contact)| contact.impacts.len()).sum();
        let wanted = self.options.impact.unwrap_or(1);
        let mut before = 0;
        let found = impacts.iter().find_map(|(samples, contact)| {
            let index = wanted.checked_sub(1 + before).filter(|index| *index < contact.impacts.len());
            before += contact.impacts.len();
            index.map(|index| (samples, contact, index))
        });
        if count == 0 {
            return Err(ReadError::file(
                "no impact is found in the record: expected a force that rises from rest and falls again",
            ));
        }
        let Some((samples, contact, index)) = found else {
            return Err(ReadError::file(format!(
                "--impact {wanted} is refused: expected 1 to {count}, of those in the record"
            )));
        };
        self.say_columns(&mut understood, samples);
        self.say_contact(&mut understood, contact, factor);
        say_impacts(&mut understood, &impacts, wanted, factor);
        let trace = Cut { samples, contact, index, factor }.trace(&self.channels)?;
        let trace = Trace { understood, ..trace };
        self.judged(trace, contact.threshold(index) * factor)
    }

    /// N in one unit of the load's column.
    fn factor(&self, understood: &mut Understood) -> Result<f64, ReadError> {
        let load = &self.channels.load;
        let si = load.si.unwrap_or(1.0);
        if load.kind == Kind::Force {
            return Ok(si);
        }
        let facts = &self.channels.table.sheet().facts;
        let (mass, source) = match (self.options.mass, &facts.mass) {
            (Some(mass), _) => (mass, "--mass".to_string()),
            (None, Some(fact)) => (fact.value, format!("line {}: {}", fact.line, fact.text)),
            (None, None) => {
                let reason =
                    format!("\"{}\" is an acceleration: give the mass that falls, as in --mass \"5 kg\"", load.title);
                return Err(ReadError::file(reason));
            }
        };
        understood.say("mass", format!("{mass} kg ({source})"), mass);
        if let Some(expected) = self.expected.filter(|expected| (mass / expected.mass - 1.0).abs() > 0.01) {
            let warning =
                format!("the mass of the trace is {mass} kg, that of the simulated impactor {} kg", expected.mass);
            understood.warnings.push(warning);
        }
        Ok(si * mass)
    }

    fn samples(&self, rows: &[sheet::Row]) -> Result<Samples, ReadError> {
        let Channels { table, load, time, displacement, .. } = &self.channels;
        let mut samples = Samples::default();
        for (index, row) in rows.iter().enumerate() {
            let load = table.value(load, row)?;
            let time = match time {
                Clock::Column(column) => table.value(column, row)?.map(|time| time * column.si.unwrap_or(1.0)),
                Clock::Rate(start, interval, _) => Some(start + index as f64 * interval),
            };
            let (Some(time), Some(load)) = (time, load) else {
                samples.dropped += 1;
                continue;
            };
            if let Some(last) = samples.times.last().filter(|last| **last >= time) {
                let reason = format!(
                    "time {time} s is not after that of the line before, {last} s: expected time that rises; --rate \"20 kHz\" \
                     counts the samples instead"
                );
                return Err(ReadError::line(row.line, reason));
            }
            samples.times.push(time);
            samples.loads.push(load);
            samples.lines.push(u32::try_from(row.line).unwrap_or(u32::MAX));
            if let Some(column) = displacement {
                samples.displacements.push(table.value(column, row)?.unwrap_or(f64::NAN) * column.si.unwrap_or(1.0));
            }
        }
        let missing = self.channels.table.sheet().missing;
        if matches!(time, Clock::Rate(..)) && missing > 0 {
            let reason =
                format!("{missing} rows without values in a record without times: expected a row for every sample");
            return Err(ReadError::file(reason));
        }
        if samples.times.len() < 2 {
            return Err(ReadError::file("fewer than two samples with time and force"));
        }
        Ok(samples)
    }

    fn say_columns(&self, understood: &mut Understood, samples: &Samples) {
        let Channels { table, load, time, displacement, .. } = &self.channels;
        let notes = table.notes.join("; ");
        let sheet = table.sheet();
        understood.statements.insert(
            0,
            super::understood::Statement {
                key: "file",
                text: format!("{}, {notes}", self.name),
                value: json!({
                    "name": self.name, "encoding": sheet.encoding(), "sheet": sheet.name, "separator": sheet.separator.name(),
                    "notes": table.notes,
                }),
            },
        );
        let interval = step(&samples.times);
        match time {
            Clock::Column(column) => understood.say("time", shown(column, "s"), of_column(column)),
            Clock::Rate(start, interval, source) => {
                let text = format!("from {start} s on, every {interval} s ({source})");
                understood.say("time", text, json!({ "start": start, "interval": interval, "source": source }));
            }
        }
        understood.say("interval", format!("{:.6} ms, {} samples", 1e3 * interval, samples.times.len()), interval);
        let si = if load.kind == Kind::Force { "N" } else { "m/s2" };
        understood.say(load.kind.example().0, shown(load, si), of_column(load));
        if let Some(filter) = load.filter {
            understood.say("filter", format!("{filter}, by the title"), filter.to_string());
        }
        if let Some(column) = displacement {
            understood.say("displacement", shown(column, "m"), of_column(column));
        }
        if samples.dropped > 0 {
            let rows = if samples.dropped == 1 { "row" } else { "rows" };
            let text = format!("{} {rows} without a time or a value", samples.dropped);
            understood.say("dropped", text, samples.dropped);
        }
        let used = |column: &&Column| {
            let time = matches!(time, Clock::Column(time) if time.index == column.index);
            column.index != load.index && !time && displacement.as_ref().is_none_or(|other| other.index != column.index)
        };
        let others: Vec<&Column> = table.columns.iter().filter(used).collect();
        if !others.is_empty() {
            let names = others.iter().map(|column| column.title.clone()).collect::<Vec<_>>();
            understood.say("passed_over", titles(&others), names);
        }
    }

    fn say_contact(&self, understood: &mut Understood, contact: &Contact, factor: f64) {
        let side = if contact.sign > 0.0 { "positive" } else { "negative" };
        understood.say("sign", format!("a push is {side}"), contact.sign);
        let offset = contact.offset * factor;
        let text = match (self.options.offset, contact.before) {
            (Some(_), _) => format!("{offset} N taken off, as --offset says"),
            (None, count) if count < MIN_BEFORE => {
                format!("none taken off: {count} samples before contact, fewer than {MIN_BEFORE}")
            }
            (None, count) => format!(
                "{offset:.4} N taken off, the median of {count} samples before contact (noise {:.3} N)",
                contact.noise * factor
            ),
        };
        understood.say(
            "offset",
            text,
            json!({ "force": offset, "samples": contact.before, "noise": contact.noise * factor }),
        );
        let (left, peak) =
            ((contact.reading - contact.offset).abs(), contact.impacts.first().map_or(0.0, |impact| impact.peak));
        if self.options.offset.is_none() && contact.before > 0 && left > SMALL_OFFSET * peak {
            let reading = contact.reading * factor;
            let warning = format!(
                "the record shows {reading:.3} N before contact, in {} samples, too few to take it off: --offset {reading:.3} does",
                contact.before
            );
            understood.warnings.push(warning);
        }
        if contact.opposite > 0.3 {
            let warning = format!(
                "the force goes to {:.0} % of the peak on the other side: is it of a filter, or is the sign wrong? --sign decides",
                100.0 * contact.opposite
            );
            understood.warnings.push(warning);
        }
    }
}

fn shown(column: &Column, si: &str) -> String {
    let factor = column.si.unwrap_or(1.0);
    let unit = column.unit.as_deref().unwrap_or("?");
    format!("column {} \"{}\", in {unit} ({factor} {si})", column.index + 1, column.title)
}

fn of_column(column: &Column) -> serde_json::Value {
    json!({ "column": column.index + 1, "title": column.title, "unit": column.unit, "factor": column.si })
}

fn say_impacts(understood: &mut Understood, records: &[(Samples, Contact)], wanted: usize, factor: f64) {
    let all: Vec<(f64, f64)> = records
        .iter()
        .flat_map(|(samples, contact)| contact.impacts.iter().map(|i| (samples.times[i.first], i.peak * factor)))
        .collect();
    let list = all.iter().map(|(time, peak)| format!("{peak:.1} N at {time:.6} s")).collect::<Vec<_>>().join(", ");
    let text = match all.len() {
        1 => list,
        count => format!("{wanted} of {count} ({list}); --impact chooses"),
    };
    let value: Vec<_> = all.iter().map(|(time, peak)| json!({ "time": time, "peak_force": peak })).collect();
    understood.say("impact", text, json!({ "chosen": wanted, "impacts": value }));
}
