//! A uniaxial test of a material by itself: a ramp of nominal strain at a constant rate, then a hold.
//!
//! The specimen is incompressible and free at its sides, so the loaded and the free directions stay principal and the difference
//! of their Kirchhoff stresses says all: nominal stress = (tau_loaded - tau_free) / l. Each law of the kernel gives its part of
//! the difference: the elastic law as it is; a Prony term the response of a Maxwell element to that; a Maxwell term the same of
//! 2 G (e_loaded - e_free) with logarithmic strains; the slider what its spring carries, up to the limit, because the load only
//! grows. Softening acts after the first load and not in it. A tear takes its part of the whole.

use softanvil_identify::law::Mode;
use softanvil_identify::law::stress::{kirchhoff, stretches};
use softanvil_identify::relaxation::history::History;
use softanvil_kernel::material::{Elastic, Material, Tear};
use softanvil_kernel::number::vector::Scalar;

/// The course of a test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Course {
    /// Stretch at the end of the ramp, below 1 in compression.
    pub stretch: f64,
    /// Duration of the ramp, s; none of one so slow that all viscous stress has relaxed.
    pub ramp: Option<f64>,
    /// Time for which the strain is then held, s.
    pub hold: f64,
}

/// Nominal stress of `material` at the end of `course`, Pa, positive in tension.
pub fn nominal_stress(material: &Material, course: &Course) -> f64 {
    let end = course.stretch;
    let elastic = Elastic::new(material);
    let at = |part: f64| 1.0 + part * (end - 1.0);
    let equilibrium = |part: f64| elastic_difference(&elastic, at(part));
    let strain = |part: f64| strain_difference(at(part));
    let viscous = course.ramp.map_or(0.0, |ramp| {
        let time = ramp + course.hold;
        // Of a term that is driven by `drive` over the parts of the ramp.
        let term = |drive: &dyn Fn(f64) -> f64, tau: f64| History::ramp(0.0, ramp, drive).response(&[time], tau)[0];
        let quasi_linear = material.prony_g.iter().zip(material.prony_tau).filter(|(g, _)| **g > 0.0);
        let additive = material.maxwell_g.iter().zip(material.maxwell_beta).filter(|(g, _)| **g > 0.0);
        quasi_linear.map(|(g, tau)| g / material.prony_g_inf() * term(&equilibrium, tau)).sum::<f64>()
            + additive.map(|(g, beta)| 2.0 * g * term(&strain, 1.0 / beta)).sum::<f64>()
    });
    let difference = equilibrium(1.0) + viscous + slider_difference(material, strain(1.0));
    left_by_tear(material, end) * difference / end
}

/// Difference of the Kirchhoff stresses of the law at the stretch `l`, Pa.
fn elastic_difference(elastic: &Elastic, l: f64) -> f64 {
    let [loaded, free, _] = kirchhoff(elastic, stretches(Mode::Uniaxial, l));
    loaded - free
}

/// Difference of the logarithmic strains at the stretch `l`.
fn strain_difference(l: f64) -> f64 {
    1.5 * l.ln()
}

/// What the spring with the slider carries, whose von Mises stress in this test is the difference itself.
fn slider_difference(material: &Material, strain: f64) -> f64 {
    let spring = 2.0 * material.slider_stiffness * strain;
    spring.clamp(-material.slider_yield_stress, material.slider_yield_stress)
}

