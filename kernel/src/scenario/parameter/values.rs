//! The values of all parameters at once.

use super::Parameter;
use super::handle::Place;
use crate::error::ParameterError;
use crate::number::real::Real;
use crate::scenario::{MAX_LAYERS, Scenario};

/// The values of all parameters, those of layers that a scenario does not have included: what a user may give in any order, the
/// number of layers last.
///
/// ```
/// use softanvil_kernel::parameter::Values;
/// use softanvil_kernel::{Parameter, preset};
///
/// let mut values = Values::of(&preset::study());
/// for (name, value) in [("layers[1].thickness", 1e-3), ("layers[1].c10", 5e5), ("layers.count", 2.0)] {
///     values.set(Parameter::find(name).unwrap(), value)?;
/// }
/// assert_eq!(values.scenario().layers[1].material.coefficient("c10"), Some(5e5));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Values {
    /// With as many layers as there can be.
    pub(super) whole: Scenario,
    /// How many of them there are.
    pub(super) layers: usize,
}

impl Values {
    /// Those of `scenario`, with spare layers behind its own.
    pub fn of(scenario: &Scenario) -> Self {
        let mut values = Self { whole: scenario.clone(), layers: scenario.layers.len() };
        values.whole.set_layer_count(MAX_LAYERS);
        values
    }

    /// Takes over those of `scenario`; of the layers that it does not have they stay.
    pub fn update(&mut self, scenario: &Scenario) {
        let old = core::mem::replace(self, Self::of(scenario)).whole;
        for (layer, old) in self.whole.layers.iter_mut().zip(old.layers).skip(self.layers) {
            *layer = old;
        }
    }

    /// The value of `parameter`; a choice as its index.
    pub fn get(&self, parameter: Parameter) -> Real {
        match parameter.place {
            Place::LayerCount(row) => row.get(&self.layers),
            Place::Test(_) | Place::Layer(..) => parameter.get(&self.whole),
        }
    }

    /// Sets the value of `parameter`; a choice by its index.
    ///
    /// # Errors
    /// A value that is not legal is refused and changes nothing.
    pub fn set(&mut self, parameter: Parameter, value: Real) -> Result<(), ParameterError> {
        parameter.check(value)?;
        match parameter.place {
            Place::LayerCount(row) => row.set(&mut self.layers, value),
            Place::Test(row) => row.set(&mut self.whole, value),
            Place::Layer(layer, row) => {
                if let Some(layer) = self.whole.layers.get_mut(layer) {
                    row.set(layer, value);
                }
            }
        }
        Ok(())
    }

    /// The parameter that `name` means ([`Parameter::find_in`]), of a layer that is not there, too.
    pub fn find(&self, name: &str) -> Option<Parameter> {
        Parameter::find_in(&self.whole, name)
    }

    /// Calls a layer `name`; one that is longer than [`crate::scenario::MAX_LAYER_NAME`] bytes, or of no layer, changes nothing.
    pub fn name_layer(&mut self, layer: usize, name: &str) {
        if let (Some(layer), Ok(name)) = (self.whole.layers.get_mut(layer), name.try_into()) {
            layer.name = name;
        }
    }

    /// The scenario that they make.
    pub fn scenario(&self) -> Scenario {
        self.clone().into_scenario()
    }

    /// The same, of values that nobody needs any more.
    pub(super) fn into_scenario(mut self) -> Scenario {
        self.whole.set_layer_count(self.layers);
        self.whole
    }
}
