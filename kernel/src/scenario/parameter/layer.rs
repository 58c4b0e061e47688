//! The rows of a layer, written once for every layer.

use super::row::{Access, Row, choice, real};
use crate::material::{ElasticLaw, Moduli, VolumetricBy, VolumetricLaw};
use crate::scenario::Layer;

/// Most rows of cells that a layer may ask for.
const MAX_ROWS: u32 = 10_000;

/// The parameters of a layer, in the order in which users meet them.
pub(super) static LAYER: &[Row<Layer>] = &[
    real!(0, of layer thickness, "m", (0.0, 0.5), "thickness at rest, at least 0.01 mm"),
    Row {
        id: 1,
        name: "rows",
        access: Access::Count {
            min: 0,
            max: MAX_ROWS,
            read: |layer| layer.rows,
            write: |layer, rows| layer.rows = rows,
        },
        description: "rows of cells through the thickness; 0 takes as many as come nearest to mesh.element_size",
    },
    real!(2, of layer material.density, "kg/m3", (10.0, 2e4), "density"),
    choice!(
        3, of layer material.law: ElasticLaw,
        "isochoric hyperelastic law (mooney_rivlin has 2, 3 or 5 parameters, by coefficients of zero)"
    ),
    choice!(4, of layer material.moduli: Moduli, "what the elastic coefficients are: after full relaxation, or before any"),
    real!(5, of layer material.c10, "Pa", (-1e9, 1e9), "coefficient of (I1 - 3) in all laws but ogden"),
    real!(6, of layer material.c01, "Pa", (-1e9, 1e9), "mooney_rivlin coefficient of (I2 - 3)"),
    real!(7, of layer material.c11, "Pa", (-1e9, 1e9), "mooney_rivlin coefficient of (I1 - 3)(I2 - 3)"),
    real!(8, of layer material.c20, "Pa", (-1e9, 1e9), "mooney_rivlin and yeoh coefficient of (I1 - 3)^2"),
    real!(9, of layer material.c02, "Pa", (-1e9, 1e9), "mooney_rivlin coefficient of (I2 - 3)^2"),
    real!(10, of layer material.c30, "Pa", (-1e9, 1e9), "yeoh coefficient of (I1 - 3)^3"),
    real!(11, of layer material.ogden_mu[0] = "1", "Pa", (-1e9, 1e9), OGDEN_MU),
    real!(12, of layer material.ogden_alpha[0] = "1", "1", (-30.0, 30.0), OGDEN_ALPHA),
    real!(13, of layer material.ogden_mu[1] = "2", "Pa", (-1e9, 1e9), OGDEN_MU),
    real!(14, of layer material.ogden_alpha[1] = "2", "1", (-30.0, 30.0), OGDEN_ALPHA),
    real!(15, of layer material.ogden_mu[2] = "3", "Pa", (-1e9, 1e9), OGDEN_MU),
    real!(16, of layer material.ogden_alpha[2] = "3", "1", (-30.0, 30.0), OGDEN_ALPHA),
    choice!(
        17, of layer material.volumetric_law: VolumetricLaw,
        "energy of volume change: K/2 (J-1)^2, or K/4 (J^2 - 1 - 2 ln J), which no compression brings to J = 0"
    ),
    choice!(18, of layer material.volumetric_by: VolumetricBy, "which of the next two states the compressibility"),
    real!(19, of layer material.bulk_modulus, "Pa", (1e2, 1e12), "bulk modulus"),
    real!(20, of layer material.poissons_ratio, "1", (0.0, 0.4999), "Poisson's ratio of the long-term law"),
    real!(21, of layer material.prony_g[0] = "1", "1", (0.0, 0.9999), PRONY_G),
    real!(22, of layer material.prony_tau[0] = "1", "s", (1e-7, 1e6), PRONY_TAU),
    real!(23, of layer material.prony_g[1] = "2", "1", (0.0, 0.9999), PRONY_G),
    real!(24, of layer material.prony_tau[1] = "2", "s", (1e-7, 1e6), PRONY_TAU),
    real!(25, of layer material.prony_g[2] = "3", "1", (0.0, 0.9999), PRONY_G),
    real!(26, of layer material.prony_tau[2] = "3", "s", (1e-7, 1e6), PRONY_TAU),
    real!(27, of layer material.prony_g[3] = "4", "1", (0.0, 0.9999), PRONY_G),
    real!(28, of layer material.prony_tau[3] = "4", "s", (1e-7, 1e6), PRONY_TAU),
    real!(29, of layer material.prony_g[4] = "5", "1", (0.0, 0.9999), PRONY_G),
    real!(30, of layer material.prony_tau[4] = "5", "s", (1e-7, 1e6), PRONY_TAU),
    real!(31, of layer material.maxwell_g[0] = "1", "Pa", (0.0, 1e11), MAXWELL_G),
    real!(32, of layer material.maxwell_beta[0] = "1", "1/s", (1e-6, 1e7), MAXWELL_BETA),
    real!(33, of layer material.maxwell_g[1] = "2", "Pa", (0.0, 1e11), MAXWELL_G),
    real!(34, of layer material.maxwell_beta[1] = "2", "1/s", (1e-6, 1e7), MAXWELL_BETA),
    real!(35, of layer material.maxwell_g[2] = "3", "Pa", (0.0, 1e11), MAXWELL_G),
    real!(36, of layer material.maxwell_beta[2] = "3", "1/s", (1e-6, 1e7), MAXWELL_BETA),
    real!(37, of layer material.maxwell_g[3] = "4", "Pa", (0.0, 1e11), MAXWELL_G),
    real!(38, of layer material.maxwell_beta[3] = "4", "1/s", (1e-6, 1e7), MAXWELL_BETA),
    real!(39, of layer material.maxwell_g[4] = "5", "Pa", (0.0, 1e11), MAXWELL_G),
    real!(40, of layer material.maxwell_beta[4] = "5", "1/s", (1e-6, 1e7), MAXWELL_BETA),
    real!(
        41, of layer material.slider_stiffness,
        "Pa",
        (0.0, 1e11),
        "shear modulus G of the damping spring; 0 switches the spring-slider off"
    ),
    real!(42, of layer material.slider_yield_stress, "Pa", (0.0, 1e10), "von Mises stress SIGF at which the slider slips"),
    real!(
        43, of layer material.tear_stretch,
        "1",
        (0.0, 100.0),
        "largest principal stretch at which the material begins to tear, at least 1; 0 switches tearing off"
    ),
    real!(44, of layer material.tear_width, "1", (1e-3, 10.0), "stretch over which the deviatoric stress falls"),
    real!(45, of layer material.tear_residual, "1", (0.0, 1.0), "part of the deviatoric stress that remains after the tear"),
];

const OGDEN_MU: &str =
    "ogden coefficient, W = sum mu/alpha (l1^alpha + l2^alpha + l3^alpha - 3); 0 switches the term off";
const OGDEN_ALPHA: &str = "ogden exponent; the shear modulus at rest is sum mu alpha / 2";
const PRONY_G: &str = "Prony coefficient, normalised on the instantaneous modulus; 0 switches the term off";
const PRONY_TAU: &str = "relaxation time of the Prony term";
const MAXWELL_G: &str = "shear modulus of an additive Maxwell term; 0 switches the term off";
const MAXWELL_BETA: &str = "decay constant of the Maxwell term, one over its relaxation time";

/// Ids of rows that are no more, which no other row gets.
pub(super) const RETIRED: &[u32] = &[];
