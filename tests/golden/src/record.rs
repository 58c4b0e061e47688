//! [`Record`]: one line of a trace.

use core::fmt;

use softanvil_kernel::Model;
use softanvil_kernel::number::real::Real;

use crate::scenes::Scene;

/// What is compared, in the order of a line's columns.
pub const QUANTITIES: [&str; 4] = ["step", "contact_force_N", "position_m", "state"];

/// The simulation after a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Record {
    /// Steps completed.
    pub step: u64,
    /// Contact force of the step on the impactor, N.
    pub force: Real,
    /// Height of the face above the undeformed anvil, m.
    pub position: Real,
    /// Digest of the full state: every number that a snapshot holds.
    pub state: u64,
}

/// The line of a trace. Numbers are the shortest decimals that are read back as the same bits, so equal lines mean equal
/// bits.
impl fmt::Display for Record {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:>6} {:>24e} {:>24e}  {:016x}", self.step, self.force, self.position, self.state)
    }
}

/// The comments at the start of a trace.
#[derive(Clone, Copy, Debug)]
pub struct Header {
    scene: &'static Scene,
    elements: usize,
    dt: Real,
}

impl Header {
    /// The comments of the trace of `scene`, whose model is `model`.
    pub fn new(scene: &'static Scene, model: &Model) -> Self {
        Self { scene, elements: model.constants.grid.n_elem(), dt: model.constants.dt }
    }
}

/// Three lines; the last is not ended.
impl fmt::Display for Header {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [step, force, position, state] = QUANTITIES;
        writeln!(f, "# {}: {}", self.scene.name, self.scene.description)?;
        writeln!(f, "# {} triangles, time step {:e} s", self.elements, self.dt)?;
        write!(f, "#{step:>5} {force:>24} {position:>24}  {state}")
    }
}

/// A line as text, without a heap.
pub struct Line {
    bytes: [u8; Self::CAPACITY],
    length: usize,
}

impl Line {
    /// More than the longest line.
    const CAPACITY: usize = 128;

    /// The line of `record`.
    pub fn new(record: &Record) -> Self {
        let mut line = Self { bytes: [0; Self::CAPACITY], length: 0 };
        let _ = fmt::Write::write_fmt(&mut line, format_args!("{record}"));
        line
    }

    /// The text.
    pub fn text(&self) -> &str {
        self.bytes.get(..self.length).and_then(|bytes| core::str::from_utf8(bytes).ok()).unwrap_or_default()
    }
}

impl fmt::Write for Line {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        let end = self.length + text.len();
        let room = self.bytes.get_mut(self.length..end).ok_or(fmt::Error)?;
        room.copy_from_slice(text.as_bytes());
        self.length = end;
        Ok(())
    }
}
