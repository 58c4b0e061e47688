//! What a sweep shows: for people as text or Markdown, for programs as JSON and CSV, and as a picture.

use std::fmt::Write;

use itertools::Itertools;
use serde_json::{Map, Value, json};

use super::case::Case;
use super::columns::{self, COLUMNS};
use super::convergence::METHOD;
use super::picture;
use super::results::{Results, percent_or_none};
use super::sheet::Sheet;
use super::{Contrast, Sweep};
use crate::measurement::quantity::QUANTITIES;
use crate::output::json::of_ending;
use crate::output::subject::{Subject, warning_lines, warnings_of};
use crate::plot::PlotError;
use crate::plot::picture_format::PictureFormat;
use crate::text::wrap::filled;
use crate::{paper, run};

/// Everything about one sweep.
pub struct Page {
    results: Results,
    subject: Subject,
    notes: Vec<String>,
}

impl Page {
    /// The page of `results`, changes of the drop of `subject`.
    pub fn new(results: Results, subject: Subject) -> Self {
        let notes = notes(&results);
        Self { results, subject, notes }
    }

    /// Whether the anvil is the paper's, so that its figures stand beside ours.
    fn is_of_the_paper(&self) -> bool {
        let said = self.results.sweep.contrasts.iter().any(|contrast| contrast.paper.is_some());
        said && paper::is_its_model(&self.results.scenario)
    }

    /// What is simulated, and what speaks against it.
    fn head(&self) -> String {
        self.subject.text() + &warning_lines(&warnings_of(&self.results.scenario).unwrap_or_default())
    }

    /// What is changed, and how its convergence is judged.
    fn about(&self) -> String {
        let sweep = &self.results.sweep;
        let method = if sweep.refines() { METHOD } else { "" };
        [sweep.about.trim(), method].into_iter().filter(|text| !text.is_empty()).collect::<Vec<_>>().join("\n\n")
    }

    /// For a terminal.
    pub fn text(&self) -> String {
        let mut text = format!("{}\n{}{}", self.results.sweep.title, filled(&self.about()), self.head());
        for sheet in self.sheets() {
            let _ = write!(text, "\n{}", sheet.text());
        }
        text + "\n" + &self.notes.iter().map(|note| filled(&format!("* {note}"))).collect::<String>()
    }

    /// For the documentation; the picture is expected beside the page, in this format.
    pub fn markdown(&self, pictures: PictureFormat) -> String {
        let sweep = &self.results.sweep;
        let mut text = format!("# {}\n\n{}\n\n{}", sweep.title, self.about(), self.head());
        for sheet in self.sheets() {
            let _ = write!(text, "\n## {}\n\n{}", sheet.title, sheet.markdown());
        }
        text.push('\n');
        for note in &self.notes {
            let _ = writeln!(text, "* {note}");
        }
        let (name, title, picture) = (&sweep.name, &sweep.title, pictures.extension());
        let _ = write!(text, "\n![{title}]({name}.{picture})\n\n");
        let made = format!("Made by `softanvil sweep {}`.", sweep.arguments);
        let _ = writeln!(text, "Every simulation is a line of [{name}.csv]({name}.csv). {made}");
        text
    }

    /// The tables, the one of the contrasts first.
    fn sheets(&self) -> impl Iterator<Item = Sheet> {
        let contrasts = (!self.results.sweep.contrasts.is_empty()).then(|| {
            let (header, rows) = self.contrasts(self.is_of_the_paper());
            let title = if self.is_of_the_paper() { "The paper beside this model" } else { "Changes" };
            Sheet { title: title.into(), n_text: header.len() - QUANTITIES.len(), header, rows }
        });
        contrasts.into_iter().chain(self.results.sheets())
    }

    /// Header and rows of the contrasts, with or without what the paper says.
    fn contrasts(&self, with_paper: bool) -> (Vec<String>, Vec<Vec<String>>) {
        let row = |what: &str, paper: &str, here: [String; QUANTITIES.len()]| {
            let texts = if with_paper { vec![what, paper] } else { vec![what] };
            texts.into_iter().map(String::from).chain(here).collect::<Vec<_>>()
        };
        let rows = self.results.sweep.contrasts.iter().map(|contrast| {
            let here = self.results.changes(contrast).map(percent_or_none);
            row(&contrast.what, contrast.paper.as_deref().unwrap_or("-"), here)
        });
        (row("change", "paper", QUANTITIES.each_ref().map(|quantity| quantity.label.into())), rows.collect())
    }

    /// For other programs, in SI.
    pub fn json(&self) -> Value {
        let results = &self.results;
        json!({
            "sweep": results.sweep.name,
            "drop": self.subject.json(),
            "warnings": warnings_of(&results.scenario).unwrap_or_default(),
            "missing": results.missing(),
            "contrasts": results.sweep.contrasts.iter().map(|contrast| self.contrast_json(contrast)).collect::<Vec<_>>(),
            "notes": self.notes,
            "cases": (0..results.cases.len()).filter_map(|number| self.case_json(number)).collect::<Vec<_>>(),
        })
    }

