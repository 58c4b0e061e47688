//! Convergence with the mesh: the same drop on coarser and finer meshes, and what they say of the discretisation error.

use itertools::Itertools;
use softanvil_kernel::mesh::Grid;
use softanvil_kernel::{SAMPLING_INTERVAL, Scenario};

use super::case::{CHANNEL_CLASS, Outcome};
use super::richardson::{Verdict, judge};
use super::sheet::Sheet;
use crate::measurement::quantity::QUANTITIES;
use crate::text::number::short;

/// Refinements unless told otherwise: three meshes, each twice as fine as the one before, and those between.
pub const REFINEMENTS: &str = "1,1.4,2,2.8,4";

/// How the order and the errors come about.
pub const METHOD: &str = "The time step goes with the elements. Meshes with a whole multiple of the scenario's rows and columns \
    are refined evenly: from three of those, order and limit are extrapolated (Richardson), and the error of the numbers is \
    estimated as Oberkampf and Roy (2010, chapter 8) advise: factor of safety 1.25 on the formal order 2 where the observed \
    order is within a tenth of it, else 3 on the observed order. Values that do not approach a limit one after the other, on \
    these meshes and those between, get no order, only their spread.";

/// Element sizes tried around the one asked for, in thousandths of it, until the mesh is refined evenly.
const TRIED: i32 = 250;

/// `scenario` on meshes finer by `refinements` and on its own, the coarsest first, each with its rows and columns.
///
/// # Errors
/// A mesh that is refused.
pub fn meshes(scenario: &Scenario, refinements: &[f64]) -> Result<Vec<([String; 2], Scenario)>, String> {
    let own = Grid::new(scenario).map_err(|error| error.to_string())?;
    let mut refinements = [refinements, &[1.0]].concat();
    refinements.sort_by(f64::total_cmp);
    let mut meshes: Vec<([String; 2], Scenario)> = Vec::new();
    for refinement in refinements {
        let mut scenario = scenario.clone();
        if refinement != 1.0 {
            scenario.mesh.element_size = size(&scenario, &own, refinement);
        }
        scenario.validate().map_err(|error| error.to_string())?;
        let grid = Grid::new(&scenario).map_err(|error| error.to_string())?;
        let counts = [grid.n_v, grid.n_u].map(|count| count.to_string());
        // Layers may not come in every number of rows.
        if meshes.iter().all(|(known, _)| *known != counts) {
            meshes.push((counts, scenario));
        }
    }
    Ok(meshes)
}

/// An element size that is smaller by `refinement`; for a whole one the nearest that refines rows and columns alike, if any.
fn size(scenario: &Scenario, own: &Grid, refinement: f64) -> f64 {
    let plain = scenario.mesh.element_size / refinement;
    let is_even = |size: &f64| {
        let mut refined = scenario.clone();
        refined.mesh.element_size = *size;
        Grid::new(&refined).is_ok_and(|grid| factor(&grid, own) == Some(refinement as usize))
    };
    let near = (0..TRIED).flat_map(|k| [k, -k]).map(|k| plain * (1.0 + 1e-3 * f64::from(k)));
    let even = if refinement.fract() == 0.0 { near.into_iter().find(is_even) } else { None };
    even.unwrap_or(plain)
}

/// By what whole factor `grid` refines `own` evenly; none if it does not.
fn factor(grid: &Grid, own: &Grid) -> Option<usize> {
    let factor = grid.n_v / own.n_v;
    (factor > 0 && (grid.n_v, grid.n_u) == (factor * own.n_v, factor * own.n_u)).then_some(factor)
}

/// A number whose convergence is judged.
pub struct Judged {
    /// Its name, without the unit.
    pub label: String,
    unit: &'static str,
    scale: f64,
    decimals: usize,
    /// Differences up to this mean nothing, in SI.
    resolution: f64,
    /// Reads it, in SI.
    pub read: Box<dyn Fn(&Outcome) -> f64>,
}

/// The four numbers, and the filtered peak force.
pub fn judged() -> Vec<Judged> {
    let mut judged: Vec<Judged> = QUANTITIES
        .iter()
        .enumerate()
        .map(|(index, quantity)| Judged {
            label: quantity.label.into(),
            unit: quantity.display_unit,
            scale: quantity.display_scale,
            decimals: quantity.decimals + 1,
            // A duration is a whole number of samples.
            resolution: if quantity.display_unit == "ms" { 1.01 * SAMPLING_INTERVAL } else { 0.0 },
            read: Box::new(move |outcome| outcome.values[index]),
        })
        .collect();
    let (label, read) = (format!("peak force, CFC {CHANNEL_CLASS}"), Box::new(Outcome::filtered_peak));
    judged.insert(1, Judged { label, unit: "N", scale: 1.0, decimals: 1, resolution: 0.0, read });
    judged
}

