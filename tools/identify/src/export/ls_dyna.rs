//! LS-DYNA keyword cards: *MAT_077_H (hyperelastic rubber), *MAT_077_O (Ogden rubber), *MAT_127 (Arruda-Boyce rubber) or *MAT_177
//! (Hill foam), in kg, m, s, Pa.
//!
//! Their viscous terms are absolute shear moduli G_i with decay constants beta_i on top of the long-term law:
//! G_i = G_inf g_i / g_inf, beta_i = 1 / tau_i. LS-DYNA drives them by the strain, the kernel by the isochoric stress:
//! the same at small strains only.
//!
//! *MAT_177 writes the terms of a foam as C = 2 mu / alpha and b = alpha with one n = nu / (1 - 2 nu) for all of them, and has no
//! viscous ones.

use std::fmt::Write;

use softanvil_kernel::material::{
    ArrudaBoyce, ElasticLaw, MAX_OGDEN_TERMS, Material, MooneyRivlin, Ogden, VolumetricBy, Yeoh,
};

use super::card::Card;
use super::{ReadBackError, coefficient, foam_terms, ogden_terms, viscous};
use crate::law::blank;

/// The cards, where LS-DYNA has the law; `comment` says where the numbers come from.
pub fn text(title: &str, comment: &str, material: &Material) -> Option<String> {
    let (keyword, cards) = law(material)?;
    let mut text = String::from("*KEYWORD\n");
    for line in comment.lines().chain(["Units: kg, m, s, Pa."]) {
        let _ = writeln!(text, "$ {line}");
    }
    let _ = write!(text, "{keyword}\n{title}\n{cards}");
    let terms: Vec<_> = viscous(material).collect();
    if !terms.is_empty() {
        text += "$       GI     BETAI\n";
    }
    for (g, beta) in terms {
        let _ = writeln!(text, "{}{}", field(g), field(beta));
    }
    Some(text + "*END\n")
}

/// The keyword and the cards before the viscous terms; none of a law that LS-DYNA does not have.
fn law(material: &Material) -> Option<(&'static str, String)> {
    let scale = material.long_term_scale();
    let value = |name: &str| coefficient(material, name);
    match material.law {
        ElasticLaw::Ogden => {
            let mut terms = ogden_terms(material);
            terms.resize(MAX_OGDEN_TERMS, (0.0, 0.0));
            let mu: String = terms.iter().map(|term| field(scale * term.0)).collect();
            let alpha: String = terms.iter().map(|term| field(term.1)).collect();
            let cards = format!("$      MU1       MU2       MU3\n{mu}\n$   ALPHA1    ALPHA2    ALPHA3\n{alpha}\n");
            Some((OGDEN, first_card(material) + &cards))
        }
        ElasticLaw::NeoHookean | ElasticLaw::MooneyRivlin | ElasticLaw::Yeoh => {
            let values = ["c10", "c01", "c11", "c20", "c02", "c30"].map(|name| field(scale * value(name))).concat();
            let cards = format!("$      C10       C01       C11       C20       C02       C30\n{values}\n");
            Some((POLYNOMIAL, first_card(material) + &cards))
        }
        ElasticLaw::ArrudaBoyce => {
            // The number of links is a whole one.
            let links = value("arruda_boyce_lambda_m").powi(2).round();
            let numbers =
                [material.density, material.effective_bulk_modulus(), scale * value("arruda_boyce_mu")].map(field);
            let first = format!(
                "$      MID        RO         K         G         N\n{:>10}{}{links:>10}\n",
                1,
                numbers.concat()
            );
            let second = format!("$     LCID     TRAMP        NT\n{:>10}{}{}\n", 0, field(0.0), field(6.0));
            Some((ARRUDA_BOYCE, first + &second))
        }
        ElasticLaw::Hyperfoam => Some((HILL_FOAM, hill_foam(material)?)),
        _ => None,
    }
}

/// The cards of *MAT_177; none of a foam whose terms have ratios of their own, or viscous ones.
fn hill_foam(material: &Material) -> Option<String> {
    let (scale, terms) = (material.long_term_scale(), foam_terms(material));
    let nu = terms.first()?.nu;
    if terms.iter().any(|term| (term.nu - nu).abs() > 1e-9) || viscous(material).next().is_some() {
        return None;
    }
    let n = nu / (1.0 - 2.0 * nu);
    let numbers = [material.density, material.effective_bulk_modulus(), n, 0.0].map(field).concat();
    let eight = |values: &mut dyn Iterator<Item = f64>| {
        let fields: Vec<String> = values.chain(std::iter::repeat(0.0)).take(8).map(field).collect();
        fields.concat()
    };
    let c = eight(&mut terms.iter().map(|term| scale * 2.0 * term.mu / term.alpha));
    let b = eight(&mut terms.iter().map(|term| term.alpha));
    Some(format!(
        "$      MID        RO         K         N        MU      LCID   FITTYPE      LCSR\n{:>10}{numbers}{:>10}{:>10}{:>10}\n\
         $       C1        C2        C3        C4        C5        C6        C7        C8\n{c}\n\
         $       B1        B2        B3        B4        B5        B6        B7        B8\n{b}\n\
         $        R         M\n{}{}\n",
        1,
        0,
        0,
        0,
        field(0.0),
        field(0.0)
    ))
}

