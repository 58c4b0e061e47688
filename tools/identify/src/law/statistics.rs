//! How well a fit describes its data, and how well the data determine its parameters.

use nalgebra::{DMatrix, DVector};
use statrs::distribution::{ContinuousCDF, StudentsT};

/// Numbers of a least-squares fit.
#[derive(Clone, Debug)]
pub struct Statistics {
    /// Number of points.
    pub n_point: usize,
    /// Number of parameters.
    pub n_parameter: usize,
    /// Sum of the squared weighted residuals: Pa^2 with absolute weights, a pure number with relative ones.
    pub residual_sum: f64,
    /// 1 - RSS / TSS of the unweighted stresses.
    pub r_squared: f64,
    /// Root mean square of the unweighted residuals, Pa.
    pub rms: f64,
    /// Largest unweighted residual, Pa.
    pub largest: f64,
    /// Akaike's criterion n ln(RSS/n) + 2 (k + 1), for comparison at the same weights only (Akaike 1974).
    pub aic: f64,
    /// Standard error of each parameter, in its unit; NaN where the data do not determine it.
    pub standard_errors: Vec<f64>,
    /// Correlation of the parameters' errors, n_parameter x n_parameter.
    pub correlation: DMatrix<f64>,
    /// Condition number of the Jacobian after scaling its columns to unit length: by this factor errors of the stress
    /// may grow in the parameters.
    pub condition: f64,
}

impl Statistics {
    /// Of `residuals` (fit less data, Pa) with `weights`, and the unweighted `jacobian` of the fit by its parameters.
    pub fn new(stresses: &[f64], residuals: &[f64], weights: &[f64], jacobian: &DMatrix<f64>) -> Self {
        let (n, k) = (residuals.len(), jacobian.ncols());
        let count = n as f64;
        let residual_sum: f64 = residuals.iter().zip(weights).map(|(r, w)| (r * w).powi(2)).sum();
        let mean = stresses.iter().sum::<f64>() / count;
        let total: f64 = stresses.iter().map(|s| (s - mean).powi(2)).sum();
        let plain: f64 = residuals.iter().map(|r| r * r).sum();
        let weighted = DMatrix::from_fn(n, k, |i, j| weights[i] * jacobian[(i, j)]);
        let covariance = Covariance::new(&weighted);
        // Without degrees of freedom there is nothing to estimate the scatter from.
        let variance = if n > k { residual_sum / (n - k) as f64 } else { f64::NAN };
        Self {
            n_point: n,
            n_parameter: k,
            residual_sum,
            r_squared: 1.0 - plain / total,
            rms: (plain / count).sqrt(),
            largest: residuals.iter().fold(0.0, |largest, r| f64::max(largest, r.abs())),
            aic: count * (residual_sum / count).ln() + 2.0 * (k as f64 + 1.0),
            standard_errors: covariance.diagonal.iter().map(|c| (variance * c).sqrt()).collect(),
            correlation: covariance.correlation,
            condition: covariance.condition,
        }
    }

    /// The same among `n` parameters, of which these are the ones at `places`, in their order, and the others known: an error of 0.
    pub fn among(self, n: usize, places: &[usize]) -> Self {
        let mut standard_errors = vec![0.0; n];
        let mut correlation = DMatrix::identity(n, n);
        for (i, place) in places.iter().enumerate() {
            standard_errors[*place] = self.standard_errors[i];
            places.iter().enumerate().for_each(|(j, other)| correlation[(*place, *other)] = self.correlation[(i, j)]);
        }
        Self { standard_errors, correlation, ..self }
    }

    /// Half-width of the 95 % confidence interval of a parameter in standard errors: Student's t with n - k degrees of
    /// freedom.
    pub fn interval(&self) -> f64 {
        confidence_factor(self.n_point, self.n_parameter)
    }
}

/// The 97.5 % quantile of Student's t for `n_point` points and `n_parameter` parameters; infinite without a degree of
/// freedom.
pub fn confidence_factor(n_point: usize, n_parameter: usize) -> f64 {
    let degrees = n_point.saturating_sub(n_parameter) as f64;
    StudentsT::new(0.0, 1.0, degrees).map_or(f64::INFINITY, |t| t.inverse_cdf(0.975))
}

/// The inverse of J^T J, by the singular values of the scaled Jacobian.
struct Covariance {
    diagonal: Vec<f64>,
    correlation: DMatrix<f64>,
    condition: f64,
}

/// Singular values below this part of the largest are rounding of zero.
const RANK: f64 = 1e-12;

