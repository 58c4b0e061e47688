//! What a record is read with, its channels and samples, and the trace that comes of it.

use super::choice::Choice;
use crate::channel::Filter;
use crate::column::Column;
use crate::series::Table;
use crate::sheet::Layout;
use crate::understood::Understood;

/// What a file leaves open.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Layout of the file.
    pub layout: Layout,
    /// Column of the time.
    pub time: Option<Choice>,
    /// Column of the force.
    pub force: Option<Choice>,
    /// Column of the acceleration.
    pub acceleration: Option<Choice>,
    /// Column of the impactor's displacement.
    pub displacement: Option<Choice>,
    /// Mass of the falling body, kg, that turns its acceleration into a force.
    pub mass: Option<f64>,
    /// Samples in a second, Hz, which count instead of a column of time.
    pub rate: Option<f64>,
    /// Force without contact, N, to be taken off; none for that before contact.
    pub offset: Option<f64>,
    /// 1 if a push is positive in the file, -1 if negative; none for the larger side.
    pub sign: Option<f64>,
    /// Which impact of the record, from 1; none for the first.
    pub impact: Option<usize>,
}

/// The impact that the record should be of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Expected {
    /// Mass of the falling body, kg.
    pub mass: f64,
    /// Its speed at the touch, m/s.
    pub speed: f64,
}

/// A force over time.
#[derive(Clone, Debug)]
pub struct Trace {
    /// Times, s, which rise.
    pub times: Vec<f64>,
    /// Forces, N, positive in compression, without the offset.
    pub forces: Vec<f64>,
    /// Largest displacement since the touch, m, if the file has it.
    pub deformation: Option<f64>,
    /// How the force was filtered, if the file says it.
    pub filter: Option<Filter>,
    /// How the file was read.
    pub understood: Understood,
}

/// The columns of a table that a trace is made of.
pub(super) struct Channels {
    pub(super) table: Table,
    pub(super) load: Column,
    pub(super) time: Clock,
    pub(super) displacement: Option<Column>,
    /// Whether the user states the units.
    pub(super) stated: bool,
}

/// Where the times come from.
pub(super) enum Clock {
    Column(Column),
    /// Time of the first sample and between two, s, and what states it.
    Rate(f64, f64, String),
}

/// A record that is being read.
pub(super) struct Record<'a> {
    pub(super) name: &'a str,
    pub(super) options: &'a Options,
    pub(super) expected: Option<&'a Expected>,
    pub(super) channels: Channels,
}

/// Samples of one block of a table.
#[derive(Default)]
pub(super) struct Samples {
    pub(super) times: Vec<f64>,
    pub(super) loads: Vec<f64>,
    pub(super) displacements: Vec<f64>,
    pub(super) lines: Vec<u32>,
    /// Rows without a time or a value.
    pub(super) dropped: usize,
}
