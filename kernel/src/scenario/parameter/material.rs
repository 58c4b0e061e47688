//! The rows of a material, written once for every layer.

use super::coefficient::{Name, for_each_place, names, rows};
use super::row::{Kind, Parameter, choice, join, real};
use crate::material::{ElasticLaw, Moduli, N_COEFFICIENT, VolumetricBy, VolumetricLaw};
use crate::number::real::Real;
use crate::scenario::Scenario;

/// The rows of the material of a layer, whose field in a scenario has the name of the group, but for the coefficients of the
/// elastic laws.
macro_rules! material_rows {
    ($layer:ident, before the coefficients) => {
        &[
            real!($layer.density, "kg/m3", (10.0, 2e4), "density"),
            choice!(
                $layer.law: ElasticLaw,
                "isochoric hyperelastic law (mooney_rivlin has 2, 3 or 5 parameters, by coefficients of zero)"
            ),
            choice!($layer.moduli: Moduli, "what the elastic coefficients are: after full relaxation, or before any"),
        ]
    };
    ($layer:ident, after the coefficients) => {
        &[
            choice!(
                $layer.volumetric_law: VolumetricLaw,
                "energy of volume change: K/2 (J-1)^2, or K/4 (J^2 - 1 - 2 ln J), which no compression brings to J = 0"
            ),
            choice!($layer.volumetric_by: VolumetricBy, "which of the next two states the compressibility"),
            real!($layer.bulk_modulus, "Pa", (1e2, 1e12), "bulk modulus"),
            real!($layer.poissons_ratio, "1", (0.0, 0.4999), "Poisson's ratio of the long-term law"),
            real!($layer.prony_g[0] = "1", "1", (0.0, 0.9999), PRONY_G),
            real!($layer.prony_tau[0] = "1", "s", (1e-7, 1e6), PRONY_TAU),
            real!($layer.prony_g[1] = "2", "1", (0.0, 0.9999), PRONY_G),
            real!($layer.prony_tau[1] = "2", "s", (1e-7, 1e6), PRONY_TAU),
            real!($layer.prony_g[2] = "3", "1", (0.0, 0.9999), PRONY_G),
            real!($layer.prony_tau[2] = "3", "s", (1e-7, 1e6), PRONY_TAU),
            real!($layer.prony_g[3] = "4", "1", (0.0, 0.9999), PRONY_G),
            real!($layer.prony_tau[3] = "4", "s", (1e-7, 1e6), PRONY_TAU),
            real!($layer.prony_g[4] = "5", "1", (0.0, 0.9999), PRONY_G),
            real!($layer.prony_tau[4] = "5", "s", (1e-7, 1e6), PRONY_TAU),
            real!($layer.maxwell_g[0] = "1", "Pa", (0.0, 1e11), MAXWELL_G),
            real!($layer.maxwell_beta[0] = "1", "1/s", (1e-6, 1e7), MAXWELL_BETA),
            real!($layer.maxwell_g[1] = "2", "Pa", (0.0, 1e11), MAXWELL_G),
            real!($layer.maxwell_beta[1] = "2", "1/s", (1e-6, 1e7), MAXWELL_BETA),
            real!($layer.maxwell_g[2] = "3", "Pa", (0.0, 1e11), MAXWELL_G),
            real!($layer.maxwell_beta[2] = "3", "1/s", (1e-6, 1e7), MAXWELL_BETA),
            real!($layer.maxwell_g[3] = "4", "Pa", (0.0, 1e11), MAXWELL_G),
            real!($layer.maxwell_beta[3] = "4", "1/s", (1e-6, 1e7), MAXWELL_BETA),
            real!($layer.maxwell_g[4] = "5", "Pa", (0.0, 1e11), MAXWELL_G),
            real!($layer.maxwell_beta[4] = "5", "1/s", (1e-6, 1e7), MAXWELL_BETA),
            real!(
                $layer.slider_stiffness,
                "Pa",
                (0.0, 1e11),
                "shear modulus G of the damping spring; 0 switches the spring-slider off"
            ),
            real!($layer.slider_yield_stress, "Pa", (0.0, 1e10), "von Mises stress SIGF at which the slider slips"),
            real!(
                $layer.tear_stretch,
                "1",
                (0.0, 100.0),
                "largest principal stretch at which the material begins to tear, at least 1; 0 switches tearing off"
            ),
            real!($layer.tear_width, "1", (1e-3, 10.0), "stretch over which the deviatoric stress falls"),
            real!($layer.tear_residual, "1", (0.0, 1.0), "part of the deviatoric stress that remains after the tear"),
        ]
    };
}

/// The rows of a layer: those of [`material_rows`], and between them those of the laws' coefficients.
macro_rules! layer_rows {
    ($layer:ident) => {{
    const BEFORE: &[Parameter] = material_rows!($layer, before the coefficients);
    const AFTER: &[Parameter] = material_rows!($layer, after the coefficients);
        const COEFFICIENTS: [Parameter; N_COEFFICIENT] = {
            fn read<const PLACE: usize>(scenario: &Scenario) -> Real {
                scenario.$layer.coefficients.at(PLACE)
            }
            fn write<const PLACE: usize>(scenario: &mut Scenario, value: Real) {
                scenario.$layer.coefficients.set_at(PLACE, value);
            }
            static NAMES: [Name; N_COEFFICIENT] = names(concat!(stringify!($layer), "."));
            rows(&NAMES, &for_each_place!(read), &for_each_place!(write))
        };
        &join::<{ BEFORE.len() + COEFFICIENTS.len() + AFTER.len() }, 3>([BEFORE, &COEFFICIENTS, AFTER])
    }};
}

/// Material of the silicone.
pub(super) const SILICONE: &[Parameter] = layer_rows!(silicone);

/// Material of the skin, where it has one of its own.
pub(super) const SKIN: &[Parameter] = layer_rows!(skin);

const PRONY_G: &str = "Prony coefficient, normalised on the instantaneous modulus; 0 switches the term off";
const PRONY_TAU: &str = "relaxation time of the Prony term";
const MAXWELL_G: &str = "shear modulus of an additive Maxwell term; 0 switches the term off";
const MAXWELL_BETA: &str = "decay constant of the Maxwell term, one over its relaxation time";
