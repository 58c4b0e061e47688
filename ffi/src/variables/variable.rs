//! One variable: what a master knows of it, and where its value lives.

use softanvil_kernel::parameter::Name;
use softanvil_kernel::{Output, Parameter, preset};

use super::inputs::{Input, Inputs};
use super::profile::{self, Profile};

/// A version of the standard.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Version {
    /// FMI 2.0, which has no arrays.
    Fmi2,
    /// FMI 3.0.
    Fmi3,
}

/// One variable.
#[derive(Clone, Copy)]
pub struct Variable {
    /// Number by which a master names it.
    pub reference: u32,
    /// Structured name, unique in the table.
    pub name: Name,
    /// Meaning, one line.
    pub description: &'static str,
    /// Type, with unit and range or names.
    pub value: ValueType,
    /// Where the value lives.
    pub source: Source,
}

/// Type of a variable.
#[derive(Clone, Copy)]
pub enum ValueType {
    /// A physical quantity.
    Real {
        /// SI unit.
        unit: &'static str,
        /// Smallest and largest legal value of what can be set.
        range: Option<(f64, f64)>,
    },
    /// A count.
    Integer {
        /// Smallest and largest legal value of what can be set.
        range: Option<(i32, i32)>,
    },
    /// One of several named choices, numbered from 0.
    Enumeration {
        /// Names of the choices.
        labels: &'static [&'static str],
    },
    /// Yes or no.
    Boolean,
    /// Text.
    String,
    /// A row of quantities, of the length that [`Source::Points`] has.
    Array {
        /// SI unit.
        unit: &'static str,
    },
    /// The length of arrays.
    Size {
        /// Smallest and largest legal value.
        range: (u64, u64),
    },
}

impl ValueType {
    /// Name of the type in a version of the standard.
    pub fn name(&self, version: Version) -> &'static str {
        match (self, version) {
            (Self::Real { .. }, Version::Fmi2) => "Real",
            (Self::Real { .. } | Self::Array { .. }, _) => "Float64",
            (Self::Integer { .. }, Version::Fmi2) => "Integer",
            (Self::Integer { .. }, Version::Fmi3) => "Int32",
            (Self::Size { .. }, _) => "UInt64",
            (Self::Enumeration { .. }, _) => "Enumeration",
            (Self::Boolean, _) => "Boolean",
            (Self::String, _) => "String",
        }
    }
}

/// Where the value of a variable lives.
#[derive(Clone, Copy)]
pub enum Source {
    /// Simulated time.
    Time,
    /// A parameter of the scenario.
    Parameter(Parameter),
    /// Set by the master at communication points.
    Input(&'static Input),
    /// A result of the kernel.
    Output(&'static Output),
    /// Time that the kernel has reached.
    KernelTime,
    /// Time step of the kernel.
    TimeStep,
    /// Number of elements.
    Elements,
    /// Number of nodes along the surface.
    SurfaceNodes,
    /// Number of points of a profile.
    Points,
    /// A profile along the surface.
    Profile(Profile),
    /// Whether the impactor touches the layer.
    ContactActive,
    /// Digest of the force samples.
    TraceHash,
    /// Set by the master to ask for the next impact.
    NextImpact,
    /// Number of the impact.
    ImpactNumber,
}

impl Variable {
    /// Whether `version` has the variable.
    pub fn is_in(&self, version: Version) -> bool {
        version == Version::Fmi3 || !matches!(self.value, ValueType::Array { .. } | ValueType::Size { .. })
    }

    /// FMI's name for the role of the variable.
    pub fn causality(&self) -> &'static str {
        match self.source {
            Source::Time => "independent",
            Source::Parameter(_) => "parameter",
            Source::Input(_) | Source::NextImpact => "input",
            Source::Points => "structuralParameter",
            Source::TimeStep | Source::Elements | Source::SurfaceNodes => "calculatedParameter",
            Source::Output(_) | Source::KernelTime | Source::Profile(_) => "output",
            Source::ContactActive | Source::TraceHash | Source::ImpactNumber => "output",
        }
    }

    /// FMI's name for when the value can change.
    pub fn variability(&self) -> &'static str {
        match self.source {
            Source::Time | Source::Output(_) | Source::KernelTime | Source::Profile(_) => "continuous",
            Source::Input(input) => input.variability,
            Source::Parameter(_) | Source::Points | Source::TimeStep | Source::Elements | Source::SurfaceNodes => {
                "fixed"
            }
            Source::ContactActive | Source::TraceHash | Source::NextImpact | Source::ImpactNumber => "discrete",
        }
    }

    /// FMI's name for how the value comes about before the first step; none where the standard forbids the attribute.
    pub fn initial(&self) -> Option<&'static str> {
        match self.source {
            Source::Time | Source::Input(_) | Source::NextImpact => None,
            Source::Parameter(_) | Source::Points => Some("exact"),
            _ => Some("calculated"),
        }
    }

    /// Value of a new instance, for what a master can set; a choice as its number, a state as 0 or 1.
    pub fn start(&self) -> Option<f64> {
        match self.source {
            Source::Parameter(parameter) => Some(parameter.get(&preset::study())),
            Source::Input(input) => Some(*(input.field)(&mut Inputs::start())),
            Source::Points => Some(profile::START_POINTS as f64),
            Source::NextImpact => Some(f64::from(u8::from(Inputs::start().next_impact))),
            _ => None,
        }
    }
}
