//! The table: every variable by its reference.

use softanvil_kernel::parameter::{Kind, Name};
use softanvil_kernel::{OUTPUTS, Output, Parameter, Scenario};

use super::digest::digest;
use super::inputs::{INPUTS, Input};
use super::profile::{POINTS, Profile};
use super::references;
use super::variable::{Source, ValueType, Variable};

impl Variable {
    fn of_parameter(parameter: Parameter) -> Self {
        let (min, max) = parameter.range();
        let value = match parameter.kind() {
            Kind::Quantity => ValueType::Real { unit: parameter.unit(), range: Some((min, max)) },
            Kind::Count => ValueType::Integer { range: Some((min as i32, max as i32)) },
            Kind::Choice { labels } => ValueType::Enumeration { labels },
        };
        Self {
            reference: references::of_parameter(parameter),
            name: parameter.name(),
            description: parameter.description(),
            value,
            source: Source::Parameter(parameter),
        }
    }

    fn of_input(input: &'static Input) -> Self {
        Self {
            reference: input.reference,
            name: Name::new(input.name),
            description: input.description,
            value: ValueType::Real { unit: input.unit, range: Some(input.range) },
            source: Source::Input(input),
        }
    }

    fn of_output(output: &'static Output) -> Self {
        Self {
            reference: references::of_output(output),
            name: output.name.into(),
            description: output.description,
            value: ValueType::Real { unit: output.unit, range: None },
            source: Source::Output(output),
        }
    }
}

/// Simulated time.
static TIME: Variable = Variable {
    reference: references::TIME,
    name: Name::new("time"),
    description: "time of the communication point",
    value: ValueType::Real { unit: "s", range: None },
    source: Source::Time,
};

/// What an instance knows about its model and state besides the kernel's outputs.
static MODEL: [Variable; 6] = [
    Variable {
        reference: references::KERNEL_TIME,
        name: Name::new("model.time"),
        description: "time that the kernel has reached: that of its step nearest to time, to which all outputs belong",
        value: ValueType::Real { unit: "s", range: None },
        source: Source::KernelTime,
    },
    Variable {
        reference: references::TIME_STEP,
        name: Name::new("model.time_step"),
        description: "time step of the kernel, which goes to the step nearest to each communication point",
        value: ValueType::Real { unit: "s", range: None },
        source: Source::TimeStep,
    },
    Variable {
        reference: references::ELEMENTS,
        name: Name::new("model.elements"),
        description: "number of elements of the mesh",
        value: ValueType::Integer { range: None },
        source: Source::Elements,
    },
    Variable {
        reference: references::SURFACE_NODES,
        name: Name::new("model.surface_nodes"),
        description: "number of nodes along the surface of the mesh",
        value: ValueType::Integer { range: None },
        source: Source::SurfaceNodes,
    },
    Variable {
        reference: references::CONTACT_ACTIVE,
        name: Name::new("contact.active"),
        description: "whether the impactor touched the layer in the last step",
        value: ValueType::Boolean,
        source: Source::ContactActive,
    },
    Variable {
        reference: references::TRACE_HASH,
        name: Name::new("result.trace_hash"),
        description: "digest (FNV-1a, 64 bit, hexadecimal) of all force samples so far: equal runs have equal digests",
        value: ValueType::String,
        source: Source::TraceHash,
    },
];

/// Impacts one after the other.
static IMPACTS: [Variable; 2] = [
    Variable {
        reference: references::NEXT_IMPACT,
        name: Name::new("impact.next"),
        description: "where it is true and was false at the communication point before, the impactor falls again as at the \
                      start, on the anvil as the last impact left it after impact.rest: outputs begin anew, damage stays",
        value: ValueType::Boolean,
        source: Source::NextImpact,
    },
    Variable {
        reference: references::IMPACT_NUMBER,
        name: Name::new("impact.number"),
        description: "number of the impact, from 1: impacts on the same anvil so far",
        value: ValueType::Integer { range: None },
        source: Source::ImpactNumber,
    },
];

const fn profile(
    reference: u32,
    name: &'static str,
    unit: &'static str,
    shows: Profile,
    text: &'static str,
) -> Variable {
    let value = ValueType::Array { unit };
    Variable { reference, name: Name::new(name), description: text, value, source: Source::Profile(shows) }
}

/// The number of points and the profiles.
static SURFACE: [Variable; 4] = [
    Variable {
        reference: references::SURFACE_POINTS,
        name: Name::new("surface.points"),
        description: "points of the profiles surface.x, surface.height and surface.contact_pressure, spread evenly over \
                      the surface at rest; with as many as model.surface_nodes they are its nodes",
        value: ValueType::Size { range: POINTS },
        source: Source::Points,
    },
    profile(
        references::SURFACE_X,
        "surface.x",
        "m",
        Profile::X,
        "current distance of the points of the surface from the centre line",
    ),
    profile(
        references::SURFACE_HEIGHT,
        "surface.height",
        "m",
        Profile::Height,
        "current height of the points of the surface above the top of the undeformed anvil",
    ),
    profile(
        references::SURFACE_CONTACT_PRESSURE,
        "surface.contact_pressure",
        "Pa",
        Profile::ContactPressure,
        "contact pressure at the points of the surface in the last step",
    ),
];

/// How many variables there are.
const COUNT: usize = 1 + Parameter::COUNT + INPUTS.len() + OUTPUTS.len() + MODEL.len() + IMPACTS.len() + SURFACE.len();

/// Groups of references by their hundreds.
const GROUPS: usize = 80;

/// All variables, in ascending order of their references.
pub struct Table {
    pub(super) rows: [Variable; COUNT],
    /// First row of each group of references.
    first: [u16; GROUPS],
    digest: u64,
}

impl Table {
    /// The table, made from the kernel's.
    pub fn new() -> Self {
        let mut all = Parameter::all()
            .map(Variable::of_parameter)
            .chain(INPUTS.iter().map(Variable::of_input))
            .chain(OUTPUTS.iter().map(Variable::of_output))
            .chain(MODEL)
            .chain(IMPACTS)
            .chain(SURFACE);
        let mut rows = core::array::from_fn(|_| all.next().unwrap_or(TIME));
        rows.sort_unstable_by_key(|variable: &Variable| variable.reference);
        let first = core::array::from_fn(|group| {
            rows.partition_point(|variable| variable.reference < references::GROUP * group as u32) as u16
        });
        let digest = digest(0, &rows);
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
    Parameter::all().all(|parameter| parameter.get(a).to_bits() == parameter.get(b).to_bits())
}
