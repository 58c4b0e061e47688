//! What a material is, in a few lines: its moduli at once and in the end, and what each of its mechanisms adds.

use serde_json::{Map, Value, json};
use softanvil_kernel::Scenario;
use softanvil_kernel::material::Material;
use softanvil_kernel::scenario::Layer;

use crate::text::number::four_digits;

/// The layers of `scenario` that have a material of their own.
fn layers(scenario: &Scenario) -> Vec<Layer<'_>> {
    let mut layers = scenario.layers().to_vec();
    layers.dedup_by_key(|layer| layer.name);
    layers
}

/// The materials of `scenario` for people, a paragraph for each layer.
pub fn text(scenario: &Scenario) -> String {
    layers(scenario).iter().map(describe).collect::<Vec<_>>().join("\n")
}

fn describe(layer: &Layer) -> String {
    let (name, material) = (layer.name, layer.material);
    let (at_once, end) = (material.shear_modulus_0(), material.shear_modulus_inf());
    let bulk = material.effective_bulk_modulus();
    let speed = |modulus: f64| four_digits((modulus / material.density).sqrt());
    let mut lines = vec![
        format!("{name}: {}, {} kg/m3", material.law.description().label, four_digits(material.density)),
        format!("  shear modulus    {} in the end, {} at once", pascal(end), pascal(at_once)),
        format!(
            "  Poisson's ratio  {:.4} in the end, {:.4} at once (bulk modulus {})",
            material.poissons_ratio_of(end),
            material.poissons_ratio_of(at_once),
            pascal(bulk)
        ),
        format!(
            "  waves at once    {} m/s in compression, {} m/s in shear",
            speed(bulk + 4.0 / 3.0 * at_once),
            speed(at_once)
        ),
    ];
    lines.extend(mechanisms(material).into_iter().map(|(label, adds)| format!("  {label:<15}  {adds}")));
    lines.join("\n") + "\n"
}

/// What is on beside the elastic law, and what it adds.
fn mechanisms(material: &Material) -> Vec<(String, String)> {
    let instantaneous = material.shear_modulus_inf() / material.prony_g_inf();
    let terms = |label: &'static str, on: Vec<(f64, f64)>| {
        on.into_iter().enumerate().filter(|(_, (g, _))| *g > 0.0).map(move |(k, (g, tau))| {
            (format!("{label} {}", k + 1), format!("adds {} that relax in {} s", pascal(g), four_digits(tau)))
        })
    };
    let prony = material.prony_g.iter().zip(material.prony_tau).map(|(g, tau)| (g * instantaneous, tau)).collect();
    let maxwell = material.maxwell_g.iter().zip(material.maxwell_beta).map(|(g, beta)| (*g, 1.0 / beta)).collect();
    let mut found: Vec<_> = terms("Prony", prony).chain(terms("Maxwell", maxwell)).collect();
    if material.slider_stiffness > 0.0 {
        let (adds, slips) = (pascal(material.slider_stiffness), pascal(material.slider_yield_stress));
        found.push(("slider".into(), format!("adds {adds} up to a von Mises stress of {slips}")));
    }
    if material.tear_stretch > 0.0 {
        let [from, to] = [material.tear_stretch, material.tear_stretch + material.tear_width].map(four_digits);
        let left = four_digits(100.0 * material.tear_residual);
        found.push((
            "tearing".into(),
            format!("from a stretch of {from} to {to}, where {left} % of the stress is left"),
        ));
    }
    found
}

/// A modulus in the unit in which it is easy to read.
fn pascal(value: f64) -> String {
    match value {
        value if value >= 1e6 => format!("{} MPa", four_digits(value * 1e-6)),
        value if value >= 1e3 => format!("{} kPa", four_digits(value * 1e-3)),
        value => format!("{} Pa", four_digits(value)),
    }
}

/// The same numbers for other programs, SI, by layer.
pub fn json(scenario: &Scenario) -> Value {
    let one = |layer: Layer| {
        let material = layer.material;
        let (at_once, end) = (material.shear_modulus_0(), material.shear_modulus_inf());
        let numbers = json!({
            "density": material.density,
            "shear_modulus_at_once": at_once,
            "shear_modulus_in_the_end": end,
            "bulk_modulus": material.effective_bulk_modulus(),
            "poissons_ratio_at_once": material.poissons_ratio_of(at_once),
            "poissons_ratio_in_the_end": material.poissons_ratio_of(end),
        });
        (layer.name.to_string(), numbers)
    };
    layers(scenario).into_iter().map(one).collect::<Map<_, _>>().into()
}

#[cfg(test)]
mod tests {
    use super::*;
    use softanvil_kernel::preset;

    #[test]
    fn the_study_says_what_its_preset_documents() {
        let text = text(&preset::study());
        for part in [
            "Mooney-Rivlin, 1072 kg/m3",
            "504.0 kPa in the end, 14.97 MPa at once",
            "0.4900 in the end, 0.2507 at once",
            "Prony 1",
        ] {
            assert!(text.contains(part), "{part}: {text}");
        }
        assert!(!text.contains("slider") && !text.contains("skin"), "{text}");
    }

    #[test]
    fn every_mechanism_that_is_on_is_told() {
        let mut scenario = preset::elastic();
        assert_eq!(mechanisms(&scenario.layers[0].material).len(), 0);
        let silicone = &mut scenario.layers[0].material;
        (silicone.prony_g[1], silicone.maxwell_g[0]) = (0.5, 1e5);
        (silicone.slider_stiffness, silicone.slider_yield_stress, silicone.tear_stretch) = (1e5, 2e4, 3.0);
        let told = mechanisms(silicone);
        assert_eq!(
            told.iter().map(|(label, _)| label.as_str()).collect::<Vec<_>>(),
            ["Prony 2", "Maxwell 1", "slider", "tearing"]
        );
        // Half of the modulus at once is the term's: it adds as much as the law.
        assert!(told[0].1.starts_with("adds 200.0 kPa"), "{}", told[0].1);
        assert_eq!(silicone.shear_modulus_0(), 400e3 + 1e5 + 1e5);
    }
}
