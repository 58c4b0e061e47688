//! The energy that layers take up until they are pressed flat somewhere: an estimate from their laws and the shape of the anvil
//! alone, without a mesh.
//!
//! The face presses every fibre of the layers on its own (an elastic foundation: Johnson, Contact Mechanics, 1985, section 4.3). Round
//! about an anvil fibres are pressed less the further they are from the lowest point of the face. Between rigid sides a fibre takes up
//! the most that it can, and with free sides about the least.

use softanvil_kernel::Scenario;
use softanvil_kernel::material::{Elastic, Material, Volumetric};
use softanvil_kernel::scenario::{Formulation, Shape};

/// Points of an integral.
const POINTS: usize = 400;

/// What is beside a fibre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sides {
    /// It keeps its width.
    Rigid,
    /// It bears nothing on them: of a foam alone.
    Free,
}

/// Energy, J, of a drop that presses the layers to the part `least` of their height where they are pressed most.
pub fn pressed_energy(scenario: &Scenario, least: f64, sides: Sides) -> f64 {
    let geometry = &scenario.geometry;
    let (most, work) = (1.0 - least, work_of_compression(scenario, 1.0 - least, sides));
    let at = |compression: f64| work[(compression / most * POINTS as f64) as usize];
    let (half_width, length) = (scenario.face_half_width(), geometry.length);
    if geometry.shape == Shape::Block {
        return at(most) * length * geometry.block_width.min(2.0 * half_width);
    }
    // A fibre beside the lowest point by x is pressed less by x^2 / 2R.
    let (height, radius) = (scenario.thickness(), geometry.core_radius + scenario.thickness());
    let reach = (2.0 * radius * most * height).sqrt().min(half_width).min(radius);
    let step = reach / POINTS as f64;
    let part = |i: usize| {
        let x = (i as f64 + 0.5) * step;
        let across = if geometry.formulation == Formulation::Axisymmetric { std::f64::consts::PI * x } else { length };
        2.0 * across * at(most - x * x / (2.0 * radius * height))
    };
    (0..POINTS).map(|i| part(i) * step).sum()
}

/// Work per area, J/m2, that presses all layers by a part of their thickness, from none to `most` in even steps.
fn work_of_compression(scenario: &Scenario, most: f64, sides: Sides) -> Vec<f64> {
    let step = most / POINTS as f64;
    let stress = |i: usize| {
        let stretch = 1.0 - (i as f64 + 0.5) * step;
        scenario
            .layers
            .iter()
            .map(|layer| -layer.thickness * nominal_stress(&layer.material, stretch, sides))
            .sum::<f64>()
    };
    let mut sum = 0.0;
    let after = (0..POINTS).map(|i| {
        sum += stress(i) * step;
        sum
    });
    std::iter::once(0.0).chain(after).collect()
}

/// Nominal stress, Pa, of a stretch.
fn nominal_stress(material: &Material, stretch: f64, sides: Sides) -> f64 {
    let law = Elastic::new(material);
    if law.is_compressible() {
        let beside = if sides == Sides::Free { free_stretch(&law, stretch) } else { 1.0 };
        return law.principal_stress([stretch, beside, beside])[0] / stretch;
    }
    // Of a law of the shape alone the deviator counts, at the shape's stretches; the volume has a law of its own.
    let side = stretch.powf(-1.0 / 3.0);
    let [along, across, _] = law.principal_stress([stretch * side, side, side]);
    2.0 / 3.0 * (along - across) / stretch + Volumetric::new(material).stress(stretch)
}

/// Stretch of the free sides of a foam that is pressed, by bisection between none and that of a constant volume.
fn free_stretch(law: &Elastic, stretch: f64) -> f64 {
    let (mut low, mut high) = (1.0, stretch.powf(-0.5));
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        if law.principal_stress([stretch, middle, middle])[1] < 0.0 { low = middle } else { high = middle }
    }
    low
}

#[cfg(test)]
mod tests {
    use softanvil_kernel::material::Hyperfoam;
    use softanvil_kernel::preset;

    use super::*;

    /// A layer whose stress is K times its compression: a neo-Hookean one of no shear modulus with the quadratic volumetric law.
    fn fluid(shape: Shape, formulation: Formulation) -> Scenario {
        let mut scenario = preset::study();
        (scenario.geometry.shape, scenario.geometry.formulation) = (shape, formulation);
        scenario.layers[0].thickness = 10e-3;
        scenario.layers[0].material = crate::scenes::neo_hookean(1e-3, 1e6);
        (scenario.geometry.block_width, scenario.impactor.face_diameter) = (0.1, 0.3);
        scenario
    }

    /// Of a block K/2 e^2 a volume; under a flat face on a dome of radius R pi R h e K/3 e^2 h, on a cylinder with sqrt(2 R h e) 8/15
    /// times K e^2 h a length, by integration of K/2 (e - x^2 / 2Rh)^2 h.
    #[test]
    fn the_energy_is_that_of_an_elastic_foundation() {
        let (part, bulk) = (0.6_f64, 1e6);
        let block = fluid(Shape::Block, Formulation::PlaneStrain);
        let length = block.geometry.length;
        let (height, radius) = (10e-3, block.geometry.core_radius + 10e-3);
        let expected = [
            (block, 0.5 * bulk * part * part * height * 0.1 * length),
            (
                fluid(Shape::Round, Formulation::Axisymmetric),
                std::f64::consts::PI * radius * height * height * bulk * part.powi(3) / 3.0,
            ),
            (
                fluid(Shape::Round, Formulation::PlaneStrain),
                8.0 / 15.0 * bulk * part * part * height * length * (2.0 * radius * height * part).sqrt(),
            ),
        ];
        for (scenario, expected) in expected {
            let found = pressed_energy(&scenario, 1.0 - part, Sides::Rigid);
            assert!((found / expected - 1.0).abs() < 0.01, "{found} and {expected}");
        }
    }
    /// Of one term with free sides, whose stretch is l^-nu: P = 2 mu / alpha (l^alpha - J^(-alpha beta)) / l, J = l^(1 - 2 nu).
    #[test]
    fn a_foam_with_free_sides_is_pressed_as_by_its_closed_form() {
        let (mu, alpha, nu) = (1e5, 6.0, 0.25);
        let material = crate::scenes::elastic(0.0, 0.0, 1e6).with(Hyperfoam::new(
            [mu, 0.0, 0.0],
            [alpha, 4.0, 4.0],
            [nu, 0.0, 0.0],
        ));
        for stretch in [0.9_f64, 0.5, 0.3] {
            let beta = nu / (1.0 - 2.0 * nu);
            let jacobian = stretch.powf(1.0 - 2.0 * nu);
            let expected = 2.0 * mu / alpha * (stretch.powf(alpha) - jacobian.powf(-alpha * beta)) / stretch;
            let found = nominal_stress(&material, stretch, Sides::Free);
            assert!((found / expected - 1.0).abs() < 1e-9, "{found} and {expected}");
        }
    }
}