impl Covariance {
    fn new(jacobian: &DMatrix<f64>) -> Self {
        let k = jacobian.ncols();
        let (scaled, norms) = scale_columns(jacobian);
        let svd = scaled.svd(false, true);
        let largest = svd.singular_values.max();
        let smallest = svd.singular_values.min();
        let Some(v) = svd.v_t.filter(|_| smallest > RANK * largest && jacobian.nrows() >= k) else {
            let nothing = DMatrix::from_element(k, k, f64::NAN);
            return Self { diagonal: vec![f64::NAN; k], correlation: nothing, condition: f64::INFINITY };
        };
        let inverse_squares = DVector::from_iterator(k, svd.singular_values.iter().map(|s| 1.0 / (s * s)));
        let inverse = v.transpose() * DMatrix::from_diagonal(&inverse_squares) * &v;
        let correlation = DMatrix::from_fn(k, k, |i, j| inverse[(i, j)] / (inverse[(i, i)] * inverse[(j, j)]).sqrt());
        let diagonal = (0..k).map(|i| inverse[(i, i)] / (norms[i] * norms[i])).collect();
        Self { diagonal, correlation, condition: largest / smallest }
    }
}

/// `matrix` with columns of unit length, and their lengths (1 for a column of zeros).
pub fn scale_columns(matrix: &DMatrix<f64>) -> (DMatrix<f64>, Vec<f64>) {
    let length = |norm: f64| if norm > 0.0 { norm } else { 1.0 };
    let norms: Vec<f64> = matrix.column_iter().map(|column| length(column.norm())).collect();
    (DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| matrix[(i, j)] / norms[j]), norms)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Source: NIST Statistical Reference Datasets, Norris (linear regression of the lowest difficulty): certified
    /// standard deviations of the estimates and R squared.
    #[test]
    fn certified_standard_errors() {
        let data = [
            (0.2, 0.1),
            (337.4, 338.8),
            (118.2, 118.1),
            (884.6, 888.0),
            (10.1, 9.2),
            (226.5, 228.1),
            (666.3, 668.5),
            (996.3, 998.5),
            (448.6, 449.1),
            (777.0, 778.9),
            (558.2, 559.2),
            (0.4, 0.3),
            (0.6, 0.1),
            (775.5, 778.1),
            (666.9, 668.8),
            (338.0, 339.3),
            (447.5, 448.9),
            (11.6, 10.8),
            (556.0, 557.7),
            (228.1, 228.3),
            (995.8, 998.0),
            (887.6, 888.8),
            (120.2, 119.6),
            (0.3, 0.3),
            (0.3, 0.6),
            (556.8, 557.6),
            (339.1, 339.3),
            (887.2, 888.0),
            (999.0, 998.5),
            (779.0, 778.9),
            (11.1, 10.2),
            (118.3, 117.6),
            (229.2, 228.9),
            (669.1, 668.4),
            (448.9, 449.2),
            (0.5, 0.2),
        ];
        let (b0, b1) = (-0.262323073774029, 1.00211681802045);
        let y: Vec<f64> = data.iter().map(|(_, y)| *y).collect();
        let residuals: Vec<f64> = data.iter().map(|(x, y)| b0 + b1 * x - y).collect();
        let jacobian = DMatrix::from_fn(data.len(), 2, |i, j| if j == 0 { 1.0 } else { data[i].0 });
        let statistics = Statistics::new(&y, &residuals, &vec![1.0; data.len()], &jacobian);
        for (found, certified) in statistics.standard_errors.iter().zip([0.232818234301152, 0.429796848199937e-3]) {
            assert!((found / certified - 1.0).abs() < 1e-9, "{found} {certified}");
        }
        assert!((statistics.r_squared - 0.999993745883712).abs() < 1e-12);
        assert!((statistics.residual_sum - 26.6173985294224).abs() < 1e-9);
    }

    /// Source: printed tables of Student's t: 12.706 for one degree of freedom, 2.228 for ten, 1.984 for a hundred.
    #[test]
    fn student_t() {
        for (degrees, t) in [(1, 12.706), (10, 2.228), (100, 1.984)] {
            assert!((confidence_factor(degrees + 2, 2) - t).abs() < 1e-3, "{degrees}");
        }
        assert!(confidence_factor(2, 2).is_infinite());
    }

    #[test]
    fn what_the_data_do_not_determine_has_no_error_estimate() {
        let jacobian = DMatrix::from_fn(5, 2, |i, j| (i + 1) as f64 * (j + 1) as f64);
        let statistics = Statistics::new(&[1.0; 5], &[0.1; 5], &[1.0; 5], &jacobian);
        assert!(statistics.condition.is_infinite() && statistics.standard_errors.iter().all(|e| e.is_nan()));
    }
}
