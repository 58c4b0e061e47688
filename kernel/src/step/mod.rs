//! One explicit step, and the limit of its length.

mod advance;
mod critical;
mod monitor;
mod motion;
mod solid_advance;
mod solid_cells;
mod solid_forces;
mod solid_rows;
mod solid_stable_step;
#[cfg(feature = "threads")]
mod solid_threads;
mod stable_step;
mod window;

pub(crate) use advance::advance_once;
pub use advance::{step, step_along, step_with, steps};
pub(crate) use critical::Critical;
pub(crate) use solid_stable_step::SolidCells;
#[cfg(feature = "threads")]
pub(crate) use solid_threads::among_threads;
#[cfg(feature = "threads")]
use solid_threads::both;
pub(crate) use stable_step::Cells;
pub use stable_step::{critical_time_step, critical_time_step_with};
pub use window::MONITOR_PERIOD;

/// Does `work`, in which steps are made, where there are no threads to share in them.
#[cfg(not(feature = "threads"))]
pub(crate) fn among_threads<R>(_: &crate::mesh::Grid, work: impl FnOnce() -> R) -> R {
    work()
}

/// Does one of these and then the other, where there are no threads.
#[cfg(not(feature = "threads"))]
fn both<A, B>(_: &crate::mesh::Grid, one: impl FnOnce() -> A, other: impl FnOnce() -> B) -> (A, B) {
    (one(), other())
}
