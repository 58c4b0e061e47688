//! What the data determine: the spread of every parameter beside the range that was allowed beforehand.

use super::problem::Problem;
use super::spread::Spread;

/// How far the data narrow a range down.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Determined {
    /// To less than [`WELL`] of it.
    Yes,
    /// To something between.
    Partly,
    /// To no less than [`HARDLY`] of it: what comes out is the range's as much as the data's.
    No,
}

/// Spread, as a part of the range, below which a parameter is determined.
pub const WELL: f64 = 0.1;
/// Spread, as a part of the range, from which on it is not.
pub const HARDLY: f64 = 0.5;

impl Determined {
    /// Judges a spread.
    pub fn of(spread: &Spread) -> Self {
        match spread.part {
            part if part < WELL => Self::Yes,
            part if part < HARDLY => Self::Partly,
            _ => Self::No,
        }
    }

    /// For programs.
    pub fn key(self) -> &'static str {
        match self {
            Self::Yes => "yes",
            Self::Partly => "partly",
            Self::No => "no",
        }
    }
}

/// A line for each kind that there is.
pub fn text(problem: &Problem, spreads: &[Spread]) -> String {
    let kinds = [
        (Determined::Yes, format!("Determined by the data (spread below {WELL} of the range)")),
        (Determined::Partly, "Determined in part".into()),
        (Determined::No, format!("Not determined (spread of {HARDLY} of the range or more)")),
    ];
    let line = |(kind, label): (Determined, String)| {
        let of_kind = problem.variables.iter().zip(spreads).filter(|(_, spread)| Determined::of(spread) == kind);
        let names = of_kind.map(|(variable, _)| variable.name.as_str()).collect::<Vec<_>>().join(", ");
        if names.is_empty() { String::new() } else { format!("{label}: {names}.\n") }
    };
    kinds.into_iter().map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    #[test]
    fn a_parameter_is_as_determined_as_its_spread_is_narrow() {
        let text = "[search]\nevaluations = 1\n[parameters]\n\"silicone.c10\" = { min = 1e4, max = 1e6 }\n\
                    \"silicone.c20\" = { min = 0.0, max = 1e6 }\n\"silicone.c01\" = { min = 0.0, max = 1e6 }\n\
                    [[impact]]\nenergy = 14.7\ntable_1 = true\n";
        let problem = Problem::parse(text, Path::new(".")).unwrap();
        // In the order of the names: c01, c10, c20.
        let spread = |part| Spread { min: 0.0, median: 0.0, max: 0.0, part };
        assert_eq!(
            super::text(&problem, &[spread(0.5), spread(0.099), spread(0.05)]),
            "Determined by the data (spread below 0.1 of the range): silicone.c10, silicone.c20.\n\
             Not determined (spread of 0.5 of the range or more): silicone.c01.\n"
        );
        assert_eq!(Determined::of(&spread(0.3)).key(), "partly");
    }
}
