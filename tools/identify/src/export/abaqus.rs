//! Abaqus keywords, in kg, m, s, Pa.
//!
//! The law of foams is *HYPERFOAM, of which all of the stress relaxes, the mean stress too.
//! Abaqus writes Ogden's law with 2 mu / alpha^2 in front, so its mu is mu alpha / 2 of here; its D1 is 2 / K.

use std::fmt::Write;

use softanvil_kernel::material::{
    ArrudaBoyce, ElasticLaw, Material, Moduli, MooneyRivlin, NeoHookean, VolumetricBy, Yeoh,
};

use super::card::Card;
use super::{ReadBackError, coefficient, foam_terms, ogden_terms, prony_terms};
use crate::law::blank;
use crate::law::foam::stress::PER_TERM;

/// The keywords, where Abaqus has the law; `comment` says where the numbers come from.
pub fn text(name: &str, comment: &str, material: &Material) -> Option<String> {
    let (keyword, values) = law(material)?;
    let mut text = String::new();
    for line in comment.lines().chain(["Units: kg, m, s, Pa."]) {
        let _ = writeln!(text, "** {line}");
    }
    let _ = writeln!(text, "*MATERIAL, NAME={name}\n*DENSITY\n{}", number(material.density));
    let moduli = match material.moduli {
        Moduli::LongTerm => "LONG TERM",
        Moduli::Instantaneous => "INSTANTANEOUS",
    };
    let _ = writeln!(text, "{keyword}, MODULI={moduli}");
    // Eight values a line.
    for line in values.chunks(8) {
        let _ = writeln!(text, "{}", line.iter().map(|value| number(*value)).collect::<Vec<_>>().join(", "));
    }
    let terms: Vec<_> = prony_terms(material).collect();
    if !terms.is_empty() {
        text += "*VISCOELASTIC, TIME=PRONY\n";
    }
    for (g, tau) in terms {
        // g, k, tau: the bulk modulus relaxes where it is the law's own.
        let k = if material.law.description().compressible { g } else { 0.0 };
        let _ = writeln!(text, "{}, {}, {}", number(g), number(k), number(tau));
    }
    Some(text)
}

/// Keyword with the form of the law, and its values; none of a law that Abaqus does not have.
fn law(material: &Material) -> Option<(String, Vec<f64>)> {
    if material.law == ElasticLaw::Hyperfoam {
        let terms = foam_terms(material);
        let pairs = terms.iter().flat_map(|term| [term.mu, term.alpha]);
        let values = pairs.chain(terms.iter().map(|term| term.nu)).collect();
        return Some((format!("*HYPERFOAM, N={}", terms.len()), values));
    }
    let (form, values) = isochoric(material)?;
    Some((format!("*HYPERELASTIC, {form}"), values))
}

/// Form of the law and values of *HYPERELASTIC.
fn isochoric(material: &Material) -> Option<(String, Vec<f64>)> {
    // No bulk term relaxes, so that D1 is the same for both kinds of moduli.
    let d1 = 2.0 / material.effective_bulk_modulus();
    let [c10, c01, c11, c20, c02, c30] =
        ["c10", "c01", "c11", "c20", "c02", "c30"].map(|name| coefficient(material, name));
    Some(match material.law {
        ElasticLaw::NeoHookean => ("NEO HOOKE".to_string(), vec![c10, d1]),
        ElasticLaw::MooneyRivlin if [c11, c20, c02] == [0.0; 3] => ("MOONEY-RIVLIN".to_string(), vec![c10, c01, d1]),
        ElasticLaw::MooneyRivlin => ("POLYNOMIAL, N=2".to_string(), vec![c10, c01, c20, c11, c02, d1, 0.0]),
        ElasticLaw::Yeoh => ("YEOH".to_string(), vec![c10, c20, c30, d1, 0.0, 0.0]),
        ElasticLaw::Ogden => {
            let terms = ogden_terms(material);
            let n = terms.len();
            let pairs = terms.into_iter().flat_map(|(mu, alpha)| [0.5 * mu * alpha, alpha]);
            let volume = std::iter::once(d1).chain(std::iter::repeat_n(0.0, n.saturating_sub(1)));
            (format!("OGDEN, N={n}"), pairs.chain(volume).collect())
        }
        ElasticLaw::ArrudaBoyce => {
            let values = ["arruda_boyce_mu", "arruda_boyce_lambda_m"].map(|name| coefficient(material, name));
            ("ARRUDA-BOYCE".to_string(), vec![values[0], values[1], d1])
        }
        _ => return None,
    })
}

