//! Why a call was refused.

use core::fmt;

use softanvil_kernel::number::decimal::Decimal;
use softanvil_kernel::parameter::Name;
use softanvil_kernel::{
    MemoryError, ModelError, NoEffect, Parameter, ParameterError, ScenarioError, SnapshotError, StepError,
};

use crate::c_api::status::SoftanvilStatus as Status;

/// `SOFTANVIL_NONE` in the header: no parameter, no element.
pub(crate) const NONE: u32 = u32::MAX;

/// Why a call failed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Failure {
    Null { argument: &'static str },
    Misaligned { argument: &'static str, alignment: usize },
    Short { argument: &'static str, given: usize, needed: usize },
    Long { argument: &'static str, given: usize },
    Uninitialised { argument: &'static str },
    UnknownId { argument: &'static str, id: u32, largest: u32 },
    RetiredId { argument: &'static str, id: u32 },
    UnknownName { argument: &'static str },
    ReservedSlot { array: &'static str, slot: usize, value: f64 },
    Time { time: f64, min: f64, max: f64 },
    Scenario(ScenarioError),
    Model(ModelError),
    Step(StepError),
    Snapshot(SnapshotError),
}

impl From<ParameterError> for Failure {
    fn from(error: ParameterError) -> Self {
        Self::Scenario(ScenarioError::Parameter(error))
    }
}

impl From<ModelError> for Failure {
    fn from(error: ModelError) -> Self {
        match error {
            ModelError::Scenario(error) => Self::Scenario(error),
            error => Self::Model(error),
        }
    }
}

impl From<MemoryError> for Failure {
    fn from(error: MemoryError) -> Self {
        Self::Model(ModelError::Memory(error))
    }
}

impl From<StepError> for Failure {
    fn from(error: StepError) -> Self {
        Self::Step(error)
    }
}

impl From<SnapshotError> for Failure {
    fn from(error: SnapshotError) -> Self {
        match error {
            SnapshotError::Length { given, needed } => Self::Short { argument: "bytes", given, needed },
            error => Self::Snapshot(error),
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Null { argument } => write!(f, "{argument} is a null pointer"),
            Self::Misaligned { argument, alignment } => {
                write!(f, "{argument} is misaligned: expected a multiple of {alignment} bytes")
            }
            Self::Short { argument, given, needed } => {
                write!(f, "{argument} has {given} bytes: expected at least {needed} bytes")
            }
            Self::Long { argument, given } => {
                write!(f, "{argument} has {given} bytes: expected at most {} bytes", isize::MAX)
            }
            Self::Uninitialised { argument } => {
                write!(f, "{argument} was not initialised by this library, was closed, or was overwritten")
            }
            Self::UnknownId { argument, id, largest } => {
                write!(f, "{argument} {id} is unknown: expected one of the table, up to {largest}")
            }
            Self::RetiredId { argument, id } => write!(f, "{argument} {id} is retired: expected any other number"),
            Self::UnknownName { argument } => write!(f, "{argument} is not in the table"),
            Self::ReservedSlot { array, slot, value } => {
                let value = Decimal(*value);
                write!(f, "{array}[{slot}] = {value} is refused: it has no meaning in this version, expected 0")
            }
            Self::Time { time, min, max } => {
                let [time, min, max] = [*time, *min, *max].map(Decimal);
                write!(f, "time {time} s is refused: expected {min} s, half a step before the present, to {max} s")
            }
            Self::Scenario(error) => error.fmt(f),
            Self::Model(error) => error.fmt(f),
            Self::Step(error) => error.fmt(f),
            Self::Snapshot(error) => error.fmt(f),
        }
    }
}

fn scenario_status(error: &ScenarioError) -> Status {
    match error {
        ScenarioError::Parameter(_) => Status::IllegalValue,
        ScenarioError::NoEffect(_) => Status::NoEffect,
        ScenarioError::Contradiction { .. } => Status::Contradiction,
        ScenarioError::LayerThickness { .. } => Status::LayerThickness,
        ScenarioError::PronySum { .. } => Status::PronySum,
        ScenarioError::ShearModulus { .. } => Status::ShearModulus,
        ScenarioError::FaceTooSmall { .. } => Status::FaceTooSmall,
        ScenarioError::FaceOfFormulation { .. } => Status::FaceOfFormulation,
        ScenarioError::FullAxisymmetric => Status::FullAxisymmetric,
        ScenarioError::OffsetOfHalf { .. } => Status::OffsetOfHalf,
        ScenarioError::TearStretch { .. } => Status::TearStretch,
        ScenarioError::Softening { .. } => Status::Softening,
        ScenarioError::BulkModulus { .. } => Status::BulkModulus,
        ScenarioError::LayerWidth { .. } => Status::LayerWidth,
        ScenarioError::WithoutPads { .. } => Status::WithoutPads,
        ScenarioError::NotInSolid { .. } => Status::NotInSolid,
    }
}

impl Failure {
    pub(crate) fn status(&self) -> Status {
        match self {
            Self::Null { .. } => Status::NullPointer,
            Self::Misaligned { .. } => Status::Misaligned,
            Self::Short { .. } | Self::Long { .. } => Status::ShortBuffer,
            Self::Uninitialised { .. } => Status::Uninitialised,
            Self::UnknownId { .. } | Self::RetiredId { .. } => Status::UnknownId,
            Self::UnknownName { .. } => Status::UnknownName,
            Self::ReservedSlot { .. } => Status::ReservedSlot,
            Self::Time { .. } => Status::IllegalTime,
            Self::Scenario(error) | Self::Model(ModelError::Scenario(error)) => scenario_status(error),
            Self::Model(ModelError::TooManyCells { .. }) => Status::TooManyCells,
            Self::Model(ModelError::StepTooSmall { .. }) => Status::StepTooSmall,
            Self::Model(ModelError::StepTooLarge { .. }) => Status::StepTooLarge,
            Self::Model(ModelError::NoArea { .. } | ModelError::NoVolume { .. }) => Status::NoArea,
            Self::Model(ModelError::Memory(_)) | Self::Step(StepError::Memory(_)) => Status::ShortBuffer,
            Self::Step(StepError::Inverted { .. }) => Status::Inverted,
            Self::Step(StepError::Unstable { .. }) => Status::Unstable,
            Self::Step(StepError::Input { .. }) => Status::IllegalInput,
            Self::Snapshot(SnapshotError::Length { .. } | SnapshotError::Memory(_)) => Status::ShortBuffer,
            Self::Snapshot(SnapshotError::Format | SnapshotError::Version { .. }) => Status::SnapshotFormat,
            Self::Snapshot(SnapshotError::Foreign) => Status::SnapshotForeign,
            Self::Snapshot(SnapshotError::Corrupt) => Status::SnapshotCorrupt,
            Self::Snapshot(SnapshotError::Failed) => Status::SnapshotFailed,
        }
    }

    /// Refused value, smallest and largest legal value.
    pub(crate) fn numbers(&self) -> [f64; 3] {
        const NAN: f64 = f64::NAN;
        match *self {
            Self::Short { given, needed, .. } => [given as f64, needed as f64, NAN],
            Self::Long { given, .. } => [given as f64, NAN, isize::MAX as f64],
            Self::UnknownId { id, largest, .. } => [f64::from(id), 0.0, f64::from(largest)],
            Self::RetiredId { id, .. } => [f64::from(id), NAN, NAN],
            Self::ReservedSlot { value, .. } => [value, 0.0, 0.0],
            Self::Time { time, min, max } => [time, min, max],
            Self::Scenario(ScenarioError::Parameter(ParameterError { value, min, max, .. })) => [value, min, max],
            Self::Scenario(ScenarioError::NoEffect(NoEffect { value, .. })) => [value, NAN, NAN],
            Self::Scenario(ScenarioError::LayerThickness { thickness, minimum, .. }) => [thickness, minimum, NAN],
            Self::Scenario(ScenarioError::LayerWidth { width, maximum, .. }) => [width, 0.0, maximum],
            Self::Scenario(ScenarioError::PronySum { sum, .. }) => [sum, 0.0, 1.0],
            Self::Scenario(ScenarioError::ShearModulus { modulus, .. }) => [modulus, 0.0, NAN],
            Self::Scenario(ScenarioError::FaceTooSmall { width, minimum, .. }) => [width, minimum, NAN],
            Self::Scenario(ScenarioError::OffsetOfHalf { offset }) => [offset, 0.0, 0.0],
            Self::Scenario(ScenarioError::TearStretch { stretch, .. }) => [stretch, 1.0, NAN],
            Self::Scenario(ScenarioError::Softening { r, .. }) => [r, 1.0, NAN],
            Self::Scenario(ScenarioError::BulkModulus { modulus, .. }) => [modulus, 0.0, NAN],
            Self::Model(ModelError::TooManyCells { cells, max }) => [cells, 1.0, max as f64],
            Self::Model(ModelError::StepTooSmall { step, smallest, .. }) => [step, smallest, NAN],
            Self::Model(ModelError::StepTooLarge { step, limit }) => [step, 0.0, limit],
            Self::Step(StepError::Unstable { limit, step, .. }) => [step, 0.0, limit],
            Self::Snapshot(SnapshotError::Version { given, expected }) => {
                [given as f64, expected as f64, expected as f64]
            }
            Self::Step(StepError::Input { error, .. }) => [error.value, error.min, error.max],
            Self::Model(ModelError::Memory(error)) | Self::Step(StepError::Memory(error)) => {
                [error.given as f64, error.needed as f64, NAN]
            }
            _ => [NAN; 3],
        }
    }

    /// Number of the parameter that is to blame.
    pub(crate) fn parameter(&self) -> u32 {
        let found = self.blamed().and_then(|name| Parameter::all().find(|parameter| parameter.name() == name));
        found.map_or(NONE, |parameter| parameter.number())
    }

    /// Name of the parameter that is to blame.
    fn blamed(&self) -> Option<Name> {
        Some(match *self {
            Self::Scenario(ScenarioError::Parameter(error)) => error.name,
            Self::Scenario(ScenarioError::NoEffect(error)) => error.name,
            Self::Scenario(ScenarioError::Contradiction { names: [_, other] }) => other,
            Self::Scenario(ScenarioError::LayerThickness { layer, .. }) => Name::of_layer(layer, "thickness"),
            Self::Scenario(ScenarioError::LayerWidth { layer, .. }) => Name::of_layer(layer, "width"),
            Self::Scenario(ScenarioError::TearStretch { layer, .. }) => Name::of_layer(layer, "tear_stretch"),
            Self::Scenario(ScenarioError::Softening { layer, .. }) => Name::of_layer(layer, "softening_r"),
            Self::Scenario(ScenarioError::FaceTooSmall { name, .. }) => name.into(),
            Self::Scenario(ScenarioError::WithoutPads { name } | ScenarioError::NotInSolid { name, .. }) => name,
            Self::Scenario(ScenarioError::FaceOfFormulation { .. }) => "impactor.shape".into(),
            Self::Scenario(ScenarioError::FullAxisymmetric) => "geometry.section".into(),
            Self::Scenario(ScenarioError::OffsetOfHalf { .. }) => "impactor.offset".into(),
            Self::Model(ModelError::TooManyCells { .. }) => "mesh.element_size".into(),
            Self::Model(ModelError::StepTooLarge { .. }) => "time.step".into(),
            _ => return None,
        })
    }

    /// Element that failed, and the time at which it did, s.
    pub(crate) fn place(&self) -> (u32, f64) {
        match *self {
            Self::Step(StepError::Inverted { element, time } | StepError::Unstable { element, time, .. }) => {
                (element, time)
            }
            Self::Step(StepError::Input { time, .. }) => (NONE, time),
            _ => (NONE, f64::NAN),
        }
    }
}

#[cfg(test)]
mod tests;
