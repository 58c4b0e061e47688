//! One explicit step, and the limit of its length.

mod advance;
mod monitor;
mod solid_advance;
mod solid_forces;
mod solid_stable_step;
mod stable_step;

pub(crate) use advance::advance_once;
pub use advance::{step, step_along, step_with, steps};
pub use monitor::MONITOR_PERIOD;
pub(crate) use solid_stable_step::SolidCells;
pub use stable_step::critical_time_step;
pub(crate) use stable_step::{Cells, Critical};
