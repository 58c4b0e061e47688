//! Laws that are linear in their coefficients, by linear least squares.

use nalgebra::{DMatrix, DVector};
use ndarray::{Array1, Array2};
use softanvil_kernel::material::Elastic;

use super::statistics::scale_columns;
use super::stress::{nominal, stretches};
use super::{DataSet, Law, MODES, stability};

/// Nominal stress of each of `units` at each point, Pa/Pa, n_point x n_modulus.
pub fn design(units: &[Elastic], data: &[DataSet]) -> DMatrix<f64> {
    let columns: Vec<DVector<f64>> = units
        .iter()
        .map(|elastic| {
            let stresses = data.iter().flat_map(|set| {
                let stretches: Vec<f64> = set.points.iter().map(|point| point.0).collect();
                nominal(elastic, set.mode, &stretches)
            });
            DVector::from_iterator(data.iter().map(|set| set.points.len()).sum(), stresses)
        })
        .collect();
    DMatrix::from_columns(&columns)
}

/// The law with one modulus 1 Pa and the others 0, for each modulus, with these values of its shapes.
pub fn unit_laws(law: &Law, shapes: &[f64]) -> Vec<Elastic> {
    let n = law.parameters.len() - shapes.len();
    let unit = |index: usize| {
        let moduli: Vec<f64> = (0..n).map(|other| if other == index { 1.0 } else { 0.0 }).collect();
        law.elastic(&law.values(&moduli, shapes))
    };
    (0..n).map(unit).collect()
}

/// Singular values below this part of the largest count as zero: the solution is then the shortest one.
const RANK: f64 = 1e-12;

/// The coefficients that minimise |A x - b|, by the singular values of A with scaled columns.
pub fn solve(a: &DMatrix<f64>, b: &DVector<f64>) -> DVector<f64> {
    let (scaled, norms) = scale_columns(a);
    let svd = scaled.svd(true, true);
    let limit = RANK * svd.singular_values.max();
    let solution = svd.solve(b, limit).unwrap_or_else(|_| DVector::zeros(a.ncols()));
    DVector::from_fn(a.ncols(), |index, _| solution[index] / norms[index])
}

/// The x >= 0 that minimises |A x - b|.
pub fn non_negative(a: &DMatrix<f64>, b: &DVector<f64>) -> DVector<f64> {
    let matrix = Array2::from_shape_fn((a.nrows(), a.ncols()), |(i, j)| a[(i, j)]);
    let (x, _) = nnls::nnls(matrix.view(), Array1::from_iter(b.iter().copied()).view());
    DVector::from_iterator(x.len(), x)
}

/// Rounds of adding violated constraints; each adds at most one a mode.
const ROUNDS: usize = 200;
/// A demanded tangent is positive by this part of its sum over the coefficients, so that rounding leaves it positive.
const MARGIN: f64 = 1e-6;

/// As [`solve`], with the sum of the `units` Drucker-stable over the stretches `range`; none if no such one is found.
///
/// Stability asks v^T D v > 0 for every v, where the tangent D is linear in the coefficients. The most violated v of
/// each mode are added as linear constraints until none is violated.
pub fn solve_stable(units: &[Elastic], a: &DMatrix<f64>, b: &DVector<f64>, range: (f64, f64)) -> Option<DVector<f64>> {
    let tangents = tangents(units, range);
    let (scaled, norms) = scale_columns(a);
    let mut constraints: Vec<DVector<f64>> = Vec::new();
    for _ in 0..ROUNDS {
        // Constraints that are not active are dropped: the cost rises with every round, so none can come back for ever.
        let (x, active) = constrained(&scaled, b, &constraints)?;
        constraints = active;
        let before = constraints.len();
        for states in &tangents {
            constraints.extend(most_violated(states, &x, &norms));
        }
        if constraints.len() == before {
            return Some(DVector::from_fn(x.len(), |index, _| x[index] / norms[index]));
        }
    }
    None
}

type Tangents = Vec<Vec<nalgebra::Matrix2<f64>>>;

/// The tangent of each unit coefficient, at each state of each mode.
fn tangents(units: &[Elastic], range: (f64, f64)) -> Vec<Tangents> {
    // The stretches at which stability is looked at afterwards.
    let steps = |end: f64| ((end - 1.0).abs() / stability::STEP - 1e-9).ceil() as i32;
    let (below, above) = (steps(range.0.max(stability::SCAN.0)), steps(range.1.min(stability::SCAN.1)));
    MODES
        .iter()
        .map(|mode| {
            (-below..=above)
                .map(|k| 1.0 + stability::STEP * f64::from(k))
                .map(|l| units.iter().map(|unit| stability::tangent(unit, stretches(*mode, l))).collect())
                .collect()
        })
        .collect()
}

/// The constraint g.x >= 1 (in scaled coefficients) of the state whose tangent is least positive, if it is violated.
fn most_violated(states: &Tangents, x: &DVector<f64>, norms: &[f64]) -> Option<DVector<f64>> {
    let mut worst: Option<(f64, DVector<f64>)> = None;
    for units in states {
        let sum = units
            .iter()
            .zip(x.iter().zip(norms))
            .map(|(unit, (x, norm))| unit * (x / norm))
            .sum::<nalgebra::Matrix2<f64>>();
        let scale: f64 =
            units.iter().zip(x.iter().zip(norms)).map(|(unit, (x, norm))| (unit * (x / norm)).norm()).sum();
        let eigen = sum.symmetric_eigen();
        let lowest = eigen.eigenvalues.imin();
        let excess = eigen.eigenvalues[lowest] / scale - MARGIN;
        if excess < 0.0 && worst.as_ref().is_none_or(|(least, _)| excess < *least) {
            let v = eigen.eigenvectors.column(lowest);
            let floor = 2.0 * MARGIN * scale;
            let row = units.iter().zip(norms).map(|(unit, norm)| (v.transpose() * unit * v)[0] / norm / floor);
            worst = Some((excess, DVector::from_iterator(norms.len(), row)));
        }
    }
    worst.map(|(_, row)| row)
}

