//! The pages of the calibrations against the sets that are shipped: every error on them is computed anew.

use std::fs;
use std::path::{Path, PathBuf};

use softanvil_tools::calibration::objective::{Evaluation, evaluate};
use softanvil_tools::calibration::problem::Problem;
use softanvil_tools::measurement::errors::error_percent;
use softanvil_tools::scenario_file;

/// Half of the last printed digit, and what the values of a set have lost in its file.
const PRINTED: f64 = 0.0501;
/// The same of distances, which have two digits.
const DISTANCE: f64 = 0.00501;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// A problem, its shipped set, and what that gives now.
struct Shipped {
    problem: Problem,
    values: Vec<f64>,
    evaluation: Evaluation,
}

impl Shipped {
    fn new(problem: &str, set: &str) -> Self {
        let problem = Problem::read(&root().join("calibration").join(problem)).unwrap();
        let scenario = scenario_file::read(&root().join("calibration").join(set), &problem.scenario).unwrap();
        let values: Vec<f64> = problem.variables.iter().map(|variable| variable.get(&scenario)).collect();
        let evaluation = evaluate(&problem, &values);
        assert!(evaluation.refusal.is_none(), "{set}: {:?}", evaluation.refusal);
        Self { problem, values, evaluation }
    }

    /// Errors in the order of the impacts and of the four numbers, with whether each was tuned, %.
    fn errors(&self) -> Vec<(f64, bool)> {
        let impacts = self.problem.targets.iter().zip(&self.evaluation.impacts);
        let of_impact = |(target, simulated): (&softanvil_tools::calibration::target::Target, _)| {
            let simulated: &softanvil_tools::calibration::objective::Simulated = simulated;
            let errors = target.measured.iter().zip(simulated.values).zip(target.counts);
            errors
                .map(|((measured, value), counts)| (error_percent(value, measured.unwrap()), counts))
                .collect::<Vec<_>>()
        };
        impacts.flat_map(of_impact).collect()
    }

    /// Distances from the material tests that count.
    fn distances(&self) -> Vec<f64> {
        let scenario = softanvil_tools::calibration::objective::scenario(&self.problem, &self.values).unwrap();
        let counted = self.problem.material_tests.iter().filter(|test| !test.predict);
        counted.map(|test| test.distance(test.model(&scenario))).collect()
    }
}

fn mean(errors: impl IntoIterator<Item = f64>) -> f64 {
    let errors: Vec<f64> = errors.into_iter().map(f64::abs).collect();
    errors.iter().sum::<f64>() / errors.len() as f64
}

fn cells(line: &str) -> Vec<&str> {
    line.trim().trim_matches('|').split('|').map(str::trim).collect()
}

/// The number in a cell, without what marks it.
fn number(cell: &str) -> f64 {
    let text = cell.trim_matches('*');
    text.parse().unwrap_or_else(|_| panic!("{cell} is no number"))
}

fn agrees(page: &str, computed: f64, tolerance: f64, what: &str) {
    assert!((number(page) - computed).abs() < tolerance, "{what}: the page has {page}, the set gives {computed}");
}

