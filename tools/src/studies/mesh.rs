//! Convergence with the mesh.

use std::ops::Range;

use softanvil_kernel::mesh::Grid;
use softanvil_kernel::scenario::Shape;
use softanvil_kernel::{SAMPLING_INTERVAL, Scenario};

use super::case::{CHANNEL_CLASS, Case, Outcome};
use super::evaluation::{Evaluation, Finding, Picture, Sheet};
use super::results::{Results, Study};
use super::richardson::{Verdict, judge};
use super::values::set;
use crate::failure::Failure;
use crate::measurement::errors::error_percent;
use crate::measurement::quantity::QUANTITIES;
use crate::paper;
use crate::plot::StudyLine;
use crate::text::number::short;

/// The study.
pub static STUDY: Study = Study {
    name: "mesh",
    title: "Convergence with the mesh",
    about: "The same drop on coarser and finer meshes; the time step goes with the elements. Meshes with a whole multiple of \
            the scenario's rows and columns are refined evenly: from those, order and limit are extrapolated \
            (Richardson), and the error of the numbers is estimated as Oberkampf and Roy (2010, chapter 8) advise: factor \
            of safety 1.25 on the formal order 2 where the observed order is within a tenth of it, else 3 on the \
            observed order. Values that do not approach a limit one after the other, on these meshes and those between, \
            get no order, only their spread.",
    values: "rows of cells through the layer",
    default_values: &["2", "3", "4", "5", "7", "10", "14", "20"],
    settings: &["rows", "columns", "element size [mm]"],
    plan: |_, scenario, values| plan(scenario, values),
    evaluate,
};

fn plan(scenario: &Scenario, values: &[String]) -> Result<Vec<Case>, Failure> {
    let own = grid(scenario)?;
    let mut rows = vec![own.n_v];
    for text in values {
        rows.push(text.trim().parse::<usize>().ok().filter(|rows| (1..=1000).contains(rows)).ok_or_else(|| {
            Failure::Input(format!(
                "study mesh: {text} is refused: expected a list of whole numbers of rows, 1 to 1000"
            ))
        })?);
    }
    rows.sort_unstable();
    rows.dedup();
    let case = |rows: usize| {
        let mut scenario = scenario.clone();
        let size = match rows == own.n_v {
            true => scenario.mesh.element_size,
            false => even_size(&scenario, &own, rows).unwrap_or_else(|| scenario.thickness() / rows as f64),
        };
        set(&mut scenario, "mesh.element_size", size)?;
        let grid = grid(&scenario)?;
        let settings = vec![grid.n_v.to_string(), grid.n_u.to_string(), format!("{:.3}", 1e3 * size)];
        Ok(Case { settings, scenario: Ok(scenario) })
    };
    let mut cases: Vec<Case> = rows.into_iter().map(case).collect::<Result<_, Failure>>()?;
    // Two layers may not come in every number of rows.
    cases.dedup_by(|a, b| a.settings[..2] == b.settings[..2]);
    Ok(cases)
}

fn grid(scenario: &Scenario) -> Result<Grid, Failure> {
    Grid::new(scenario).map_err(|error| Failure::Input(error.to_string()))
}

/// An element size that gives `rows` rows, a multiple of those of `own`, and the same multiple of its columns.
fn even_size(scenario: &Scenario, own: &Grid, rows: usize) -> Option<f64> {
    if !rows.is_multiple_of(own.n_v) {
        return None;
    }
    let factor = (rows / own.n_v) as f64;
    let geometry = &scenario.geometry;
    let width = match geometry.shape {
        Shape::Round => 0.5 * std::f64::consts::PI * (geometry.core_radius + 0.5 * scenario.thickness()),
        Shape::Block => 0.5 * geometry.block_width,
    };
    let layers = scenario.layers.iter().enumerate().map(|(place, layer)| (layer.thickness, own.rows_of(place).len()));
    // Sizes that the grid rounds to a count of cells.
    let sizes = |(length, count): (f64, usize)| {
        let count = factor * count as f64;
        length / (count + 0.5)..length / (count - 0.5)
    };
    let columns = sizes((width, own.n_u - own.centre));
    let common = layers.map(sizes).fold(columns, |a: Range<f64>, b| a.start.max(b.start)..a.end.min(b.end));
    (common.start < common.end).then_some(0.5 * (common.start + common.end))
}

