//! What a picture shows of a run.

use crate::measurement::band::ForceBand;
use crate::measurement::quantity::COUNT;
use crate::run::Run;

/// What a picture shows of one run.
pub struct Shown<'a> {
    /// What the legend calls it.
    pub label: String,
    /// The run.
    pub run: &'a Run,
    /// What the experiment measured, in SI and in the order of [`crate::measurement::quantity::QUANTITIES`].
    pub experiment: Option<[f64; COUNT]>,
    /// Where 90 % of the forces are to be expected.
    pub band: Option<&'a ForceBand>,
}
