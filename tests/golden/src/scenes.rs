//! The table of scenes. The drops of the study follow the preset; every other scene states its own numbers, so that it
//! changes only with the mathematics.

#[cfg(feature = "pads")]
use softanvil_kernel::material::Hyperfoam;
use softanvil_kernel::material::{
    Coefficients, ElasticLaw, Material, Moduli, MooneyRivlin, NeoHookean, Ogden, VolumetricBy, VolumetricLaw, Yeoh,
};
use softanvil_kernel::number::digest::Digest;
use softanvil_kernel::number::real::Real;
#[cfg(all(feature = "pads", feature = "solid"))]
use softanvil_kernel::scenario::Body;
#[cfg(feature = "pads")]
use softanvil_kernel::scenario::LayerInterface;
#[cfg(feature = "solid")]
use softanvil_kernel::scenario::Symmetry;
use softanvil_kernel::scenario::{DropBy, Formulation, Interface, Layer, Motion, Section, StepBy};
use softanvil_kernel::{Constants, Scenario, StepInput, preset};

/// Force samples from one record to the next: 0.25 ms.
pub const SAMPLES_PER_RECORD: u64 = 5;

/// Record up to which a slow target runs: 2.5 ms, of which the face has touched the layer for more than half.
pub const SHORT: u64 = 10;

/// Something to simulate, and what comes out of it.
#[derive(Debug)]
pub struct Scene {
    /// Name of the scene and of its file in `traces`.
    pub name: &'static str,
    /// What it shows, one line.
    pub description: &'static str,
    /// Makes the scenario.
    pub scenario: fn() -> Scenario,
    /// What acts on the impactor in the step after so many steps.
    pub input: fn(&Constants, u64) -> StepInput,
    /// The trace as it stands in the repository.
    pub trace: &'static str,
}

/// The trace of a scene: single precision has its own.
#[cfg(not(feature = "single"))]
macro_rules! trace_file {
    ($name:literal) => {
        concat!("../traces/", $name, ".txt")
    };
}
#[cfg(feature = "single")]
macro_rules! trace_file {
    ($name:literal) => {
        concat!("../traces/single/", $name, ".txt")
    };
}

macro_rules! scene {
    ($name:literal, $scenario:expr, $input:expr, $description:literal) => {
        Scene {
            name: $name,
            description: $description,
            scenario: $scenario,
            input: $input,
            trace: include_str!(trace_file!($name)),
        }
    };
}

/// Every scene.
pub static SCENES: &[Scene] = &[
    scene!("drop-14.7-J", || study(14.7), nothing, "the study's drop with 14.7 J"),
    scene!("drop-9.8-J", || study(9.8), nothing, "the study's drop with 9.8 J"),
    scene!("drop-4.9-J", || study(4.9), nothing, "the study's drop with 4.9 J"),
    scene!("ogden", ogden, nothing, "three Ogden terms, logarithmic volumetric law, two Prony terms"),
    scene!("yeoh", yeoh, nothing, "three Yeoh terms as instantaneous moduli, one Prony term, slider"),
    scene!(
        "two-layers",
        two_layers,
        nothing,
        "Mooney-Rivlin under a neo-Hookean skin that tears, additive Maxwell terms"
    ),
    scene!("axisymmetric", axisymmetric, nothing, "a hemisphere, Mooney-Rivlin with slider"),
    scene!("driven", driven, press, "a face that presses and withdraws as prescribed"),
    scene!(
        "frictional-core",
        frictional_core,
        pull,
        "full section, face off centre, core with friction, external force"
    ),
    #[cfg(feature = "pads")]
    scene!("pad", pad, nothing, "a foam that softens, with two terms and one Prony term, slides on Mooney-Rivlin"),
    #[cfg(feature = "solid")]
    scene!(
        "solid",
        solid,
        nothing,
        "half of a short cylinder in three dimensions, narrow face off centre, core with friction, two Prony terms, slider"
    ),
    #[cfg(all(feature = "pads", feature = "solid"))]
    scene!(
        "solid-pad",
        solid_pad,
        nothing,
        "half of a dome in three dimensions under a round pad that covers a part, lies loose with a gap and slides"
    ),
];

impl Scene {
    /// The state at the end of the trace; none if the trace has none.
    pub fn last_state(&self) -> Option<u64> {
        u64::from_str_radix(self.trace.split_whitespace().last()?, 16).ok()
    }

    /// The scene called `name`.
    pub fn find(name: &str) -> Option<&'static Self> {
        SCENES.iter().find(|scene| scene.name == name)
    }
}

/// The kernel digest ([`softanvil_kernel::KERNEL_DIGEST`]) of scenes that end in these states, in the order of [`SCENES`].
pub fn digest(states: impl Iterator<Item = u64>) -> u64 {
    let mut digest = Digest::new();
    states.for_each(|state| digest.word(state));
    digest.value()
}

