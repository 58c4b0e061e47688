//! What a study shows: for people as text or Markdown, for programs as JSON and CSV, and as a picture.

use std::fmt::Write;

use serde_json::{Map, Value, json};

use super::columns::{self, COLUMNS};
use super::evaluation::{Evaluation, Finding, Picture, Sheet};
use super::results::Results;
use crate::measurement::series::CONTACT_FORCE;
use crate::output::subject::{Subject, warning_lines, warnings_of};
use crate::plot::picture_format::PictureFormat;
use crate::plot::{self, PlotError};
use crate::text::table::{FIXED_BLANK, align_right, new_plain_table, text as table_text};
use crate::text::wrap::filled;
use crate::{paper, run};

/// Everything about one study.
pub struct Page {
    results: Results,
    evaluation: Evaluation,
    subject: Subject,
}

impl Page {
    /// Evaluates `results`, changes of the drop of `subject`.
    pub fn new(results: Results, subject: Subject) -> Self {
        let mut evaluation = (results.study.evaluate)(&results);
        for (case, reason) in results.failures() {
            evaluation.notes.push(format!("Not simulated: {}: {reason}.", named(&results, &case.settings)));
        }
        for (case, outcome) in results.cut() {
            let remark = run::remark(&outcome.run);
            let remark = remark.trim_start_matches("! ").trim_end().replace('\n', " ");
            evaluation.notes.push(format!("{}: {remark}", named(&results, &case.settings)));
        }
        if results.missing() > 0 {
            let (missing, all) = (results.missing(), results.cases.len());
            evaluation.notes.push(format!("Interrupted: {missing} of {all} simulations are missing."));
        }
        Self { results, evaluation, subject }
    }

    /// Name of the study.
    pub fn name(&self) -> &'static str {
        self.results.study.name
    }

    /// Title of the study.
    pub fn title(&self) -> &'static str {
        self.results.study.title
    }

    /// The paper beside ours.
    pub fn findings(&self) -> &[Finding] {
        &self.evaluation.findings
    }

    /// Whether the anvil is the paper's, so that its figures stand beside ours.
    fn is_of_the_paper(&self) -> bool {
        paper::is_its_model(&self.results.scenario)
    }

    fn warnings(&self) -> String {
        warning_lines(&warnings_of(&self.results.scenario).unwrap_or_default())
    }

    /// For a terminal.
    pub fn text(&self) -> String {
        let study = self.results.study;
        let about = filled(study.about);
        let mut text = format!("{}\n{about}\n{}{}", study.title, self.subject.text(), self.warnings());
        for sheet in self.sheets() {
            let header: Vec<&str> = sheet.header.iter().map(String::as_str).collect();
            let mut table = new_plain_table(&header);
            let fixed = |text: &String| text.replace(" %", &format!("{}%", FIXED_BLANK));
            table.add_rows(sheet.rows.iter().map(|row| row.iter().map(fixed).collect::<Vec<_>>()));
            align_right(&mut table, sheet.n_text..sheet.header.len());
            let _ = write!(text, "\n{}{}\n", filled(&sheet.title), table_text(&mut table));
        }
        if !self.evaluation.notes.is_empty() {
            text.push('\n');
        }
        for note in &self.evaluation.notes {
            text += &filled(&format!("* {note}"));
        }
        text
    }

    /// For the documentation; the picture is expected beside the page, in this format.
    pub fn markdown(&self, pictures: PictureFormat) -> String {
        let study = self.results.study;
        let mut text = format!("# {}\n\n{}\n\n{}{}", study.title, study.about, self.subject.text(), self.warnings());
        for sheet in self.sheets() {
            let _ = write!(text, "\n## {}\n\n{}", sheet.title, sheet.markdown());
        }
        if !self.evaluation.notes.is_empty() {
            text.push('\n');
        }
        for note in &self.evaluation.notes {
            let _ = writeln!(text, "* {note}");
        }
        let _ = write!(text, "\n![{}]({}.{})\n\n", study.title, study.name, pictures.extension());
        let _ = writeln!(
            text,
            "Every simulation is a line of [{name}.csv]({name}.csv). Made by `softanvil study {name}`.",
            name = study.name
        );
        text
    }

    /// The tables, the one of the findings first.
    fn sheets(&self) -> impl Iterator<Item = Sheet> {
        let findings = (!self.evaluation.findings.is_empty()).then(|| findings_sheet(self));
        findings.into_iter().chain(self.evaluation.sheets.iter().map(Sheet::copy))
    }

    /// For other programs, in SI.
    pub fn json(&self) -> Value {
        let study = self.results.study;
        let with_paper = self.is_of_the_paper();
        let findings = self.evaluation.findings.iter().map(|finding| {
            let paper = with_paper.then_some(finding.paper.as_str());
            json!({ "key": finding.key, "what": finding.what, "paper": paper, "here": finding.here,
                    "value": finding.value })
        });
        let rows = self.results.cases.iter().zip(&self.results.outcomes).filter_map(|(case, outcome)| {
            let mut object = Map::new();
            let settings = study.settings.iter().zip(&case.settings);
            object.extend(settings.map(|(name, text)| {
                let (name, text) = columns::si(name, text);
                (name, Value::from(text))
            }));
            match outcome.as_ref()? {
                Ok(outcome) => {
                    object.extend(COLUMNS.iter().map(|column| (column.key.into(), (column.read)(outcome).into())));
                    object.extend(crate::output::json::of_ending(&outcome.run));
                    object.insert("trace_hash".into(), outcome.run.trace_hash().into());
                }
                Err(reason) => {
                    object.insert("failure".into(), reason.as_str().into());
                }
            }
            Some(Value::Object(object))
        });
        json!({
            "study": study.name,
            "drop": self.subject.json(),
            "warnings": warnings_of(&self.results.scenario).unwrap_or_default(),
            "missing": self.results.missing(),
            "findings": findings.collect::<Vec<_>>(),
            "notes": self.evaluation.notes,
            "cases": rows.collect::<Vec<_>>(),
        })
    }

    /// The picture, as SVG.
    ///
    /// # Errors
    /// What the drawing library refuses.
    pub fn svg(&self) -> Result<String, PlotError> {
        match &self.evaluation.picture {
            Picture::Lines { title, x, y, lines } => plot::study(title, *x, y, lines),
            Picture::Forces { title, curves } => plot::forces(title, CONTACT_FORCE, curves.clone()),
        }
    }

    /// The simulations as CSV.
    ///
    /// # Errors
    /// What the CSV library refuses.
    pub fn csv(&self) -> Result<Vec<u8>, csv::Error> {
        let mut csv = csv::Writer::from_writer(Vec::new());
        csv.write_record(columns::header(self.results.study))?;
        for (number, outcome) in self.results.outcomes.iter().enumerate() {
            if let Some(outcome) = outcome {
                csv.write_record(columns::record(
                    self.results.study,
                    number,
                    &self.results.cases[number].settings,
                    outcome,
                ))?;
            }
        }
        csv.into_inner().map_err(|error| csv::Error::from(error.into_error()))
    }
}