/// Part of the stress that a tear leaves.
fn left_by_tear(material: &Material, l: f64) -> f64 {
    let tear = Tear::new(material);
    let largest = l.max(l.powf(-0.5));
    if tear.active() { tear.factor(Scalar, largest) } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use softanvil_kernel::material::{MooneyRivlin, NeoHookean};
    use softanvil_kernel::preset::elastic_silicone;
    use softanvil_specimen::{Compression, compress};

    fn pressed(stretch: f64, ramp: Option<f64>, hold: f64) -> Course {
        Course { stretch, ramp, hold }
    }

    #[test]
    fn a_neo_hookean_cylinder_has_the_stress_of_the_textbook() {
        let material = elastic_silicone().with(NeoHookean { c10: 1e5 });
        // Nominal stress 2 C10 (l - l^-2).
        for (l, expected) in [(0.5, -7e5), (2.0, 3.5e5)] {
            assert!((nominal_stress(&material, &pressed(l, None, 0.0)) - expected).abs() < 1e-3);
        }
    }

    /// Terms that have relaxed leave the long-term law, terms that had no time the instantaneous one.
    #[test]
    fn the_limits_of_fast_and_slow() {
        let mut material = elastic_silicone();
        (material.prony_g[0], material.prony_tau[0]) = (0.75, 0.1);
        let long = nominal_stress(&material, &pressed(0.8, None, 0.0));
        for (ramp, hold, factor) in [(1e-6, 0.0, 4.0), (1e-6, 100.0, 1.0), (1e4, 0.0, 1.0)] {
            let stress = nominal_stress(&material, &pressed(0.8, Some(ramp), hold));
            assert!((stress / (factor * long) - 1.0).abs() < 1e-4, "{ramp} {hold}: {stress}");
        }
        let mut additive = elastic_silicone();
        (additive.maxwell_g[0], additive.maxwell_beta[0]) = (1e6, 10.0);
        let more = nominal_stress(&additive, &pressed(0.8, Some(1e-6), 0.0)) - long;
        // 2 G times the difference of the strains, over the stretch.
        assert!((more / (2e6 * 1.5 * 0.8f64.ln() / 0.8) - 1.0).abs() < 1e-4, "{more}");
    }

    /// The kernel itself, by virtual tests of a cylinder with all of these laws at once. What is left between the two is
    /// inertia, compressibility, and the smooth start of the cylinder's plate.
    #[test]
    fn a_cylinder_of_the_kernel_says_the_same() {
        let mut material = elastic_silicone().with(MooneyRivlin { c10: 3e4, c20: 1.5e4, ..MooneyRivlin::ZERO });
        (material.prony_g[0], material.prony_tau[0]) = (0.5, 0.3);
        (material.maxwell_g[0], material.maxwell_beta[0]) = (1e5, 5.0);
        (material.slider_stiffness, material.slider_yield_stress) = (2e5, 1e4);
        (material.poissons_ratio, material.bulk_modulus) = (0.499, 1e8);
        for (rate, strain, hold) in [(0.67, 0.1, 0.0), (0.67, 0.5, 0.0), (6.7, 0.5, 0.2), (0.067, 0.3, 0.0)] {
            let test = Compression { strain, hold, ..Compression::study(rate) };
            let curve = compress(&material, &test).unwrap();
            // The plate of the virtual test stops smoothly: without a hold the curve counts as long as its rate is constant.
            let read = match hold {
                0.0 => curve.iter().find(|point| point.strain > 0.85 * strain),
                _ => curve.last(),
            };
            let (kernel, strain) = read.map(|point| (point.stress, point.strain)).unwrap();
            let stress = -nominal_stress(&material, &pressed(1.0 - strain, Some(strain / rate), hold));
            assert!((stress / kernel - 1.0).abs() < 0.01, "{rate} {strain} {hold}: {stress} Pa, kernel {kernel} Pa");
        }
    }

    #[test]
    fn what_is_torn_bears_less() {
        let mut material = elastic_silicone();
        let whole = nominal_stress(&material, &pressed(2.0, None, 0.0));
        (material.tear_stretch, material.tear_width, material.tear_residual) = (1.2, 0.1, 0.25);
        assert!((nominal_stress(&material, &pressed(2.0, None, 0.0)) - 0.25 * whole).abs() < 1e-9);
        // Compressed to a quarter it is as long across.
        let pressed = pressed(0.25, None, 0.0);
        assert!(
            (nominal_stress(&material, &pressed) - 0.25 * nominal_stress(&elastic_silicone(), &pressed)).abs() < 1e-3
        );
    }
}