/// What the keywords in `text` mean to Abaqus, which has no damping spring.
///
/// # Errors
/// A keyword that is missing, or a value that is no number.
pub fn read(text: &str) -> Result<Card, ReadBackError> {
    let mut material = blank();
    material.density = *values(text, "*DENSITY")?.1.first().ok_or_else(|| ReadBackError::new("*DENSITY"))?;
    let foam = text.contains("*HYPERFOAM");
    let (options, values_of_law) = values(text, if foam { "*HYPERFOAM" } else { "*HYPERELASTIC" })?;
    let value = |index: usize| {
        values_of_law.get(index).copied().ok_or_else(|| ReadBackError::new(format!("value {} of the law", index + 1)))
    };
    let d1 = if foam {
        let n = values_of_law.len() / PER_TERM;
        let term = |k: usize| Ok([value(2 * k)?, value(2 * k + 1)?, value(2 * n + k)?]);
        let terms = (0..n).map(term).collect::<Result<Vec<_>, ReadBackError>>()?;
        material = material.with_values(ElasticLaw::Hyperfoam, &terms.concat());
        // Its own, whatever else is said.
        2.0 / material.effective_bulk_modulus()
    } else if options.contains("NEO HOOKE") {
        material = material.with(NeoHookean { c10: value(0)? });
        value(1)?
    } else if options.contains("MOONEY-RIVLIN") {
        material = material.with(MooneyRivlin { c10: value(0)?, c01: value(1)?, ..MooneyRivlin::ZERO });
        value(2)?
    } else if options.contains("POLYNOMIAL") {
        let [c10, c01, c20, c11, c02] = [value(0)?, value(1)?, value(2)?, value(3)?, value(4)?];
        material = material.with(MooneyRivlin { c10, c01, c11, c20, c02 });
        value(5)?
    } else if options.contains("ARRUDA-BOYCE") {
        material = material.with(ArrudaBoyce::new(value(0)?, value(1)?));
        value(2)?
    } else if options.contains("YEOH") {
        material = material.with(Yeoh { c10: value(0)?, c20: value(1)?, c30: value(2)? });
        value(3)?
    } else {
        // n pairs and n D.
        let n = values_of_law.len() / 3;
        let terms = values_of_law[..2 * n].chunks_exact(2).flat_map(|term| [2.0 * term[0] / term[1], term[1]]);
        material = material.with_values(ElasticLaw::Ogden, &terms.collect::<Vec<_>>());
        value(2 * n)?
    };
    if options.contains("INSTANTANEOUS") {
        material.moduli = Moduli::Instantaneous;
    }
    material.volumetric_by = VolumetricBy::BulkModulus;
    material.bulk_modulus = 2.0 / d1;
    if text.contains("*VISCOELASTIC") {
        for (k, term) in values(text, "*VISCOELASTIC")?.1.chunks_exact(3).enumerate().take(material.prony_g.len()) {
            (material.prony_g[k], material.prony_tau[k]) = (term[0], term[2]);
        }
    }
    Ok(Card { slider: None, ..Card::of(&material) })
}

/// The line of `keyword` and the values below it.
fn values<'a>(text: &'a str, keyword: &str) -> Result<(&'a str, Vec<f64>), ReadBackError> {
    let mut lines = text.lines().skip_while(|line| !line.starts_with(keyword));
    let options = lines.next().ok_or_else(|| ReadBackError::new(keyword))?;
    let values = lines.take_while(|line| !line.starts_with('*')).flat_map(|line| line.split(','));
    let number = |value: &str| value.trim().parse().map_err(|_| ReadBackError::new(format!("\"{}\"", value.trim())));
    Ok((options, values.map(number).collect::<Result<_, _>>()?))
}

fn number(value: f64) -> String {
    if value == 0.0 { "0.0".into() } else { format!("{value:.9e}") }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::Law;

    /// Source: Abaqus Keywords Reference, *HYPERELASTIC: N=2 polynomial C10, C01, C20, C11, C02, D1, D2.
    #[test]
    fn values_stand_in_the_order_of_the_keyword() {
        let mut material = Law::find("mooney_rivlin_5").unwrap().material(&[1e5, 2e4, 3e3, 4e2, 5e1]);
        material.prony_g[1] = 0.25;
        material.prony_tau[1] = 8.0;
        let text = text("rubber", "", &material).unwrap();
        assert_eq!(values(&text, "*HYPERELASTIC").unwrap().1[..5], [1e5, 2e4, 4e2, 3e3, 5e1]);
        assert_eq!(values(&text, "*VISCOELASTIC").unwrap().1, [0.25, 0.0, 8.0]);
        assert!(text.contains("POLYNOMIAL, N=2, MODULI=LONG TERM"));
    }

    /// Source: Abaqus Keywords Reference, *HYPERFOAM: pairs of mu and alpha, then every nu.
    #[test]
    fn values_of_a_foam_stand_in_the_order_of_the_keyword() {
        let mut material = Law::find("foam_2").unwrap().material(&[1e5, 8.0, 0.1, 2e4, -2.0, 0.3]);
        (material.prony_g[0], material.prony_tau[0]) = (0.25, 8.0);
        let text = text("foam", "", &material).unwrap();
        assert_eq!(values(&text, "*HYPERFOAM").unwrap().1, [1e5, 8.0, 2e4, -2.0, 0.1, 0.3]);
        assert_eq!(values(&text, "*VISCOELASTIC").unwrap().1, [0.25, 0.25, 8.0]);
        assert!(text.contains("*HYPERFOAM, N=2, MODULI=LONG TERM"));
    }

    /// The initial shear modulus of Abaqus's Ogden form is the sum of its mu.
    #[test]
    fn ogden_coefficients_are_converted() {
        let material = Law::find("ogden_3").unwrap().material(&[6.3e5, 1.3, 1.2e3, 5.0, -1e4, -2.0]);
        let text = text("rubber", "", &material).unwrap();
        let (_, values) = values(&text, "*HYPERELASTIC").unwrap();
        let sum: f64 = values[..6].iter().step_by(2).sum();
        assert!((sum / material.shear_modulus_inf() - 1.0).abs() < 1e-9, "{values:?}");
        assert_eq!(values.len(), 9);
    }
}
