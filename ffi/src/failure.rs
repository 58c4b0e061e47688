//! Why a call was refused, and [`SoftanvilError`], how C learns the details.

use core::ffi::c_char;
use core::fmt::{self, Write};

use softanvil_kernel::decimal::Decimal;
use softanvil_kernel::{MemoryError, ModelError, NoEffect, ParameterError, ScenarioError, SnapshotError, StepError};

use crate::environment;
use crate::ids::PARAMETER_BY_ID;
use crate::ptr::Out;
use crate::status::SoftanvilStatus as Status;

/// Bytes of the text of a `SoftanvilError`, its NUL included.
pub const SOFTANVIL_ERROR_TEXT_SIZE: usize = 256;

/// `SOFTANVIL_NONE` in the header: no parameter, no element.
pub(crate) const NONE: u32 = u32::MAX;

/// Why a call failed. The caller owns it; a function writes the whole of it when it fails and leaves it alone when it
/// succeeds. Numbers that do not apply are NaN.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct SoftanvilError {
    /// The status that the function returned, a `SoftanvilStatus`.
    pub status: i32,
    /// Number of the refused parameter, a `SoftanvilParameter`; otherwise SOFTANVIL_NONE.
    pub parameter: u32,
    /// Index of the element that failed; otherwise SOFTANVIL_NONE.
    pub element: u32,
    /// Always 0.
    pub reserved_word: u32,
    /// The refused value, in the unit of what was refused: a parameter, a length in bytes, a time step in s.
    pub value: f64,
    /// Smallest legal value.
    pub min: f64,
    /// Largest legal value.
    pub max: f64,
    /// Simulated time of a failed step, s.
    pub time: f64,
    /// Always 0.
    pub reserved: [f64; 4],
    /// One line for people, with the value, its unit and what is legal; ends with a NUL.
    pub text: [c_char; SOFTANVIL_ERROR_TEXT_SIZE],
}

