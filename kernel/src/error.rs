//! What can go wrong, one enum per operation. Every message names the value, its unit and what is legal.

use core::fmt;

use crate::decimal::Decimal;
use crate::math;
use crate::real::Real;
use crate::sampling::SAMPLING_INTERVAL;
use crate::scenario::ElasticLaw;

/// A parameter value that is not legal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParameterError {
    /// Name of the parameter.
    pub name: &'static str,
    /// The refused value.
    pub value: Real,
    /// Unit of the value.
    pub unit: &'static str,
    /// Smallest legal value.
    pub min: Real,
    /// Largest legal value.
    pub max: Real,
}

/// Shows a quantity with its unit; "1" is not shown.
struct Quantity(Real, &'static str);

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.1 {
            "1" => write!(f, "{}", Decimal(self.0)),
            unit => write!(f, "{} {unit}", Decimal(self.0)),
        }
    }
}

impl fmt::Display for ParameterError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let legal = Quantity(self.max, self.unit);
        let (value, min) = (Quantity(self.value, self.unit), Decimal(self.min));
        write!(f, "{} = {value} is refused: expected {min} to {legal}", self.name)
    }
}

impl core::error::Error for ParameterError {}

/// A value that has no effect in its scenario.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NoEffect {
    /// Name of the parameter.
    pub name: &'static str,
    /// Its value.
    pub value: Real,
    /// Unit of the value.
    pub unit: &'static str,
    /// Name of the parameter that leaves it without effect.
    pub by: &'static str,
    /// What that says: the label of its choice, or nothing where it is 0.
    pub says: &'static str,
}

impl fmt::Display for NoEffect {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (value, says) = (Quantity(self.value, self.unit), if self.says.is_empty() { "0" } else { self.says });
        write!(f, "{} = {value} has no effect: {} is {says}", self.name, self.by)
    }
}

impl core::error::Error for NoEffect {}

/// A scenario that cannot be simulated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ScenarioError {
    /// One value is out of its range.
    Parameter(ParameterError),
    /// A given value has no effect.
    NoEffect(NoEffect),
    /// Two given values state the same thing.
    Contradiction {
        /// Names of their parameters.
        names: [&'static str; 2],
    },
    /// Another number of layers than in the base is given, but not how thick the silicone then is.
    LayerThickness {
        /// Whether two layers are given, or one.
        two: bool,
        /// Thickness of the silicone in the base, m.
        thickness: Real,
    },
    /// The Prony coefficients leave no long-term stiffness.
    PronySum {
        /// Group of the layer's parameters.
        layer: &'static str,
        /// sum g_i.
        sum: Real,
    },
    /// The elastic law has no positive shear modulus at rest.
    ShearModulus {
        /// Group of the layer's parameters.
        layer: &'static str,
        /// The law.
        law: ElasticLaw,
        /// Its shear modulus at rest, Pa.
        modulus: Real,
    },
    /// The material would be torn before the test.
    TearStretch {
        /// Group of the layer's parameters.
        layer: &'static str,
        /// Stretch at which it begins to tear.
        stretch: Real,
    },
    /// A skin with a material of its own has next to no thickness.
    SkinTooThin {
        /// Thickness of the skin, m.
        thickness: Real,
        /// Smallest legal thickness, m.
        minimum: Real,
    },
    /// The face does not cover the anvil, so the chord thickness ends inside the section.
    FaceTooSmall {
        /// Diameter of the face, m.
        diameter: Real,
        /// Smallest legal diameter for this anvil, m.
        minimum: Real,
    },
    /// A full section of a body of revolution.
    FullAxisymmetric,
    /// An impactor beside the centre line of a half section.
    OffsetOfHalf {
        /// Distance from the centre line, m.
        offset: Real,
    },
}

impl From<ParameterError> for ScenarioError {
    fn from(error: ParameterError) -> Self {
        Self::Parameter(error)
    }
}

