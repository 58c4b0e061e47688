//! LS-DYNA keyword cards: *MAT_077_H (hyperelastic rubber) or *MAT_077_O (Ogden rubber), in kg, m, s, Pa.
//!
//! Their viscous terms are absolute shear moduli G_i with decay constants beta_i on top of the long-term law:
//! G_i = G_inf g_i / g_inf, beta_i = 1 / tau_i. LS-DYNA drives them by the strain, the kernel by the isochoric stress:
//! the same at small strains only.

use std::fmt::Write;

use softanvil_kernel::material::{ElasticLaw, MAX_OGDEN_TERMS, Material, MooneyRivlin, Ogden, VolumetricBy, Yeoh};

use super::card::Card;
use super::{ReadBackError, coefficient, ogden_terms, viscous};
use crate::law::blank;

/// The cards, where LS-DYNA has the law; `comment` says where the numbers come from.
pub fn text(title: &str, comment: &str, material: &Material) -> Option<String> {
    let (keyword, law) = law(material)?;
    let mut text = String::from("*KEYWORD\n");
    for line in comment.lines().chain(["Units: kg, m, s, Pa."]) {
        let _ = writeln!(text, "$ {line}");
    }
    let _ = writeln!(text, "{keyword}\n{title}");
    let bulk = material.effective_bulk_modulus();
    let shear = material.shear_modulus_inf();
    let poissons_ratio = (3.0 * bulk - 2.0 * shear) / (2.0 * (3.0 * bulk + shear));
    text += "$      MID        RO        PR         N        NV         G      SIGF       REF\n";
    let (g, sigf) = (material.slider_stiffness, material.slider_yield_stress);
    let _ = writeln!(
        text,
        "{:>10}{}{}{:>10}{:>10}{}{}{:>10}",
        1,
        field(material.density),
        field(poissons_ratio),
        0,
        0,
        field(g),
        field(sigf),
        0
    );
    text += &law;
    let terms: Vec<_> = viscous(material).collect();
    if !terms.is_empty() {
        text += "$       GI     BETAI\n";
    }
    for (g, beta) in terms {
        let _ = writeln!(text, "{}{}", field(g), field(beta));
    }
    Some(text + "*END\n")
}

/// The keyword and the cards of the coefficients; none of a law that LS-DYNA does not have.
fn law(material: &Material) -> Option<(&'static str, String)> {
    let scale = material.long_term_scale();
    match material.law {
        ElasticLaw::Ogden => {
            let mut terms = ogden_terms(material);
            terms.resize(MAX_OGDEN_TERMS, (0.0, 0.0));
            let mu: String = terms.iter().map(|term| field(scale * term.0)).collect();
            let alpha: String = terms.iter().map(|term| field(term.1)).collect();
            let cards = format!("$      MU1       MU2       MU3\n{mu}\n$   ALPHA1    ALPHA2    ALPHA3\n{alpha}\n");
            Some((OGDEN, cards))
        }
        ElasticLaw::NeoHookean | ElasticLaw::MooneyRivlin | ElasticLaw::Yeoh => {
            let names = ["c10", "c01", "c11", "c20", "c02", "c30"];
            let values = names.map(|name| field(scale * coefficient(material, name))).concat();
            Some((POLYNOMIAL, format!("$      C10       C01       C11       C20       C02       C30\n{values}\n")))
        }
        _ => None,
    }
}

/// The keyword of Ogden's law.
const OGDEN: &str = "*MAT_077_O_TITLE";
/// The keyword of the polynomials.
const POLYNOMIAL: &str = "*MAT_077_H_TITLE";

