//! The rows of a layer, written once for every layer.

use super::row::{Access, Row, choice, real};
use crate::material::{COEFFICIENTS, Coefficient, ElasticLaw, Moduli, N_COEFFICIENT, VolumetricBy, VolumetricLaw};
use crate::number::real::Real;
use crate::scenario::Layer;
#[cfg(feature = "pads")]
use crate::scenario::LayerInterface;

/// Most rows of cells that a layer may ask for.
const MAX_ROWS: u32 = 10_000;

/// How many parameters a layer has.
pub(super) const COUNT: usize = BEFORE.len() + N_COEFFICIENT + AFTER.len();

/// The parameter of a layer at a place in the order in which users meet them.
pub(super) fn row(place: usize) -> Option<&'static Row<Layer>> {
    let Some(place) = place.checked_sub(BEFORE.len()) else { return BEFORE.get(place) };
    match place.checked_sub(N_COEFFICIENT) {
        None => COEFFICIENT.get(place),
        Some(place) => AFTER.get(place),
    }
}

static BEFORE: &[Row<Layer>] = &[
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
    #[cfg(feature = "pads")]
    real!(
        34, of layer width,
        "m",
        (0.0, 10.0),
        "width along its lower side, full or, of a dome, the diameter; 0 is as wide as what is below it"
    ),
    #[cfg(feature = "pads")]
    choice!(
        35, of layer interface: LayerInterface,
        "how it sits on the layer below: glued, or free to lift and slide, with friction or without"
    ),
    #[cfg(feature = "pads")]
    real!(36, of layer friction_coefficient, "1", (0.0, 10.0), "Coulomb coefficient of a frictional interface below it"),
    #[cfg(feature = "pads")]
    real!(37, of layer gap, "m", (0.0, 0.1), "distance to the layer below at rest, where they are not bonded"),
    real!(2, of layer material.density, "kg/m3", (10.0, 2e4), "density"),
    choice!(
        3, of layer material.law: ElasticLaw,
        "hyperelastic law, isochoric but for hyperfoam (mooney_rivlin has 2, 3 or 5 parameters, by coefficients of zero)"
    ),
    choice!(4, of layer material.moduli: Moduli, "what the elastic coefficients are: after full relaxation, or before any"),
];

/// Number of the first coefficient: those before it are the other rows'.
const FIRST_COEFFICIENT: u32 = 48;

/// The coefficients of the elastic laws, as they describe themselves.
static COEFFICIENT: [Row<Layer>; N_COEFFICIENT] = {
    let mut rows = [const { coefficient(0) }; N_COEFFICIENT];
    let mut place = 1;
    while place < N_COEFFICIENT {
        rows[place] = coefficient(place);
        place += 1;
    }
    rows
};

/// The row of the coefficient at `place`, which is its place for ever: new laws stand behind the others.
const fn coefficient(place: usize) -> Row<Layer> {
    let Coefficient { name, unit, min, max, description, .. } = COEFFICIENTS[place];
    let (id, read, write) = (FIRST_COEFFICIENT + place as u32, read_coefficient, write_coefficient);
    Row { id, name, access: Access::Entry { unit, min, max, place, read, write }, description }
}

fn read_coefficient(layer: &Layer, place: usize) -> Real {
    layer.material.coefficients.at(place)
}

fn write_coefficient(layer: &mut Layer, place: usize, value: Real) {
    layer.material.coefficients.set_at(place, value);
}

