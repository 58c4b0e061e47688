//! The table of parameters: name, unit, legal range and meaning of every field of a [`Scenario`], in one place.
//!
//! Scenario files, the C ABI and the FMU are all generated from or checked against this table.

mod changes;
mod effect;
mod material;

pub use self::changes::Changes;
use self::material::{SILICONE, SKIN};
use crate::error::ParameterError;
use crate::real::Real;
use crate::scenario::{DropBy, Formulation, Interface, Layers, Motion, Scenario, Section, Shape, StepBy};

/// One row of the table.
#[derive(Clone, Copy)]
pub struct Parameter {
    /// Structured name, `group.field`.
    pub name: &'static str,
    /// What the value is and how it is stored.
    pub kind: Kind,
    /// Meaning, one line.
    pub description: &'static str,
}

/// What a parameter's value is.
#[derive(Clone, Copy)]
pub enum Kind {
    /// A physical quantity in an SI unit ("1" for a ratio), legal from `min` to `max`, both included.
    Real {
        /// SI unit.
        unit: &'static str,
        /// Smallest legal value.
        min: Real,
        /// Largest legal value.
        max: Real,
        /// The field in a scenario.
        field: fn(&mut Scenario) -> &mut Real,
    },
    /// One of several named choices, numbered from 0 in this order.
    Choice {
        /// Names of the choices.
        labels: &'static [&'static str],
        /// Index of the scenario's choice.
        read: fn(&Scenario) -> usize,
        /// Sets the choice by its index.
        write: fn(&mut Scenario, usize),
    },
}

impl Parameter {
    /// The row called `name`.
    pub fn find(name: &str) -> Option<&'static Parameter> {
        PARAMETERS.iter().find(|parameter| parameter.name == name)
    }

    /// Unit of the value; "1" for ratios and choices.
    pub fn unit(&self) -> &'static str {
        match self.kind {
            Kind::Real { unit, .. } => unit,
            Kind::Choice { .. } => "1",
        }
    }

    /// Smallest and largest legal value.
    pub fn range(&self) -> (Real, Real) {
        match self.kind {
            Kind::Real { min, max, .. } => (min, max),
            Kind::Choice { labels, .. } => (0.0, labels.len() as Real - 1.0),
        }
    }

    /// The value in `scenario`; a choice as its index.
    pub fn get(&self, scenario: &Scenario) -> Real {
        match self.kind {
            Kind::Real { field, .. } => *field(&mut { *scenario }),
            Kind::Choice { read, .. } => read(scenario) as Real,
        }
    }

    /// Sets the value in `scenario`; a choice by its index.
    ///
    /// # Errors
    /// A value that is not legal is refused and changes nothing.
    pub fn set(&self, scenario: &mut Scenario, value: Real) -> Result<(), ParameterError> {
        self.check(value)?;
        match self.kind {
            Kind::Real { field, .. } => *field(scenario) = value,
            Kind::Choice { write, .. } => write(scenario, value as usize),
        }
        Ok(())
    }

    /// Whether `value` is legal: finite, in range, and whole for a choice.
    ///
    /// # Errors
    /// The name, value, unit and legal range of a refused value.
    pub fn check(&self, value: Real) -> Result<(), ParameterError> {
        let (min, max) = self.range();
        let in_range = value >= min && value <= max;
        let whole = match self.kind {
            Kind::Real { .. } => true,
            Kind::Choice { .. } => in_range && value as usize as Real == value,
        };
        if in_range && whole {
            return Ok(());
        }
        Err(ParameterError { name: self.name, value, unit: self.unit(), min, max })
    }
}

const fn real(
    name: &'static str,
    unit: &'static str,
    range: (Real, Real),
    field: fn(&mut Scenario) -> &mut Real,
    description: &'static str,
) -> Parameter {
    Parameter { name, kind: Kind::Real { unit, min: range.0, max: range.1, field }, description }
}

const fn choice(
    name: &'static str,
    labels: &'static [&'static str],
    read: fn(&Scenario) -> usize,
    write: fn(&mut Scenario, usize),
    description: &'static str,
) -> Parameter {
    Parameter { name, kind: Kind::Choice { labels, read, write }, description }
}

