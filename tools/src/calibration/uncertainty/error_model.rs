//! How likely the measured numbers are: a simulated number times a log-normal error, rounded as it was printed.
//!
//! ln y = ln f + e with e normal of variance noise^2 + discrepancy^2 (+ that of an emulator), and what is known is that
//! y lies in the interval that was rounded to the printed value. The discrepancies, one of each of the four quantities, are
//! inferred together with the parameters under half-normal priors.

use super::normal::ln_probability;
use super::options::UncertaintyOptions;
use crate::calibration::problem::Problem;
use crate::calibration::target::Target;
use crate::measurement::quantity::{COUNT, QUANTITIES};
use crate::paper::{DECIMALS, TABLE_1};

/// A measured number that counts.
#[derive(Clone, Copy, Debug)]
pub struct Number {
    /// Index of its impact among the targets.
    pub target: usize,
    /// Index of its quantity.
    pub quantity: usize,
    /// Logarithms of the ends of the interval in which it lies, of its SI value.
    pub interval: [f64; 2],
}

/// The measured numbers with what is known of their errors.
#[derive(Clone, Debug)]
pub struct ErrorModel {
    /// The numbers that count.
    pub numbers: Vec<Number>,
    /// Relative standard deviation of the measurement, by quantity.
    pub noise: [f64; COUNT],
    /// Scales of the priors of the discrepancies, by quantity.
    pub scales: [f64; COUNT],
    /// The quantities whose discrepancy is inferred.
    pub inferred: Vec<usize>,
}

impl ErrorModel {
    /// The error model of `problem`.
    ///
    /// # Errors
    /// A problem without a number that counts, or an impact of a trace alone.
    pub fn new(problem: &Problem) -> Result<Self, String> {
        let options = &problem.uncertainty;
        let mut numbers = Vec::new();
        for (index, target) in problem.targets.iter().enumerate().filter(|(_, target)| !target.predict) {
            if target.measured.iter().all(Option::is_none) {
                let keys = QUANTITIES.each_ref().map(|quantity| quantity.key).join(", ");
                return Err(format!(
                    "--uncertainty takes measured numbers, and the impact of {} J has a trace alone: give some of {keys} \
                     (softanvil measure --trace prints them), or predict = true",
                    target.energy
                ));
            }
            numbers.extend(intervals(target, options).map(|(quantity, interval)| Number {
                target: index,
                quantity,
                interval,
            }));
        }
        if numbers.is_empty() {
            return Err("--uncertainty needs a measured number that counts".into());
        }
        Ok(Self::of(numbers, options))
    }

    /// The same of these numbers.
    pub fn of(numbers: Vec<Number>, options: &UncertaintyOptions) -> Self {
        let scales = options.discrepancy();
        let counts = |quantity: usize| numbers.iter().any(|number| number.quantity == quantity);
        let inferred = (0..COUNT).filter(|quantity| scales[*quantity] > 0.0 && counts(*quantity)).collect();
        Self { numbers, noise: options.noise(), scales, inferred }
    }

    /// Standard deviation of the logarithm of a number of `quantity` beside `discrepancies`, those that are inferred.
    pub fn deviation(&self, quantity: usize, discrepancies: &[f64]) -> f64 {
        let place = self.inferred.iter().position(|inferred| *inferred == quantity);
        let discrepancy = place.map_or(0.0, |place| discrepancies[place]);
        (self.noise[quantity].powi(2) + discrepancy.powi(2)).sqrt()
    }

    /// Logarithm of the likelihood of the numbers: `logarithms` are those of the simulated ones, with the variance of each.
    pub fn ln_likelihood(&self, logarithms: &[f64], variances: &[f64], discrepancies: &[f64]) -> f64 {
        let rows = self.numbers.iter().zip(logarithms).zip(variances);
        rows.map(|((number, simulated), variance)| {
            let deviation = (self.deviation(number.quantity, discrepancies).powi(2) + variance).sqrt();
            let [low, high] = number.interval.map(|end| (end - simulated) / deviation);
            // A density has the unit of its number, a probability none.
            let unit = if low < high { 0.0 } else { deviation.ln() };
            ln_probability(low, high) - unit
        })
        .sum()
    }

    /// Logarithm of the prior of discrepancies whose logarithms are sampled: half-normal, with the Jacobian.
    pub fn ln_prior(&self, ln_discrepancies: &[f64]) -> f64 {
        let rows = self.inferred.iter().zip(ln_discrepancies);
        rows.map(|(quantity, ln)| ln - 0.5 * (ln.exp() / self.scales[*quantity]).powi(2)).sum()
    }