static AFTER: &[Row<Layer>] = &[
    choice!(
        5, of layer material.volumetric_law: VolumetricLaw,
        "energy of volume change: K/2 (J-1)^2, or K/4 (J^2 - 1 - 2 ln J), which no compression brings to J = 0"
    ),
    choice!(6, of layer material.volumetric_by: VolumetricBy, "which of the next two states the compressibility"),
    real!(7, of layer material.bulk_modulus, "Pa", (1e2, 1e12), "bulk modulus"),
    real!(8, of layer material.poissons_ratio, "1", (0.0, 0.4999), "Poisson's ratio of the long-term law"),
    real!(9, of layer material.prony_g[0] = "1", "1", (0.0, 0.9999), PRONY_G),
    real!(10, of layer material.prony_tau[0] = "1", "s", (1e-7, 1e6), PRONY_TAU),
    real!(11, of layer material.prony_g[1] = "2", "1", (0.0, 0.9999), PRONY_G),
    real!(12, of layer material.prony_tau[1] = "2", "s", (1e-7, 1e6), PRONY_TAU),
    real!(13, of layer material.prony_g[2] = "3", "1", (0.0, 0.9999), PRONY_G),
    real!(14, of layer material.prony_tau[2] = "3", "s", (1e-7, 1e6), PRONY_TAU),
    real!(15, of layer material.prony_g[3] = "4", "1", (0.0, 0.9999), PRONY_G),
    real!(16, of layer material.prony_tau[3] = "4", "s", (1e-7, 1e6), PRONY_TAU),
    real!(17, of layer material.prony_g[4] = "5", "1", (0.0, 0.9999), PRONY_G),
    real!(18, of layer material.prony_tau[4] = "5", "s", (1e-7, 1e6), PRONY_TAU),
    real!(19, of layer material.maxwell_g[0] = "1", "Pa", (0.0, 1e11), MAXWELL_G),
    real!(20, of layer material.maxwell_beta[0] = "1", "1/s", (1e-6, 1e7), MAXWELL_BETA),
    real!(21, of layer material.maxwell_g[1] = "2", "Pa", (0.0, 1e11), MAXWELL_G),
    real!(22, of layer material.maxwell_beta[1] = "2", "1/s", (1e-6, 1e7), MAXWELL_BETA),
    real!(23, of layer material.maxwell_g[2] = "3", "Pa", (0.0, 1e11), MAXWELL_G),
    real!(24, of layer material.maxwell_beta[2] = "3", "1/s", (1e-6, 1e7), MAXWELL_BETA),
    real!(25, of layer material.maxwell_g[3] = "4", "Pa", (0.0, 1e11), MAXWELL_G),
    real!(26, of layer material.maxwell_beta[3] = "4", "1/s", (1e-6, 1e7), MAXWELL_BETA),
    real!(27, of layer material.maxwell_g[4] = "5", "Pa", (0.0, 1e11), MAXWELL_G),
    real!(28, of layer material.maxwell_beta[4] = "5", "1/s", (1e-6, 1e7), MAXWELL_BETA),
    real!(
        29, of layer material.slider_stiffness,
        "Pa",
        (0.0, 1e11),
        "shear modulus G of the damping spring; 0 switches the spring-slider off"
    ),
    real!(30, of layer material.slider_yield_stress, "Pa", (0.0, 1e10), "von Mises stress SIGF at which the slider slips"),
    real!(
        31, of layer material.tear_stretch,
        "1",
        (0.0, 100.0),
        "largest principal stretch at which the material begins to tear, at least 1; 0 switches tearing off"
    ),
    real!(32, of layer material.tear_width, "1", (1e-3, 10.0), "stretch over which the deviatoric stress falls"),
    real!(33, of layer material.tear_residual, "1", (0.0, 1.0), "part of the deviatoric stress that remains after the tear"),
    #[cfg(feature = "pads")]
    real!(
        40, of layer material.softening_r,
        "1",
        (0.0, 100.0),
        "r of the softening after the first load (Ogden and Roxburgh 1999), at least 1; 0 switches it off"
    ),
    #[cfg(feature = "pads")]
    real!(41, of layer material.softening_m, "Pa", (1.0, 1e9), "m of the softening, the energy that its scale starts from"),
    #[cfg(feature = "pads")]
    real!(
        42, of layer material.softening_beta,
        "1",
        (0.0, 10.0),
        "beta of the softening, the part of the largest energy so far in its scale"
    ),
];

const PRONY_G: &str = "Prony coefficient, normalised on the instantaneous modulus; 0 switches the term off";
const PRONY_TAU: &str = "relaxation time of the Prony term";
const MAXWELL_G: &str = "shear modulus of an additive Maxwell term; 0 switches the term off";
const MAXWELL_BETA: &str = "decay constant of the Maxwell term, one over its relaxation time";

/// Ids of rows that are no more, which no other row gets.
pub(super) const RETIRED: &[u32] = &[];
