//! Messages to the master.

use alloc::ffi::CString;
use alloc::string::String;
use core::ffi::{CStr, c_char, c_void};
use core::fmt::Display;

use crate::session::Status;

/// Log categories of the standard that the model description declares.
pub mod category {
    use core::ffi::CStr;

    /// Changes of mode.
    pub const EVENTS: &CStr = c"logEvents";
    /// Refused calls and failed steps.
    pub const ERROR: &CStr = c"logStatusError";
    /// What a status function cannot tell.
    pub const DISCARD: &CStr = c"logStatusDiscard";
    /// All of them.
    pub const ALL: &CStr = c"logAll";
}

/// Every category.
pub const CATEGORIES: [&CStr; 4] = [category::EVENTS, category::ERROR, category::DISCARD, category::ALL];

/// `fmi2CallbackLogger`, which takes a format and what it names.
pub type FormatLogger = unsafe extern "C" fn(
    environment: *mut c_void,
    instance_name: *const c_char,
    status: Status,
    category: *const c_char,
    message: *const c_char,
    ...
);

/// `fmi3LogMessageCallback`, which takes a text.
pub type TextLogger =
    unsafe extern "C" fn(environment: *mut c_void, status: Status, category: *const c_char, message: *const c_char);

/// The master's logger.
pub enum Logger {
    /// There is none.
    Silent,
    /// That of FMI 2.0, and the name of the instance.
    Format(FormatLogger, CString),
    /// That of FMI 3.0.
    Text(TextLogger),
}

/// The way to the master's logger.
pub struct Log {
    logger: Logger,
    environment: *mut c_void,
    /// Whether changes of mode are told, too.
    pub events: bool,
}

impl Log {
    /// A log that hands `environment` back to `logger`.
    pub fn new(logger: Logger, environment: *mut c_void, events: bool) -> Self {
        Self { logger, environment, events }
    }

    /// A refused call or failed step; never kept back.
    pub fn error(&self, function: &str, error: &dyn Display) {
        self.write(Status::ERROR, category::ERROR, &alloc::format!("{function}: {error}"));
    }

    /// A question that cannot be answered.
    pub fn discard(&self, function: &str, what: &str) {
        if self.events {
            self.write(Status::DISCARD, category::DISCARD, &alloc::format!("{function}: {what}"));
        }
    }

    /// A change of mode.
    pub fn event(&self, message: &str) {
        if self.events {
            self.write(Status::OK, category::EVENTS, message);
        }
    }

    fn write(&self, status: Status, category: &CStr, message: &str) {
        // Texts become C's without zeros inside, which no message has.
        match &self.logger {
            Logger::Silent => {}
            Logger::Format(logger, name) => {
                let Ok(message) = CString::new(escape(message)) else { return };
                // SAFETY: the master's own function, called as the standard says: texts that end with a zero and live
                // through the call, and a message without conversions, so that no further argument is read.
                unsafe { logger(self.environment, name.as_ptr(), status, category.as_ptr(), message.as_ptr()) };
            }
            Logger::Text(logger) => {
                let Ok(message) = CString::new(message) else { return };
                // SAFETY: the master's own function, with texts that end with a zero and live through the call.
                unsafe { logger(self.environment, status, category.as_ptr(), message.as_ptr()) };
            }
        }
    }
}

/// The message as a format: "%" starts a conversion there, "#" the name of a variable.
fn escape(message: &str) -> String {
    message.replace('%', "%%").replace('#', "##")
}

#[cfg(test)]
mod tests {
    use super::escape;

    #[test]
    fn messages_are_escaped_for_the_loggers_format() {
        assert_eq!(escape("5 % of #r1#"), "5 %% of ##r1##");
    }
}
