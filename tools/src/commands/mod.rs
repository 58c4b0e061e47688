//! The subcommands, one file each: an `Options` of arguments, and `carry_out`, which returns the text for standard
//! output.

pub mod calibrate;
pub mod drop_options;
pub mod fit;
pub mod fmu;
pub mod golden;
pub mod measure;
pub mod output_files;
pub mod page;
pub mod protect;
pub mod reading_options;
pub mod reduction;
pub mod report;
pub mod run;
pub mod scenario;
pub mod sweep;
pub mod trace_options;
mod uncertainty_options;
pub mod validate;