/// Files of a folder of `calibration`, without their ending.
fn names(folder: &str) -> Vec<String> {
    let files = fs::read_dir(root().join("calibration").join(folder)).unwrap().map(|entry| entry.unwrap().path());
    let problems = files.filter(|path| path.extension().is_some_and(|extension| extension == "toml"));
    let mut names: Vec<String> =
        problems.map(|path| path.file_stem().unwrap().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

#[test]
fn the_errors_of_the_protocols_are_those_of_the_shipped_sets() {
    let page = fs::read_to_string(root().join("docs/protocols.md")).unwrap();
    let header = cells(page.lines().find(|line| line.starts_with("| energy |")).unwrap());
    let rows: Vec<Vec<&str>> =
        page.lines().map(cells).filter(|row| row.len() == 11 && row[0].ends_with(" J")).collect();
    assert_eq!(rows.len(), 12);
    let labels: Vec<Vec<&str>> = page.lines().filter(|line| line.starts_with("| (")).map(cells).collect();
    let names = names("");
    assert_eq!((names.len(), header.len(), labels.len()), (8, 11, 8));
    for name in names {
        let shipped = Shipped::new(&format!("{name}.toml"), &format!("best/{name}.toml"));
        let column = header.iter().position(|title| title.split(' ').nth(1) == Some(&name)).unwrap();
        let errors = shipped.errors();
        for (row, (error, counts)) in rows.iter().zip(&errors) {
            agrees(row[column], *error, PRINTED, &format!("{name}, {} {}", row[0], row[1]));
            assert_eq!(row[column].starts_with('*'), !counts, "{name}: what was predicted is in italics");
        }
        // The rows of the first table are in the order of the columns of the second.
        let label = &labels[column - 3];
        let part = |counted: bool| mean(errors.iter().filter(|error| error.1 == counted).map(|error| error.0));
        agrees(label[2], mean(errors.iter().map(|error| error.0)), PRINTED, &format!("{name}, mean of twelve"));
        agrees(label[3], part(true), PRINTED, &format!("{name}, mean of the tuned"));
        if errors.iter().any(|error| !error.1) {
            agrees(label[4], part(false), PRINTED, &format!("{name}, mean of the predicted"));
        }
        let fitted = format!("{} / {}", shipped.values.len(), errors.iter().filter(|error| error.1).count());
        assert_eq!(label[1], fitted, "{name}: parameters and numbers fitted");
    }
}

#[test]
fn the_distances_on_the_page_are_those_of_the_shipped_set() {
    let page = fs::read_to_string(root().join("docs/protocols.md")).unwrap();
    let shipped = Shipped::new("material-tests.toml", "best/material-tests.toml");
    let scenario = softanvil_tools::calibration::objective::scenario(&shipped.problem, &shipped.values).unwrap();
    for test in &shipped.problem.material_tests {
        let row = page.lines().find(|line| line.starts_with(&format!("| {} |", test.name))).unwrap();
        let distance = cells(row)[4].split(' ').next().unwrap();
        agrees(distance, test.distance(test.model(&scenario)), PRINTED, &test.name);
    }
}

#[test]
fn the_errors_of_the_mechanisms_are_those_of_the_shipped_sets() {
    let page = fs::read_to_string(root().join("docs/mechanisms.md")).unwrap();
    let names = names("mechanisms");
    assert_eq!(names, self::names("mechanisms/best"));
    for name in names {
        let shipped = Shipped::new(&format!("mechanisms/{name}.toml"), &format!("mechanisms/best/{name}.toml"));
        let errors = shipped.errors();
        let title = format!("| `{name}` |");
        let rows: Vec<Vec<&str>> = page.lines().filter(|line| line.starts_with(&title)).map(cells).collect();
        assert_eq!(rows[0][2], shipped.values.len().to_string(), "{name}: parameters");
        agrees(rows[0][3], mean(errors.iter().map(|error| error.0)), PRINTED, &format!("{name}, mean of twelve"));
        let worst = errors.iter().map(|error| error.0).fold(0.0, |a: f64, b| if b.abs() > a.abs() { b } else { a });
        agrees(rows[0][4], worst, PRINTED, &format!("{name}, largest"));
        assert_eq!(rows[1].len(), 13);
        for (cell, (error, _)) in rows[1][1..].iter().zip(errors) {
            agrees(cell, error, PRINTED, &name);
        }
    }
}

#[test]
fn the_front_on_the_page_is_that_of_the_shipped_sets() {
    let page = fs::read_to_string(root().join("docs/mechanisms.md")).unwrap();
    let names = names("front");
    let mut before = f64::INFINITY;
    for name in &names {
        let shipped = Shipped::new("material-tests.toml", &format!("front/{name}.toml"));
        let weight = name.strip_prefix("weight-").unwrap();
        let row = page.lines().map(cells).find(|cells| cells.len() == 6 && cells[0] == weight).unwrap();
        agrees(row[1], mean(shipped.errors().iter().map(|error| error.0)), PRINTED, name);
        let distances = shipped.distances();
        let distance = (distances.iter().map(|d| d * d).sum::<f64>() / distances.len() as f64).sqrt();
        agrees(row[3], distance, DISTANCE, name);
        // The more they weigh the nearer it is to the tests: in the order of the names, which is that of the weights.
        assert!(distance < before, "{name}: {distance} after {before}");
        before = distance;
        for layer in
            &softanvil_tools::calibration::objective::scenario(&shipped.problem, &shipped.values).unwrap().layers
        {
            let ratio = layer.material.poissons_ratio_0();
            assert!(ratio > 0.0, "{name}: Poisson's ratio at once is {ratio}");
        }
    }
    assert_eq!(names.len(), 5);
}
