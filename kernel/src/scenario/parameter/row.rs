//! A row of the table of parameters.

use crate::error::ParameterError;
use crate::number::real::Real;
use crate::scenario::Scenario;

/// One row of the table.
///
/// ```
/// use softanvil_kernel::parameter::Kind;
/// use softanvil_kernel::{Parameter, preset};
///
/// let mut scenario = preset::study();
/// let mass = Parameter::find("impactor.mass").unwrap();
/// assert_eq!((mass.get(&scenario), mass.unit(), mass.range()), (5.0, "kg", (1e-3, 1e4)));
/// mass.set(&mut scenario, 6.0)?;
/// assert_eq!(scenario.impactor.mass, 6.0);
///
/// // A choice goes by the number of its label.
/// let motion = Parameter::find("impactor.motion").unwrap();
/// let Kind::Choice { labels, .. } = motion.kind else { panic!("no choice") };
/// assert_eq!(labels[motion.get(&scenario) as usize], "drop");
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy)]
pub struct Parameter {
    /// Structured name, `group.field`.
    pub name: &'static str,
    /// What the value is and how it is stored.
    pub kind: Kind,
    /// Meaning, one line.
    pub description: &'static str,
}

/// What a parameter's value is.
#[derive(Clone, Copy)]
pub enum Kind {
    /// A physical quantity in an SI unit ("1" for a ratio), legal from `min` to `max`, both included.
    Real {
        /// SI unit.
        unit: &'static str,
        /// Smallest legal value.
        min: Real,
        /// Largest legal value.
        max: Real,
        /// The scenario's value.
        read: fn(&Scenario) -> Real,
        /// Sets it.
        write: fn(&mut Scenario, Real),
    },
    /// One of several named choices, numbered from 0 in this order.
    Choice {
        /// Names of the choices.
        labels: &'static [&'static str],
        /// Index of the scenario's choice.
        read: fn(&Scenario) -> usize,
        /// Sets the choice by its index.
        write: fn(&mut Scenario, usize),
    },
}

impl Parameter {
    /// Unit of the value; "1" for ratios and choices.
    pub fn unit(&self) -> &'static str {
        match self.kind {
            Kind::Real { unit, .. } => unit,
            Kind::Choice { .. } => "1",
        }
    }

    /// Smallest and largest legal value.
    pub fn range(&self) -> (Real, Real) {
        match self.kind {
            Kind::Real { min, max, .. } => (min, max),
            Kind::Choice { labels, .. } => (0.0, labels.len() as Real - 1.0),
        }
    }

    /// The value in `scenario`; a choice as its index.
    pub fn get(&self, scenario: &Scenario) -> Real {
        match self.kind {
            Kind::Real { read, .. } => read(scenario),
            Kind::Choice { read, .. } => read(scenario) as Real,
        }
    }

    /// Sets the value in `scenario`; a choice by its index.
    ///
    /// # Errors
    /// A value that is not legal is refused and changes nothing.
    pub fn set(&self, scenario: &mut Scenario, value: Real) -> Result<(), ParameterError> {
        self.check(value)?;
        match self.kind {
            Kind::Real { write, .. } => write(scenario, value),
            Kind::Choice { write, .. } => write(scenario, value as usize),
        }
        Ok(())
    }

    /// Whether `value` is legal: finite, in range, and whole for a choice.
    ///
    /// # Errors
    /// The name, value, unit and legal range of a refused value.
    pub fn check(&self, value: Real) -> Result<(), ParameterError> {
        let (min, max) = self.range();
        let in_range = value >= min && value <= max;
        let whole = match self.kind {
            Kind::Real { .. } => true,
            Kind::Choice { .. } => in_range && value as usize as Real == value,
        };
        if in_range && whole {
            return Ok(());
        }
        Err(ParameterError { name: self.name, value, unit: self.unit(), min, max })
    }
}

/// The groups one after the other; `N` has to be the sum of their lengths.
pub(super) const fn join<const N: usize, const GROUPS: usize>(groups: [&[Parameter]; GROUPS]) -> [Parameter; N] {
    let mut rows = [groups[0][0]; N];
    let (mut group, mut from, mut to) = (0, 0, 0);
    while to < N {
        if from == groups[group].len() {
            group += 1;
            from = 0;
        } else {
            rows[to] = groups[group][from];
            from += 1;
            to += 1;
        }
    }
    rows
}

/// The row of a quantity: its field in a scenario, which is its name as well, or an entry of one with its number in the name; its
/// unit, legal range and meaning.
macro_rules! real {
    ($group:ident.$field:ident, $unit:literal, $range:expr, $text:expr) => {
        real!([$group.$field] concat!(stringify!($group), ".", stringify!($field)), $unit, $range, $text)
    };
    ($group:ident.$field:ident[$i:literal] = $number:literal, $unit:literal, $range:expr, $text:expr) => {
        real!([$group.$field[$i]] concat!(stringify!($group), ".", stringify!($field), "_", $number), $unit, $range, $text)
    };
    ([$($field:tt)+] $name:expr, $unit:literal, $range:expr, $text:expr) => {
        Parameter {
            name: $name,
            kind: Kind::Real {
                unit: $unit,
                min: $range.0,
                max: $range.1,
                read: |scenario| scenario.$($field)+,
                write: |scenario, value| scenario.$($field)+ = value,
            },
            description: $text,
        }
    };
}
pub(super) use real;

/// The row of a choice: its field in a scenario, which is its name as well, the type of that, and its meaning.
macro_rules! choice {
    ($group:ident.$field:ident: $choice:ty, $text:expr) => {
        Parameter {
            name: concat!(stringify!($group), ".", stringify!($field)),
            kind: Kind::Choice {
                labels: <$choice as strum::VariantNames>::VARIANTS,
                read: |scenario| scenario.$group.$field as usize,
                write: |scenario, index| {
                    if let Some(choice) = <$choice>::from_repr(index) {
                        scenario.$group.$field = choice;
                    }
                },
            },
            description: $text,
        }
    };
}
pub(super) use choice;