/// What the cards in `text` mean to LS-DYNA: fields of ten columns, lines of comment begin with $.
///
/// # Errors
/// A card that is missing or a field that is no number.
pub fn read(text: &str) -> Result<Card, ReadBackError> {
    let mut lines = text.lines().filter(|line| !line.starts_with('$'));
    let keyword = lines.find(|line| line.starts_with("*MAT_077_")).ok_or_else(|| ReadBackError::new("*MAT_077"))?;
    let cards: Vec<Vec<f64>> =
        lines.skip(1).take_while(|line| !line.starts_with('*')).map(fields).collect::<Result<_, _>>()?;
    let first = card(&cards, 0, 8)?;
    let mut material = blank();
    let (coefficients, terms) = match keyword {
        OGDEN => {
            let (mu, alpha) = (card(&cards, 1, 3)?, card(&cards, 2, 3)?);
            material = material.with(Ogden::new([mu[0], mu[1], mu[2]], [alpha[0], alpha[1], alpha[2]]));
            (2, cards.get(3..))
        }
        _ => {
            // C30 makes a law of Yeoh's of it; no other has it beside the mixed ones.
            let c = card(&cards, 1, 6)?;
            let yeoh = c[5] != 0.0 || [c[1], c[2], c[4]] == [0.0; 3];
            material = if yeoh {
                material.with(Yeoh { c10: c[0], c20: c[3], c30: c[5] })
            } else {
                material.with(MooneyRivlin { c10: c[0], c01: c[1], c11: c[2], c20: c[3], c02: c[4] })
            };
            (1, cards.get(2..))
        }
    };
    let terms = terms.unwrap_or_default().iter().enumerate();
    let viscous = terms.map(|(k, _)| card(&cards, coefficients + 1 + k, 2).map(|term| (term[0], 1.0 / term[1])));
    material.density = first[1];
    material.volumetric_by = VolumetricBy::PoissonsRatio;
    material.poissons_ratio = first[2];
    (material.slider_stiffness, material.slider_yield_stress) = (first[5], first[6]);
    Ok(Card { viscous: viscous.collect::<Result<_, _>>()?, ..Card::of(&material) })
}

fn card(cards: &[Vec<f64>], index: usize, width: usize) -> Result<&[f64], ReadBackError> {
    let card = cards.get(index).filter(|card| card.len() >= width);
    card.map(Vec::as_slice).ok_or_else(|| ReadBackError::new(format!("card {} of {width} fields", index + 1)))
}

fn fields(line: &str) -> Result<Vec<f64>, ReadBackError> {
    let field = |bytes: &[u8]| {
        let text = std::str::from_utf8(bytes).unwrap_or_default().trim();
        text.parse().map_err(|_| ReadBackError::new(format!("\"{text}\"")))
    };
    line.as_bytes().chunks(WIDTH).map(field).collect()
}

/// Columns of a field.
const WIDTH: usize = 10;

/// A number in ten columns with as many digits as fit.
fn field(value: f64) -> String {
    if value == 0.0 {
        return format!("{:>10}", "0.0");
    }
    (0..=7)
        .rev()
        .flat_map(|digits| {
            // A point without digits behind it still makes a real number.
            let point = if digits == 0 { "." } else { "" };
            [format!("{value:.digits$}{point}"), format!("{value:.digits$e}")]
        })
        .filter(|text| text.len() <= 9 && text.contains('.'))
        .min_by(|a, b| error(a, value).total_cmp(&error(b, value)))
        .map_or_else(|| format!("{value:>10.2e}"), |text| format!("{text:>10}"))
}

fn error(text: &str, value: f64) -> f64 {
    text.parse::<f64>().map_or(f64::INFINITY, |read| ((read - value) / value).abs())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::Law;

    #[test]
    fn numbers_fill_their_ten_columns() {
        for value in [1072.0, 0.48, 1.0 / 3.0, -123456.789, 3e-12, -4.56789e-7, 47e6, 1.5e11, 5.0] {
            let text = field(value);
            assert_eq!(text.len(), 10, "{text}");
            assert!(error(text.trim(), value) < 2e-4, "{value}: {text}");
        }
    }

    #[test]
    fn cards_hold_the_coefficients_in_their_columns() {
        let mut material = Law::find("mooney_rivlin_5").unwrap().material(&[1e5, 2e4, 3e3, 4e2, 5e1]);
        material.prony_g[0] = 0.5;
        material.prony_tau[0] = 0.25;
        let cards = text("rubber", "from a test", &material).unwrap();
        let numbers = |after: &str| -> Vec<f64> {
            let line = cards.lines().skip_while(|line| !line.starts_with(after)).nth(1).unwrap();
            line.as_bytes().chunks(10).map(|c| std::str::from_utf8(c).unwrap().trim().parse().unwrap()).collect()
        };
        assert_eq!(numbers("$      C10"), [1e5, 2e4, 3e3, 4e2, 5e1, 0.0]);
        // G_inf = 2 (C10 + C01) = 240 kPa, which a term of g = 1/2 doubles.
        assert_eq!(numbers("$       GI"), [2.4e5, 4.0]);
        assert_eq!(numbers("$      MID")[1..3], [1072.0, 0.48]);
        assert!(cards.contains("*MAT_077_H_TITLE"));
        let ogden = text("rubber", "", &Law::find("ogden_2").unwrap().material(&[6e5, 1.3, -1e4, -2.0])).unwrap();
        assert!(ogden.contains("*MAT_077_O_TITLE") && !ogden.contains("GI"), "{ogden}");
    }
}
