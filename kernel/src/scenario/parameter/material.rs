//! The rows of a material, written once for every layer.

use super::row::{Parameter, choice, real};
use crate::material::{ElasticLaw, Moduli, VolumetricBy, VolumetricLaw};

/// Name of a row in the group of a layer.
macro_rules! name {
    ($layer:ident, $field:literal) => {
        concat!(stringify!($layer), ".", $field)
    };
}

/// The rows of the material of a layer, whose field in a scenario has the name of the group.
macro_rules! material_rows {
    ($layer:ident) => {
        &[
            real(name!($layer, "density"), "kg/m3", (10.0, 2e4), |s| &mut s.$layer.density, "density"),
            choice(
                name!($layer, "law"),
                &["neo_hookean", "mooney_rivlin", "yeoh", "ogden"],
                |s| s.$layer.law as usize,
                |s, i| {
                    s.$layer.law = match i {
                        0 => ElasticLaw::NeoHookean,
                        1 => ElasticLaw::MooneyRivlin,
                        2 => ElasticLaw::Yeoh,
                        _ => ElasticLaw::Ogden,
                    }
                },
                "isochoric hyperelastic law (mooney_rivlin has 2, 3 or 5 parameters, by coefficients of zero)",
            ),
            choice(
                name!($layer, "moduli"),
                &["long_term", "instantaneous"],
                |s| s.$layer.moduli as usize,
                |s, i| s.$layer.moduli = if i == 0 { Moduli::LongTerm } else { Moduli::Instantaneous },
                "what the elastic coefficients are: after full relaxation, or before any",
            ),
            real(
                name!($layer, "c10"),
                "Pa",
                (-1e9, 1e9),
                |s| &mut s.$layer.c10,
                "coefficient of (I1 - 3) in all laws but ogden",
            ),
            real(
                name!($layer, "c01"),
                "Pa",
                (-1e9, 1e9),
                |s| &mut s.$layer.c01,
                "mooney_rivlin coefficient of (I2 - 3)",
            ),
            real(
                name!($layer, "c11"),
                "Pa",
                (-1e9, 1e9),
                |s| &mut s.$layer.c11,
                "mooney_rivlin coefficient of (I1 - 3)(I2 - 3)",
            ),
            real(
                name!($layer, "c20"),
                "Pa",
                (-1e9, 1e9),
                |s| &mut s.$layer.c20,
                "mooney_rivlin and yeoh coefficient of (I1 - 3)^2",
            ),
            real(
                name!($layer, "c02"),
                "Pa",
                (-1e9, 1e9),
                |s| &mut s.$layer.c02,
                "mooney_rivlin coefficient of (I2 - 3)^2",
            ),
            real(name!($layer, "c30"), "Pa", (-1e9, 1e9), |s| &mut s.$layer.c30, "yeoh coefficient of (I1 - 3)^3"),
            real(name!($layer, "ogden_mu_1"), "Pa", (-1e9, 1e9), |s| &mut s.$layer.ogden_mu[0], OGDEN_MU),
            real(name!($layer, "ogden_alpha_1"), "1", (-30.0, 30.0), |s| &mut s.$layer.ogden_alpha[0], OGDEN_ALPHA),
            real(name!($layer, "ogden_mu_2"), "Pa", (-1e9, 1e9), |s| &mut s.$layer.ogden_mu[1], OGDEN_MU),
            real(name!($layer, "ogden_alpha_2"), "1", (-30.0, 30.0), |s| &mut s.$layer.ogden_alpha[1], OGDEN_ALPHA),
            real(name!($layer, "ogden_mu_3"), "Pa", (-1e9, 1e9), |s| &mut s.$layer.ogden_mu[2], OGDEN_MU),
            real(name!($layer, "ogden_alpha_3"), "1", (-30.0, 30.0), |s| &mut s.$layer.ogden_alpha[2], OGDEN_ALPHA),
            choice(
                name!($layer, "volumetric_law"),
                &["quadratic", "simo"],
                |s| s.$layer.volumetric_law as usize,
                |s, i| s.$layer.volumetric_law = if i == 0 { VolumetricLaw::Quadratic } else { VolumetricLaw::Simo },
                "energy of volume change: K/2 (J-1)^2, or K/4 (J^2 - 1 - 2 ln J), which no compression brings to J = 0",
            ),
            choice(
                name!($layer, "volumetric_by"),
                &["bulk_modulus", "poissons_ratio"],
                |s| s.$layer.volumetric_by as usize,
                |s, i| {
                    s.$layer.volumetric_by =
                        if i == 0 { VolumetricBy::BulkModulus } else { VolumetricBy::PoissonsRatio }
                },
                "which of the next two states the compressibility",
            ),
            real(name!($layer, "bulk_modulus"), "Pa", (1e2, 1e12), |s| &mut s.$layer.bulk_modulus, "bulk modulus"),
            real(
                name!($layer, "poissons_ratio"),
                "1",
                (0.0, 0.4999),
                |s| &mut s.$layer.poissons_ratio,
                "Poisson's ratio of the long-term law",
            ),
            real(name!($layer, "prony_g_1"), "1", (0.0, 0.9999), |s| &mut s.$layer.prony_g[0], PRONY_G),
            real(name!($layer, "prony_tau_1"), "s", (1e-7, 1e6), |s| &mut s.$layer.prony_tau[0], PRONY_TAU),
            real(name!($layer, "prony_g_2"), "1", (0.0, 0.9999), |s| &mut s.$layer.prony_g[1], PRONY_G),
            real(name!($layer, "prony_tau_2"), "s", (1e-7, 1e6), |s| &mut s.$layer.prony_tau[1], PRONY_TAU),
            real(name!($layer, "prony_g_3"), "1", (0.0, 0.9999), |s| &mut s.$layer.prony_g[2], PRONY_G),
            real(name!($layer, "prony_tau_3"), "s", (1e-7, 1e6), |s| &mut s.$layer.prony_tau[2], PRONY_TAU),
            real(name!($layer, "prony_g_4"), "1", (0.0, 0.9999), |s| &mut s.$layer.prony_g[3], PRONY_G),
            real(name!($layer, "prony_tau_4"), "s", (1e-7, 1e6), |s| &mut s.$layer.prony_tau[3], PRONY_TAU),
            real(name!($layer, "prony_g_5"), "1", (0.0, 0.9999), |s| &mut s.$layer.prony_g[4], PRONY_G),
            real(name!($layer, "prony_tau_5"), "s", (1e-7, 1e6), |s| &mut s.$layer.prony_tau[4], PRONY_TAU),
            real(name!($layer, "maxwell_g_1"), "Pa", (0.0, 1e11), |s| &mut s.$layer.maxwell_g[0], MAXWELL_G),
            real(name!($layer, "maxwell_beta_1"), "1/s", (1e-6, 1e7), |s| &mut s.$layer.maxwell_beta[0], MAXWELL_BETA),
            real(name!($layer, "maxwell_g_2"), "Pa", (0.0, 1e11), |s| &mut s.$layer.maxwell_g[1], MAXWELL_G),
            real(name!($layer, "maxwell_beta_2"), "1/s", (1e-6, 1e7), |s| &mut s.$layer.maxwell_beta[1], MAXWELL_BETA),
            real(name!($layer, "maxwell_g_3"), "Pa", (0.0, 1e11), |s| &mut s.$layer.maxwell_g[2], MAXWELL_G),
            real(name!($layer, "maxwell_beta_3"), "1/s", (1e-6, 1e7), |s| &mut s.$layer.maxwell_beta[2], MAXWELL_BETA),
            real(name!($layer, "maxwell_g_4"), "Pa", (0.0, 1e11), |s| &mut s.$layer.maxwell_g[3], MAXWELL_G),
            real(name!($layer, "maxwell_beta_4"), "1/s", (1e-6, 1e7), |s| &mut s.$layer.maxwell_beta[3], MAXWELL_BETA),
            real(name!($layer, "maxwell_g_5"), "Pa", (0.0, 1e11), |s| &mut s.$layer.maxwell_g[4], MAXWELL_G),
            real(name!($layer, "maxwell_beta_5"), "1/s", (1e-6, 1e7), |s| &mut s.$layer.maxwell_beta[4], MAXWELL_BETA),
            real(
                name!($layer, "slider_stiffness"),
                "Pa",
                (0.0, 1e11),
                |s| &mut s.$layer.slider_stiffness,
                "shear modulus G of the damping spring; 0 switches the spring-slider off",
            ),
            real(
                name!($layer, "slider_yield_stress"),
                "Pa",
                (0.0, 1e10),
                |s| &mut s.$layer.slider_yield_stress,
                "von Mises stress SIGF at which the slider slips",
            ),
            real(
                name!($layer, "tear_stretch"),
                "1",
                (0.0, 100.0),
                |s| &mut s.$layer.tear_stretch,
                "largest principal stretch at which the material begins to tear, at least 1; 0 switches tearing off",
            ),
            real(
                name!($layer, "tear_width"),
                "1",
                (1e-3, 10.0),
                |s| &mut s.$layer.tear_width,
                "stretch over which the deviatoric stress falls",
            ),
            real(
                name!($layer, "tear_residual"),
                "1",
                (0.0, 1.0),
                |s| &mut s.$layer.tear_residual,
                "part of the deviatoric stress that remains after the tear",
            ),
        ]
    };
}

/// Material of the silicone.
pub(super) const SILICONE: &[Parameter] = material_rows!(silicone);

/// Material of the skin, where it has one of its own.
pub(super) const SKIN: &[Parameter] = material_rows!(skin);

const OGDEN_MU: &str =
    "ogden coefficient, W = sum mu/alpha (l1^alpha + l2^alpha + l3^alpha - 3); 0 switches the term off";
const OGDEN_ALPHA: &str = "ogden exponent; the shear modulus at rest is sum mu alpha / 2";
const PRONY_G: &str = "Prony coefficient, normalised on the instantaneous modulus; 0 switches the term off";
const PRONY_TAU: &str = "relaxation time of the Prony term";
const MAXWELL_G: &str = "shear modulus of an additive Maxwell term; 0 switches the term off";
const MAXWELL_BETA: &str = "decay constant of the Maxwell term, one over its relaxation time";