/// Order of convergence and errors of the same drop on `meshes`, the coarsest first; none without three evenly refined ones.
pub fn orders(title: &str, meshes: &[&Outcome]) -> Option<Sheet> {
    let triple = even_triple(meshes)?;
    let rows = triple.map(|outcome| outcome.run.constants.grid.n_v);
    let ratio = rows[1] as f64 / rows[0] as f64;
    let header = rows.map(|rows| format!("{rows} rows")).into_iter().chain(["order".into(), "limit".into()]);
    let errors = [rows[0], rows[2]].map(|rows| format!("error of {rows} rows"));
    Some(Sheet {
        title: format!("{title}, refinement by {}", short(ratio)),
        header: std::iter::once(String::new()).chain(header).chain(errors).collect(),
        rows: judged().iter().map(|judged| judged.row(&triple, ratio, between(rows[0], meshes, judged))).collect(),
        n_text: 1,
    })
}

/// The finest three meshes that are refined evenly, twice by the same factor.
fn even_triple<'a>(meshes: &[&'a Outcome]) -> Option<[&'a Outcome; 3]> {
    let refined = |fine: &Outcome, coarse: &Outcome| factor(&fine.run.constants.grid, &coarse.run.constants.grid);
    let triples = meshes.iter().copied().tuple_combinations().filter(|(coarse, middle, fine)| {
        refined(fine, middle).is_some_and(|factor| factor > 1 && refined(middle, coarse) == Some(factor))
    });
    triples.last().map(|(coarse, middle, fine)| [coarse, middle, fine])
}

/// The spread from `coarsest` rows on, if the meshes between the three show that the values do not settle one after the
/// other.
fn between(coarsest: usize, meshes: &[&Outcome], judged: &Judged) -> Option<Verdict> {
    let finer = meshes.iter().filter(|outcome| outcome.run.constants.grid.n_v >= coarsest);
    let values: Vec<f64> = finer.map(|outcome| (judged.read)(outcome)).collect();
    let changes: Vec<f64> = values.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let oscillating = changes.windows(2).any(|pair| pair[0] * pair[1] < 0.0);
    let (low, high) = values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(*v), h.max(*v)));
    (oscillating && high - low > judged.resolution).then_some(Verdict::Scattered { oscillating, spread: high - low })
}

impl Judged {
    /// The line of the table of orders.
    fn row(&self, triple: &[&Outcome; 3], ratio: f64, scattered: Option<Verdict>) -> Vec<String> {
        let values = triple.map(|outcome| (self.read)(outcome));
        let number = |value: f64| format!("{:.*}", self.decimals, value * self.scale);
        let percent = |error: f64| format!("{:.2} %", 100.0 * error / values[2].abs());
        let spread = |spread: f64| format!("spread {}", percent(spread));
        let verdict = match scattered.unwrap_or_else(|| judge(values, ratio, self.resolution)) {
            Verdict::Converging { order, asymptotic, limit, error } => {
                let mark = if asymptotic { "" } else { " (not asymptotic)" };
                [format!("{order:.1}{mark}"), number(limit), percent(error[0]), percent(error[2])]
            }
            Verdict::Scattered { oscillating, spread: all } => {
                let why = if oscillating { "none: not monotone" } else { "none: changes grow" };
                [why.into(), "-".into(), spread(all), spread(all)]
            }
            Verdict::Settled { spread: all } => {
                ["settled within a sample".into(), "-".into(), spread(all), spread(all)]
            }
        };
        let what = format!("{} ({})", self.label, self.unit);
        std::iter::once(what).chain(values.map(number)).chain(verdict).collect()
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
        let sizes = meshes(&scenario, &[2.0, 3.0, 4.0, 1.4]).unwrap();
        let rows: Vec<&str> = sizes.iter().map(|([rows, _], _)| rows.as_str()).collect();
        assert_eq!(rows, ["5", "7", "10", "15", "20"]);
        let factors: Vec<_> = sizes.iter().map(|(_, fine)| factor(&Grid::new(fine).unwrap(), &own)).collect();
        assert_eq!(factors, [Some(1), None, Some(2), Some(3), Some(4)]);
        // A skin of one row that is thinner than an element does not refine with the silicone.
        scenario.add_layer(preset::chamois()).unwrap();
        let own = Grid::new(&scenario).unwrap();
        let fine = meshes(&scenario, &[2.0]).unwrap().remove(1).1;
        assert_eq!(factor(&Grid::new(&fine).unwrap(), &own), None);
    }
}
