//! The description of one drop test: geometry, impactor, layers, interfaces, mesh, time.
//!
//! A [`Scenario`] is plain data. Every number and choice in it is a [`crate::Parameter`], which has a name, unit, legal range
//! and meaning; [`Scenario::validate`] checks each of them and what several say together.

use heapless::Vec;
use strum::{FromRepr, VariantNames};

use crate::features::PADS;
use crate::number::real::Real;
use crate::scenario::impactor::Impactor;
use crate::scenario::layer::{Layer, LayerInterface, MAX_LAYERS};

/// Everything that defines a simulation, in SI units.
///
/// ```
/// use softanvil_kernel::preset;
///
/// let mut scenario = preset::study();
/// scenario.layers[0].thickness = 20e-3;
/// scenario.impactor.mass = 4.0;
/// scenario.impactor = scenario.impactor.with_energy(8.0);
/// scenario.validate()?;
/// assert_eq!(scenario.impactor.start_speed(), 2.0);
/// scenario.impactor.offset = 10e-3;
/// let refused = scenario.validate().unwrap_err().to_string();
/// assert_eq!(refused, "impactor.offset = 0.01 m is refused: expected 0 m with geometry.section = half");
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Scenario {
    /// Shape and size of the anvil.
    pub geometry: Geometry,
    /// The drop mass.
    pub impactor: Impactor,
    /// The layers from the core to the surface, at least one.
    pub layers: Vec<Layer, MAX_LAYERS>,
    /// Interface between layer and core.
    pub core: CoreInterface,
    /// Interface between impactor and layer.
    pub face: FaceInterface,
    /// Spatial discretisation.
    pub mesh: Mesh,
    /// Temporal discretisation and simulated time.
    pub time: Time,
    /// How the numbers of the test are read from the force.
    pub measurement: Measurement,
}

/// Shape of the section.
#[derive(Clone, Copy, Debug, FromRepr, PartialEq, Eq, VariantNames)]
#[strum(serialize_all = "snake_case")]
pub enum Shape {
    /// A layer on a round core: half a cylinder in plane strain, half a sphere when axisymmetric.
    Round,
    /// A flat block on a flat core, for material and verification tests.
    Block,
}

/// Kinematics of the section.
#[derive(Clone, Copy, Debug, FromRepr, PartialEq, Eq, VariantNames)]
#[strum(serialize_all = "snake_case")]
pub enum Formulation {
    /// No strain out of the section, whose thickness is the chord of the face (limited to the length).
    PlaneStrain,
    /// The section turned about its centre line.
    Axisymmetric,
    /// Three dimensions: the body that [`Geometry::body`] makes of the section.
    #[cfg(feature = "solid")]
    Solid,
}

impl Formulation {
    /// Whether it has three dimensions.
    #[inline(always)]
    pub fn is_solid(self) -> bool {
        !matches!(self, Self::PlaneStrain | Self::Axisymmetric)
    }
}

/// What a solid makes of its section.
#[derive(Clone, Copy, Debug, FromRepr, PartialEq, Eq, VariantNames)]
#[strum(serialize_all = "snake_case")]
pub enum Body {
    /// Drawn along z over [`Geometry::length`]: half a cylinder, or a cuboid.
    Prism,
    /// Turned about its centre line: a dome, or a disc.
    Revolved,
}

/// How much of a solid is meshed.
#[derive(Clone, Copy, Debug, FromRepr, PartialEq, Eq, VariantNames)]
#[strum(serialize_all = "snake_case")]
pub enum Symmetry {
    /// x >= 0 and z >= 0: both planes through the centre line are planes of symmetry.
    Quarter,
    /// z >= 0.
    Half,
    /// All of it.
    Full,
}

/// What holds the ends of a prism.
#[derive(Clone, Copy, Debug, FromRepr, PartialEq, Eq, VariantNames)]
#[strum(serialize_all = "snake_case")]
pub enum Ends {
    /// Nothing.
    Free,
    /// They do not move along z, as a section in plane strain.
    Held,
}

/// How much of the section is meshed.
#[derive(Clone, Copy, Debug, FromRepr, PartialEq, Eq, VariantNames)]
#[strum(serialize_all = "snake_case")]
pub enum Section {
    /// The right half, with a centre line that moves only vertically.
    Half,
    /// Both halves (plane strain).
    Full,
}