/// A number whose convergence is judged.
struct Judged {
    key: &'static str,
    what: String,
    scale: f64,
    decimals: usize,
    /// Differences up to this mean nothing, in SI.
    resolution: f64,
    read: fn(&Outcome) -> f64,
}

fn judged() -> Vec<Judged> {
    let reads: [fn(&Outcome) -> f64; 4] = [|o| o.values[0], |o| o.values[1], |o| o.values[2], |o| o.values[3]];
    let mut judged: Vec<Judged> = QUANTITIES
        .iter()
        .zip(reads)
        .map(|(quantity, read)| Judged {
            key: quantity.key,
            what: format!("{} ({})", quantity.label, quantity.display_unit),
            scale: quantity.display_scale,
            decimals: quantity.decimals + 1,
            // A duration is a whole number of samples.
            resolution: if quantity.display_unit == "ms" { 1.01 * SAMPLING_INTERVAL } else { 0.0 },
            read,
        })
        .collect();
    let what = format!("peak force, CFC {CHANNEL_CLASS} (N)");
    let filtered = Outcome::filtered_peak;
    judged.insert(1, Judged { key: "filtered_peak", what, scale: 1.0, decimals: 1, resolution: 0.0, read: filtered });
    judged
}

fn evaluate(results: &Results) -> Evaluation {
    let rows = |case: &Case| case.settings[0].parse::<usize>().unwrap_or_default();
    let finest = results.done().max_by_key(|(case, _)| rows(case)).map(|(_, outcome)| outcome);
    let mut evaluation = Evaluation {
        sheets: vec![results.sheet("Meshes (changes are from the finest)", &[0, 1, 2], |_| true, finest)],
        findings: Vec::new(),
        notes: Vec::new(),
        picture: picture(results, finest),
    };
    match even_triple(results) {
        Some(triple) => orders(results, &triple, &mut evaluation),
        None => evaluation.notes.push("No three evenly refined meshes: no order of convergence.".into()),
    }
    evaluation
}

/// Rows of three meshes that refine the scenario's evenly by the same factor, the finest ones there are.
fn even_triple(results: &Results) -> Option<[usize; 3]> {
    let own = Grid::new(&results.scenario).ok()?;
    let even: Vec<usize> = results
        .done()
        .map(|(_, outcome)| outcome.run.constants.grid)
        .filter(|grid| grid.n_v % own.n_v == 0 && grid.n_v / own.n_v * own.n_u == grid.n_u)
        .map(|grid| grid.n_v / own.n_v)
        .collect();
    let mut triples = even.iter().filter_map(|&coarse| {
        let ratio = even.iter().filter(|&&middle| {
            middle > coarse && (middle * middle) % coarse == 0 && even.contains(&(middle * middle / coarse))
        });
        ratio.max().map(|&middle| [coarse, middle, middle * middle / coarse])
    });
    triples.next().map(|triple| triple.map(|factor| factor * own.n_v))
}

