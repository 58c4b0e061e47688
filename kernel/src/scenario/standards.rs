//! The set-ups of standards for pads and protectors, each with a pad to start from.
//!
//! Of every number the source is given; "second-hand" is one that was read on a page of a laboratory or of a maker and not in the
//! standard, and "assumed" one without a source. What a standard asks for is no business of a simulation: limits stand in the
//! command line's table of standards.

use crate::material::{Hyperfoam, Material};
use crate::number::real::Real;
use crate::sampling::SAMPLING_INTERVAL;
use crate::scenario::preset::{consistent, elastic_silicone, study};
use crate::scenario::{
    Body, CoreInterface, FaceInterface, FaceShape, Formulation, Geometry, Impactor, Interface, Layer, LayerInterface,
    Mesh, Scenario, Time,
};

/// An elastomeric foam: two terms of [`Hyperfoam`], fitted with `softanvil fit --foam` to the compression, tension and shear of the
/// foam "leap" in `data/foam` and rounded: root mean squares of 0.9, 6.2 and 1.2 % of the largest stresses. Elastic, because these
/// tests say nothing of its viscosity. The density is assumed: the most that body padding of rugby union may have without its
/// tolerance (World Rugby, Regulation 12, schedule 1).
pub fn elastomeric_foam() -> Material {
    foam(1.0)
}

/// A stiff foam of no particular maker: [`elastomeric_foam`] made 60 times as stiff, 7 MPa in shear, of which 20 mm are not pressed
/// through by a motorcyclist's fall. Assumed.
pub fn stiff_foam() -> Material {
    foam(60.0)
}

/// Friction under and on a pad, assumed: that of the study's model.
const FRICTION: Real = 0.3;

/// [`elastomeric_foam`], `factor` times as stiff.
fn foam(factor: Real) -> Material {
    let law = Hyperfoam::new([113.4e3 * factor, 2.44e3 * factor, 0.0], [11.87, -0.189, 4.0], [0.1235, 0.499, 0.0]);
    Material { density: 45.0, ..elastic_silicone().with(law) }
}

/// `scenario` with a pad of `thickness` m that lies on it, with a friction of [`FRICTION`].
fn padded(mut scenario: Scenario, thickness: Real, material: Material) -> Scenario {
    // There is room for it.
    let _ = scenario.add_layer(Layer {
        interface: LayerInterface::Frictional,
        friction_coefficient: FRICTION,
        ..Layer::new("pad", thickness, material)
    });
    scenario
}

/// A pad of `thickness` m alone, on a rigid core.
fn pad_on_core(thickness: Real, material: Material) -> Scenario {
    let mut scenario = study();
    scenario.layers.clear();
    let scenario = Scenario {
        core: CoreInterface { interface: Interface::Frictional, friction_coefficient: FRICTION },
        face: FaceInterface { friction_coefficient: FRICTION },
        ..scenario
    };
    padded(scenario, thickness, material)
}

/// `scenario` with `steps` steps in a sampling interval, and time for a foam to throw the mass back.
fn timed(scenario: Scenario, steps: Real, duration: Real) -> Scenario {
    let time = Time { step: SAMPLING_INTERVAL / steps, duration, ..scenario.time };
    consistent(Scenario { time, ..scenario })
}

/// The body padding of rugby union on the study's soft anvil, whose silicone stands for a shoulder: 10 mm of
/// [`elastomeric_foam`], the most that a pad may have (World Rugby, Regulation 12, schedule 1). Mass, face and energy are those of
/// the standard's test, as in the study. The pad lies on the silicone with a friction that is assumed to be that of the study.
/// The mesh is coarser than the study's, which makes the drop quicker: the peak force is 1.1 % below that of a mesh seven times
/// as fine (`docs/performance.md`), and without the pad 3.6 % below that of the study's mesh.
pub fn rugby_soft_anvil() -> Scenario {
    let scenario = padded(study(), 10e-3, elastomeric_foam());
    timed(Scenario { mesh: Mesh { element_size: 5.3e-3 }, ..scenario }, 12.0, 30e-3)
}

/// The same padding on the standard's own anvil, a steel cylinder of 115 mm (World Rugby, Regulation 12, schedule 1, 6.3: 5 kg, a
/// flat face of 130 mm, a drop of 300 mm or 14.7 J, an accelerometer in the mass). The anvil's length of 150 mm and the friction
/// on it, as of the study's core, are assumed.
pub fn rugby_steel_anvil() -> Scenario {
    let pad = pad_on_core(10e-3, elastomeric_foam());
    let geometry = Geometry { core_radius: 57.5e-3, ..pad.geometry };
    timed(Scenario { geometry, ..pad }, 104.0, 30e-3)
}

/// Limb protectors of motorcyclists, EN 1621-1: 5 kg with 50 J, a face of 40 mm x 30 mm, a dome with a radius of 50 mm on a load
/// cell (second-hand: sweetprotection.com and tagpath.pages.dev, which agree). The section turns about its axis, so the face is
/// round, of the same area, which is assumed to matter little. The protector, 20 mm of [`stiff_foam`], and
/// its friction are assumed.
pub fn en1621_1() -> Scenario {
    let pad = pad_on_core(20e-3, stiff_foam());
    let (formulation, body) = (Formulation::Axisymmetric, Body::Revolved);
    let geometry = Geometry { formulation, body, core_radius: 50e-3, ..pad.geometry };
    // 2 sqrt(40 mm * 30 mm / pi).
    let impactor = Impactor { face_diameter: 39.1e-3, drop_energy: 50.0, ..pad.impactor };
    timed(Scenario { geometry, impactor, ..pad }, 61.0, 30e-3)
}

/// Back protectors of motorcyclists, EN 1621-2: 5 kg with 50 J (second-hand: blitzflitz.cz and 4camping.at). That anvil and striker
/// are others than those of EN 1621-1 is said by a laboratory (satra.com), and not how they look: a bar of 25 mm that lies along a
/// round anvil with a radius of 150 mm, over a length of 100 mm, is assumed, as are the protector, 20 mm of [`stiff_foam`], and its friction.
pub fn en1621_2() -> Scenario {
    let pad = pad_on_core(20e-3, stiff_foam());
    let geometry = Geometry { core_radius: 150e-3, length: 100e-3, ..pad.geometry };
    let impactor = Impactor {
        shape: FaceShape::Bar,
        face_diameter: 25e-3,
        face_length: 100e-3,
        drop_energy: 50.0,
        ..pad.impactor
    };
    timed(Scenario { geometry, impactor, ..pad }, 50.0, 30e-3)
}

/// Shin guards of association football, EN 13061, blunt impact: 1 kg on a guard on an instrumented leg (second-hand: satra.com).
/// Assumed are the energy of 2 J, a leg of a steel cylinder of 80 mm, 100 mm of it under a flat face of 50 mm, and the guard, 5 mm of
/// [`stiff_foam`] without the shell that most guards have.
pub fn en13061() -> Scenario {
    let pad = pad_on_core(5e-3, stiff_foam());
    let geometry = Geometry { core_radius: 40e-3, length: 100e-3, ..pad.geometry };
    let impactor = Impactor { mass: 1.0, face_diameter: 50e-3, drop_energy: 2.0, ..pad.impactor };
    timed(Scenario { geometry, impactor, mesh: Mesh { element_size: 1.5e-3 }, ..pad }, 84.0, 15e-3)
}
