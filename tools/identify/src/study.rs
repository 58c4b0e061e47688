//! A starting material from the scalars that the study prints.
//!
//! "Finite element model to simulate impact on a soft tissue simulant", Sports Engineering (2023),
//! doi 10.1007/s12283-023-00407-7, gives no coefficients, but a quasi-static modulus, a relaxation and a ramp modulus.
//! They contradict each other, so the material is a start for a calibration and no result.

use softanvil_kernel::material::Material;

use crate::law::Law;

/// Young's modulus in quasi-static compression at 0.67 1/s, Pa.
pub const YOUNGS_MODULUS: f64 = 0.18e6;
/// Shear moduli at 50 % strain before and after relaxation, Pa.
pub const SHEAR_MODULI: (f64, f64) = (0.6e6, 0.33e6);
/// Young's modulus during the fast ramp of the relaxation test, Pa.
pub const RAMP_MODULUS: f64 = 1.1e6;
/// Compression of the relaxation test.
pub const STRAIN: f64 = 0.5;
/// Time after which its stress is steady, s.
pub const STEADY: f64 = 1.0;
/// Shear modulus of the damping spring, Pa.
pub const DAMPING_MODULUS: f64 = 47e6;
/// Limit stresses that the rule of thumb of LS-DYNA's manual gives that spring, Pa.
pub const LIMIT_STRESSES: (f64, f64) = (47e3, 188e3);

/// The starting material: Yeoh with two terms and one Prony term.
///
/// * C10 = E / 6, the quasi-static modulus at small strain.
/// * C20 so that the nominal stress at 50 % compression is 3 G_inf times the strain, the relaxed modulus as a secant.
/// * g = 1 - G_inf / G_0 and tau = a quarter of the time to the steady state, when 98 % has relaxed.
/// * The damping spring with the middle of its limit stresses.
pub fn material() -> Material {
    let stretch = 1.0 - STRAIN;
    let stress = 3.0 * SHEAR_MODULI.1 * STRAIN;
    let c10 = YOUNGS_MODULUS / 6.0;
    // |P| = 2 (l^-2 - l)(C10 + 2 C20 (I1 - 3)).
    let (factor, i1) = (2.0 * (stretch.powi(-2) - stretch), stretch * stretch + 2.0 / stretch - 3.0);
    let c20 = (stress / factor - c10) / (2.0 * i1);
    let mut material = match Law::find("yeoh_2") {
        Some(law) => law.material(&[c10, c20]),
        None => crate::law::blank(),
    };
    material.prony_g[0] = 1.0 - SHEAR_MODULI.1 / SHEAR_MODULI.0;
    material.prony_tau[0] = STEADY / 4.0;
    material.slider_stiffness = DAMPING_MODULUS;
    material.slider_yield_stress = 0.5 * (LIMIT_STRESSES.0 + LIMIT_STRESSES.1);
    material
}

/// Where the study's numbers do not fit together, each with the figures.
pub fn contradictions() -> Vec<String> {
    let mpa = |pascal: f64| pascal / 1e6;
    let shear = YOUNGS_MODULUS / 3.0;
    vec![
        format!(
            "E = {} MPa in slow compression means G = {:.2} MPa, the relaxed shear modulus is {} MPa, {:.1} times that: \
             the start makes one law of both by stiffening with strain",
            mpa(YOUNGS_MODULUS),
            mpa(shear),
            mpa(SHEAR_MODULI.1),
            SHEAR_MODULI.1 / shear
        ),
        format!(
            "E = {} MPa during the ramp means G = {:.2} MPa, but relaxation begins at {} MPa, after some of it is over",
            mpa(RAMP_MODULUS),
            mpa(RAMP_MODULUS / 3.0),
            mpa(SHEAR_MODULI.0)
        ),
        format!(
            "E = {} MPa was measured at 0.67 1/s, where a few percent of strain take less than 0.1 s, and so should be near \
             the unrelaxed {} MPa, not below the relaxed one",
            mpa(YOUNGS_MODULUS),
            mpa(3.0 * SHEAR_MODULI.0)
        ),
        format!(
            "the damping spring of {} MPa is {:.0} times the quasi-static shear modulus and was tuned on the drop of \
             14.7 J; its limit stress is not printed (rule of thumb {} to {} MPa)",
            mpa(DAMPING_MODULUS),
            DAMPING_MODULUS / shear,
            mpa(LIMIT_STRESSES.0),
            mpa(LIMIT_STRESSES.1)
        ),
        "Poisson's ratio is 0.48 in the simulation, while the compression tests were read as incompressible".into(),
        "the fastest test is one of 0.67 1/s, but 1.4 to 2.4 m/s on 15 mm are 90 to 160 1/s: the drops are extrapolated".into(),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::{Mode, stress};
    use softanvil_kernel::material::Elastic;

    /// Source: the study's scalars, which the material must give back where it is said to.
    #[test]
    fn the_start_gives_the_scalars_back() {
        let material = material();
        assert!((3.0 * material.shear_modulus_inf() / 0.18e6 - 1.0).abs() < 1e-12);
        let stress = stress::nominal(&Elastic::new(&material), Mode::Uniaxial, &[0.5])[0];
        assert!((stress / (-3.0 * 0.33e6 * 0.5) - 1.0).abs() < 1e-12, "{stress}");
        assert!((material.prony_g_inf() - 0.55).abs() < 1e-12);
    }
}
