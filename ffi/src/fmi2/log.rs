//! Messages to the master.

use alloc::ffi::CString;
use alloc::string::String;
use core::ffi::{CStr, c_void};
use core::fmt::Display;

use super::types::{CallbackFunctions, CallbackLogger, Status};

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

/// The way to the master's logger.
pub struct Log {
    logger: Option<CallbackLogger>,
    environment: *mut c_void,
    instance_name: CString,
    /// Whether changes of mode are told, too.
    pub events: bool,
}

impl Log {
    /// The log of the instance called `instance_name`.
    pub fn new(callbacks: &CallbackFunctions, instance_name: &CStr, events: bool) -> Self {
        Self {
            logger: callbacks.logger,
            environment: callbacks.environment,
            instance_name: instance_name.into(),
            events,
        }
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
        let Some(logger) = self.logger else { return };
        // Without zeros inside, which no message has.
        let Ok(message) = CString::new(escape(message)) else { return };
        // SAFETY: the master's own function, called as the standard says: texts that end with a zero and live through
        // the call, and a message without conversions, so that no further argument is read.
        unsafe {
            logger(self.environment, self.instance_name.as_ptr(), status, category.as_ptr(), message.as_ptr());
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
