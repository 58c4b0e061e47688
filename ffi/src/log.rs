//! Messages to the master.

use alloc::vec::Vec;
use core::ffi::{CStr, c_char, c_void};
use core::fmt::{self, Display, Write};

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
    Format(FormatLogger, Name),
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
        self.write(Status::ERROR, category::ERROR, &format_args!("{function}: {error}"));
    }

    /// A question that cannot be answered.
    pub fn discard(&self, function: &str, what: &str) {
        if self.events {
            self.write(Status::DISCARD, category::DISCARD, &format_args!("{function}: {what}"));
        }
    }

    /// A change of mode.
    pub fn event(&self, message: &dyn Display) {
        if self.events {
            self.write(Status::OK, category::EVENTS, message);
        }
    }

    fn write(&self, status: Status, category: &CStr, message: &dyn Display) {
        match &self.logger {
            Logger::Silent => {}
            Logger::Format(logger, name) => {
                let message = Message::new(message, true);
                // SAFETY: the master's own function, called as the standard says: texts that end with a zero and live
                // through the call, and a message without conversions, so that no further argument is read.
                unsafe {
                    logger(self.environment, name.get().as_ptr(), status, category.as_ptr(), message.get().as_ptr())
                };
            }
            Logger::Text(logger) => {
                let message = Message::new(message, false);
                // SAFETY: the master's own function, with texts that end with a zero and live through the call.
                unsafe { logger(self.environment, status, category.as_ptr(), message.get().as_ptr()) };
            }
        }
    }
}

/// Name of an instance, with its final zero.
pub struct Name(Vec<u8>);

impl Name {
    /// A copy of `name`; none if the heap has no room for it.
    pub fn new(name: &CStr) -> Option<Self> {
        let mut bytes = Vec::new();
        bytes.try_reserve_exact(name.count_bytes() + 1).ok()?;
        bytes.extend_from_slice(name.to_bytes_with_nul());
        Some(Self(bytes))
    }

    fn get(&self) -> &CStr {
        CStr::from_bytes_until_nul(&self.0).unwrap_or_default()
    }
}

/// Longest message, bytes; longer ones are cut.
const LONGEST: usize = 1024;

/// A message in memory of its own, because there may be no other.
struct Message {
    text: [u8; LONGEST + 1],
    length: usize,
    /// Whether it goes where "%" starts a conversion and "#" the name of a variable.
    is_format: bool,
}

impl Message {
    fn new(message: &dyn Display, is_format: bool) -> Self {
        let mut text = Self { text: [0; LONGEST + 1], length: 0, is_format };
        let _ = write!(text, "{message}");
        text
    }

    fn get(&self) -> &CStr {
        CStr::from_bytes_until_nul(&self.text).unwrap_or_default()
    }

    /// Adds a character as a whole; refused if there is no room for it.
    fn push(&mut self, character: &[u8]) -> fmt::Result {
        let end = self.length + character.len();
        let room = self.text.get_mut(self.length..end.min(LONGEST)).ok_or(fmt::Error)?;
        if room.len() < character.len() {
            return Err(fmt::Error);
        }
        room.iter_mut().zip(character).for_each(|(to, from)| *to = *from);
        self.length = end;
        Ok(())
    }
}

impl Write for Message {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        text.chars().try_for_each(|character| match character {
            '%' if self.is_format => self.push(b"%%"),
            '#' if self.is_format => self.push(b"##"),
            _ => self.push(character.encode_utf8(&mut [0; 4]).as_bytes()),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::{LONGEST, Message};

    #[test]
    fn messages_are_escaped_for_the_loggers_format() {
        assert_eq!(Message::new(&"5 % of #r1#", true).get(), c"5 %% of ##r1##");
        assert_eq!(Message::new(&"5 % of #r1#", false).get(), c"5 % of #r1#");
    }

    #[test]
    fn a_message_that_is_too_long_is_cut_between_characters() {
        for text in ["ä".repeat(LONGEST), "%".repeat(LONGEST), "x".repeat(2 * LONGEST)] {
            let message = Message::new(&text, true);
            assert_eq!(message.get().count_bytes(), LONGEST);
            assert!(message.get().to_str().is_ok());
        }
    }
}
