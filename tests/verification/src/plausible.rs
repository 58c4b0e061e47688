//! Drops that a laboratory may well ask for, at random: every law, stiffness, thickness, energy and section, and what came
//! of each with the step that the kernel chose for it.

use softanvil_kernel::material::{Hyperfoam, Material, VolumetricBy, VolumetricLaw};
use softanvil_kernel::scenario::{Body, FaceShape, Formulation, Interface, Layer, LayerInterface, Shape, Symmetry};
use softanvil_kernel::state::state_digest;
use softanvil_kernel::step::critical_time_step;
use softanvil_kernel::{SAMPLING_INTERVAL, Scenario, Simulation, StepInput, preset};

use crate::bearing::{Sides, pressed_energy};
use crate::deformation::Samples;
use crate::penetration::deepest;
use crate::scenes::{elastic, random_law};

/// What came of a drop.
#[derive(Clone, Copy, Debug)]
pub struct Outcome {
    /// Steps in a sampling interval over the fewest whose step stays below every limit that the drop has met.
    pub steps_over_hindsight: f64,
    /// Largest size of the energy's residual over the energy of the drop.
    pub residual: f64,
    /// The deepest that a node has been inside another layer, over the element size, which segments are about as long as.
    pub penetration: f64,
    /// What the momentum of the mass has changed by beside impulse and gravity, over that at the start; 0 with rails, which take
    /// momentum that no output tells.
    pub momentum: f64,
    /// Digest of the whole state at the end.
    pub digest: u64,
}

