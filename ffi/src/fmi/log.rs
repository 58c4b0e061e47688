//! Messages to the master.

use alloc::vec::Vec;
use core::ffi::{CStr, c_char, c_void};
use core::fmt::{self, Display, Write};

use crate::fmi::status::Status;

/// A log category of the standard that the model description declares: its name, and the messages in it.
pub struct Category {
    name: &'static CStr,
    /// One bit for each kind of message.
    pub bits: u8,
}

impl Category {
    /// Changes of mode.
    const EVENTS: Self = Self { name: c"logEvents", bits: 1 };
    /// Refused calls and failed steps.
    const ERROR: Self = Self { name: c"logStatusError", bits: 2 };
    /// Refused steps that may be tried otherwise (FMI 3.0), and what a status function cannot tell (FMI 2.0).
    const DISCARD: Self = Self { name: c"logStatusDiscard", bits: 4 };
    /// Results that are not what they seem, and values that have no effect.
    const WARNING: Self = Self { name: c"logStatusWarning", bits: 8 };
    /// All of them.
    pub const ALL: Self = Self { name: c"logAll", bits: 15 };

    /// The category called `name`.
    pub fn find(name: &CStr) -> Option<Self> {
        [Self::EVENTS, Self::WARNING, Self::ERROR, Self::DISCARD, Self::ALL]
            .into_iter()
            .find(|category| category.name == name)
    }
}

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
    /// Bits of the categories that are written.
    enabled: u8,
}

impl Log {
    /// A log that hands `environment` back to `logger`, and tells of everything if it is `on`.
    pub fn new(logger: Logger, environment: *mut c_void, on: bool) -> Self {
        Self { logger, environment, enabled: if on { Category::ALL.bits } else { 0 } }
    }

    /// Switches the categories of `bits` on or off; the others stay as they are.
    pub fn switch(&mut self, on: bool, bits: u8) {
        self.enabled = if on { self.enabled | bits } else { self.enabled & !bits };
    }

    /// A refused call or failed step. FMI 2.0 switches what helps to debug, which leaves errors; FMI 3.0 says that with
    /// logging off "the callback function must not be called by the FMU".
    pub fn error(&self, function: &str, error: &dyn Display) {
        if self.tells(&Category::ERROR) || matches!(self.logger, Logger::Format(..)) {
            self.write(Status::ERROR, &Category::ERROR, &format_args!("{function}: {error}"));
        }
    }

    /// A step that may be tried otherwise, or a question that cannot be answered.
    pub fn discard(&self, function: &str, what: &dyn Display) {
        if self.tells(&Category::DISCARD) {
            self.write(Status::DISCARD, &Category::DISCARD, &format_args!("{function}: {what}"));
        }
    }

    /// A result that is not what it seems, or a value without effect: told as an error is.
    pub fn warning(&self, message: &dyn Display) {
        if self.tells(&Category::WARNING) || matches!(self.logger, Logger::Format(..)) {
            self.write(Status::WARNING, &Category::WARNING, message);
        }
    }

    /// A change of mode.
    pub fn event(&self, message: &dyn Display) {
        if self.tells(&Category::EVENTS) {
            self.write(Status::OK, &Category::EVENTS, message);
        }
    }

    fn tells(&self, category: &Category) -> bool {
        self.enabled & category.bits != 0
    }

    fn write(&self, status: Status, category: &Category, message: &dyn Display) {
        let category = category.name;
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
    text: heapless::Vec<u8, { LONGEST + 1 }>,
    /// Whether it goes where "%" starts a conversion and "#" the name of a variable.
    is_format: bool,
}

impl Message {
    fn new(message: &dyn Display, is_format: bool) -> Self {
        let mut text = Self { text: heapless::Vec::new(), is_format };
        let _ = write!(text, "{message}");
        // There is room for the final zero: see `push`.
        let _ = text.text.push(0);
        text
    }

    fn get(&self) -> &CStr {
        CStr::from_bytes_until_nul(&self.text).unwrap_or_default()
    }

    /// Adds a character as a whole; refused if there is no room for it.
    fn push(&mut self, character: &[u8]) -> fmt::Result {
        if self.text.len() + character.len() > LONGEST {
            return Err(fmt::Error);
        }
        self.text.extend_from_slice(character).map_err(|_| fmt::Error)
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
