//! Abaqus keywords, in kg, m, s, Pa.
//!
//! Abaqus writes Ogden's law with 2 mu / alpha^2 in front, so its mu is mu alpha / 2 of here; its D1 is 2 / K.

use std::fmt::Write;

use softanvil_kernel::material::{ElasticLaw, Material, Moduli};

use super::ls_dyna::active;
use super::prony_terms;

/// The keywords; `comment` says where the numbers come from.
pub fn text(name: &str, comment: &str, material: &Material) -> String {
    let mut text = String::new();
    for line in comment.lines().chain(["Units: kg, m, s, Pa."]) {
        let _ = writeln!(text, "** {line}");
    }
    let _ = writeln!(text, "*MATERIAL, NAME={name}\n*DENSITY\n{}", number(material.density));
    // No bulk term relaxes, so that D1 is the same for both kinds of moduli.
    let d1 = 2.0 / material.effective_bulk_modulus();
    let moduli = match material.moduli {
        Moduli::LongTerm => "LONG TERM",
        Moduli::Instantaneous => "INSTANTANEOUS",
    };
    let [c10, c01, c11, c20, c02, c30] = active(material);
    let (form, values) = match material.law {
        ElasticLaw::NeoHookean => ("NEO HOOKE".to_string(), vec![c10, d1]),
        ElasticLaw::MooneyRivlin if [c11, c20, c02] == [0.0; 3] => ("MOONEY-RIVLIN".to_string(), vec![c10, c01, d1]),
        ElasticLaw::MooneyRivlin => ("POLYNOMIAL, N=2".to_string(), vec![c10, c01, c20, c11, c02, d1, 0.0]),
        ElasticLaw::Yeoh => ("YEOH".to_string(), vec![c10, c20, c30, d1, 0.0, 0.0]),
        ElasticLaw::Ogden => {
            let terms = material.ogden_mu.iter().zip(material.ogden_alpha).filter(|(mu, _)| **mu != 0.0);
            let pairs: Vec<f64> = terms.flat_map(|(mu, alpha)| [0.5 * mu * alpha, alpha]).collect();
            let n = pairs.len() / 2;
            let volume = std::iter::once(d1).chain(std::iter::repeat_n(0.0, n.saturating_sub(1)));
            (format!("OGDEN, N={n}"), pairs.into_iter().chain(volume).collect())
        }
    };
    let _ = writeln!(text, "*HYPERELASTIC, {form}, MODULI={moduli}");
    // Eight values a line.
    for line in values.chunks(8) {
        let _ = writeln!(text, "{}", line.iter().map(|value| number(*value)).collect::<Vec<_>>().join(", "));
    }
    let terms: Vec<_> = prony_terms(material).collect();
    if !terms.is_empty() {
        text += "*VISCOELASTIC, TIME=PRONY\n";
    }
    for (g, tau) in terms {
        // g, k, tau: the bulk modulus does not relax.
        let _ = writeln!(text, "{}, 0.0, {}", number(g), number(tau));
    }
    text
}

fn number(value: f64) -> String {
    if value == 0.0 { "0.0".into() } else { format!("{value:.9e}") }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::Law;

    fn values(text: &str, keyword: &str) -> Vec<f64> {
        let lines = text.lines().skip_while(|line| !line.starts_with(keyword)).skip(1);
        let data = lines.take_while(|line| !line.starts_with('*'));
        data.flat_map(|line| line.split(", ").map(|value| value.parse::<f64>().unwrap())).collect()
    }

    /// Source: Abaqus Keywords Reference, *HYPERELASTIC: N=2 polynomial C10, C01, C20, C11, C02, D1, D2.
    #[test]
    fn values_stand_in_the_order_of_the_keyword() {
        let mut material = Law::find("mooney_rivlin_5").unwrap().material(&[1e5, 2e4, 3e3, 4e2, 5e1]);
        material.prony_g[1] = 0.25;
        material.prony_tau[1] = 8.0;
        let text = text("rubber", "", &material);
        assert_eq!(values(&text, "*HYPERELASTIC")[..5], [1e5, 2e4, 4e2, 3e3, 5e1]);
        assert_eq!(values(&text, "*VISCOELASTIC"), [0.25, 0.0, 8.0]);
        assert!(text.contains("POLYNOMIAL, N=2, MODULI=LONG TERM"));
    }

    /// The initial shear modulus of Abaqus's Ogden form is the sum of its mu.
    #[test]
    fn ogden_coefficients_are_converted() {
        let material = Law::find("ogden_3").unwrap().material(&[6.3e5, 1.3, 1.2e3, 5.0, -1e4, -2.0]);
        let values = values(&text("rubber", "", &material), "*HYPERELASTIC");
        let sum: f64 = values[..6].iter().step_by(2).sum();
        assert!((sum / material.shear_modulus_inf() - 1.0).abs() < 1e-9, "{values:?}");
        assert_eq!(values.len(), 9);
    }
}
