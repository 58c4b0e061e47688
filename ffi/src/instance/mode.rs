//! Modes of an instance, and in which of them a function is legal.

/// Where an instance is in its life, as one bit each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Mode {
    /// Parameters can be set.
    Instantiated = 1,
    /// Parameters can still be set, and the initial results be read.
    Initialization = 2,
    /// Between communication steps.
    Step = 4,
    /// The simulation is over.
    Terminated = 8,
    /// A step could not be completed.
    Failed = 16,
    /// The master handles an event (FMI 3.0).
    Event = 32,
    /// Structural parameters can be set (FMI 3.0).
    Configuration = 64,
    /// The master looks in during a communication step (FMI 3.0).
    IntermediateUpdate = 128,
}

impl Mode {
    /// The modes that can be saved.
    const SAVED: [Self; 6] =
        [Self::Instantiated, Self::Initialization, Self::Step, Self::Terminated, Self::Event, Self::Configuration];

    /// The modes in which the scenario may still change: no simulation belongs to it yet.
    pub(super) const BEFORE_WORK: u8 =
        Self::Instantiated as u8 | Self::Configuration as u8 | Self::Initialization as u8;

    /// The mode saved as `code`.
    pub(super) fn from_code(code: u64) -> Option<Self> {
        Self::SAVED.into_iter().find(|mode| *mode as u64 == code)
    }

    /// What the mode is called in messages.
    pub fn name(self) -> &'static str {
        match self {
            Self::Instantiated => "after instantiation",
            Self::Initialization => "in initialization mode",
            Self::Step => "between communication steps",
            Self::Terminated => "after termination",
            Self::Failed => "after a failed step",
            Self::Event => "in event mode",
            Self::Configuration => "in configuration mode",
            Self::IntermediateUpdate => "in intermediate update mode",
        }
    }
}

/// A function of the standard: its name, and the modes in which it is legal.
pub struct Function {
    /// Name in the standard's header.
    pub name: &'static str,
    /// Bits of [`Mode`].
    pub legal: u8,
}