/// Every parameter of a scenario, in the order in which users meet them.
pub static PARAMETERS: &[Parameter] = &ROWS;

static ROWS: [Parameter; TEST.len() + SILICONE.len() + SKIN.len() + NUMERICS.len()] =
    join([TEST, SILICONE, SKIN, NUMERICS]);

/// The groups one after the other; its length has to be the sum of theirs.
const fn join<const N: usize>(groups: [&[Parameter]; 4]) -> [Parameter; N] {
    let mut rows = [TEST[0]; N];
    let (mut group, mut from, mut to) = (0, 0, 0);
    while to < N {
        if from == groups[group].len() {
            group += 1;
            from = 0;
        } else {
            rows[to] = groups[group][from];
            from += 1;
            to += 1;
        }
    }
    rows
}

/// Geometry and impactor.
const TEST: &[Parameter] = &[
    choice(
        "geometry.shape",
        &["round", "block"],
        |s| s.geometry.shape as usize,
        |s, i| s.geometry.shape = if i == 0 { Shape::Round } else { Shape::Block },
        "layer on a round core, or a flat block on a flat core",
    ),
    choice(
        "geometry.formulation",
        &["plane_strain", "axisymmetric"],
        |s| s.geometry.formulation as usize,
        |s, i| s.geometry.formulation = if i == 0 { Formulation::PlaneStrain } else { Formulation::Axisymmetric },
        "kinematics of the section",
    ),
    choice(
        "geometry.layers",
        &["one", "two"],
        |s| s.geometry.layers as usize,
        |s, i| s.geometry.layers = if i == 0 { Layers::One } else { Layers::Two },
        "one material through the whole thickness (the study's simplification), or a skin of its own on the silicone",
    ),
    choice(
        "geometry.section",
        &["half", "full"],
        |s| s.geometry.section as usize,
        |s, i| s.geometry.section = if i == 0 { Section::Half } else { Section::Full },
        "half of the section with symmetry, or all of it",
    ),
    real(
        "geometry.core_radius",
        "m",
        (1e-3, 1.0),
        |s| &mut s.geometry.core_radius,
        "radius of the rigid core (round shape)",
    ),
    real(
        "geometry.silicone_thickness",
        "m",
        (1e-4, 0.5),
        |s| &mut s.geometry.silicone_thickness,
        "thickness of the silicone; of the whole layer where there is one",
    ),
    real(
        "geometry.skin_thickness",
        "m",
        (0.0, 0.1),
        |s| &mut s.geometry.skin_thickness,
        "thickness of the skin on the silicone (two layers)",
    ),
    real(
        "geometry.length",
        "m",
        (1e-3, 10.0),
        |s| &mut s.geometry.length,
        "largest out-of-plane thickness in plane strain (effective length of the layer)",
    ),
    real(
        "geometry.block_width",
        "m",
        (1e-4, 10.0),
        |s| &mut s.geometry.block_width,
        "full width, or diameter if axisymmetric (block shape)",
    ),
    choice(
        "impactor.motion",
        &["drop", "driven", "prescribed"],
        |s| s.impactor.motion as usize,
        |s, i| {
            s.impactor.motion = match i {
                0 => Motion::Drop,
                1 => Motion::Driven,
                _ => Motion::Prescribed,
            }
        },
        "a falling mass, a position given from outside with every call, or down at a speed to a depth and hold",
    ),
    real("impactor.mass", "kg", (1e-3, 1e4), |s| &mut s.impactor.mass, "mass of the impactor"),
    real(
        "impactor.face_diameter",
        "m",
        (1e-3, 10.0),
        |s| &mut s.impactor.face_diameter,
        "diameter of the flat face; its chord is the thickness of a round section in plane strain",
    ),
    real(
        "impactor.offset",
        "m",
        (-1.0, 1.0),
        |s| &mut s.impactor.offset,
        "distance of the face's centre from the centre line, to the right (full section)",
    ),
    real("impactor.gap", "m", (0.0, 1.0), |s| &mut s.impactor.gap, "height of the face above the anvil at the start"),
    real("impactor.gravity", "m/s2", (0.0, 100.0), |s| &mut s.impactor.gravity, "acceleration of gravity"),
    choice(
        "impactor.drop_by",
        &["height", "energy", "speed"],
        |s| s.impactor.drop_by as usize,
        |s, i| {
            s.impactor.drop_by = match i {
                0 => DropBy::Height,
                1 => DropBy::Energy,
                _ => DropBy::Speed,
            }
        },
        "which of the next three states the drop",
    ),
    real("impactor.drop_height", "m", (0.0, 100.0), |s| &mut s.impactor.drop_height, "free fall before the start"),
    real("impactor.drop_energy", "J", (0.0, 1e5), |s| &mut s.impactor.drop_energy, "kinetic energy at the start"),
    real("impactor.drop_speed", "m/s", (0.0, 100.0), |s| &mut s.impactor.drop_speed, "downward speed at the start"),
    real(
        "impactor.prescribed_speed",
        "m/s",
        (1e-6, 100.0),
        |s| &mut s.impactor.prescribed_speed,
        "downward speed of the prescribed motion",
    ),
    real(
        "impactor.prescribed_depth",
        "m",
        (0.0, 1.0),
        |s| &mut s.impactor.prescribed_depth,
        "depth below the undeformed anvil at which the prescribed motion ends and holds",
    ),
    real(
        "impactor.prescribed_rise",
        "s",
        (0.0, 100.0),
        |s| &mut s.impactor.prescribed_rise,
        "time over which the prescribed speed rises at the start and falls at the end, smoothly; at most travel / speed",
    ),
];

