//! The loading that a relaxation test relaxes from: the elastic response over time, on straight lines between knots.

/// Elastic response over time.
///
/// The response of a Prony term is the solution of q' = e' - q / tau, exact on each line.
#[derive(Clone, Debug, PartialEq)]
pub struct History {
    /// (time in s, elastic response), in the order of time; before the first knot the response is zero, at it it jumps.
    knots: Vec<(f64, f64)>,
}

impl History {
    /// A jump to 1 at `start` s.
    pub fn step(start: f64) -> Self {
        Self { knots: vec![(start, 1.0)] }
    }

    /// A rise to 1 in `ramp` s from `start` s; `elastic` is the response over the part of the strain, from (0, 0) to
    /// (1, 1).
    pub fn ramp(start: f64, ramp: f64, elastic: impl Fn(f64) -> f64) -> Self {
        if ramp <= 0.0 {
            return Self::step(start);
        }
        let knot = |k: usize| {
            let part = k as f64 / RAMP_LINES as f64;
            (start + ramp * part, elastic(part))
        };
        Self { knots: (0..=RAMP_LINES).map(knot).collect() }
    }

    /// The response measured or computed at `knots`, whose times rise.
    pub fn measured(knots: Vec<(f64, f64)>) -> Self {
        Self { knots }
    }

    /// Elastic response at `times`, which do not fall.
    pub fn elastic(&self, times: &[f64]) -> Vec<f64> {
        self.response(times, f64::INFINITY)
    }

    /// Response of a term of relaxation time `tau` s at `times`, which do not fall.
    pub fn response(&self, times: &[f64], tau: f64) -> Vec<f64> {
        let mut response = Vec::with_capacity(times.len());
        let (mut now, mut q) = self.knots.first().copied().unwrap_or_default();
        let mut next = 1;
        for &time in times {
            if self.knots.first().is_none_or(|first| time < first.0) {
                response.push(0.0);
                continue;
            }
            while self.knots.get(next).is_some_and(|knot| knot.0 <= time) {
                q = advance(q, self.slope(next), self.knots[next].0 - now, tau);
                now = self.knots[next].0;
                next += 1;
            }
            q = advance(q, self.slope(next), time - now, tau);
            now = time;
            response.push(q);
        }
        response
    }

    /// Slope of the line that ends at knot `end`; zero after the last.
    fn slope(&self, end: usize) -> f64 {
        match (self.knots.get(end.wrapping_sub(1)), self.knots.get(end)) {
            (Some(a), Some(b)) if b.0 > a.0 => (b.1 - a.1) / (b.0 - a.0),
            _ => 0.0,
        }
    }
}

/// Lines of a ramp: the curve of a law between two knots then differs from its line by less than 1e-4 of the whole.
const RAMP_LINES: usize = 100;

/// q after `dt` on a line of this slope: q e^-x + slope tau (1 - e^-x), x = dt / tau.
fn advance(q: f64, slope: f64, dt: f64, tau: f64) -> f64 {
    if tau.is_infinite() {
        return q + slope * dt;
    }
    let x = dt / tau;
    q * (-x).exp() - slope * tau * (-x).exp_m1()
}

#[cfg(test)]
mod tests {
    use super::*;

    const TIMES: [f64; 7] = [0.0, 0.05, 0.1, 0.3, 1.0, 4.0, 20.0];

    /// Source: a Maxwell element in a step, e^(-t/tau), and in a ramp of duration T, tau/T (1 - e^(-t/tau)) up to T and
    /// that times e^(-(t-T)/tau) after it (e.g. Christensen, Theory of Viscoelasticity, 1982).
    #[test]
    fn the_closed_forms_of_step_and_ramp() {
        for tau in [0.02, 0.5, 7.0] {
            let step = History::step(0.0).response(&TIMES, tau);
            let ramp = History::ramp(0.0, 0.1, |part| part).response(&TIMES, tau);
            for ((t, q), r) in TIMES.iter().zip(step).zip(ramp) {
                assert!((q - (-t / tau).exp()).abs() < 1e-14);
                let peak = |t: f64| tau / 0.1 * (1.0 - (-t / tau).exp());
                let expected = if *t <= 0.1 { peak(*t) } else { peak(0.1) * (-(t - 0.1) / tau).exp() };
                assert!((r - expected).abs() < 1e-12, "{tau} {t}: {r} {expected}");
            }
        }
    }

    #[test]
    fn the_elastic_response_is_the_history_itself() {
        let history = History::measured(vec![(0.0, 0.0), (0.1, 1.0), (1.0, 0.8)]);
        let expected = [0.0, 0.5, 1.0, 0.955555555555555, 0.8, 0.8, 0.8];
        let expected = expected.map(|e: f64| if (e - 0.9555).abs() < 1e-3 { 1.0 - 0.2 * 0.2 / 0.9 } else { e });
        for (found, expected) in history.elastic(&TIMES).iter().zip(expected) {
            assert!((found - expected).abs() < 1e-12, "{found} {expected}");
        }
        assert_eq!(History::step(2.0).elastic(&[1.0, 2.0, 3.0]), [0.0, 1.0, 1.0]);
    }
}
