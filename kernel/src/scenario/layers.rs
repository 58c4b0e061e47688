//! More layers, or fewer.

use crate::error::{ParameterError, ScenarioError};
use crate::number::real::Real;
use crate::scenario::{Layer, MAX_LAYERS, Scenario, preset};

impl Scenario {
    /// Lays `layer` on the others.
    ///
    /// # Errors
    /// There are as many layers as there can be; nothing changes then.
    ///
    /// ```
    /// use softanvil_kernel::preset;
    ///
    /// let mut scenario = preset::study();
    /// scenario.add_layer(preset::chamois())?;
    /// assert_eq!(scenario.layers[1].name, "skin");
    /// assert_eq!(scenario.thickness(), 15e-3 + 1e-3);
    /// # Ok::<(), softanvil_kernel::ScenarioError>(())
    /// ```
    pub fn add_layer(&mut self, layer: Layer) -> Result<(), ScenarioError> {
        let (value, max) = (self.layers.len() as Real + 1.0, MAX_LAYERS as Real);
        let name = "layers.count".into();
        self.layers.push(layer).map_err(|_| ParameterError { name, value, unit: "1", min: 1.0, max })?;
        Ok(())
    }

    /// Keeps the first `count` layers, or adds spare ones ([`preset::spare_layer`]) until there are as many: 1 to [`MAX_LAYERS`].
    pub fn set_layer_count(&mut self, count: usize) {
        self.layers.truncate(count.max(1));
        while self.layers.len() < count && self.layers.push(preset::spare_layer()).is_ok() {}
    }
}