/// Interfaces, mesh, time and measurement.
const NUMERICS: &[Parameter] = &[
    choice(
        "core.interface",
        &["bonded", "frictional", "sliding"],
        |s| s.core.interface as usize,
        |s, i| {
            s.core.interface = match i {
                0 => Interface::Bonded,
                1 => Interface::Frictional,
                _ => Interface::Sliding,
            }
        },
        "how the layer sits on the core: glued, in contact with friction, or on rollers (neither lifts nor rubs)",
    ),
    real(
        "core.friction_coefficient",
        "1",
        (0.0, 10.0),
        |s| &mut s.core.friction_coefficient,
        "Coulomb coefficient of a frictional core",
    ),
    real(
        "face.friction_coefficient",
        "1",
        (0.0, 10.0),
        |s| &mut s.face.friction_coefficient,
        "Coulomb coefficient under the impactor",
    ),
    real(
        "mesh.element_size",
        "m",
        (1e-5, 0.1),
        |s| &mut s.mesh.element_size,
        "edge length that the structured mesh aims at",
    ),
    choice(
        "time.step_by",
        &["safety_factor", "given"],
        |s| s.time.step_by as usize,
        |s, i| s.time.step_by = if i == 0 { StepBy::SafetyFactor } else { StepBy::Given },
        "which of the next two states the time step",
    ),
    real(
        "time.safety_factor",
        "1",
        (0.01, 1.0),
        |s| &mut s.time.safety_factor,
        "fraction of the smallest stability limit that a trial of the scenario finds",
    ),
    real(
        "time.step",
        "s",
        (1e-10, 5e-5),
        |s| &mut s.time.step,
        "requested step; the largest whole divisor of 50 us not above it is used",
    ),
    real(
        "time.design_compression",
        "1",
        (0.01, 0.95),
        |s| &mut s.time.design_compression,
        "part of the layer's thickness that a driven face presses it by at most, for which the step is chosen",
    ),
    real("time.duration", "s", (5e-5, 100.0), |s| &mut s.time.duration, "simulated time of a run"),
    real(
        "measurement.force_threshold",
        "N",
        (0.0, 1e5),
        |s| &mut s.measurement.force_threshold,
        "force that begins and ends the impact duration",
    ),
    real(
        "measurement.channel_class",
        "Hz",
        (1.0, 2000.0),
        |s| &mut s.measurement.channel_class,
        "channel frequency class (SAE J211, ISO 6487) of contact.force_filtered, such as 60, 180, 600 or 1000",
    ),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::preset;

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
