//! Order of convergence and discretisation error from results on three meshes of constant refinement.
//!
//! Source: Oberkampf and Roy, Verification and Validation in Scientific Computing (2010), chapter 8: Richardson
//! extrapolation with the observed order, and Roache's grid convergence index with the factor of safety 1.25 where the
//! observed order is within a tenth of the formal one, and 3 with an order limited to 0.5 to the formal one elsewhere.

/// Formal order of the linear triangles.
pub const FORMAL_ORDER: f64 = 2.0;

/// Distance from the formal order, in parts of it, within which results are taken as asymptotic.
const ASYMPTOTIC: f64 = 0.1;
/// Factors of safety inside and outside of the asymptotic range.
const SAFETY: [f64; 2] = [1.25, 3.0];
/// Smallest order that an error estimate relies on.
const SMALLEST_ORDER: f64 = 0.5;

/// What three results tell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Verdict {
    /// They approach a limit.
    Converging {
        /// Observed order.
        order: f64,
        /// Whether it is the formal one.
        asymptotic: bool,
        /// Extrapolated to elements of size zero.
        limit: f64,
        /// Error estimates of the results, coarsest mesh first.
        error: [f64; 3],
    },
    /// They do not: no order, and nothing to extrapolate to.
    Scattered {
        /// Whether the last change goes the other way than the one before.
        oscillating: bool,
        /// Largest less smallest of them.
        spread: f64,
    },
    /// They differ by less than the quantity is read to.
    Settled {
        /// Largest less smallest of them.
        spread: f64,
    },
}

/// Judges results on three meshes, coarsest first, each with elements `ratio` times smaller than the one before.
/// Differences up to `resolution` mean nothing.
pub fn judge(values: [f64; 3], ratio: f64, resolution: f64) -> Verdict {
    let changes = [values[1] - values[0], values[2] - values[1]];
    let largest = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let spread = largest - values.iter().copied().fold(f64::INFINITY, f64::min);
    if spread <= resolution {
        return Verdict::Settled { spread };
    }
    if changes[0] * changes[1] <= 0.0 {
        return Verdict::Scattered { oscillating: true, spread };
    }
    let order = (changes[0] / changes[1]).ln() / ratio.ln();
    if order <= 0.0 {
        return Verdict::Scattered { oscillating: false, spread };
    }
    let asymptotic = (order - FORMAL_ORDER).abs() <= ASYMPTOTIC * FORMAL_ORDER;
    let (safety, used) = match asymptotic {
        true => (SAFETY[0], FORMAL_ORDER),
        false => (SAFETY[1], order.clamp(SMALLEST_ORDER, FORMAL_ORDER)),
    };
    let finest = safety * changes[1].abs() / (ratio.powf(used) - 1.0);
    let limit = values[2] + changes[1] / (ratio.powf(order) - 1.0);
    // The change to the finest mesh is known; what the finest lacks is estimated.
    let error = values.map(|value| (values[2] - value).abs() + finest);
    Verdict::Converging { order, asymptotic, limit, error }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Source: the definition: values that are a limit plus a constant times the size to an order.
    #[test]
    fn order_and_limit_of_exact_sequences_come_back() {
        for (exact, ratio, asymptotic) in [(2.0, 2.0_f64, true), (1.0, 2.0, false), (1.9, 1.5, true), (0.3, 3.0, false)]
        {
            let values = [0, 1, 2].map(|level: i32| 7.0 + 0.4 * ratio.powf(-exact * f64::from(level)));
            let Verdict::Converging { order, asymptotic: found, limit, error } = judge(values, ratio, 0.0) else {
                panic!("{values:?}");
            };
            assert!((order - exact).abs() < 1e-9 && (limit - 7.0).abs() < 1e-9, "{order} {limit}");
            assert_eq!(found, asymptotic);
            for (value, error) in values.iter().zip(error) {
                assert!(error >= (value - 7.0).abs(), "{error} of {value}");
            }
        }
    }

    #[test]
    fn what_does_not_converge_gets_no_order() {
        assert_eq!(judge([1.0, 2.0, 1.5], 2.0, 0.0), Verdict::Scattered { oscillating: true, spread: 1.0 });
        assert_eq!(judge([1.0, 2.0, 4.0], 2.0, 0.0), Verdict::Scattered { oscillating: false, spread: 3.0 });
        assert_eq!(judge([1.0, 1.0, 2.0], 2.0, 0.0), Verdict::Scattered { oscillating: true, spread: 1.0 });
        assert_eq!(judge([1.0, 1.5, 1.25], 2.0, 0.5), Verdict::Settled { spread: 0.5 });
    }
}
