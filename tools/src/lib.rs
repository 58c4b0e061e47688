//! What the command line of Softanvil is made of, for its binary, its tests and other programs on a host.
//!
//! From top to bottom:
//!
//! 1. [`cli`] is the command line; each file of [`commands`] is one subcommand, [`failure`] how one ends badly.
//! 2. `report` writes the report folder, whose page is that of [`page`]; [`plot`] and [`section`] draw, [`output`] prints and stores results, [`text`] has its
//!    numbers, lines and tables, [`files`] keeps half-written files away, and what others wrote.
//! 3. [`sweep`] changes parameters of a drop, [`reduction`] its dimensions; [`protect`] judges pads; [`paper`] has what the paper printed, which its `validation` compares with runs;
//!    [`calibration`] searches, [`identification`] fits a material to test data, [`golden`] compares this machine with the
//!    golden traces.
//! 4. [`measurement`] is what instruments see of a run, or have seen of an impact.
//! 5. [`run`] simulates a drop and says whether its numbers are final; [`scenario_file`] and [`presets`] say which drop,
//!    [`progress`] how far it is, [`interrupt`] when to end early, [`identity`] which kernel it is.

#[cfg(feature = "command-line")]
pub mod calibration;
#[cfg(feature = "command-line")]
pub mod cli;
#[cfg(feature = "command-line")]
pub mod commands;
pub mod failure;
#[cfg(feature = "command-line")]
pub mod files;
#[cfg(feature = "command-line")]
pub mod golden;
#[cfg(feature = "command-line")]
pub mod identification;
#[cfg(feature = "command-line")]
pub mod identity;
#[cfg(feature = "command-line")]
pub mod interrupt;
pub mod measurement;
pub mod output;
pub mod page;
pub mod paper;
pub mod plot;
pub mod presets;
pub mod progress;
#[cfg(feature = "command-line")]
pub mod protect;
#[cfg(feature = "command-line")]
pub mod reduction;
#[cfg(feature = "command-line")]
pub mod report;
pub mod run;
pub mod scenario_file;
pub mod section;
#[cfg(feature = "command-line")]
pub mod sweep;
pub mod text;
