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
}

impl Mode {
    /// Every mode, for the search by code.
    const ALL: [Self; 5] = [Self::Instantiated, Self::Initialization, Self::Step, Self::Terminated, Self::Failed];

    /// The mode saved as `code`.
    pub(super) fn from_code(code: u64) -> Option<Self> {
        Self::ALL.into_iter().find(|mode| *mode as u64 == code)
    }

    /// What the mode is called in messages.
    pub fn name(self) -> &'static str {
        match self {
            Self::Instantiated => "after instantiation",
            Self::Initialization => "in initialization mode",
            Self::Step => "between communication steps",
            Self::Terminated => "after termination",
            Self::Failed => "after a failed step",
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
