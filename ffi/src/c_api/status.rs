//! [`SoftanvilStatus`]: what every function of the C ABI returns.

use core::ffi::CStr;

/// Result of a call. Numbers are stable: a retired one stays reserved, new ones are added. Treat an unknown number as
/// a failure.
///
/// 100 to 199: the call itself; 200 to 299: the scenario; 300 to 399: a step; 400 to 499: a snapshot.
#[repr(i32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SoftanvilStatus {
    /// Done.
    Ok = 0,
    /// A pointer that must point to something is null.
    NullPointer = 100,
    /// A pointer is not aligned as its type or the simulation's memory needs it.
    Misaligned = 101,
    /// A buffer is too short.
    ShortBuffer = 102,
    /// A structure was never initialised by this library, was closed, or was overwritten.
    Uninitialised = 103,
    /// No such parameter, output, choice or preset.
    UnknownId = 104,
    /// No such name.
    UnknownName = 105,
    /// A parameter's value is not a number, is outside its legal range, or is not one of its choices.
    IllegalValue = 200,
    /// The Prony coefficients leave no long-term stiffness.
    PronySum = 201,
    /// The elastic coefficients give no positive shear modulus at rest.
    ShearModulus = 202,
    /// The impactor's face is narrower than two cells of the mesh.
    FaceTooSmall = 203,
    /// The element size asks for more cells than a mesh may have.
    TooManyCells = 204,
    /// The stable time step is smaller than any that is offered.
    StepTooSmall = 205,
    /// The given time step is above the stability limit at rest.
    StepTooLarge = 206,
    /// A slot of a scenario or an input that has no meaning in this version is not zero.
    ReservedSlot = 207,
    /// The stretch at which a layer begins to tear is below 1.
    TearStretch = 208,
    /// A layer has no thickness, or next to none; a layer that the preset does not have needs one.
    LayerThickness = 209,
    /// An axisymmetric anvil has no full section.
    FullAxisymmetric = 210,
    /// Only a full section can have an impactor beside the centre line.
    OffsetOfHalf = 211,
    /// An element has no area.
    NoArea = 212,
    /// A value differs from the preset's and has no effect beside the others.
    NoEffect = 213,
    /// Two values that state the same thing differ from the preset's.
    Contradiction = 214,
    /// The formulation of the section cannot have a face of this shape.
    FaceOfFormulation = 215,
    /// The r of a layer's softening is below 1.
    Softening = 218,
    /// The coefficients of a compressible law give no positive bulk modulus at rest.
    BulkModulus = 219,
    /// A layer is wider than what it lies on.
    LayerWidth = 216,
    /// The library was built without pads, which the scenario needs.
    WithoutPads = 217,
    /// A solid does not have what the scenario asks for.
    NotInSolid = 220,
    /// An element turned inside out or is no longer finite.
    Inverted = 300,
    /// The time step is above the current stability limit of an element.
    Unstable = 301,
    /// The input of a step is not a finite number.
    IllegalInput = 302,
    /// The time to run to is not a number, is past, or is too far ahead.
    IllegalTime = 303,
    /// The bytes are not a snapshot of this format version.
    SnapshotFormat = 400,
    /// The snapshot belongs to a different scenario.
    SnapshotForeign = 401,
    /// The snapshot's checksum does not match its content.
    SnapshotCorrupt = 402,
    /// The simulation has failed in a step and is not worth saving.
    SnapshotFailed = 403,
}

use SoftanvilStatus as S;

impl SoftanvilStatus {
    /// Every status.
    pub const ALL: [Self; 36] = [
        S::Ok,
        S::NullPointer,
        S::Misaligned,
        S::ShortBuffer,
        S::Uninitialised,
        S::UnknownId,
        S::UnknownName,
        S::IllegalValue,
        S::PronySum,
        S::ShearModulus,
        S::FaceTooSmall,
        S::TooManyCells,
        S::StepTooSmall,
        S::StepTooLarge,
        S::ReservedSlot,
        S::TearStretch,
        S::LayerThickness,
        S::FullAxisymmetric,
        S::OffsetOfHalf,
        S::NoArea,
        S::NoEffect,
        S::Contradiction,
        S::FaceOfFormulation,
        S::LayerWidth,
        S::WithoutPads,
        S::Softening,
        S::BulkModulus,
        S::NotInSolid,
        S::Inverted,
        S::Unstable,
        S::IllegalInput,
        S::IllegalTime,
        S::SnapshotFormat,
        S::SnapshotForeign,
        S::SnapshotCorrupt,
        S::SnapshotFailed,
    ];

    /// One line without values.
    pub const fn text(self) -> &'static CStr {
        match self {
            S::Ok => c"done",
            S::NullPointer => c"null pointer",
            S::Misaligned => c"misaligned pointer",
            S::ShortBuffer => c"buffer too short",
            S::Uninitialised => c"structure not initialised by this library, closed, or overwritten",
            S::UnknownId => c"unknown number of a parameter, output, choice or preset",
            S::UnknownName => c"unknown name",
            S::IllegalValue => c"illegal value of a parameter",
            S::PronySum => c"Prony coefficients leave no long-term stiffness",
            S::ShearModulus => c"elastic coefficients give no positive shear modulus",
            S::FaceTooSmall => c"face of the impactor too small for the mesh",
            S::TooManyCells => c"element size asks for too many cells",
            S::StepTooSmall => c"stable time step too small",
            S::StepTooLarge => c"given time step above the stability limit",
            S::ReservedSlot => c"reserved slot not zero",
            S::TearStretch => c"tear stretch below 1",
            S::LayerThickness => c"layer without a thickness",
            S::FullAxisymmetric => c"full section of an axisymmetric anvil",
            S::OffsetOfHalf => c"offset impactor on a half section",
            S::NoArea => c"element without area",
            S::NoEffect => c"value without effect",
            S::Contradiction => c"two values that state the same thing",
            S::Softening => c"r of a softening below 1",
            S::BulkModulus => c"elastic coefficients give no positive bulk modulus",
            S::FaceOfFormulation => c"face that the formulation cannot have",
            S::LayerWidth => c"layer wider than what it lies on",
            S::WithoutPads => c"library built without pads",
            S::NotInSolid => c"what a solid does not have",
            S::Inverted => c"element inverted or not finite",
            S::Unstable => c"time step above the current stability limit",
            S::IllegalInput => c"input of a step not finite",
            S::IllegalTime => c"time to run to past, too far ahead, or no number",
            S::SnapshotFormat => c"not a snapshot of this format version",
            S::SnapshotForeign => c"snapshot of a different scenario",
            S::SnapshotCorrupt => c"snapshot corrupt",
            S::SnapshotFailed => c"failed simulation cannot be saved",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_texts_are_unique() {
        for (i, status) in SoftanvilStatus::ALL.iter().enumerate() {
            for other in &SoftanvilStatus::ALL[..i] {
                assert!((*other as i32) < *status as i32, "{other:?} {status:?}");
                assert_ne!(other.text(), status.text());
            }
        }
    }
}
