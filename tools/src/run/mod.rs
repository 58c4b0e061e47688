//! A simulated drop, and how it ended.

mod drop;
mod ending;
mod remark;

pub use drop::{Drop, LONGEST_EXTENSION, Run, RunError, Until};
pub use ending::{Ending, MARK};
pub use remark::{remark, suffix};
