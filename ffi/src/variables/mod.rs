//! The table of FMI variables. It serves the getters, the setters and the model descriptions of both versions alike.
//!
//! Parameters and outputs come from the kernel's tables; only what a master sees and the kernel does not stands here:
//! time, inputs, and what an instance knows about its model.

pub mod profile;
pub mod references;
mod token;
pub mod units;

use softanvil_kernel::input::{INPUTS as ROWS, InputRow};
use softanvil_kernel::parameter::Kind;
use softanvil_kernel::{OUTPUTS, Output, PARAMETERS, Parameter, ParameterError, Scenario, StepInput, preset};

use profile::Profile;
pub use token::{Token, token};

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
    pub name: &'static str,
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
    Integer,
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
            (Self::Integer, Version::Fmi2) => "Integer",
            (Self::Integer, Version::Fmi3) => "Int32",
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
    Parameter(&'static Parameter),
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
}

/// What the master gives at communication points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inputs {
    /// Upward force on a falling impactor, N.
    pub external_force: f64,
    /// Height of a driven impactor at the end of the communication step, m.
    pub driven_position: f64,
    /// Velocity of a driven impactor at the end of the communication step, m/s.
    pub driven_velocity: f64,
    /// Whether the master gives the position: whether it has ever set one.
    pub has_position: bool,
    /// Whether the master gives the velocity: whether it has ever set one.
    pub has_velocity: bool,
}

impl Inputs {
    /// No force, and the impactor at rest where the preset has it.
    pub fn start() -> Self {
        Self {
            external_force: 0.0,
            driven_position: preset::study().impactor.gap,
            driven_velocity: 0.0,
            has_position: false,
            has_velocity: false,
        }
    }

    /// The same for the impactor of `scenario`, which stays where that puts it until the master gives a position.
    pub fn in_scenario(self, scenario: &Scenario) -> Self {
        let driven_position = if self.has_position { self.driven_position } else { scenario.impactor.gap };
        Self { driven_position, ..self }
    }

    /// What acts on the impactor during a communication step.
    pub fn to_kernel(self) -> StepInput {
        StepInput {
            external_force: self.external_force,
            driven_position: Some(self.driven_position),
            driven_velocity: self.has_velocity.then_some(self.driven_velocity),
        }
    }
}

/// One row of the table of inputs.
pub struct Input {
    reference: u32,
    row: &'static InputRow,
    /// The field in the inputs.
    pub field: fn(&mut Inputs) -> &mut f64,
    description: &'static str,
}

impl Input {
    /// Sets `value` in `inputs`, if it is finite and in range.
    ///
    /// A velocity is given from the first one on that is not 0: importers that set every start value give none by that.
    ///
    /// # Errors
    /// The name, value, unit and legal range of a refused value.
    pub fn set(&self, inputs: &mut Inputs, value: f64) -> Result<(), ParameterError> {
        self.row.check(value)?;
        *(self.field)(inputs) = value;
        inputs.has_position |= self.reference == references::DRIVEN_POSITION;
        inputs.has_velocity |= inputs.driven_velocity != 0.0;
        Ok(())
    }
}

/// Every input.
pub static INPUTS: &[Input] = &[
    Input {
        reference: references::EXTERNAL_FORCE,
        row: &ROWS[0],
        field: |inputs| &mut inputs.external_force,
        description: "upward force on a falling impactor besides gravity and contact, held over the kernel \
                      steps of a communication step",
    },
    Input {
        reference: references::DRIVEN_POSITION,
        row: &ROWS[1],
        field: |inputs| &mut inputs.driven_position,
        description: "height of the face of a driven impactor at the end of the communication step that follows, to which \
                      it moves from where it is; impactor.gap until it is set",
    },
    Input {
        reference: references::DRIVEN_VELOCITY,
        row: &ROWS[2],
        field: |inputs| &mut inputs.driven_velocity,
        description: "upward velocity of a driven impactor at the end of the communication step that follows: once it has \
                      been other than 0 the face moves along a cubic, before along straight lines",
    },
];

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
            Source::Input(_) => "input",
            Source::Points => "structuralParameter",
            Source::TimeStep | Source::Elements | Source::SurfaceNodes => "calculatedParameter",
            Source::Output(_) | Source::KernelTime | Source::Profile(_) | Source::ContactActive | Source::TraceHash => {
                "output"
            }
        }
    }

    /// FMI's name for when the value can change.
    pub fn variability(&self) -> &'static str {
        match self.source {
            Source::Time | Source::Input(_) | Source::Output(_) | Source::KernelTime | Source::Profile(_) => {
                "continuous"
            }
            Source::Parameter(_) | Source::Points | Source::TimeStep | Source::Elements | Source::SurfaceNodes => {
                "fixed"
            }
            Source::ContactActive | Source::TraceHash => "discrete",
        }
    }

    /// FMI's name for how the value comes about before the first step; none where the standard forbids the attribute.
    pub fn initial(&self) -> Option<&'static str> {
        match self.source {
            Source::Time | Source::Input(_) => None,
            Source::Parameter(_) | Source::Points => Some("exact"),
            _ => Some("calculated"),
        }
    }

    /// Value of a new instance, for what a master can set; a choice as its number.
    pub fn start(&self) -> Option<f64> {
        match self.source {
            Source::Parameter(parameter) => Some(parameter.get(&preset::study())),
            Source::Input(input) => Some(*(input.field)(&mut Inputs::start())),
            Source::Points => Some(profile::START_POINTS as f64),
            _ => None,
        }
    }

    fn of_parameter(parameter: &'static Parameter) -> Option<Self> {
        let value = match parameter.kind {
            Kind::Real { unit, min, max, .. } => ValueType::Real { unit, range: Some((min, max)) },
            Kind::Choice { labels, .. } => ValueType::Enumeration { labels },
        };
        Some(Self {
            reference: references::reference_of(references::PARAMETERS, parameter.name)?,
            name: parameter.name,
            description: parameter.description,
            value,
            source: Source::Parameter(parameter),
        })
    }

    fn of_input(input: &'static Input) -> Self {
        Self {
            reference: input.reference,
            name: input.row.name,
            description: input.description,
            value: ValueType::Real { unit: input.row.unit, range: Some(input.row.range) },
            source: Source::Input(input),
        }
    }

    fn of_output(output: &'static Output) -> Option<Self> {
        Some(Self {
            reference: references::reference_of(references::OUTPUTS, output.name)?,
            name: output.name,
            description: output.description,
            value: ValueType::Real { unit: output.unit, range: None },
            source: Source::Output(output),
        })
    }
}