/// The x that minimises |A x - b| with g.x >= 1 for every g, as a problem of least distance solved by non-negative least
/// squares (Lawson and Hanson 1974, chapter 23), and the constraints that are active; none if no x meets the constraints.
fn constrained(
    a: &DMatrix<f64>,
    b: &DVector<f64>,
    constraints: &[DVector<f64>],
) -> Option<(DVector<f64>, Vec<DVector<f64>>)> {
    let svd = a.clone().svd(true, true);
    let (u, v_t) = (svd.u?, svd.v_t?);
    let n = a.ncols();
    let limit = RANK * svd.singular_values.max();
    // In units of |b|, or the constraints look all alike. A x - b = U z + (rest), z = S V^T x - U^T b.
    let unit = b.norm().max(f64::MIN_POSITIVE);
    let projected = u.transpose() * b / unit;
    let from_z = |z: &DVector<f64>| {
        let y = DVector::from_fn(n, |i, _| (z[i] + projected[i]) / svd.singular_values[i].max(limit));
        v_t.transpose() * y * unit
    };
    if constraints.is_empty() {
        return Some((from_z(&DVector::zeros(n)), Vec::new()));
    }
    let mut dual = Array2::zeros((n + 1, constraints.len()));
    for (column, g) in constraints.iter().enumerate() {
        let g = &v_t * g;
        let row = DVector::from_fn(n, |i, _| g[i] / svd.singular_values[i].max(limit));
        let bound = 1.0 / unit - row.dot(&projected);
        // Each constraint scaled to unit length, which changes nothing but the condition.
        let length = (row.norm_squared() + bound * bound).sqrt();
        for i in 0..n {
            dual[(i, column)] = row[i] / length;
        }
        dual[(n, column)] = bound / length;
    }
    let mut target = Array1::zeros(n + 1);
    target[n] = 1.0;
    let (multipliers, _) = nnls::nnls(dual.view(), target.view());
    let residual = dual.dot(&multipliers) - &target;
    if residual[n].abs() < f64::EPSILON {
        return None;
    }
    let active = constraints.iter().zip(&multipliers).filter(|(_, multiplier)| **multiplier > 0.0);
    let active = active.map(|(constraint, _)| constraint.clone()).collect();
    Some((from_z(&DVector::from_fn(n, |i, _| -residual[i] / residual[n])), active))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::Mode;
    use crate::law::stability::Stability;

    /// A curve that softens so much that the unconstrained fit is unstable.
    fn softening() -> Vec<DataSet> {
        let stress = |l: f64| 1e5 * (1.0 - (-3.0 * (l - 1.0)).exp());
        let points = (1..20).map(|k| 1.0 + 0.1 * f64::from(k)).map(|l| (l, stress(l))).collect();
        vec![DataSet { mode: Mode::Uniaxial, points }]
    }

    #[test]
    fn a_demanded_stability_is_kept_at_the_least_cost() {
        let data = softening();
        let b = DVector::from_iterator(19, data[0].points.iter().map(|point| point.1));
        let range = (0.5, 3.0);
        for name in ["mooney_rivlin_2", "mooney_rivlin_3", "mooney_rivlin_5", "yeoh_2", "yeoh_3"] {
            let law = Law::find(name).unwrap();
            let units = unit_laws(law, &[]);
            let a = design(&units, &data);
            let stable = |x: &DVector<f64>| Stability::new(&Elastic::new(&law.material(x.as_slice()))).covers(range);
            let (free, bound) = (solve(&a, &b), solve_stable(&units, &a, &b, range).unwrap());
            assert!(stable(&bound), "{name}: {bound}");
            let cost = |x: &DVector<f64>| (&a * x - &b).norm();
            assert!(cost(&bound) >= cost(&free) * (1.0 - 1e-9), "{name}");
            assert!(stable(&free) || cost(&bound) > cost(&free), "{name}");
            // Any step from the bound towards the free minimum leaves the stable set: the bound is the nearest.
            if !stable(&free) {
                assert!(!stable(&(&bound + (&free - &bound) * 0.02)), "{name}");
            }
        }
    }

    #[test]
    fn a_stable_minimum_is_not_moved_by_the_demand() {
        let law = Law::find("mooney_rivlin_2").unwrap();
        let points =
            (1..9).map(|k| 1.0 + 0.2 * f64::from(k)).map(|l: f64| (l, 2.0 * (l - l.powi(-2)) * (3.0 + 1.0 / l)));
        let data = [DataSet { mode: Mode::Uniaxial, points: points.collect() }];
        let b = DVector::from_iterator(8, data[0].points.iter().map(|point| point.1));
        let units = unit_laws(law, &[]);
        let a = design(&units, &data);
        let x = solve_stable(&units, &a, &b, (0.3, 3.0)).unwrap();
        assert!((x - DVector::from_vec(vec![3.0, 1.0])).norm() < 1e-9);
    }
}