/// Why a call failed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Failure {
    Null { argument: &'static str },
    Misaligned { argument: &'static str, alignment: usize },
    Short { argument: &'static str, given: usize, needed: usize },
    Long { argument: &'static str, given: usize },
    Uninitialised { argument: &'static str },
    UnknownId { argument: &'static str, id: u32, count: usize },
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
            Self::UnknownId { argument, id, count } => {
                write!(f, "{argument} {id} is unknown: expected 0 to {}", count.saturating_sub(1))
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
        ScenarioError::FullAxisymmetric => Status::FullAxisymmetric,
        ScenarioError::OffsetOfHalf { .. } => Status::OffsetOfHalf,
        ScenarioError::TearStretch { .. } => Status::TearStretch,
        ScenarioError::SkinTooThin { .. } => Status::SkinTooThin,
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
            Self::Model(ModelError::NoArea { .. }) => Status::NoArea,
            Self::Model(ModelError::Memory(_)) | Self::Step(StepError::Memory(_)) => Status::ShortBuffer,
            Self::Step(StepError::Inverted { .. }) => Status::Inverted,
            Self::Step(StepError::Unstable { .. }) => Status::Unstable,
            Self::Step(StepError::Input { .. }) => Status::IllegalInput,
            Self::Snapshot(SnapshotError::Length { .. } | SnapshotError::Memory(_)) => Status::ShortBuffer,
            Self::Snapshot(SnapshotError::Format) => Status::SnapshotFormat,
            Self::Snapshot(SnapshotError::Foreign) => Status::SnapshotForeign,
            Self::Snapshot(SnapshotError::Corrupt) => Status::SnapshotCorrupt,
            Self::Snapshot(SnapshotError::Failed) => Status::SnapshotFailed,
        }
    }

    /// Refused value, smallest and largest legal value.
    fn numbers(&self) -> [f64; 3] {
        const NAN: f64 = f64::NAN;
        match *self {
            Self::Short { given, needed, .. } => [given as f64, needed as f64, NAN],
            Self::Long { given, .. } => [given as f64, NAN, isize::MAX as f64],
            Self::UnknownId { id, count, .. } => [f64::from(id), 0.0, count.saturating_sub(1) as f64],
            Self::RetiredId { id, .. } => [f64::from(id), NAN, NAN],
            Self::ReservedSlot { value, .. } => [value, 0.0, 0.0],
            Self::Time { time, min, max } => [time, min, max],
            Self::Scenario(ScenarioError::Parameter(ParameterError { value, min, max, .. })) => [value, min, max],
            Self::Scenario(ScenarioError::NoEffect(NoEffect { value, .. })) => [value, NAN, NAN],
            Self::Scenario(ScenarioError::LayerThickness { thickness, .. }) => [thickness, NAN, NAN],
            Self::Scenario(ScenarioError::PronySum { sum, .. }) => [sum, 0.0, 1.0],
            Self::Scenario(ScenarioError::ShearModulus { modulus, .. }) => [modulus, 0.0, NAN],
            Self::Scenario(ScenarioError::FaceTooSmall { diameter, minimum }) => [diameter, minimum, NAN],
            Self::Scenario(ScenarioError::OffsetOfHalf { offset }) => [offset, 0.0, 0.0],
            Self::Scenario(ScenarioError::TearStretch { stretch, .. }) => [stretch, 1.0, NAN],
            Self::Scenario(ScenarioError::SkinTooThin { thickness, minimum }) => [thickness, minimum, NAN],
            Self::Model(ModelError::TooManyCells { cells }) => [cells, 1.0, softanvil_kernel::mesh::MAX_CELLS as f64],
            Self::Model(ModelError::StepTooSmall { step, smallest }) => [step, smallest, NAN],
            Self::Model(ModelError::StepTooLarge { step, limit }) => [step, 0.0, limit],
            Self::Step(StepError::Unstable { limit, step, .. }) => [step, 0.0, limit],
            Self::Step(StepError::Input { error, .. }) => [error.value, error.min, error.max],
            Self::Model(ModelError::Memory(error)) | Self::Step(StepError::Memory(error)) => {
                [error.given as f64, error.needed as f64, NAN]
            }
            _ => [NAN; 3],
        }
    }

    /// Number of the parameter that is to blame.
    fn parameter(&self) -> u32 {
        let name = match self {
            Self::Scenario(ScenarioError::Parameter(error)) => error.name,
            Self::Scenario(ScenarioError::NoEffect(error)) => error.name,
            Self::Scenario(ScenarioError::Contradiction { names: [_, other] }) => other,
            Self::Scenario(ScenarioError::LayerThickness { .. }) => "geometry.silicone_thickness",
            Self::Scenario(ScenarioError::FaceTooSmall { .. }) => "impactor.face_diameter",
            Self::Scenario(ScenarioError::SkinTooThin { .. }) => "geometry.skin_thickness",
            Self::Scenario(ScenarioError::FullAxisymmetric) => "geometry.section",
            Self::Scenario(ScenarioError::OffsetOfHalf { .. }) => "impactor.offset",
            Self::Model(ModelError::TooManyCells { .. }) => "mesh.element_size",
            Self::Model(ModelError::StepTooLarge { .. }) => "time.step",
            _ => return NONE,
        };
        (0..).zip(PARAMETER_BY_ID).find(|(_, row)| row.name == name).map_or(NONE, |(id, _)| id)
    }

    /// Element that failed, and the time at which it did, s.
    fn place(&self) -> (u32, f64) {
        match *self {
            Self::Step(StepError::Inverted { element, time } | StepError::Unstable { element, time, .. }) => {
                (element, time)
            }
            Self::Step(StepError::Input { time, .. }) => (NONE, time),
            _ => (NONE, f64::NAN),
        }
    }

    /// Everything that C learns.
    pub(crate) fn details(&self) -> SoftanvilError {
        let [value, min, max] = self.numbers();
        let (element, time) = self.place();
        let mut text = [0; SOFTANVIL_ERROR_TEXT_SIZE];
        let _ = write!(Text::new(&mut text), "{self}");
        SoftanvilError {
            status: self.status() as i32,
            parameter: self.parameter(),
            element,
            reserved_word: 0,
            value,
            min,
            max,
            time,
            reserved: [0.0; 4],
            text,
        }
    }
}

/// Text in a fixed array of characters: cut off where the array ends, always closed by a NUL.
struct Text<'a> {
    room: core::slice::IterMut<'a, c_char>,
}

impl<'a> Text<'a> {
    /// Fills `array` with NULs and writes from its front.
    fn new(array: &'a mut [c_char]) -> Self {
        array.fill(0);
        let room = array.len().saturating_sub(1);
        Self { room: array.get_mut(..room).unwrap_or_default().iter_mut() }
    }
}

impl Write for Text<'_> {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        // The text leads, because the side that leads loses an item when the other side ends.
        for (byte, place) in text.bytes().zip(self.room.by_ref()) {
            *place = byte as c_char;
        }
        Ok(())
    }
}

/// `text` as C reads it; None if the array is too short for it.
pub(crate) fn characters<const N: usize>(text: &str) -> Option<[c_char; N]> {
    let mut array = [0; N];
    let _ = Text::new(&mut array).write_str(text);
    (text.len() < N).then_some(array)
}

/// Does `work` in the default floating-point environment; what it refuses becomes a status, and details in `error` if the
/// caller wants them. A bad `error` is refused before anything is done.
pub(crate) fn report(
    error: Result<Option<Out<SoftanvilError>>, Failure>,
    work: impl FnOnce() -> Result<(), Failure>,
) -> Status {
    let error = match error {
        Ok(error) => error,
        Err(failure) => return failure.status(),
    };
    match environment::neutral(work) {
        Ok(()) => Status::Ok,
        Err(failure) => {
            if let Some(error) = error {
                error.write(failure.details());
            }
            failure.status()
        }
    }
}

/// As [`report`], for functions without details.
pub(crate) fn status(work: impl FnOnce() -> Result<(), Failure>) -> Status {
    report(Ok(None), work)
}