/// Simulated time.
static TIME: Variable = Variable {
    reference: references::TIME,
    name: "time",
    description: "time of the communication point",
    value: ValueType::Real { unit: "s", range: None },
    source: Source::Time,
};

/// What an instance knows about its model and state besides the kernel's outputs.
static MODEL: [Variable; 6] = [
    Variable {
        reference: references::KERNEL_TIME,
        name: "model.time",
        description: "time that the kernel has reached: that of its step nearest to time, to which all outputs belong",
        value: ValueType::Real { unit: "s", range: None },
        source: Source::KernelTime,
    },
    Variable {
        reference: references::TIME_STEP,
        name: "model.time_step",
        description: "time step of the kernel, which goes to the step nearest to each communication point",
        value: ValueType::Real { unit: "s", range: None },
        source: Source::TimeStep,
    },
    Variable {
        reference: references::ELEMENTS,
        name: "model.elements",
        description: "number of elements of the mesh",
        value: ValueType::Integer,
        source: Source::Elements,
    },
    Variable {
        reference: references::SURFACE_NODES,
        name: "model.surface_nodes",
        description: "number of nodes along the surface of the mesh",
        value: ValueType::Integer,
        source: Source::SurfaceNodes,
    },
    Variable {
        reference: references::CONTACT_ACTIVE,
        name: "contact.active",
        description: "whether the impactor touched the layer in the last step",
        value: ValueType::Boolean,
        source: Source::ContactActive,
    },
    Variable {
        reference: references::TRACE_HASH,
        name: "result.trace_hash",
        description: "digest (FNV-1a, 64 bit, hexadecimal) of all force samples so far: equal runs have equal digests",
        value: ValueType::String,
        source: Source::TraceHash,
    },
];

/// How many variables there are.
const COUNT: usize = 1
    + references::PARAMETERS.len()
    + INPUTS.len()
    + references::OUTPUTS.len()
    + MODEL.len()
    + profile::VARIABLES.len();

/// Groups of references by their hundreds.
const GROUPS: usize = 70;

/// All variables, in ascending order of their references.
pub struct Table {
    rows: [Variable; COUNT],
    /// First row of each group of references.
    first: [u16; GROUPS],
    digest: u64,
}

impl Table {
    /// The table, made from the kernel's.
    pub fn new() -> Self {
        let mut all = PARAMETERS
            .iter()
            .filter_map(Variable::of_parameter)
            .chain(INPUTS.iter().map(Variable::of_input))
            .chain(OUTPUTS.iter().filter_map(Variable::of_output))
            .chain(MODEL)
            .chain(profile::VARIABLES);
        let mut rows = core::array::from_fn(|_| all.next().unwrap_or(TIME));
        rows.sort_unstable_by_key(|variable: &Variable| variable.reference);
        let first = core::array::from_fn(|group| {
            rows.partition_point(|variable| variable.reference < references::GROUP * group as u32) as u16
        });
        let digest = token::digest(0, &rows);
        Self { rows, first, digest }
    }

    /// Every variable.
    pub fn rows(&self) -> &[Variable] {
        &self.rows
    }

    /// Digest of everything that a master can know of the table, which a saved state must match.
    pub fn digest(&self) -> u64 {
        self.digest
    }

    /// The variable that a master calls `reference`.
    pub fn find(&self, reference: u32) -> Option<&Variable> {
        let first = usize::from(*self.first.get((reference / references::GROUP) as usize)?);
        let place = first + (reference % references::GROUP) as usize;
        match self.rows.get(place) {
            Some(variable) if variable.reference == reference => Some(variable),
            // None, or one behind a gap in its group.
            _ => {
                let row = self.rows.binary_search_by_key(&reference, |variable| variable.reference).ok()?;
                self.rows.get(row)
            }
        }
    }
}

impl Default for Table {
    fn default() -> Self {
        Self::new()
    }
}

/// Whether two scenarios agree in every bit.
pub(crate) fn same_bits(a: &Scenario, b: &Scenario) -> bool {
    PARAMETERS.iter().all(|parameter| parameter.get(a).to_bits() == parameter.get(b).to_bits())
}

#[cfg(test)]
mod tests;
