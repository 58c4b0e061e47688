//! What the results of a study say: tables, figures beside those of the paper, sentences and a picture.

use crate::plot::StudyLine;

/// A table for people.
pub struct Sheet {
    /// Above the table.
    pub title: String,
    /// Titles of the columns.
    pub header: Vec<String>,
    /// The rows.
    pub rows: Vec<Vec<String>>,
    /// Leading columns that are texts; the others are numbers.
    pub n_text: usize,
}

/// A figure of the paper beside ours.
pub struct Finding {
    /// Name for programs.
    pub key: &'static str,
    /// What it is.
    pub what: String,
    /// What the paper says.
    pub paper: String,
    /// What is found here, with its unit.
    pub here: String,
    /// The same as a number, in the unit of `here`.
    pub value: f64,
}

/// What a study draws.
pub enum Picture {
    /// Results over the value that is changed.
    Lines {
        /// Above the axes.
        title: &'static str,
        /// Quantity and unit of the horizontal axis, and whether it is logarithmic.
        x: (&'static str, bool),
        /// Quantity and unit of the vertical axis.
        y: &'static str,
        /// The lines.
        lines: Vec<StudyLine>,
    },
    /// Forces over time: points of ms and N.
    Forces {
        /// Above the axes.
        title: &'static str,
        /// What the legend calls them, and their points.
        curves: Vec<(String, Vec<(f64, f64)>)>,
    },
}

/// What the results of a study say.
pub struct Evaluation {
    /// Tables.
    pub sheets: Vec<Sheet>,
    /// The paper beside ours.
    pub findings: Vec<Finding>,
    /// Sentences.
    pub notes: Vec<String>,
    /// The picture.
    pub picture: Picture,
}