impl fmt::Display for ScenarioError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Parameter(error) => error.fmt(f),
            Self::NoEffect(no_effect) => no_effect.fmt(f),
            Self::Contradiction { names: [one, other] } => {
                write!(f, "{one} and {other} state the same thing: expected one of them")
            }
            Self::LayerThickness { two, thickness } => {
                let (layers, of) = if *two { ("two", "the whole layer") } else { ("one", "the silicone alone") };
                let thickness = Decimal(*thickness);
                write!(
                    f,
                    "geometry.layers = {layers} needs geometry.silicone_thickness as well: {thickness} m is that of {of}"
                )
            }
            Self::PronySum { layer, sum } => {
                let sum = Decimal(*sum);
                write!(f, "{layer}.prony_g_1 to _5 sum to {sum}: expected a sum of at least 0 and below 1")
            }
            Self::ShearModulus { layer, law, modulus } => {
                let modulus = Decimal(*modulus);
                let coefficients = match law {
                    ElasticLaw::NeoHookean | ElasticLaw::Yeoh => "c10 gives",
                    ElasticLaw::MooneyRivlin => "c10 and c01 give",
                    ElasticLaw::Ogden => "ogden_mu_1 to _3 and ogden_alpha_1 to _3 give",
                };
                write!(f, "{layer}.{coefficients} a shear modulus of {modulus} Pa: expected above 0 Pa")
            }
            Self::TearStretch { layer, stretch } => {
                let stretch = Decimal(*stretch);
                write!(f, "{layer}.tear_stretch = {stretch} is refused: expected 0 (off) or at least 1")
            }
            Self::SkinTooThin { thickness, minimum } => {
                let (thickness, minimum) = (Decimal(*thickness), Decimal(*minimum));
                write!(
                    f,
                    "geometry.skin_thickness = {thickness} m is refused: with two layers expected at least {minimum} m"
                )
            }
            Self::FullAxisymmetric => {
                f.write_str("geometry.section = full is refused: legal with an axisymmetric formulation is half")
            }
            Self::OffsetOfHalf { offset } => {
                let offset = Decimal(*offset);
                write!(f, "impactor.offset = {offset} m is refused: legal with geometry.section = half is 0 m")
            }
            Self::FaceTooSmall { diameter, minimum } => {
                let (diameter, minimum) = (Decimal(*diameter), Decimal(*minimum));
                write!(
                    f,
                    "impactor.face_diameter = {diameter} m is refused: over this anvil expected at least {minimum} m"
                )
            }
        }
    }
}

impl core::error::Error for ScenarioError {}

/// Why a model or a state could not be built.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ModelError {
    /// The scenario is refused.
    Scenario(ScenarioError),
    /// The mesh would have more cells than [`crate::mesh::MAX_CELLS`].
    TooManyCells {
        /// Cells that the element size asks for.
        cells: Real,
    },
    /// The stable step is below the smallest divisor of the sampling interval that is offered.
    StepTooSmall {
        /// Stable step, s.
        step: Real,
        /// Smallest step, s.
        smallest: Real,
    },
    /// The given step is above the stability limit at rest.
    StepTooLarge {
        /// Given step, s.
        step: Real,
        /// Stability limit, s.
        limit: Real,
    },
    /// A triangle without area, or with its corners in the wrong order.
    NoArea {
        /// Index of the triangle.
        element: u32,
    },
    /// There is too little memory.
    Memory(MemoryError),
}

/// The memory given is smaller than [`crate::storage::Size`] says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MemoryError {
    /// What the memory is for.
    pub what: &'static str,
    /// Items given.
    pub given: usize,
    /// Items needed.
    pub needed: usize,
}

impl fmt::Display for MemoryError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { what, given, needed } = self;
        write!(f, "memory for {what} holds {given} items: expected at least {needed}")
    }
}

impl core::error::Error for MemoryError {}

impl From<ScenarioError> for ModelError {
    fn from(error: ScenarioError) -> Self {
        Self::Scenario(error)
    }
}

impl From<MemoryError> for ModelError {
    fn from(error: MemoryError) -> Self {
        Self::Memory(error)
    }
}

