//! Texts in arrays of fixed size, as C reads them.

use core::ffi::c_char;
use core::fmt::{self, Display, Write};

/// Bytes of a name, its NUL included.
pub const SOFTANVIL_NAME_SIZE: usize = 64;

/// Text in a fixed array of characters: cut off where the array ends, always closed by a NUL.
pub(crate) struct Text<'a> {
    room: core::slice::IterMut<'a, c_char>,
    is_cut: bool,
}

impl<'a> Text<'a> {
    /// Fills `array` with NULs and writes from its front.
    pub(crate) fn new(array: &'a mut [c_char]) -> Self {
        array.fill(0);
        let room = array.len().saturating_sub(1);
        Self { room: array.get_mut(..room).unwrap_or_default().iter_mut(), is_cut: false }
    }
}

impl Write for Text<'_> {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.is_cut |= text.len() > self.room.len();
        // The text leads, because the side that leads loses an item when the other side ends.
        for (byte, place) in text.bytes().zip(self.room.by_ref()) {
            *place = byte as c_char;
        }
        Ok(())
    }
}

/// `text` as C reads it; None if the array is too short for it.
pub(crate) fn characters<const N: usize>(text: &dyn Display) -> Option<[c_char; N]> {
    let mut array = [0; N];
    let mut writer = Text::new(&mut array);
    let _ = write!(writer, "{text}");
    let is_whole = !writer.is_cut;
    is_whole.then_some(array)
}
