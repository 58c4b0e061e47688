//! The rows of what is not a layer's.

use super::row::{Access, Row, choice, real};
#[cfg(feature = "pads")]
use crate::scenario::FaceShape;
#[cfg(feature = "solid")]
use crate::scenario::{Body, Ends, Symmetry};
use crate::scenario::{DropBy, Formulation, Interface, MAX_LAYERS, Motion, Scenario, Section, Shape, StepBy};

/// Geometry and impactor.
pub(super) static TEST: &[Row<Scenario>] = &[
    choice!(0, geometry.shape: Shape, "layer on a round core, or a flat block on a flat core"),
    choice!(1, geometry.formulation: Formulation, "kinematics: a section in plane strain or turned about its centre line, or a solid in three dimensions"),
    choice!(2, geometry.section: Section, "half of the section with symmetry, or all of it (not of a solid)"),
    #[cfg(feature = "solid")]
    choice!(60, geometry.body: Body, "what a solid makes of its section: drawn along z, or turned about its centre line"),
    #[cfg(feature = "solid")]
    choice!(
        61, geometry.symmetry: Symmetry,
        "part of a solid that is meshed: x >= 0 and z >= 0 with symmetry, z >= 0 with symmetry, or all of it"
    ),
    #[cfg(feature = "solid")]
    choice!(62, geometry.ends: Ends, "ends of a solid prism: free, or held along z as a section in plane strain"),
    real!(3, geometry.core_radius, "m", (1e-3, 1.0), "radius of the rigid core (round shape)"),
    real!(
        4,
        geometry.length,
        "m",
        (1e-3, 10.0),
        "largest out-of-plane thickness in plane strain (effective length of the layers), or length of a solid prism"
    ),
    real!(5, geometry.block_width, "m", (1e-4, 10.0), "full width, or diameter if axisymmetric (block shape)"),
    choice!(
        6, impactor.motion: Motion,
        "a falling mass, a position given from outside with every call, or down at a speed to a depth and hold"
    ),
    real!(7, impactor.mass, "kg", (1e-3, 1e4), "mass of the impactor"),
    #[cfg(feature = "pads")]
    choice!(
        31, impactor.shape: FaceShape,
        "a flat disc, a flat rectangle, a ball (axisymmetric) or a round bar along the anvil (plane strain)"
    ),
    real!(
        8,
        impactor.face_diameter,
        "m",
        (1e-3, 10.0),
        "diameter of a round face, a sphere or a bar; the chord of a round face that covers a round section is its \
         thickness in plane strain, and a narrower one counts as a rectangle of its area and width"
    ),
    #[cfg(feature = "pads")]
    real!(32, impactor.face_width, "m", (1e-3, 10.0), "width of a rectangular face across the section"),
    #[cfg(feature = "pads")]
    real!(
        33,
        impactor.face_length,
        "m",
        (1e-3, 10.0),
        "length of a rectangular face or of a bar along the anvil: the thickness of the section in plane strain, up to \
         geometry.length; over a dome a rectangular face counts as a disc of its area"
    ),
    real!(
        9,
        impactor.offset,
        "m",
        (-1.0, 1.0),
        "distance of the face's centre from the centre line, to the right (full section; half or full solid)"
    ),
    real!(10, impactor.gap, "m", (0.0, 1.0), "height of the face above the anvil at the start"),
    real!(11, impactor.gravity, "m/s2", (0.0, 100.0), "acceleration of gravity"),
    #[cfg(feature = "pads")]
    real!(
        34,
        impactor.rail_friction,
        "N",
        (0.0, 1e5),
        "friction of the rails that guide the falling mass: against its motion, and what holds it at rest"
    ),
    #[cfg(feature = "pads")]
    real!(35, impactor.rail_damping, "N.s/m", (0.0, 1e6), "force of the rails against the motion, over the speed"),
    choice!(12, impactor.drop_by: DropBy, "which of the next three states the drop"),
    real!(13, impactor.drop_height, "m", (0.0, 100.0), "free fall before the start"),
    real!(14, impactor.drop_energy, "J", (0.0, 1e5), "kinetic energy at the start"),
    real!(15, impactor.drop_speed, "m/s", (0.0, 100.0), "downward speed at the start"),
    real!(16, impactor.prescribed_speed, "m/s", (1e-6, 100.0), "downward speed of the prescribed motion"),
    real!(
        17,
        impactor.prescribed_depth,
        "m",
        (0.0, 1.0),
        "depth below the undeformed anvil at which the prescribed motion ends and holds"
    ),
    real!(
        18,
        impactor.prescribed_rise,
        "s",
        (0.0, 100.0),
        "time over which the prescribed speed rises at the start and falls at the end, smoothly; at most travel / speed"
    ),
];

/// How many layers there are.
pub(super) static LAYER_COUNT: Row<usize> = Row {
    id: 19,
    name: "layers.count",
    access: Access::Count {
        min: 1,
        max: MAX_LAYERS as u32,
        read: |count| *count,
        write: |count, number| *count = number,
    },
    description: "number of layers between core and face, layers[0] next to the core",
};

/// Interfaces, mesh, time and measurement.
pub(super) static NUMERICS: &[Row<Scenario>] = &[
    choice!(
        20, core.interface: Interface,
        "how the layer sits on the core: glued, in contact with friction, on rollers (neither lifts nor rubs), or in contact \
         that lifts and does not rub"
    ),
    real!(21, core.friction_coefficient, "1", (0.0, 10.0), "Coulomb coefficient of a frictional core"),
    real!(22, face.friction_coefficient, "1", (0.0, 10.0), "Coulomb coefficient under the impactor"),
    real!(23, mesh.element_size, "m", (1e-5, 0.1), "edge length that the structured mesh aims at"),
    choice!(24, time.step_by: StepBy, "which of the next two states the time step"),
    real!(
        25,
        time.safety_factor,
        "1",
        (0.01, 1.0),
        "fraction of the smallest stability limit that a trial of the scenario finds"
    ),
    real!(26, time.step, "s", (1e-10, 5e-5), "requested step; the largest whole divisor of 50 us not above it is used"),
    real!(
        27,
        time.design_compression,
        "1",
        (0.01, 0.95),
        "part of the layer's thickness that a driven face presses it by at most, for which the step is chosen"
    ),
    real!(28, time.duration, "s", (5e-5, 100.0), "simulated time of a run"),
    real!(29, measurement.force_threshold, "N", (0.0, 1e5), "force that begins and ends the impact duration"),
    real!(
        30,
        measurement.channel_class,
        "Hz",
        (1.0, 2000.0),
        "channel frequency class (SAE J211, ISO 6487) of contact.force_filtered, such as 60, 180, 600 or 1000"
    ),
];

/// Ids of rows that are no more, which no other row gets.
pub(super) const RETIRED: &[u32] = &[];
