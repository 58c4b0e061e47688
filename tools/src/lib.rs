//! What the command line of Softanvil is made of, for its binary, its tests and other programs on a host.
//!
//! From top to bottom:
//!
//! 1. [`cli`] is the command line; each file of [`commands`] is one subcommand, [`failure`] how one ends badly.
//! 2. [`report`] writes the report folder; [`plot`], [`section`], [`table`] and [`trace`] draw, print and store results,
//!    pictures in a [`picture_format`], [`staging`] keeps half-written files away, [`folder`] and [`place`] those
//!    of others.
//! 3. [`validation`] compares runs with the [`paper`], by the four [`quantity`]s of its table, [`comparison`] with a
//!    [`measured`] trace, whose [`contact`] is found through its noise, [`calibration`] searches; a [`reading`] is what a
//!    laboratory's instruments see of a run.
//! 4. [`studies`] change one thing of a drop at a time, beside what the paper says of it.
//! 5. [`golden`] compares this machine with the golden traces, [`identification`] fits a material to test data.
//! 6. [`run`] simulates a drop, [`ending`] says whether its numbers are final; [`scenario_file`] and [`presets`] say which
//!    drop, [`subject`] in words, [`progress`] how far it is, [`interrupt`] when to end early.

pub mod calibration;
pub mod cli;
pub mod commands;
pub mod comparison;
pub mod contact;
pub mod curve_score;
pub mod ending;
pub mod failure;
pub mod folder;
pub mod golden;
pub mod identification;
pub mod interrupt;
pub mod json;
pub mod material_summary;
pub mod measured;
pub mod paper;
pub mod picture_format;
pub mod place;
pub mod plot;
pub mod presets;
pub mod progress;
pub mod quantity;
pub mod reading;
pub mod report;
pub mod run;
pub mod scenario_file;
pub mod section;
pub mod series;
pub mod staging;
pub mod studies;
pub mod subject;
pub mod table;
pub mod trace;
pub mod validation;
