//! [`SoftanvilError`]: how C learns why a call was refused.

use core::ffi::c_char;
use core::fmt::Write;

use crate::c_api::failure::Failure;
use crate::c_api::ptr::Out;
use crate::c_api::status::SoftanvilStatus as Status;
use crate::c_api::text::Text;
use crate::environment;

/// Bytes of the text of a `SoftanvilError`, its NUL included.
pub const SOFTANVIL_ERROR_TEXT_SIZE: usize = 256;

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

impl Failure {
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