impl fmt::Display for ModelError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Scenario(error) => error.fmt(f),
            Self::TooManyCells { cells } => write!(
                f,
                "mesh.element_size asks for {} cells: expected 1 to {} (choose a larger size, in m)",
                Decimal(*cells),
                crate::mesh::MAX_CELLS
            ),
            Self::StepTooSmall { step, smallest } => {
                let (step, smallest) = (Decimal(*step), Decimal(*smallest));
                write!(f, "the stable time step is {step} s: expected at least {smallest} s (softer or coarser)")
            }
            Self::StepTooLarge { step, limit } => {
                let (step, limit) = (Decimal(*step), Decimal(*limit));
                write!(f, "time.step = {step} s is refused: expected above 0 s and up to {limit} s at rest")
            }
            Self::NoArea { element } => {
                write!(f, "element {element} has no area: expected corners in counter-clockwise order")
            }
            Self::Memory(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for ModelError {}

/// Why a step could not be completed. But for an input or a memory that is refused, the state stays as the failing step
/// left it, and every further step gives the same error until the state is reset or restored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StepError {
    /// A triangle turned inside out, or its shape is not finite.
    Inverted {
        /// Index of the triangle.
        element: u32,
        /// Simulated time, s.
        time: Real,
    },
    /// The step exceeds the current stability limit of a triangle.
    Unstable {
        /// Index of the triangle.
        element: u32,
        /// Simulated time, s.
        time: Real,
        /// Stability limit there, s.
        limit: Real,
        /// The fixed step, s.
        step: Real,
    },
    /// An input is not legal. No step is made, and the state is as before.
    Input {
        /// The input, its refused value and what is legal.
        error: ParameterError,
        /// Simulated time, s.
        time: Real,
    },
    /// There is too little memory for the state. No step is made.
    Memory(MemoryError),
}

impl From<MemoryError> for StepError {
    fn from(error: MemoryError) -> Self {
        Self::Memory(error)
    }
}

impl fmt::Display for StepError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Inverted { element, time } => {
                write!(f, "element {element} is inverted or not finite at {} s", Decimal(*time))
            }
            Self::Unstable { element, time, limit, step } => {
                let enough = Decimal(enough(*limit));
                let [time, limit, step] = [*time, *limit, *step].map(Decimal);
                write!(
                    f,
                    "the time step of {step} s is above the stability limit {limit} s of element {element} at {time} s: \
                     {enough} s would do there (time.step_by = given with time.step, or for a driven face a larger \
                     time.design_compression)"
                )
            }
            Self::Input { error, time } => write!(f, "{error} (input at {} s)", Decimal(*time)),
            Self::Memory(error) => error.fmt(f),
        }
    }
}

/// The largest step that is a whole divisor of the sampling interval and at least a tenth below `limit`, s.
fn enough(limit: Real) -> Real {
    SAMPLING_INTERVAL / math::ceil(SAMPLING_INTERVAL / (0.9 * limit))
}

impl core::error::Error for StepError {}

/// Why a saved state was refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SnapshotError {
    /// The buffer is not as long as the snapshot of this model.
    Length {
        /// Bytes given.
        given: usize,
        /// Bytes needed.
        needed: usize,
    },
    /// The bytes are not a snapshot of this format version.
    Format,
    /// The snapshot belongs to a different model.
    Foreign,
    /// The checksum does not match.
    Corrupt,
    /// The state has failed; there is nothing worth saving.
    Failed,
    /// There is too little memory.
    Memory(MemoryError),
}

impl From<MemoryError> for SnapshotError {
    fn from(error: MemoryError) -> Self {
        Self::Memory(error)
    }
}

impl fmt::Display for SnapshotError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length { given, needed } => {
                write!(f, "the snapshot buffer has {given} bytes: expected exactly {needed}")
            }
            Self::Format => f.write_str("the bytes are not a snapshot of this version"),
            Self::Foreign => f.write_str("the snapshot belongs to a different model"),
            Self::Corrupt => f.write_str("the snapshot's checksum does not match its content"),
            Self::Failed => f.write_str("the state has failed and cannot be saved: reset or restore it first"),
            Self::Memory(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for SnapshotError {}