impl Sheet {
    fn copy(&self) -> Self {
        Self { title: self.title.clone(), header: self.header.clone(), rows: self.rows.clone(), n_text: self.n_text }
    }

    /// As a table of Markdown.
    fn markdown(&self) -> String {
        let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
        let rule = (0..self.header.len()).map(|i| if i < self.n_text { "---" } else { "---:" });
        let mut text = line(&self.header) + &format!("|{}|\n", rule.collect::<Vec<_>>().join("|"));
        self.rows.iter().for_each(|row| text += &line(row));
        text
    }
}

/// The findings as a table.
fn findings_sheet(page: &Page) -> Sheet {
    let with_paper = page.is_of_the_paper();
    let title = if with_paper { "The paper beside this model" } else { "Findings" };
    let (header, rows) = findings_table(page, with_paper);
    Sheet { title: title.into(), n_text: header.len(), header, rows }
}

/// Header and rows of the findings, with or without what the paper says.
fn findings_table(page: &Page, with_paper: bool) -> (Vec<String>, Vec<Vec<String>>) {
    let row = |what: &str, paper: &str, here: &str| {
        let texts = if with_paper { vec![what, paper, here] } else { vec![what, here] };
        texts.into_iter().map(String::from).collect()
    };
    let rows = page.findings().iter().map(|finding| row(&finding.what, &finding.paper, &finding.here));
    (row("", "paper", "here"), rows.collect())
}

/// A table of the findings of all `pages`, in Markdown, with links to the pages.
pub fn overview(pages: &[Page]) -> String {
    let with_paper = pages.iter().all(Page::is_of_the_paper);
    let mut sheet = Sheet { title: String::new(), header: Vec::new(), rows: Vec::new(), n_text: 0 };
    for page in pages {
        let (header, rows) = findings_table(page, with_paper);
        for (index, row) in rows.into_iter().enumerate() {
            let study = if index == 0 { format!("[{}]({}.md)", page.name(), page.name()) } else { String::new() };
            sheet.rows.push([study].into_iter().chain(row).collect());
        }
        sheet.header = ["study".to_string()].into_iter().chain(header).collect();
    }
    sheet.n_text = sheet.header.len();
    sheet.markdown()
}

/// Settings with their names.
fn named(results: &Results, settings: &[String]) -> String {
    let pairs = results.study.settings.iter().zip(settings).filter(|(_, text)| !text.is_empty());
    pairs.map(|(name, text)| format!("{name} {text}")).collect::<Vec<_>>().join(", ")
}
