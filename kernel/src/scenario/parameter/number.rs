//! Numbers of parameters, by which the C ABI and the FMU know them for ever.

use super::{Parameter, general, layer};
use crate::scenario::MAX_LAYERS;

/// Numbers for the parameters that belong to no layer, those of later versions included.
pub const TEST_NUMBERS: u32 = 64;

/// Numbers for the parameters of a layer, likewise.
pub const LAYER_NUMBERS: u32 = 96;

/// Numbers of all parameters: those that belong to no layer, then those of each layer.
pub const NUMBERS: usize = (TEST_NUMBERS + LAYER_NUMBERS * MAX_LAYERS as u32) as usize;

impl Parameter {
    /// Its number, below [`NUMBERS`]: [`Parameter::id`], and of a layer [`TEST_NUMBERS`] and [`LAYER_NUMBERS`] for every layer
    /// below it on top.
    pub fn number(&self) -> u32 {
        match self.layer() {
            Some(layer) => TEST_NUMBERS + LAYER_NUMBERS * layer as u32 + self.id(),
            None => self.id(),
        }
    }

    /// The parameter with this number.
    pub fn by_number(number: u32) -> Option<Self> {
        match number.checked_sub(TEST_NUMBERS) {
            Some(of_layers) => {
                let (layer, id) = (of_layers / LAYER_NUMBERS, of_layers % LAYER_NUMBERS);
                Self::of_layer(layer as usize).find(|parameter| parameter.id() == id)
            }
            None => Self::with_layers(0).find(|parameter| parameter.number() == number),
        }
    }

    /// Whether a parameter had this number that is no more.
    pub fn is_retired(number: u32) -> bool {
        match number.checked_sub(TEST_NUMBERS) {
            Some(of_layers) => layer::RETIRED.contains(&(of_layers % LAYER_NUMBERS)),
            None => general::RETIRED.contains(&number),
        }
    }
}
