//! The table of the ready-made scenarios.

use crate::scenario::Scenario;
use crate::scenario::preset::{
    block, dragon_skin_30, ecoflex_00_30, elastic, natural_rubber, study, study_14_7, study_incompressible,
};
#[cfg(feature = "pads")]
use crate::scenario::standards;

/// A scenario with a name.
#[derive(Clone, Copy, Debug)]
pub struct Preset {
    /// Its number, for ever: no other preset gets it, even when this one is no more.
    pub id: u32,
    /// Name.
    pub name: &'static str,
    /// Makes the scenario.
    pub scenario: fn() -> Scenario,
    /// Meaning, one line.
    pub description: &'static str,
    /// What of the study's table went into it.
    pub fitted: Fitted,
}

/// How many parameters were fitted to how many numbers of the study's table: what the errors against it are worth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fitted {
    /// Parameters.
    pub parameters: u32,
    /// Numbers they were fitted to; the others are predicted.
    pub numbers: u32,
}

impl Fitted {
    /// Numbers of the study's table: four of each of three drops.
    pub const TABLE: u32 = 12;
    /// Nothing was: the model is not the study's.
    pub const NONE: Self = Self { parameters: 0, numbers: 0 };
}

impl core::fmt::Display for Fitted {
    fn fmt(&self, f: &mut core::fmt::Formatter) -> core::fmt::Result {
        let Self { parameters, numbers } = *self;
        if *self == Self::NONE {
            return f.write_str("no parameter fitted to any of the numbers");
        }
        let plural = if parameters == 1 { "" } else { "s" };
        write!(f, "{parameters} parameter{plural} fitted to ")?;
        match Self::TABLE.saturating_sub(numbers) {
            0 => write!(f, "all {numbers} numbers, none predicted"),
            predicted => write!(f, "{numbers} of the {} numbers, the other {predicted} predicted", Self::TABLE),
        }
    }
}

/// Ids of presets that are no more, which no other preset gets.
pub const RETIRED: &[u32] = &[];

/// Every preset; the first is the default.
pub static PRESETS: &[Preset] = &[
    Preset {
        id: 0,
        name: "study",
        scenario: study,
        description: "the study's soft anvil, 5 parameters fitted to the 12 numbers of its 3 drops",
        fitted: Fitted { parameters: 5, numbers: 12 },
    },
    Preset {
        id: 1,
        name: "study-14.7",
        scenario: study_14_7,
        description: "the study's soft anvil, 4 parameters fitted to the 4 numbers of 14.7 J alone",
        fitted: Fitted { parameters: 4, numbers: 4 },
    },
    Preset {
        id: 2,
        name: "study-incompressible",
        scenario: study_incompressible,
        description: "the study's soft anvil, incompressible, 5 parameters fitted to the 12 numbers",
        fitted: Fitted { parameters: 5, numbers: 12 },
    },
    Preset {
        id: 3,
        name: "elastic",
        scenario: elastic,
        description: "the study's anvil of a plain elastic silicone, to start from with a material of one's own",
        fitted: Fitted::NONE,
    },
    Preset {
        id: 4,
        name: "block",
        scenario: block,
        description: "a flat block of the plain elastic silicone on a flat core, bonded",
        fitted: Fitted::NONE,
    },
    Preset {
        id: 5,
        name: "ecoflex-00-30",
        scenario: ecoflex_00_30,
        description: "the study's anvil of Ecoflex 00-30, elastic, from tension tests of Marechal et al. (2021)",
        fitted: Fitted::NONE,
    },
    Preset {
        id: 6,
        name: "dragon-skin-30",
        scenario: dragon_skin_30,
        description: "the study's anvil of Dragon Skin 30, elastic, from tension tests of Marechal et al. (2021)",
        fitted: Fitted::NONE,
    },
    Preset {
        id: 7,
        name: "natural-rubber",
        scenario: natural_rubber,
        description: "the study's anvil of Treloar's vulcanised natural rubber, elastic, by Ogden (1972)",
        fitted: Fitted::NONE,
    },
    #[cfg(feature = "pads")]
    Preset {
        id: 8,
        name: "rugby-soft-anvil",
        scenario: standards::rugby_soft_anvil,
        description: "10 mm of body padding of rugby union, an elastomeric foam, on the study's soft anvil",
        fitted: Fitted::NONE,
    },
    #[cfg(feature = "pads")]
    Preset {
        id: 9,
        name: "rugby-steel-anvil",
        scenario: standards::rugby_steel_anvil,
        description: "the same body padding on the standard's steel cylinder of 115 mm",
        fitted: Fitted::NONE,
    },
    #[cfg(feature = "pads")]
    Preset {
        id: 10,
        name: "en1621-1",
        scenario: standards::en1621_1,
        description: "20 mm of a stiff foam as a motorcyclist's limb protector on a dome of 50 mm radius, 50 J",
        fitted: Fitted::NONE,
    },
    #[cfg(feature = "pads")]
    Preset {
        id: 11,
        name: "en1621-2",
        scenario: standards::en1621_2,
        description: "20 mm of a stiff foam as a motorcyclist's back protector under a bar, 50 J; set-up mostly assumed",
        fitted: Fitted::NONE,
    },
    #[cfg(feature = "pads")]
    Preset {
        id: 12,
        name: "en13061",
        scenario: standards::en13061,
        description: "5 mm of a stiff foam as a football player's shin guard, 1 kg with 2 J; set-up mostly assumed",
        fitted: Fitted::NONE,
    },
];
