//! Comparison of records with a trace.

use core::fmt;

use crate::record::{Line, QUANTITIES, Record};

/// Compares records, in order, with the lines of a trace.
#[derive(Clone)]
pub struct Checker<'t> {
    lines: core::str::Lines<'t>,
}

/// The first difference between a run and its trace.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference<'t> {
    /// What was computed.
    pub found: Record,
    /// The quantity, one of [`QUANTITIES`].
    pub quantity: &'static str,
    /// What the trace has in its place; nothing if it has ended.
    pub expected: &'t str,
}

impl<'t> Checker<'t> {
    /// A comparison with `trace` from its start.
    pub fn new(trace: &'t str) -> Self {
        Self { lines: trace.lines() }
    }

    /// Passes over the lines before `step`.
    pub fn skip_to(&mut self, step: u64) {
        let mut ahead = self.clone();
        while let Some(line) = ahead.next_line() {
            if line.split_whitespace().next().and_then(|text| text.parse::<u64>().ok()) >= Some(step) {
                return;
            }
            *self = ahead.clone();
        }
    }

    /// Compares the next record.
    ///
    /// # Errors
    /// The first quantity of it that differs.
    pub fn check(&mut self, record: &Record) -> Result<(), Difference<'t>> {
        let mut expected = self.next_line().unwrap_or_default().split_whitespace();
        let line = Line::new(record);
        for (found, quantity) in line.text().split_whitespace().zip(QUANTITIES) {
            let expected = expected.next().unwrap_or_default();
            if found != expected {
                return Err(Difference { found: *record, quantity, expected });
            }
        }
        Ok(())
    }

    /// Whether the trace goes on.
    pub fn has_more(&self) -> bool {
        self.clone().next_line().is_some()
    }

    /// The next line that is not a comment.
    fn next_line(&mut self) -> Option<&'t str> {
        self.lines.find(|line| !line.starts_with('#'))
    }
}

impl fmt::Display for Difference<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { found, quantity, expected } = self;
        write!(f, "step {}: {quantity} is ", found.step)?;
        match *quantity {
            "contact_force_N" => write!(f, "{:e}", found.force),
            "position_m" => write!(f, "{:e}", found.position),
            "state" => write!(f, "{:016x}", found.state),
            _ => write!(f, "{}", found.step),
        }?;
        if expected.is_empty() { f.write_str(", the trace has ended") } else { write!(f, ", the trace has {expected}") }
    }
}

#[cfg(all(test, not(feature = "single")))]
mod tests {
    extern crate std;

    use super::*;
    use std::string::ToString;

    const TRACE: &str = "# comment\n 0 0e0 2e-3 00000000000000aa\n 13 1.5e0 -1e-3 00000000000000bb\n";

    fn second() -> Record {
        Record { step: 13, force: 1.5, position: -1e-3, state: 0xbb }
    }

    #[test]
    fn the_first_quantity_that_differs_is_named() {
        let first = Record { step: 0, force: 0.0, position: 2e-3, state: 0xaa };
        let mut start = Checker::new(TRACE);
        assert_eq!(start.check(&first), Ok(()));
        assert!(start.has_more());
        assert_eq!(start.clone().check(&second()), Ok(()));
        for (changed, quantity, text) in [
            (Record { step: 12, ..second() }, "step", "step 12: step is 12, the trace has 13"),
            (
                Record { force: 1.5 + f64::EPSILON, ..second() },
                "contact_force_N",
                "step 13: contact_force_N is 1.5000000000000002e0, the trace has 1.5e0",
            ),
            (
                Record { position: 1e-3, state: 0, ..second() },
                "position_m",
                "step 13: position_m is 1e-3, the trace has -1e-3",
            ),
            (
                Record { state: 0xbc, ..second() },
                "state",
                "step 13: state is 00000000000000bc, the trace has 00000000000000bb",
            ),
        ] {
            let difference = start.clone().check(&changed).unwrap_err();
            assert_eq!(difference.quantity, quantity);
            assert_eq!(difference.to_string(), text);
        }
    }

    #[test]
    fn a_trace_that_ends_early_is_a_difference() {
        let mut checker = Checker::new(TRACE);
        checker.skip_to(13);
        assert_eq!(checker.check(&second()), Ok(()));
        assert!(!checker.has_more());
        assert!(checker.check(&second()).unwrap_err().to_string().ends_with("the trace has ended"));
    }

    #[test]
    fn zeros_of_either_sign_differ() {
        let trace = "0 0e0 0e0 0000000000000000";
        let record = Record { step: 0, force: -0.0, position: 0.0, state: 0 };
        assert_eq!(Checker::new(trace).check(&record).unwrap_err().quantity, "contact_force_N");
    }
}