/// Shape and size of the anvil.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Geometry {
    /// Round or block.
    pub shape: Shape,
    /// Plane strain, axisymmetric or solid.
    pub formulation: Formulation,
    /// Half or full section.
    pub section: Section,
    /// Radius of the rigid core of a round anvil, m.
    pub core_radius: Real,
    /// Largest out-of-plane thickness in plane strain, or length along z of a solid prism, m.
    pub length: Real,
    /// Full width (plane strain) or diameter (axisymmetric) of a block, m.
    pub block_width: Real,
    /// What a solid makes of its section.
    pub body: Body,
    /// How much of a solid is meshed.
    pub symmetry: Symmetry,
    /// What holds the ends of a prism.
    pub ends: Ends,
}

/// How the layer sits on the core.
#[derive(Clone, Copy, Debug, FromRepr, PartialEq, Eq, VariantNames)]
#[strum(serialize_all = "snake_case")]
pub enum Interface {
    /// Glued: no relative motion.
    Bonded,
    /// Unilateral contact with Coulomb friction.
    Frictional,
    /// Neither lifts nor rubs: rollers.
    Sliding,
    /// Unilateral contact without friction.
    Separating,
}

impl Interface {
    /// Whether it may pull at the layer as well as press.
    pub(crate) fn holds(self) -> bool {
        matches!(self, Self::Bonded | Self::Sliding)
    }

    /// Whether Coulomb friction acts.
    pub(crate) fn rubs(self) -> bool {
        self == Self::Frictional
    }
}

/// Interface between layer and core.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CoreInterface {
    /// What it transmits.
    pub interface: Interface,
    /// Coulomb coefficient of a frictional interface.
    pub friction_coefficient: Real,
}

/// Interface between impactor and layer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FaceInterface {
    /// Coulomb coefficient under the impactor.
    pub friction_coefficient: Real,
}

/// Spatial discretisation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mesh {
    /// Edge length that the structured mesh aims at, m.
    pub element_size: Real,
}

/// Which of the two numbers states the time step.
#[derive(Clone, Copy, Debug, FromRepr, PartialEq, Eq, VariantNames)]
#[strum(serialize_all = "snake_case")]
pub enum StepBy {
    /// [`Time::safety_factor`] times the stability limit of the stiffest expected state.
    SafetyFactor,
    /// [`Time::step`].
    Given,
}

/// Temporal discretisation and simulated time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Time {
    /// Which of the next two counts.
    pub step_by: StepBy,
    /// Fraction of the stability limit.
    pub safety_factor: Real,
    /// Requested step, s; the largest whole divisor of the sampling interval not above it is used.
    pub step: Real,
    /// Part of the layer's thickness that a driven face is expected to press it by at most; the step is chosen for it.
    pub design_compression: Real,
    /// Simulated time that a run covers unless told otherwise, s.
    pub duration: Real,
}

/// How the numbers of the test are read from the force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measurement {
    /// Force that begins and ends the impact duration, N.
    pub force_threshold: Real,
    /// Channel frequency class of the filtered force (SAE J211, ISO 6487), Hz.
    pub channel_class: Real,
}

impl Scenario {
    /// Thickness of all layers together, m.
    pub fn thickness(&self) -> Real {
        self.layers.iter().fold(0.0, |sum, layer| sum + layer.thickness)
    }

    /// Whether what is meshed has both sides of the centre line.
    pub(crate) fn has_both_sides(&self) -> bool {
        let geometry = &self.geometry;
        if geometry.formulation.is_solid() {
            geometry.symmetry != Symmetry::Quarter
        } else {
            geometry.section == Section::Full
        }
    }

    /// Distance from the layer `place`, counted from the core, to the one below, m; 0 where they are bonded, and on the core.
    pub fn gap_below(&self, place: usize) -> Real {
        self.layers.get(place).filter(|_| self.is_open(place)).map_or(0.0, |layer| layer.gap)
    }

    /// Height of the surface above the core at rest, m: of all layers and the gaps between them.
    pub fn height(&self) -> Real {
        (0..self.layers.len()).fold(self.thickness(), |sum, place| sum + self.gap_below(place))
    }

    /// Whether the layer `place` and the one below have nodes of their own between them.
    pub fn is_open(&self, place: usize) -> bool {
        PADS && place > 0 && self.layers.get(place).is_some_and(|layer| layer.interface != LayerInterface::Bonded)
    }

    /// Radius of the curved core surface, m; none for a flat one.
    pub(crate) fn core_radius(&self) -> Option<Real> {
        match self.geometry.shape {
            Shape::Round => Some(self.geometry.core_radius),
            Shape::Block => None,
        }
    }
}
