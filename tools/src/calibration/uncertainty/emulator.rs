//! An emulator: polynomials for the logarithms of the simulated numbers, over the parts of the ranges.
//!
//! Least squares over Hermite polynomials of coordinates in which the simulated points have no mean, no correlation and unit
//! variance. The degree, of each output its own, is that with the smallest error at points left out, one at a time (in closed form, by the leverages);
//! these errors are its variances. It says nothing beyond the region in which points were simulated.

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

/// Largest degree.
const DEGREES: std::ops::RangeInclusive<usize> = 1..=4;
/// Points for each coefficient, at least.
const POINTS_PER_TERM: f64 = 1.7;
/// How much farther from the middle than the farthest simulated point the emulator still speaks, in its coordinates.
const REACH: f64 = 1.1;

/// Polynomials for several outputs of the same point.
pub struct Emulator {
    mean: Vec<f64>,
    /// Rows of the lower triangle that turn a deviation from the mean into coordinates.
    whitening: Vec<Vec<f64>>,
    /// Largest distance from the middle.
    radius: f64,
    /// Degree of each coordinate in each term.
    terms: Vec<Vec<usize>>,
    /// Coefficients, term by term, those of all outputs one after the other.
    coefficients: Vec<f64>,
    /// Variance of the error at points left out, by output.
    pub variances: Vec<f64>,
}

/// A fit of one degree to all outputs.
struct Fit {
    /// Coefficients by term and output.
    coefficients: DMatrix<f64>,
    /// Variances of the errors at points left out.
    variances: Vec<f64>,
}

impl Emulator {
    /// Fits `outputs` at `points`; none where there are too few of them.
    pub fn fit(points: &[Vec<f64>], outputs: &[Vec<f64>]) -> Option<Self> {
        let (n, n_output) = (points.first()?.len(), outputs.first()?.len());
        let (mean, whitening) = whitened(points)?;
        let affordable = |degree: &usize| points.len() as f64 >= POINTS_PER_TERM * terms(n, *degree).len() as f64;
        let degrees: Vec<usize> = DEGREES.take_while(affordable).collect();
        let mut emulator = Self {
            mean,
            whitening,
            radius: f64::INFINITY,
            terms: terms(n, *degrees.last()?),
            coefficients: Vec::new(),
            variances: Vec::new(),
        };
        let coordinates: Vec<Vec<f64>> = points.iter().map(|point| emulator.coordinates(point)).collect();
        let rows: Vec<Vec<f64>> = coordinates.iter().map(|coordinates| emulator.values(coordinates)).collect();
        // Terms of a lower degree stand before those of a higher one.
        let fits: Vec<Fit> =
            degrees.iter().filter_map(|degree| fitted(&rows, terms(n, *degree).len(), outputs)).collect();
        let best = |output: usize| {
            fits.iter().min_by(|a, b| a.variances[output].total_cmp(&b.variances[output])).map(|fit| (output, fit))
        };
        let best: Vec<(usize, &Fit)> = (0..n_output).map(best).collect::<Option<_>>()?;
        let coefficient =
            |term: usize, (output, fit): &(usize, &Fit)| fit.coefficients.get((term, *output)).copied().unwrap_or(0.0);
        let all = (0..emulator.terms.len()).flat_map(|term| best.iter().map(move |best| coefficient(term, best)));
        emulator.coefficients = all.collect();
        emulator.variances = best.iter().map(|(output, fit)| fit.variances[*output]).collect();
        emulator.radius = REACH * coordinates.iter().map(|coordinates| length(coordinates)).fold(0.0, f64::max);
        Some(emulator)
    }

    /// The outputs at `point`; none beyond where points were simulated.
    pub fn predict(&self, point: &[f64]) -> Option<Vec<f64>> {
        let coordinates = self.coordinates(point);
        if length(&coordinates) > self.radius {
            return None;
        }
        let n_output = self.variances.len();
        let mut outputs = vec![0.0; n_output];
        for (value, row) in self.values(&coordinates).into_iter().zip(self.coefficients.chunks(n_output)) {
            for (output, coefficient) in outputs.iter_mut().zip(row) {
                *output += value * coefficient;
            }
        }
        Some(outputs)
    }

    /// Largest degree of the polynomials.
    pub fn degree(&self) -> usize {
        self.terms.iter().map(|term| term.iter().sum()).max().unwrap_or(0)
    }

    fn coordinates(&self, point: &[f64]) -> Vec<f64> {
        let deviations: Vec<f64> = point.iter().zip(&self.mean).map(|(value, mean)| value - mean).collect();
        self.whitening.iter().map(|row| row.iter().zip(&deviations).map(|(a, b)| a * b).sum()).collect()
    }

    /// The values of all terms.
    fn values(&self, coordinates: &[f64]) -> Vec<f64> {
        let hermite: Vec<[f64; 5]> = coordinates.iter().map(|x| hermite(*x)).collect();
        let value = |term: &Vec<usize>| term.iter().zip(&hermite).map(|(degree, of)| of[*degree]).product();
        self.terms.iter().map(value).collect()
    }
}