fn study(energy: Real) -> Scenario {
    let scenario = preset::study();
    Scenario { impactor: scenario.impactor.with_energy(energy), ..scenario }
}

/// 5 J on a round anvil; the numbers that calibration and tuning may move in the preset are stated.
fn base(silicone: Material) -> Scenario {
    let mut scenario = preset::study();
    scenario.geometry.length = 0.12;
    scenario.impactor.drop_by = DropBy::Energy;
    scenario.impactor.drop_energy = 5.0;
    scenario.layers[0].material = silicone;
    scenario.core.interface = Interface::Bonded;
    scenario.face.friction_coefficient = 0.3;
    scenario.mesh.element_size = 3e-3;
    scenario.time.step_by = StepBy::Given;
    scenario.time.step = 2.5e-6;
    scenario.time.duration = 6e-3;
    scenario.measurement.force_threshold = 20.0;
    scenario
}

/// Mooney-Rivlin with five coefficients and nothing else.
fn rubber() -> Material {
    Material {
        density: 1070.0,
        law: ElasticLaw::MooneyRivlin,
        moduli: Moduli::LongTerm,
        coefficients: Coefficients::of(&MooneyRivlin { c10: 0.12e6, c01: 0.06e6, c11: 0.03e6, c20: 2e3, c02: 12e3 }),
        volumetric_law: VolumetricLaw::Quadratic,
        volumetric_by: VolumetricBy::BulkModulus,
        bulk_modulus: 2e6,
        poissons_ratio: 0.45,
        prony_g: [0.0; 5],
        prony_tau: [1.0; 5],
        maxwell_g: [0.0; 5],
        maxwell_beta: [1e3; 5],
        slider_stiffness: 0.0,
        slider_yield_stress: 0.0,
        tear_stretch: 0.0,
        tear_width: 0.1,
        tear_residual: 0.0,
        softening_r: 0.0,
        softening_m: 1e3,
        softening_beta: 0.1,
    }
}

fn ogden() -> Scenario {
    base(Material {
        volumetric_law: VolumetricLaw::Simo,
        prony_g: [0.3, 0.2, 0.0, 0.0, 0.0],
        prony_tau: [0.5e-3, 20e-3, 1.0, 1.0, 1.0],
        ..rubber().with(Ogden::new([0.3e6, 2e3, -0.02e6], [1.3, 5.0, -2.0]))
    })
}

fn yeoh() -> Scenario {
    base(Material {
        moduli: Moduli::Instantaneous,
        volumetric_by: VolumetricBy::PoissonsRatio,
        prony_g: [0.5, 0.0, 0.0, 0.0, 0.0],
        prony_tau: [1e-3, 1.0, 1.0, 1.0, 1.0],
        slider_stiffness: 10e6,
        slider_yield_stress: 20e3,
        ..rubber().with(Yeoh { c10: 0.3e6, c20: -4e3, c30: 1e3 })
    })
}

fn two_layers() -> Scenario {
    let mut scenario = base(rubber());
    scenario.layers[0].thickness = 14e-3;
    let skin = Material {
        density: 900.0,
        bulk_modulus: 8e6,
        maxwell_g: [0.4e6, 0.2e6, 0.1e6, 0.0, 0.0],
        maxwell_beta: [5e3, 500.0, 20.0, 1e3, 1e3],
        tear_stretch: 1.02,
        tear_width: 0.1,
        tear_residual: 0.2,
        ..rubber().with(NeoHookean { c10: 0.5e6 })
    };
    // There is room for a second layer.
    let _ = scenario.add_layer(Layer::new("skin", 1.5e-3, skin));
    scenario.time.step = 1.25e-6;
    scenario.time.duration = 4e-3;
    scenario
}

#[cfg(feature = "pads")]
/// The pad is narrower than the layer under it, and smoother than the face.
fn pad() -> Scenario {
    let mut scenario = base(rubber());
    scenario.layers[0].thickness = 12e-3;
    let foam = Material {
        density: 120.0,
        prony_g: [0.3, 0.0, 0.0, 0.0, 0.0],
        prony_tau: [2e-3, 1.0, 1.0, 1.0, 1.0],
        softening_r: 1.5,
        softening_m: 2e3,
        softening_beta: 0.2,
        ..rubber().with(Hyperfoam::new([0.2e6, 0.05e6, 0.0], [8.0, -2.0, 4.0], [0.05, 0.2, 0.0]))
    };
    // There is room for a second layer.
    let _ = scenario.add_layer(Layer {
        width: 0.14,
        interface: LayerInterface::Frictional,
        friction_coefficient: 0.1,
        ..Layer::new("pad", 8e-3, foam)
    });
    scenario
}