/// The first card of *MAT_077.
fn first_card(material: &Material) -> String {
    let (bulk, shear) = (material.effective_bulk_modulus(), material.shear_modulus_inf());
    let poissons_ratio = (3.0 * bulk - 2.0 * shear) / (2.0 * (3.0 * bulk + shear));
    format!(
        "$      MID        RO        PR         N        NV         G      SIGF       REF\n{:>10}{}{}{:>10}{:>10}{}{}{:>10}\n",
        1,
        field(material.density),
        field(poissons_ratio),
        0,
        0,
        field(material.slider_stiffness),
        field(material.slider_yield_stress),
        0
    )
}

/// The keyword of Ogden's law.
const OGDEN: &str = "*MAT_077_O_TITLE";
/// The keyword of the polynomials.
const POLYNOMIAL: &str = "*MAT_077_H_TITLE";
/// The keyword of Arruda and Boyce's law, with the same series.
const ARRUDA_BOYCE: &str = "*MAT_127_TITLE";

/// The keyword of Hill's foam.
const HILL_FOAM: &str = "*MAT_177_TITLE";

/// What the cards in `text` mean to LS-DYNA: fields of ten columns, lines of comment begin with $.
///
/// # Errors
/// A card that is missing or a field that is no number.
pub fn read(text: &str) -> Result<Card, ReadBackError> {
    let mut lines = text.lines().filter(|line| !line.starts_with('$'));
    let keyword = lines.find(|line| line.starts_with("*MAT_")).ok_or_else(|| ReadBackError::new("*MAT"))?;
    let cards: Vec<Vec<f64>> =
        lines.skip(1).take_while(|line| !line.starts_with('*')).map(fields).collect::<Result<_, _>>()?;
    let (material, coefficients) = match keyword {
        OGDEN => {
            let (mu, alpha) = (card(&cards, 1, 3)?, card(&cards, 2, 3)?);
            (read_first(&cards)?.with(Ogden::new([mu[0], mu[1], mu[2]], [alpha[0], alpha[1], alpha[2]])), 3)
        }
        ARRUDA_BOYCE => {
            let first = card(&cards, 0, 5)?;
            let (volumetric_by, law) = (VolumetricBy::BulkModulus, ArrudaBoyce::new(first[3], first[4].sqrt()));
            (Material { density: first[1], volumetric_by, bulk_modulus: first[2], ..blank().with(law) }, 2)
        }
        HILL_FOAM => {
            let (first, c, b) = (card(&cards, 0, 4)?, card(&cards, 1, 8)?, card(&cards, 2, 8)?);
            let nu = first[3] / (1.0 + 2.0 * first[3]);
            let terms = c.iter().zip(b).filter(|(c, _)| **c != 0.0).flat_map(|(c, b)| [0.5 * c * b, *b, nu]);
            let material = blank().with_values(ElasticLaw::Hyperfoam, &terms.collect::<Vec<_>>());
            (Material { density: first[1], ..material }, cards.len())
        }
        _ => {
            // C30 makes a law of Yeoh's of it; no other has it beside the mixed ones.
            let (c, first) = (card(&cards, 1, 6)?, read_first(&cards)?);
            let yeoh = c[5] != 0.0 || [c[1], c[2], c[4]] == [0.0; 3];
            let material = match yeoh {
                true => first.with(Yeoh { c10: c[0], c20: c[3], c30: c[5] }),
                false => first.with(MooneyRivlin { c10: c[0], c01: c[1], c11: c[2], c20: c[3], c02: c[4] }),
            };
            (material, 2)
        }
    };
    let terms = (coefficients..cards.len()).map(|k| card(&cards, k, 2).map(|term| (term[0], 1.0 / term[1])));
    let (viscous, card) = (terms.collect::<Result<_, _>>()?, Card::of(&material));
    // *MAT_127 and *MAT_177 have no damping spring.
    let slider = card.slider.filter(|_| ![ARRUDA_BOYCE, HILL_FOAM].contains(&keyword));
    Ok(Card { viscous, slider, ..card })
}

/// What the first card of *MAT_077 says.
fn read_first(cards: &[Vec<f64>]) -> Result<Material, ReadBackError> {
    let first = card(cards, 0, 8)?;
    Ok(Material {
        density: first[1],
        volumetric_by: VolumetricBy::PoissonsRatio,
        poissons_ratio: first[2],
        slider_stiffness: first[5],
        slider_yield_stress: first[6],
        ..blank()
    })
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
        let chains = Law::find("arruda_boyce").unwrap().material(&[2e5, 5.0]);
        let chains = text("rubber", "", &chains).unwrap();
        assert!(chains.contains("*MAT_127_TITLE\nrubber\n") && chains.contains(" 2.00000e5        25\n"), "{chains}");
        let law = Law::find("foam_2").unwrap();
        let foam = text("foam", "", &law.material(&[1e5, 8.0, 0.25, 2e4, -2.0, 0.25])).unwrap();
        let row = |after: &str| foam.lines().skip_while(|line| !line.starts_with(after)).nth(1).unwrap().to_string();
        assert!(foam.contains("*MAT_177_TITLE\nfoam\n") && row("$      MID")[30..40].trim() == "0.5000000", "{foam}");
        assert!(row("$       C1").starts_with(" 2.50000e4 -2.0000e4"), "{foam}");
        assert!(text("foam", "", &law.material(&[1e5, 8.0, 0.1, 2e4, -2.0, 0.3])).is_none());
        assert!(text("rubber", "", &Law::find("gent").unwrap().material(&[2e5, 80.0])).is_none());
        assert!(ogden.contains("*MAT_077_O_TITLE") && !ogden.contains("GI"), "{ogden}");
    }
}
