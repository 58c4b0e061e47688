//! The names by which the command line knows the kernel's presets.

use clap::builder::PossibleValue;
use softanvil_kernel::{Scenario, preset};

/// A ready-made scenario.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Preset {
    /// The soft anvil of the study.
    #[default]
    Study,
}

impl Preset {
    /// Every preset.
    pub const ALL: &'static [Preset] = &[Preset::Study];

    /// Its name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Study => "study",
        }
    }

    /// Its scenario.
    pub fn scenario(self) -> Scenario {
        match self {
            Self::Study => preset::study(),
        }
    }
}

impl clap::ValueEnum for Preset {
    fn value_variants<'a>() -> &'a [Self] {
        Self::ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(PossibleValue::new(self.name()))
    }
}