    /// The largest likelihood times prior over discrepancies between 0.3 % and 100 %.
    pub fn best_ln_likelihood(&self, logarithms: &[f64]) -> f64 {
        const STEPS: i32 = 14;
        let mut total = 0.0;
        for quantity in 0..COUNT {
            let own = |index: &usize| self.numbers[*index].quantity == quantity;
            let rows: Vec<usize> = (0..self.numbers.len()).filter(own).collect();
            if rows.is_empty() {
                continue;
            }
            let part = Self {
                numbers: rows.iter().map(|index| self.numbers[*index]).collect(),
                inferred: self.inferred.iter().copied().filter(|inferred| *inferred == quantity).collect(),
                ..*self
            };
            let simulated: Vec<f64> = rows.iter().map(|index| logarithms[*index]).collect();
            let zeros = vec![0.0; rows.len()];
            let at = |ln: f64| {
                let ln = vec![ln; part.inferred.len()];
                let discrepancies: Vec<f64> = ln.iter().map(|ln| ln.exp()).collect();
                part.ln_likelihood(&simulated, &zeros, &discrepancies) + part.ln_prior(&ln)
            };
            let grid = (0..=STEPS).map(|step| at(0.003f64.ln() * (1.0 - f64::from(step) / f64::from(STEPS))));
            total += grid.fold(f64::NEG_INFINITY, f64::max);
        }
        total
    }
}

/// The numbers of `target` that count, with the logarithms of the ends of their intervals.
fn intervals<'a>(
    target: &'a Target,
    options: &UncertaintyOptions,
) -> impl Iterator<Item = (usize, [f64; 2])> + use<'a> {
    let rounding = options.rounding();
    (0..COUNT).filter(|i| target.counts[*i]).filter_map(move |i| {
        let value = target.measured[i]?;
        let half = 0.5 * printed_step(target.energy, i, value).unwrap_or(rounding[i]);
        Some((i, [(value - half).max(0.01 * value).ln(), (value + half).ln()]))
    })
}

/// The step to which the study's table rounds, if `value` is its own.
fn printed_step(energy: f64, quantity: usize, value: f64) -> Option<f64> {
    let case = TABLE_1.iter().find(|case| case.energy == energy && case.experiment[quantity] == value)?;
    debug_assert!(case.experiment[quantity] > 0.0);
    Some(10f64.powi(-(DECIMALS[quantity] as i32)) / QUANTITIES[quantity].display_scale)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn model(discrepancy: f64, interval: [f64; 2]) -> ErrorModel {
        let discrepancy = [("impulse".to_string(), discrepancy)].into();
        let options = UncertaintyOptions { discrepancy, ..UncertaintyOptions::default() };
        ErrorModel::of(vec![Number { target: 0, quantity: 3, interval }], &options)
    }

    #[test]
    fn the_interval_of_a_printed_number_is_that_of_its_digits() {
        assert_eq!(printed_step(14.7, 3, 16.0), Some(1.0));
        assert!((printed_step(9.8, 1, 3.5e-3).unwrap() - 1e-4).abs() < 1e-18);
        assert_eq!(printed_step(9.8, 1, 3.6e-3), None);
    }

    /// Source: the closed form of a normal density, and of a step that everything within rounds to.
    #[test]
    fn the_likelihood_is_a_density_without_rounding_and_a_probability_with_it() {
        let exact = model(0.0, [1.0, 1.0]);
        let expected = -0.5 * 2f64.powi(2) - (0.01 * (2.0 * std::f64::consts::PI).sqrt()).ln();
        assert!((exact.ln_likelihood(&[1.02], &[0.0], &[]) - expected).abs() < 1e-9);
        let rounded = model(0.0, [1.0, 2.0]);
        assert!(rounded.ln_likelihood(&[1.5], &[0.0], &[]).abs() < 1e-12);
        assert!((rounded.ln_likelihood(&[1.0], &[0.0], &[]) - 0.5f64.ln()).abs() < 1e-12);
        // The variance of an emulator and a discrepancy widen it alike.
        let wide = model(0.1, [1.0, 1.0]);
        let by_discrepancy = wide.ln_likelihood(&[1.2], &[0.0], &[0.05]);
        assert!((by_discrepancy - exact.ln_likelihood(&[1.2], &[0.0025], &[])).abs() < 1e-12);
    }
}