/// Least squares over the first `n_term` values of each row.
fn fitted(rows: &[Vec<f64>], n_term: usize, outputs: &[Vec<f64>]) -> Option<Fit> {
    let count = rows.len();
    let design = DMatrix::from_fn(count, n_term, |row, term| rows[row][term]);
    let wanted = DMatrix::from_fn(count, outputs.first()?.len(), |row, output| outputs[row][output]);
    let mut normal = design.transpose() * &design;
    // Keeps the matrix regular where points lie in a plane; far below any error.
    for term in 0..n_term {
        normal[(term, term)] += 1e-9 * count as f64;
    }
    let solved = Cholesky::<f64, Dyn>::new(normal)?;
    let coefficients = solved.solve(&(design.transpose() * &wanted));
    let residuals = &wanted - &design * &coefficients;
    let leverage = |row: &Vec<f64>| {
        let row = DVector::from_column_slice(&row[..n_term]);
        row.dot(&solved.solve(&row)).min(0.999)
    };
    let leverages: Vec<f64> = rows.iter().map(leverage).collect();
    let left_out = |output: usize| {
        let squares = (0..count).map(|row| (residuals[(row, output)] / (1.0 - leverages[row])).powi(2));
        squares.sum::<f64>() / count as f64
    };
    let variances = (0..wanted.ncols()).map(left_out).collect();
    Some(Fit { coefficients, variances })
}

/// Hermite polynomials of degrees 0 to 4, of unit variance where x is normal.
fn hermite(x: f64) -> [f64; 5] {
    let square = x * x;
    [
        1.0,
        x,
        (square - 1.0) / 2f64.sqrt(),
        (square - 3.0) * x / 6f64.sqrt(),
        ((square - 6.0) * square + 3.0) / 24f64.sqrt(),
    ]
}

/// Degrees of `n` coordinates in all terms up to `degree`, the lowest first.
fn terms(n: usize, degree: usize) -> Vec<Vec<usize>> {
    let mut terms = unordered_terms(n, degree);
    terms.sort_by_key(|term| term.iter().sum::<usize>());
    terms
}

fn unordered_terms(n: usize, degree: usize) -> Vec<Vec<usize>> {
    let Some(rest) = n.checked_sub(1) else { return vec![Vec::new()] };
    let of =
        |own: usize| unordered_terms(rest, degree - own).into_iter().map(move |others| [&[own][..], &others].concat());
    (0..=degree).flat_map(of).collect()
}

fn length(coordinates: &[f64]) -> f64 {
    coordinates.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Mean of `points`, and the inverse of the Cholesky factor of their covariance.
fn whitened(points: &[Vec<f64>]) -> Option<(Vec<f64>, Vec<Vec<f64>>)> {
    let (n, count) = (points.first()?.len(), points.len() as f64);
    let mean: Vec<f64> = (0..n).map(|i| points.iter().map(|point| point[i]).sum::<f64>() / count).collect();
    let covariance = DMatrix::from_fn(n, n, |i, j| {
        let sum = points.iter().map(|point| (point[i] - mean[i]) * (point[j] - mean[j])).sum::<f64>();
        sum / count + if i == j { 1e-12 } else { 0.0 }
    });
    let lower = Cholesky::<f64, Dyn>::new(covariance)?.l();
    let inverse = lower.solve_lower_triangular(&DMatrix::identity(n, n))?;
    Some((mean, (0..n).map(|i| (0..n).map(|j| inverse[(i, j)]).collect()).collect()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use fcmaes_core::Rng;

    #[test]
    fn a_cubic_comes_back_exactly_and_its_error_is_told() {
        let mut random = Rng::new(1);
        let points: Vec<Vec<f64>> = (0..80).map(|_| random.uniform_vec(2)).collect();
        let cubic = |point: &[f64]| 1.0 + point[0] - 2.0 * point[0] * point[1] * point[1] + point[1].powi(3);
        let outputs: Vec<Vec<f64>> =
            points.iter().map(|point| vec![cubic(point), cubic(point) + random.normreal(0.0, 0.05)]).collect();
        let emulator = Emulator::fit(&points, &outputs).unwrap();
        for _ in 0..20 {
            let point: Vec<f64> = random.uniform_vec(2).iter().map(|part| 0.2 + 0.6 * part).collect();
            let found = emulator.predict(&point).unwrap();
            assert!((found[0] - cubic(&point)).abs() < 1e-5, "{found:?}");
        }
        // The noise of the second output is what is left at a point left out.
        assert!(emulator.variances[0].sqrt() < 1e-5, "{:?}", emulator.variances);
        assert!((emulator.variances[1].sqrt() / 0.05 - 1.0).abs() < 0.25, "{:?}", emulator.variances);
    }

    #[test]
    fn nothing_is_said_far_from_the_points_nor_of_too_few() {
        let mut random = Rng::new(1);
        let points: Vec<Vec<f64>> = (0..30).map(|_| random.uniform_vec(2)).collect();
        let outputs: Vec<Vec<f64>> = points.iter().map(|point| vec![point[0]]).collect();
        assert!(Emulator::fit(&points, &outputs).unwrap().predict(&[3.0, 0.5]).is_none());
        assert!(Emulator::fit(&points[..3], &outputs[..3]).is_none());
    }

    #[test]
    fn there_are_as_many_terms_as_there_should_be() {
        // (n + d)! / (n! d!)
        assert_eq!([terms(5, 2).len(), terms(5, 4).len(), terms(2, 3).len()], [21, 126, 10]);
    }
}
