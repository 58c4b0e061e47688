//! Which layers of a stack are the pad, and the stack without it.

use softanvil_kernel::Scenario;

/// Name of the lowest layer of a pad.
pub const PAD: &str = "pad";

/// Place of the lowest layer of the pad: the one called so, or the topmost.
pub fn place(scenario: &Scenario) -> usize {
    let named = scenario.layers.iter().position(|layer| layer.name == PAD);
    named.unwrap_or(scenario.layers.len().saturating_sub(1))
}

/// Thickness of the pad, m.
pub fn thickness(scenario: &Scenario) -> f64 {
    scenario.layers.iter().skip(place(scenario)).map(|layer| layer.thickness).sum()
}

/// `scenario` without the pad; none where nothing soft is left for a face to fall on.
pub fn bare(scenario: &Scenario) -> Option<Scenario> {
    let place = place(scenario);
    (place > 0).then(|| {
        let mut bare = scenario.clone();
        bare.set_layer_count(place);
        bare
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use softanvil_kernel::preset;
    use softanvil_kernel::scenario::Layer;

    #[test]
    fn the_pad_is_the_layer_of_that_name_and_all_above_it_or_the_topmost() {
        let mut scenario = preset::study();
        assert_eq!((place(&scenario), bare(&scenario)), (0, None));
        for name in ["pad", "shell"] {
            scenario.add_layer(Layer::new(name, 5e-3, preset::elastic_silicone())).unwrap();
        }
        assert_eq!((place(&scenario), thickness(&scenario)), (1, 10e-3));
        assert_eq!(bare(&scenario), Some(preset::study()));
        scenario.layers[1].name = "foam".try_into().unwrap();
        assert_eq!((place(&scenario), thickness(&scenario)), (2, 5e-3));
    }
}
