//! What a material is, in a few lines: its moduli at once and in the end, and what each of its mechanisms adds.

use serde_json::{Value, json};
use softanvil_kernel::Scenario;
use softanvil_kernel::material::Material;
use softanvil_kernel::scenario::Layer;

use crate::text::number::four_digits;

/// What people call the layers of `scenario`, and the layers.
fn layers(scenario: &Scenario) -> impl Iterator<Item = (String, &Layer)> {
    scenario.layers.iter().enumerate().map(|(place, layer)| (name(place, layer), layer))
}

/// The name of a layer, or its place.
pub fn name(place: usize, layer: &Layer) -> String {
    if layer.name.is_empty() { format!("layers[{place}]") } else { layer.name.to_string() }
}

/// The materials of `scenario` for people, a paragraph for each layer.
pub fn text(scenario: &Scenario) -> String {
    layers(scenario).map(|(name, layer)| describe(&name, &layer.material)).collect::<Vec<_>>().join("\n")
}

fn describe(name: &str, material: &Material) -> String {
    let (at_once, end) = (material.shear_modulus_0(), material.shear_modulus_inf());
    let bulk = material.effective_bulk_modulus();
    let speed = |modulus: f64| four_digits((modulus / material.density).sqrt());
    let mut lines = vec![
        format!("{name}: {}, {} kg/m3", material.law.description().label, four_digits(material.density)),
        format!("  shear modulus    {} in the end, {} at once", pascal(end), pascal(at_once)),
        format!(
            "  Poisson's ratio  {:.4} in the end, {:.4} at once (bulk modulus {})",
            material.poissons_ratio_of(end),
            material.poissons_ratio_0(),
            pascal(bulk)
        ),
        format!(
            "  waves at once    {} m/s in compression, {} m/s in shear",
            speed(material.bulk_modulus_0() + 4.0 / 3.0 * at_once),
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
    if material.softening_r > 0.0 {
        let [r, beta] = [material.softening_r, material.softening_beta].map(four_digits);
        let m = four_digits(material.softening_m);
        found.push(("softening".into(), format!("after the first load, with r = {r}, m = {m} J/m3 and beta = {beta}")));
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

/// The layers for other programs, SI, from the core to the surface: names, thicknesses and the same numbers.
pub fn json(scenario: &Scenario) -> Value {
    let one = |(name, layer): (String, &Layer)| {
        let material = &layer.material;
        let (at_once, end) = (material.shear_modulus_0(), material.shear_modulus_inf());
        json!({
            "name": name,
            "thickness": layer.thickness,
            "density": material.density,
            "shear_modulus_at_once": at_once,
            "shear_modulus_in_the_end": end,
            "bulk_modulus": material.effective_bulk_modulus(),
            "poissons_ratio_at_once": material.poissons_ratio_0(),
            "poissons_ratio_in_the_end": material.poissons_ratio_of(end),
        })
    };
    layers(scenario).map(one).collect()
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
    fn every_layer_has_a_paragraph_under_its_name_or_place() {
        let mut scenario = preset::study();
        scenario.set_layer_count(2);
        scenario.add_layer(preset::chamois()).unwrap();
        let text = text(&scenario);
        let heads: Vec<_> = text.lines().filter_map(|line| line.split_once(": ")).map(|(name, _)| name).collect();
        assert_eq!(heads, ["silicone", "layers[1]", "skin"]);
        assert_eq!(json(&scenario)[2]["thickness"], 1e-3);
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
