//! LS-DYNA keyword cards: *MAT_077_H (hyperelastic rubber) or *MAT_077_O (Ogden rubber), in kg, m, s, Pa.
//!
//! Their viscous terms are absolute shear moduli G_i with decay constants beta_i on top of the long-term law:
//! G_i = G_inf g_i / g_inf, beta_i = 1 / tau_i. LS-DYNA drives them by the strain, the kernel by the isochoric stress:
//! the same at small strains only.

use std::fmt::Write;

use softanvil_kernel::material::{ElasticLaw, Material};

use super::prony_terms;

/// The cards; `comment` says where the numbers come from.
pub fn text(title: &str, comment: &str, material: &Material) -> String {
    let ogden = material.law == ElasticLaw::Ogden;
    let mut text = String::from("*KEYWORD\n");
    for line in comment.lines().chain(["Units: kg, m, s, Pa."]) {
        let _ = writeln!(text, "$ {line}");
    }
    let _ = writeln!(text, "*MAT_077_{}_TITLE\n{title}", if ogden { "O" } else { "H" });
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
    let scale = material.long_term_scale();
    if ogden {
        text += "$      MU1       MU2       MU3\n";
        text += &(material.ogden_mu.iter().map(|mu| field(scale * mu)).collect::<String>() + "\n");
        text += "$   ALPHA1    ALPHA2    ALPHA3\n";
        let alpha = material.ogden_mu.iter().zip(material.ogden_alpha).map(|(mu, a)| if *mu == 0.0 { 0.0 } else { a });
        text += &(alpha.map(field).collect::<String>() + "\n");
    } else {
        text += "$      C10       C01       C11       C20       C02       C30\n";
        let [c10, c01, c11, c20, c02, c30] = active(material);
        text += &([c10, c01, c11, c20, c02, c30].map(|c| field(scale * c)).concat() + "\n");
    }
    let terms: Vec<_> = viscous(material).collect();
    if !terms.is_empty() {
        text += "$       GI     BETAI\n";
    }
    for (g, beta) in terms {
        let _ = writeln!(text, "{}{}", field(g), field(beta));
    }
    text + "*END\n"
}

/// C10, C01, C11, C20, C02, C30 as far as the law uses them.
pub(super) fn active(material: &Material) -> [f64; 6] {
    let m = material;
    match m.law {
        ElasticLaw::NeoHookean | ElasticLaw::Ogden => [m.c10, 0.0, 0.0, 0.0, 0.0, 0.0],
        ElasticLaw::MooneyRivlin => [m.c10, m.c01, m.c11, m.c20, m.c02, 0.0],
        ElasticLaw::Yeoh => [m.c10, 0.0, 0.0, m.c20, 0.0, m.c30],
    }
}

/// (G_i, beta_i) of the Prony terms and of the additive Maxwell terms.
fn viscous(material: &Material) -> impl Iterator<Item = (f64, f64)> {
    let scale = material.shear_modulus_inf() / material.prony_g_inf();
    let maxwell = material.maxwell_g.into_iter().zip(material.maxwell_beta).filter(|(g, _)| *g > 0.0);
    prony_terms(material).map(move |(g, tau)| (scale * g, 1.0 / tau)).chain(maxwell)
}

/// A number in ten columns with as many digits as fit.
fn field(value: f64) -> String {
    if value == 0.0 {
        return format!("{:>10}", "0.0");
    }
    (0..=7)
        .rev()
        .flat_map(|digits| [format!("{value:.digits$}"), format!("{value:.digits$e}")])
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
        let cards = text("rubber", "from a test", &material);
        let numbers = |after: &str| -> Vec<f64> {
            let line = cards.lines().skip_while(|line| !line.starts_with(after)).nth(1).unwrap();
            line.as_bytes().chunks(10).map(|c| std::str::from_utf8(c).unwrap().trim().parse().unwrap()).collect()
        };
        assert_eq!(numbers("$      C10"), [1e5, 2e4, 3e3, 4e2, 5e1, 0.0]);
        // G_inf = 2 (C10 + C01) = 240 kPa, which a term of g = 1/2 doubles.
        assert_eq!(numbers("$       GI"), [2.4e5, 4.0]);
        assert_eq!(numbers("$      MID")[1..3], [1072.0, 0.48]);
        assert!(cards.contains("*MAT_077_H_TITLE"));
        let ogden = text("rubber", "", &Law::find("ogden_2").unwrap().material(&[6e5, 1.3, -1e4, -2.0]));
        assert!(ogden.contains("*MAT_077_O_TITLE") && !ogden.contains("GI"), "{ogden}");
    }
}
