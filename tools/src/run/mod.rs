//! A simulated drop, and how it ended.

mod drop;
mod ending;
mod remark;
mod work;

pub use drop::{Drop, LONGEST_EXTENSION, Run, RunError, Until};
pub use ending::{Ending, MARK};
pub use remark::{remark, suffix};
pub use work::element_updates;
