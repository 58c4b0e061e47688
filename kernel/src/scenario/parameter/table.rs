//! The rows of the table.

use super::material::{SILICONE, SKIN};
use super::row::{Kind, Parameter, choice, join, real};
use crate::scenario::{DropBy, Formulation, Interface, Layers, Motion, Section, Shape, StepBy};

/// Every parameter of a scenario, in the order in which users meet them.
pub static PARAMETERS: &[Parameter] = &ROWS;

impl Parameter {
    /// The row called `name`.
    pub fn find(name: &str) -> Option<&'static Parameter> {
        PARAMETERS.iter().find(|parameter| parameter.name == name)
    }
}

pub(crate) static ROWS: [Parameter; TEST.len() + SILICONE.len() + SKIN.len() + NUMERICS.len()] =
    join([TEST, SILICONE, SKIN, NUMERICS]);

/// Geometry and impactor.
const TEST: &[Parameter] = &[
    choice!(geometry.shape: Shape, "layer on a round core, or a flat block on a flat core"),
    choice!(geometry.formulation: Formulation, "kinematics of the section"),
    choice!(
        geometry.layers: Layers,
        "one material through the whole thickness (the study's simplification), or a skin of its own on the silicone"
    ),
    choice!(geometry.section: Section, "half of the section with symmetry, or all of it"),
    real!(geometry.core_radius, "m", (1e-3, 1.0), "radius of the rigid core (round shape)"),
    real!(
        geometry.silicone_thickness,
        "m",
        (1e-4, 0.5),
        "thickness of the silicone; of the whole layer where there is one"
    ),
    real!(geometry.skin_thickness, "m", (0.0, 0.1), "thickness of the skin on the silicone (two layers)"),
    real!(
        geometry.length,
        "m",
        (1e-3, 10.0),
        "largest out-of-plane thickness in plane strain (effective length of the layer)"
    ),
    real!(geometry.block_width, "m", (1e-4, 10.0), "full width, or diameter if axisymmetric (block shape)"),
    choice!(
        impactor.motion: Motion,
        "a falling mass, a position given from outside with every call, or down at a speed to a depth and hold"
    ),
    real!(impactor.mass, "kg", (1e-3, 1e4), "mass of the impactor"),
    real!(
        impactor.face_diameter,
        "m",
        (1e-3, 10.0),
        "diameter of the flat face; its chord is the thickness of a round section in plane strain"
    ),
    real!(
        impactor.offset,
        "m",
        (-1.0, 1.0),
        "distance of the face's centre from the centre line, to the right (full section)"
    ),
    real!(impactor.gap, "m", (0.0, 1.0), "height of the face above the anvil at the start"),
    real!(impactor.gravity, "m/s2", (0.0, 100.0), "acceleration of gravity"),
    choice!(impactor.drop_by: DropBy, "which of the next three states the drop"),
    real!(impactor.drop_height, "m", (0.0, 100.0), "free fall before the start"),
    real!(impactor.drop_energy, "J", (0.0, 1e5), "kinetic energy at the start"),
    real!(impactor.drop_speed, "m/s", (0.0, 100.0), "downward speed at the start"),
    real!(impactor.prescribed_speed, "m/s", (1e-6, 100.0), "downward speed of the prescribed motion"),
    real!(
        impactor.prescribed_depth,
        "m",
        (0.0, 1.0),
        "depth below the undeformed anvil at which the prescribed motion ends and holds"
    ),
    real!(
        impactor.prescribed_rise,
        "s",
        (0.0, 100.0),
        "time over which the prescribed speed rises at the start and falls at the end, smoothly; at most travel / speed"
    ),
];

/// Interfaces, mesh, time and measurement.
const NUMERICS: &[Parameter] = &[
    choice!(
        core.interface: Interface,
        "how the layer sits on the core: glued, in contact with friction, or on rollers (neither lifts nor rubs)"
    ),
    real!(core.friction_coefficient, "1", (0.0, 10.0), "Coulomb coefficient of a frictional core"),
    real!(face.friction_coefficient, "1", (0.0, 10.0), "Coulomb coefficient under the impactor"),
    real!(mesh.element_size, "m", (1e-5, 0.1), "edge length that the structured mesh aims at"),
    choice!(time.step_by: StepBy, "which of the next two states the time step"),
    real!(
        time.safety_factor,
        "1",
        (0.01, 1.0),
        "fraction of the smallest stability limit that a trial of the scenario finds"
    ),
    real!(time.step, "s", (1e-10, 5e-5), "requested step; the largest whole divisor of 50 us not above it is used"),
    real!(
        time.design_compression,
        "1",
        (0.01, 0.95),
        "part of the layer's thickness that a driven face presses it by at most, for which the step is chosen"
    ),
    real!(time.duration, "s", (5e-5, 100.0), "simulated time of a run"),
    real!(measurement.force_threshold, "N", (0.0, 1e5), "force that begins and ends the impact duration"),
    real!(
        measurement.channel_class,
        "Hz",
        (1.0, 2000.0),
        "channel frequency class (SAE J211, ISO 6487) of contact.force_filtered, such as 60, 180, 600 or 1000"
    ),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::real::Real;
    use crate::scenario::parameter::Kind;
    use crate::scenario::preset;

    #[test]
    fn every_value_survives_a_round_trip() {
        for parameter in PARAMETERS {
            let mut scenario = preset::study();
            let (min, max) = parameter.range();
            for value in [min, max] {
                parameter.set(&mut scenario, value).unwrap();
                assert_eq!(parameter.get(&scenario), value, "{}", parameter.name);
            }
        }
    }

    #[test]
    fn illegal_values_are_refused_and_change_nothing() {
        for parameter in PARAMETERS {
            let (min, max) = parameter.range();
            for value in [min - 1.0 - min.abs(), max + 1.0 + max.abs(), Real::NAN, Real::INFINITY, Real::NEG_INFINITY] {
                let mut scenario = preset::study();
                let error = parameter.set(&mut scenario, value).unwrap_err();
                assert_eq!((error.name, error.min, error.max), (parameter.name, min, max));
                assert_eq!(scenario, preset::study());
            }
        }
    }

    #[test]
    fn names_are_unique_and_choices_are_whole() {
        for (i, parameter) in PARAMETERS.iter().enumerate() {
            assert!(PARAMETERS[..i].iter().all(|other| other.name != parameter.name), "{}", parameter.name);
            if let Kind::Choice { .. } = parameter.kind {
                assert!(parameter.check(0.5).is_err(), "{}", parameter.name);
            }
        }
    }

    #[test]
    fn a_refused_value_names_itself_its_unit_and_its_range() {
        let error = Parameter::find("impactor.mass").unwrap().set(&mut preset::study(), -1.0).unwrap_err();
        extern crate std;
        assert_eq!(std::format!("{error}"), "impactor.mass = -1 kg is refused: expected 0.001 to 10000 kg");
    }
}