/// The random numbers of a drop (the finaliser of SplitMix64), so that one can be made without those before it.
pub fn samples_of(seed: u64, index: u64) -> Samples {
    let mut word = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15).wrapping_add(index);
    word = (word ^ (word >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    word = (word ^ (word >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    Samples::new(1 + (word ^ (word >> 31)) % 2_147_483_646)
}

/// A plausible drop: c10 from 20 kPa to 1 MPa, or another law as stiff; Poisson's ratio from 0.45 to 0.495; a layer of 6 to
/// 30 mm; 2.5 to 14.7 J; half with a Prony term, a Maxwell term or a spring-slider; cylinder or dome; core bonded or
/// frictional. A foam has an energy that it bears.
pub fn scenario(samples: &mut Samples) -> Scenario {
    let mut scenario = preset::study();
    let mut unit = || 0.5 * (1.0 + samples.number());
    let c10 = logarithmic(unit(), 20e3, 1e6);
    let (damping, numbers) = (unit(), [unit(), unit()]);
    scenario.layers[0].thickness = 6e-3 + 24e-3 * unit();
    scenario.impactor.drop_energy = 2.5 + 12.2 * unit();
    if unit() < 0.5 {
        scenario.geometry.formulation = Formulation::Axisymmetric;
    }
    scenario.core.interface = if unit() < 0.5 { Interface::Bonded } else { Interface::Frictional };
    // A thick layer reaches past the study's face.
    let radius = scenario.geometry.core_radius + scenario.thickness();
    scenario.impactor.face_diameter = scenario.impactor.face_diameter.max(2.1 * radius);
    let volumetric_law = if unit() < 0.7 { VolumetricLaw::Quadratic } else { VolumetricLaw::Simo };
    let poissons_ratio = 0.45 + 0.045 * unit();
    let law = random_law(samples, c10);
    scenario.layers[0].material =
        Material { volumetric_by: VolumetricBy::PoissonsRatio, poissons_ratio, volumetric_law, ..law };
    damp(&mut scenario.layers[0].material, damping, numbers);
    if scenario.layers[0].material.law.description().compressible {
        make_foam(&mut scenario, samples);
    }
    scenario
}

/// A foam is light, bears a drop by its stiffness and thickness, and half of them soften.
fn make_foam(scenario: &mut Scenario, samples: &mut Samples) {
    let mut unit = || 0.5 * (1.0 + samples.number());
    let layer = &mut scenario.layers[0];
    let modulus = layer.material.shear_modulus_inf();
    layer.material.density = logarithmic(unit(), 40.0, 300.0);
    let energy = modulus * layer.thickness * (0.05 + 0.15 * unit());
    if unit() < 0.5 {
        layer.material.softening_r = 1.2 + unit();
        layer.material.softening_m = modulus * logarithmic(unit(), 0.003, 0.03);
        layer.material.softening_beta = 0.3 * unit();
    }
    let area = pressed_area(scenario);
    drop_on_foam(scenario, energy * area);
}

/// A drop of so much energy, J, with a mass that the foam bears at rest.
fn drop_on_foam(scenario: &mut Scenario, energy: f64) {
    let bearable = WORK_OF_WEIGHT * energy / (scenario.impactor.gravity * scenario.thickness());
    scenario.impactor.mass = scenario.impactor.mass.min(bearable);
    scenario.impactor.drop_energy = energy;
}

/// A drop on a pad of foam alone: one to three terms of 20 kPa to 2 MPa with exponents of -5 to 25 and Poisson's ratios of 0 to 0.45, less
/// with large exponents; 6 to 60 mm thick, half of them damped; a block with free sides under a face that covers it, or the study's cylinder or a
/// dome. The energy is up to what presses it with free sides to 30 % of its height where it is pressed most, and at most
/// 50 J.
pub fn foam(samples: &mut Samples) -> Scenario {
    let mut scenario = preset::study();
    let mut unit = || 0.5 * (1.0 + samples.number());
    let terms = 1 + (3.0 * unit()) as usize % 3;
    let (mut mu, mut alpha, mut nu) = ([0.0; 3], [4.0; 3], [0.0; 3]);
    let modulus = logarithmic(unit(), 20e3, 2e6);
    for k in 0..terms {
        (mu[k], alpha[k], nu[k]) =
            (modulus * if k == 0 { 1.0 } else { 0.3 * unit() }, -5.0 + 30.0 * unit(), 0.45 * unit());
        // An exponent next to zero switches the term off.
        alpha[k] = if alpha[k].abs() < 0.2 { 0.2 } else { alpha[k] };
        nu[k] = nu[k].min(poissons_ratio_of_foam(alpha[k]));
    }
    let layer = &mut scenario.layers[0];
    layer.material = elastic(0.0, 0.0, 1e6).with(Hyperfoam::new(mu, alpha, nu));
    (layer.thickness, layer.material.density) = (logarithmic(unit(), 6e-3, 60e-3), logarithmic(unit(), 25.0, 300.0));
    let (damping, numbers) = (unit(), [unit(), unit()]);
    let height = layer.thickness;
    damp(&mut layer.material, damping, numbers);
    match (3.0 * unit()) as usize % 3 {
        0 => {
            scenario.geometry.shape = Shape::Block;
            (scenario.geometry.block_width, scenario.geometry.length) = (0.1, 0.1);
            scenario.impactor.shape = FaceShape::Rectangular;
            (scenario.impactor.face_width, scenario.impactor.face_length) = (0.11, 0.1);
        }
        1 => scenario.geometry.formulation = Formulation::Axisymmetric,
        _ => {}
    }
    scenario.core.interface = if unit() < 0.5 { Interface::Bonded } else { Interface::Frictional };
    let radius = scenario.geometry.core_radius + height;
    scenario.impactor.face_diameter = scenario.impactor.face_diameter.max(2.1 * radius);
    let borne = pressed_energy(&scenario, 0.3, Sides::Free);
    drop_on_foam(&mut scenario, (borne * (0.1 + 0.9 * unit())).clamp(0.1, 50.0));
    scenario.time.duration = 40e-3;
    scenario
}

/// The largest Poisson's ratio of a term with this exponent: its pressure grows as J^(-alpha beta), beta = nu / (1 - 2 nu), which with
/// alpha beta = 15 is 75-fold by a quarter of the volume. Foams with large exponents have small ratios: two of car seats have exponents of 22
/// and 27 with ratios below 0.003 (Silber and Then, Preventive Biomechanics, 2013, table 4.3).
fn poissons_ratio_of_foam(alpha: f64) -> f64 {
    let beta = 15.0 / alpha.abs();
    beta / (1.0 + 2.0 * beta)
}

/// Largest part of a drop's energy that the weight may add on its way through the foam.
const WORK_OF_WEIGHT: f64 = 0.2;

/// About the area, m2, that is pressed: of a block all, of the study's anvil some 5e-3, of a dome that of the plane which cuts
/// off half the thickness.
fn pressed_area(scenario: &Scenario) -> f64 {
    let height = scenario.thickness();
    match (scenario.geometry.shape, scenario.geometry.formulation) {
        (Shape::Block, _) => 0.01,
        (_, Formulation::Axisymmetric) => std::f64::consts::PI * (scenario.geometry.core_radius + height) * height,
        _ => 5e-3,
    }
}

/// A plausible drop on a stack: one or two layers more, from 1 to 15 mm thick, of other laws and stiffnesses; bonded, frictional or
/// separating, some with a gap, some narrower; faces of every kind that the formulation has, many of them narrower than the anvil.
pub fn stack(samples: &mut Samples) -> Scenario {
    let mut scenario = scenario(samples);
    let more = 1 + usize::from(samples.number() > 0.3);
    let mut part = 1.0;
    for place in 1..=more {
        let mut unit = || 0.5 * (1.0 + samples.number());
        let (thickness, c10) = (logarithmic(unit(), 1e-3, 15e-3), logarithmic(unit(), 20e3, 1e6));
        let interface = [LayerInterface::Bonded, LayerInterface::Frictional, LayerInterface::Separating];
        let interface = interface[(3.0 * unit()) as usize % 3];
        let gap = if unit() < 0.3 && interface != LayerInterface::Bonded { 2e-3 * unit() } else { 0.0 };
        if unit() < 0.5 {
            part *= 0.4 + 0.6 * unit();
        }
        let (friction_coefficient, poissons_ratio) = (0.6 * unit(), 0.3 + 0.19 * unit());
        let material =
            Material { volumetric_by: VolumetricBy::PoissonsRatio, poissons_ratio, ..random_law(samples, c10) };
        let below = scenario.geometry.core_radius + scenario.height() + gap;
        let width = if part < 1.0 { part * std::f64::consts::PI * below } else { 0.0 };
        let layer = Layer { width, interface, friction_coefficient, gap, ..Layer::new("", thickness, material) };
        scenario.add_layer(layer).unwrap_or_else(|error| panic!("layer {place}: {error}"));
    }
    let mut unit = || 0.5 * (1.0 + samples.number());
    let impactor = &mut scenario.impactor;
    let third = match scenario.geometry.formulation {
        Formulation::PlaneStrain | Formulation::Solid => FaceShape::Bar,
        Formulation::Axisymmetric => FaceShape::Sphere,
    };
    impactor.shape = [FaceShape::Round, FaceShape::Rectangular, third][(3.0 * unit()) as usize % 3];
    (impactor.face_width, impactor.face_length) = (20e-3 + 80e-3 * unit(), 30e-3 + 100e-3 * unit());
    impactor.face_diameter = if unit() < 0.3 { 0.25 } else { 30e-3 + 70e-3 * unit() };
    (impactor.rail_friction, impactor.rail_damping) = (20.0 * unit(), 5.0 * unit());
    // The load is that of the face, not of the anvil.
    impactor.drop_energy *= 0.5 * (impactor.face_diameter.min(impactor.face_width) / 0.13).min(1.0);
    scenario
}

/// A plausible drop on a solid, one layer or a stack, prism or body of revolution, of which a quarter, a half or all is there.
pub fn solid(samples: &mut Samples) -> Scenario {
    let mut scenario = if samples.number() < 0.0 { scenario(samples) } else { stack(samples) };
    let mut unit = || 0.5 * (1.0 + samples.number());
    let geometry = &mut scenario.geometry;
    geometry.formulation = Formulation::Solid;
    geometry.body = if unit() < 0.5 { Body::Prism } else { Body::Revolved };
    geometry.symmetry =
        [Symmetry::Quarter, Symmetry::Quarter, Symmetry::Half, Symmetry::Full][(4.0 * unit()) as usize % 4];
    geometry.length = 40e-3 + 60e-3 * unit();
    scenario.mesh.element_size = 6e-3 + 3e-3 * unit();
    // The load is that of the length.
    scenario.impactor.drop_energy *= scenario.geometry.length / 0.13;
    scenario
}

/// Gives a part of the materials one of the kinds of damping.
fn damp(material: &mut Material, which: f64, [first, second]: [f64; 2]) {
    let modulus = material.shear_modulus_inf();
    if which < 0.2 {
        let overstress = logarithmic(first, 0.2, 10.0);
        material.prony_g[0] = overstress / (1.0 + overstress);
        material.prony_tau[0] = logarithmic(second, 1e-4, 0.1);
    } else if which < 0.35 {
        material.maxwell_g[0] = modulus * logarithmic(first, 0.25, 5.0);
        material.maxwell_beta[0] = logarithmic(second, 10.0, 5e3);
    } else if which < 0.5 {
        material.slider_stiffness = modulus * logarithmic(first, 0.5, 15.0);
        material.slider_yield_stress = modulus * logarithmic(second, 0.01, 0.25);
    }
}

/// Between `low` and `high`, evenly on the scale of logarithms.
fn logarithmic(unit: f64, low: f64, high: f64) -> f64 {
    low * (high / low).powf(unit)
}

/// Looks at the limit and the energies, in a drop.
pub const LOOKS: u64 = 1_000;

/// Drops as `scenario` says.
///
/// # Errors
/// Why the drop is refused or fails.
pub fn outcome(scenario: &Scenario) -> Result<Outcome, String> {
    outcome_of(&mut Simulation::new(scenario).map_err(|error| error.to_string())?, LOOKS)
}

/// Drops on, from the start, with so many `looks`.
///
/// # Errors
/// Why the drop fails.
pub fn outcome_of(simulation: &mut Simulation, looks: u64) -> Result<Outcome, String> {
    let constants = simulation.constants();
    let scenario = constants.scenario.clone();
    let (steps, chosen) = (constants.steps_in(scenario.time.duration), constants.steps_per_sample);
    let (mut limit, mut residual, mut depth) = (f64::INFINITY, 0.0_f64, 0.0_f64);
    let stride = steps.div_ceil(looks);
    let mut done = 0;
    while done < steps {
        let count = stride.min(steps - done);
        simulation.step(count, &StepInput::default()).map_err(|error| error.to_string())?;
        done += count;
        let look = simulation.with(|model, state| (critical_time_step(model, state).0, deepest(model, state)));
        let (now, inside) = look.map_err(|error| error.to_string())?;
        (limit, depth) = (limit.min(now), depth.max(inside));
        let unexplained = simulation.scalars().energy.residual().abs() / scenario.impactor.drop_energy;
        // No number is the worst of all, and stays it.
        if unexplained.is_nan() || unexplained > residual {
            residual = unexplained;
        }
    }
    let needed = (SAMPLING_INTERVAL / limit).ceil().max(1.0);
    let digest = simulation.with(|model, state| state_digest(model, state)).map_err(|error| error.to_string())?;
    Ok(Outcome {
        steps_over_hindsight: f64::from(chosen) / needed,
        residual,
        penetration: depth / scenario.mesh.element_size,
        momentum: momentum(simulation),
        digest,
    })
}

/// As [`Outcome::momentum`].
fn momentum(simulation: &Simulation) -> f64 {
    let impactor = &simulation.constants().scenario.impactor;
    if impactor.rail_friction != 0.0 || impactor.rail_damping != 0.0 {
        return 0.0;
    }
    let (start, scalars) = (impactor.mass * impactor.start_speed(), simulation.scalars());
    let expected = scalars.metrics.impulse - start - impactor.mass * impactor.gravity * simulation.time();
    (impactor.mass * scalars.impactor.velocity - expected).abs() / start
}

/// A drop in one line.
pub fn summary(scenario: &Scenario) -> String {
    let (geometry, material) = (&scenario.geometry, &scenario.layers[0].material);
    format!(
        "{:?}, {:?}, {:.1} mm of {:?} with G = {:.0} Pa, nu = {:.3}, {:.1} J, {:?} of {:.0} mm{}",
        geometry.formulation,
        scenario.core.interface,
        1e3 * scenario.thickness(),
        material.law,
        material.shear_modulus_inf(),
        material.poissons_ratio,
        scenario.impactor.drop_energy,
        scenario.impactor.shape,
        2e3 * scenario.face_half_width(),
        scenario.layers.iter().skip(1).map(above).collect::<String>()
    )
}

/// A layer that lies on another one.
fn above(layer: &Layer) -> String {
    let (material, [thickness, gap, width]) = (&layer.material, [layer.thickness, layer.gap, layer.width]);
    let [thickness, gap, width] = [thickness, gap, width].map(|length| 1e3 * length);
    let modulus = material.shear_modulus_inf();
    format!(
        "; {:?} {thickness:.1} mm of {:?}, G = {modulus:.0} Pa, gap {gap:.1}, width {width:.0}",
        layer.interface, material.law
    )
}