fn axisymmetric() -> Scenario {
    let mut scenario = base(Material { slider_stiffness: 10e6, slider_yield_stress: 30e3, ..rubber() });
    scenario.geometry.formulation = Formulation::Axisymmetric;
    scenario.impactor.drop_by = DropBy::Height;
    scenario.impactor.drop_height = 0.05;
    scenario
}

fn driven() -> Scenario {
    let mut scenario = base(Material {
        prony_g: [0.4, 0.1, 0.1, 0.0, 0.0],
        prony_tau: [0.2e-3, 2e-3, 20e-3, 1.0, 1.0],
        slider_stiffness: 5e6,
        slider_yield_stress: 10e3,
        ..rubber()
    });
    scenario.impactor.motion = Motion::Driven;
    scenario.impactor.gap = 0.5e-3;
    scenario
}

fn frictional_core() -> Scenario {
    let mut scenario = base(rubber());
    scenario.geometry.section = Section::Full;
    scenario.impactor.offset = 4e-3;
    scenario.impactor.drop_by = DropBy::Speed;
    scenario.impactor.drop_speed = 1.8;
    scenario.core.interface = Interface::Frictional;
    scenario.core.friction_coefficient = 0.2;
    scenario.face.friction_coefficient = 0.15;
    scenario
}

#[cfg(feature = "solid")]
fn solid() -> Scenario {
    let mut scenario = base(Material {
        prony_g: [0.3, 0.2, 0.0, 0.0, 0.0],
        prony_tau: [0.5e-3, 20e-3, 1.0, 1.0, 1.0],
        slider_stiffness: 1e6,
        slider_yield_stress: 10e3,
        ..rubber()
    });
    (scenario.geometry.formulation, scenario.geometry.symmetry) = (Formulation::Solid, Symmetry::Half);
    (scenario.geometry.length, scenario.mesh.element_size) = (20e-3, 7.5e-3);
    scenario.impactor.drop_energy = 1.0;
    (scenario.impactor.offset, scenario.impactor.face_diameter) = (3e-3, 17e-3);
    (scenario.core.interface, scenario.core.friction_coefficient) = (Interface::Frictional, 0.2);
    scenario.time.step = 5e-6;
    scenario
}

#[cfg(all(feature = "pads", feature = "solid"))]
fn solid_pad() -> Scenario {
    let mut scenario = base(rubber());
    let geometry = &mut scenario.geometry;
    (geometry.formulation, geometry.body, geometry.symmetry) = (Formulation::Solid, Body::Revolved, Symmetry::Half);
    scenario.mesh.element_size = 24e-3;
    scenario.layers[0].rows = 1;
    // There is room for a second layer.
    let _ = scenario.add_layer(Layer {
        rows: 1,
        width: 0.09,
        interface: LayerInterface::Frictional,
        friction_coefficient: 0.15,
        gap: 0.4e-3,
        ..Layer::new("pad", 8e-3, rubber())
    });
    (scenario.impactor.drop_energy, scenario.impactor.gap) = (3.0, 0.5e-3);
    (scenario.impactor.offset, scenario.impactor.face_diameter) = (3e-3, 50e-3);
    (scenario.core.interface, scenario.core.friction_coefficient) = (Interface::Frictional, 0.2);
    scenario.time.step = 5e-6;
    scenario
}

fn nothing(_: &Constants, _: u64) -> StepInput {
    StepInput::default()
}

/// Down by 3.5 mm and back, in 5 ms, and then at rest: p(s) = s^3 (10 - 15 s + 6 s^2) each way, which starts and ends
/// without speed and acceleration.
fn press(constants: &Constants, step_index: u64) -> StepInput {
    const STROKE: Real = 3.5e-3;
    const EACH_WAY: Real = 2.5e-3;
    let s = constants.time(step_index + 1) / EACH_WAY;
    let s = if s > 2.0 {
        0.0
    } else if s > 1.0 {
        2.0 - s
    } else {
        s
    };
    let smooth = s * s * s * (10.0 - s * (15.0 - s * 6.0));
    StepInput { driven_position: Some(constants.scenario.impactor.gap - STROKE * smooth), ..StepInput::default() }
}

/// Half a newton more upwards in every step.
fn pull(_: &Constants, step_index: u64) -> StepInput {
    StepInput { external_force: 0.5 * step_index as Real, ..StepInput::default() }
}

#[cfg(all(test, feature = "pads", feature = "solid"))]
mod tests {
    use super::*;

    #[test]
    fn the_kernel_states_the_digest_of_the_traces() {
        let digest = digest(SCENES.iter().filter_map(Scene::last_state));
        assert_eq!(softanvil_kernel::KERNEL_DIGEST, digest, "kernel/src/identity.rs: {digest:#018x}");
    }
}