    fn contrast_json(&self, contrast: &Contrast) -> Value {
        let changes = QUANTITIES.iter().zip(self.results.changes(contrast));
        let changes: Map<String, Value> = changes.map(|(quantity, c)| (quantity.key.into(), c.into())).collect();
        let paper = contrast.paper.as_ref().filter(|_| self.is_of_the_paper());
        json!({ "what": contrast.what, "from": contrast.from, "to": contrast.to, "paper": paper, "change_percent": changes })
    }

    /// The case with this number; nothing if it was not simulated.
    fn case_json(&self, number: usize) -> Option<Value> {
        let headings = self.results.sweep.headings().into_iter().map(String::from);
        let settings = self.results.cases[number].settings.iter().map(|text| text.as_str().into());
        let mut object: Map<String, Value> = headings.zip(settings).collect();
        match self.results.outcomes[number].as_ref()? {
            Ok(outcome) => {
                object.extend(COLUMNS.iter().map(|column| (column.key.into(), (column.read)(outcome).into())));
                object.extend(of_ending(&outcome.run));
                object.insert("trace_hash".into(), outcome.run.trace_hash().into());
            }
            Err(reason) => {
                object.insert("failure".into(), reason.as_str().into());
            }
        }
        Some(Value::Object(object))
    }

    /// The picture, as SVG.
    ///
    /// # Errors
    /// What the drawing library refuses.
    pub fn svg(&self) -> Result<String, PlotError> {
        picture::draw(&self.results)
    }

    /// The simulations as CSV.
    ///
    /// # Errors
    /// What the CSV library refuses.
    pub fn csv(&self) -> Result<Vec<u8>, csv::Error> {
        let mut csv = csv::Writer::from_writer(Vec::new());
        csv.write_record(columns::header(&self.results.sweep))?;
        for (number, (case, outcome)) in self.results.cases.iter().zip(&self.results.outcomes).enumerate() {
            if let Some(outcome) = outcome {
                csv.write_record(columns::record(number, &case.settings, outcome))?;
            }
        }
        csv.into_inner().map_err(|error| csv::Error::from(error.into_error()))
    }
}

/// A table of the contrasts of all `pages`, in Markdown, with links to the pages.
pub fn overview(pages: &[Page]) -> String {
    let with_paper = pages.iter().any(Page::is_of_the_paper);
    let mut sheet = Sheet { title: String::new(), header: Vec::new(), rows: Vec::new(), n_text: 0 };
    for page in pages {
        let (header, mut rows) = page.contrasts(with_paper);
        if rows.is_empty() {
            rows.push(vec![String::new(); header.len()]);
        }
        let sweep = &page.results.sweep;
        for (index, row) in rows.into_iter().enumerate() {
            let link = if index == 0 { format!("[{}]({}.md)", sweep.title, sweep.name) } else { String::new() };
            sheet.rows.push(std::iter::once(link).chain(row).collect());
        }
        sheet.n_text = header.len() + 1 - QUANTITIES.len();
        sheet.header = std::iter::once("sweep".to_string()).chain(header).collect();
    }
    sheet.markdown()
}

/// What a reader has to know of the numbers.
fn notes(results: &Results) -> Vec<String> {
    let mut notes = vec![reference(&results.sweep)];
    if let [axis] = &results.sweep.axes[..]
        && results.done().count() > 1
        && results.done().map(|(_, outcome)| (outcome.run.trace_hash(), outcome.values.map(f64::to_bits))).all_equal()
    {
        let name = axis.name.split(" [").next().unwrap_or_default();
        notes.push(format!("{name} changes nothing in this scenario, to the last bit."));
    }
    for (case, reason) in results.failures() {
        notes.push(format!("Not simulated: {}: {reason}.", named(results, case)));
    }
    for (case, outcome) in results.cut() {
        let remark = run::remark(&outcome.run);
        let remark = remark.trim_start_matches("! ").trim_end().replace('\n', " ");
        notes.push(format!("{}: {remark}", named(results, case)));
    }
    if results.missing() > 0 {
        notes.push(format!("Interrupted: {} of {} simulations are missing.", results.missing(), results.cases.len()));
    }
    notes
}

/// From what the changes in brackets are.
fn reference(sweep: &Sweep) -> String {
    let same = if sweep.common() > 0 { ", beside the same other settings" } else { "" };
    match sweep.axes.last().and_then(|axis| Some((axis, axis.own()?))) {
        _ if sweep.refines() => format!("Changes are from the finest mesh{same}."),
        Some((axis, own)) => format!("Changes are from {} = {}, the scenario's own value{same}.", axis.name, own.name),
        None => format!("Changes are from the first line{same}."),
    }
}

/// The settings of a case with their names.
fn named(results: &Results, case: &Case) -> String {
    let pairs = results.sweep.headings().into_iter().zip(&case.settings);
    pairs.map(|(name, text)| format!("{name} {text}")).collect::<Vec<_>>().join(", ")
}
