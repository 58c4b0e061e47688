//! Why an instance refused a call. Every message names the value, its unit and what is legal.

use core::fmt;

use softanvil_kernel::parameter::Name;
use softanvil_kernel::{ModelError, ParameterError, SnapshotError, StepError};

use super::mode::Mode;

/// A refusal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Error {
    /// The function is not legal in this mode.
    Call {
        /// Mode at the call.
        mode: Mode,
    },
    /// An argument is a null pointer.
    Null {
        /// Name of the argument.
        argument: &'static str,
    },
    /// An argument is not one of the values that the standard has for it.
    Argument {
        /// Name of the argument.
        argument: &'static str,
        /// The refused value.
        value: i64,
    },
    /// The capability is declared as absent in the model description.
    Unsupported {
        /// What cannot be done.
        what: &'static str,
    },
    /// No variable has this reference.
    Unknown {
        /// The reference.
        reference: u32,
    },
    /// The variable is of another type.
    Type {
        /// Name of the variable.
        name: Name,
        /// Its type.
        is: &'static str,
        /// Type of the call.
        asked: &'static str,
    },
    /// The variable can never be set.
    ReadOnly {
        /// Name of the variable.
        name: Name,
        /// Its causality.
        causality: &'static str,
    },
    /// A parameter was set after initialization.
    Fixed {
        /// Name of the parameter.
        name: Name,
        /// The refused value.
        value: f64,
        /// Its unit.
        unit: &'static str,
    },
    /// A structural parameter was set outside configuration mode, or another variable in it.
    Structural {
        /// Name of the variable.
        name: Name,
    },
    /// The arrays of the call do not fit together.
    ValueCount {
        /// Values given.
        given: usize,
        /// Values that the variables have.
        needed: usize,
    },
    /// The value is out of range.
    Value(ParameterError),
    /// The scenario cannot be simulated.
    Model(ModelError),
    /// The experiment starts at no time.
    StartTime {
        /// The refused start, s.
        start: f64,
    },
    /// The experiment ends at no time, or before it starts.
    StopTime {
        /// The refused end, s.
        stop: f64,
        /// Start, s.
        start: f64,
    },
    /// The master is not where the instance is.
    CommunicationPoint {
        /// Time given, s.
        given: f64,
        /// Time of the instance, s.
        expected: f64,
        /// Half a kernel step, s.
        half: f64,
    },
    /// The communication step is not positive, or too long.
    StepSize {
        /// Step given, s.
        given: f64,
        /// Largest communication step, s.
        largest: f64,
    },
    /// The step leads past the end of the experiment.
    PastStop {
        /// Where it leads, s.
        end: f64,
        /// End of the experiment, s.
        stop: f64,
    },
    /// The kernel could not complete a step.
    Step(StepError),
    /// The heap has no room.
    NoMemory {
        /// Bytes needed.
        bytes: usize,
    },
    /// The saved state was refused.
    Snapshot(SnapshotError),
    /// The buffer does not have the length of the saved state.
    StateSize {
        /// Bytes given.
        given: usize,
        /// Bytes needed.
        needed: usize,
    },
}

impl From<ParameterError> for Error {
    fn from(error: ParameterError) -> Self {
        Self::Value(error)
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Call { mode } => write!(f, "the call is not legal {}", mode.name()),
            Self::Null { argument } => write!(f, "{argument} is null"),
            Self::Argument { argument, value } => write!(f, "{argument} = {value} is not a value of the standard"),
            Self::Unsupported { what } => write!(f, "{what} is not supported, see the model description"),
            Self::Value(error) => error.fmt(f),
            Self::Model(error) => error.fmt(f),
            Self::Step(error) => error.fmt(f),
            Self::Snapshot(error) => error.fmt(f),
            Self::NoMemory { bytes } => write!(f, "there is no memory for {bytes} bytes"),
            Self::StateSize { given, needed } => {
                write!(f, "the buffer has {given} bytes: expected exactly {needed}, the size of the saved state")
            }
            _ => self.variable(f).unwrap_or_else(|| self.time(f)),
        }
    }
}

impl Error {
    /// Refusals about a variable.
    fn variable(&self, f: &mut fmt::Formatter<'_>) -> Option<fmt::Result> {
        Some(match self {
            Self::Unknown { reference } => write!(f, "no variable has the value reference {reference}"),
            Self::Type { name, is, asked } => write!(f, "{name} is of type {is}, not {asked}"),
            Self::ReadOnly { name, causality } => {
                write!(f, "{name} has the causality {causality} and cannot be set: expected parameters and inputs")
            }
            Self::Fixed { name, value, unit } => write!(
                f,
                "{name} = {value} [{unit}] is refused: a fixed parameter can be set until initialization mode ends"
            ),
            Self::Structural { name } => {
                write!(f, "{name} is refused: configuration mode is for structural parameters, and they for it alone")
            }
            Self::ValueCount { given, needed } => {
                write!(f, "nValues = {given} is refused: the variables have {needed} values together")
            }
            _ => return None,
        })
    }

    /// Refusals about time.
    fn time(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::StartTime { start } => write!(f, "start time {start} s is refused: expected a finite number"),
            Self::StopTime { stop, start } => {
                write!(f, "stop time {stop} s is refused: expected a finite time from the start at {start} s on")
            }
            Self::CommunicationPoint { given, expected, half } => write!(
                f,
                "communication point {given} s is refused: expected {expected} s, where the instance is, within {half} s"
            ),
            Self::StepSize { given, largest } => {
                write!(f, "communication step {given} s is refused: expected above 0 s up to {largest} s")
            }
            Self::PastStop { end, stop } => {
                write!(f, "the step leads to {end} s: expected up to the stop time of {stop} s")
            }
            _ => Ok(()),
        }
    }
}

impl core::error::Error for Error {}

#[cfg(test)]
mod tests;