fn orders(results: &Results, rows: &[usize; 3], evaluation: &mut Evaluation) {
    let outcome = |rows: usize| results.done().find(|(_, o)| o.run.constants.grid.n_v == rows).map(|(_, o)| o);
    let [Some(a), Some(b), Some(c)] = rows.map(outcome) else { return };
    let ratio = rows[1] as f64 / rows[0] as f64;
    let header = ["".into(), format!("{} rows", rows[0]), format!("{} rows", rows[1]), format!("{} rows", rows[2])]
        .into_iter()
        .chain(["order".into(), "limit".into()])
        .chain([rows[0], rows[2]].map(|rows| format!("error of {rows} rows")));
    let mut sheet = Sheet {
        title: format!("Order of convergence and discretisation error, refinement by {}", short(ratio)),
        header: header.collect(),
        rows: Vec::new(),
        n_text: 1,
    };
    for judged in judged() {
        let values = [a, b, c].map(judged.read);
        let verdict = between(results, rows[0], &judged).unwrap_or_else(|| judge(values, ratio, judged.resolution));
        let number = |value: f64| format!("{:.*}", judged.decimals, value * judged.scale);
        let percent = |error: f64| format!("{:.2} %", 100.0 * error / values[2].abs());
        let (order, limit, coarse, fine) = match verdict {
            Verdict::Converging { order, asymptotic, limit, error } => {
                let mark = if asymptotic { "" } else { " (not asymptotic)" };
                (format!("{order:.1}{mark}"), number(limit), percent(error[0]), percent(error[2]))
            }
            Verdict::Scattered { oscillating, spread } => {
                let why = if oscillating { "none: not monotone" } else { "none: changes grow" };
                let spread = format!("spread {}", percent(spread));
                (why.into(), "-".into(), spread.clone(), spread)
            }
            Verdict::Settled { spread } => {
                let text = format!("spread {}", percent(spread));
                ("settled within a sample".into(), "-".into(), text.clone(), text)
            }
        };
        let estimate = match verdict {
            Verdict::Converging { error, .. } => error[0],
            Verdict::Scattered { spread, .. } | Verdict::Settled { spread } => spread,
        };
        evaluation.findings.push(Finding {
            key: judged.key,
            what: format!("{}: discretisation error of {} rows", judged.what, rows[0]),
            paper: format!("convergence gave {} mm, no error printed", short(1e3 * paper::ELEMENT_SIZE)),
            here: coarse.clone(),
            value: 100.0 * estimate / values[2].abs(),
        });
        let texts = [judged.what.clone()].into_iter().chain(values.map(number)).chain([order, limit, coarse, fine]);
        sheet.rows.push(texts.collect());
    }
    evaluation.sheets.push(sheet);
}

/// The spread from `coarsest` rows on, if the meshes between the three show that the values do not settle one after the
/// other.
fn between(results: &Results, coarsest: usize, judged: &Judged) -> Option<Verdict> {
    let meshes = results.done().filter(|(_, outcome)| outcome.run.constants.grid.n_v >= coarsest);
    let values: Vec<f64> = meshes.map(|(_, outcome)| (judged.read)(outcome)).collect();
    let changes: Vec<f64> = values.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let oscillating = changes.windows(2).any(|pair| pair[0] * pair[1] < 0.0);
    let (low, high) = values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(*v), h.max(*v)));
    (oscillating && high - low > judged.resolution).then_some(Verdict::Scattered { oscillating, spread: high - low })
}

fn picture(results: &Results, finest: Option<&Outcome>) -> Picture {
    let line = |judged: Judged| {
        let point = |(case, outcome): (&Case, &Outcome)| {
            let size = case.settings[2].parse().ok()?;
            Some((size, error_percent((judged.read)(outcome), (judged.read)(finest?))))
        };
        let label = judged.what.split(" (").next().unwrap_or_default().to_string();
        StudyLine { label, dashed: false, points: results.done().filter_map(point).collect() }
    };
    Picture::Lines {
        title: "Change of the numbers from the finest mesh",
        x: ("element size (mm)", false),
        y: "change (%)",
        lines: judged().into_iter().map(line).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use softanvil_kernel::preset;

    #[test]
    fn multiples_of_the_rows_come_with_the_same_multiple_of_the_columns() {
        let mut scenario = preset::study();
        let own = Grid::new(&scenario).unwrap();
        for factor in [2, 3, 4] {
            let mut fine = scenario.clone();
            fine.mesh.element_size = even_size(&scenario, &own, factor * own.n_v).unwrap();
            let grid = Grid::new(&fine).unwrap();
            assert_eq!((grid.n_v, grid.n_u), (factor * own.n_v, factor * own.n_u));
        }
        assert_eq!(even_size(&scenario, &own, own.n_v + 1), None);
        // A skin of one row that is thinner than an element does not refine with the silicone.
        scenario.add_layer(softanvil_kernel::preset::chamois()).unwrap();
        let own = Grid::new(&scenario).unwrap();
        assert_eq!(even_size(&scenario, &own, 2 * own.n_v), None);
    }
}
