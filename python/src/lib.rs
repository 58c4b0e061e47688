//! The kernel and the library of the command line for Python: the module `softanvil._softanvil`, over which the package in the
//! folder `softanvil` lays what people use.
//!
//! From top to bottom: [`study`] runs many scenarios at once and [`command`] the command line, [`run`] one drop, [`simulation`]
//! goes step by step, both with the arrays of [`field`]; [`settings`] is a scenario on its way, read by [`quantity`];
//! [`records`] reads measured traces, [`tables`] tells what there is; [`interrupt`] and [`error`] are for all of them.

mod command;
mod error;
mod field;
mod interrupt;
mod quantity;
mod records;
mod run;
mod settings;
mod simulation;
mod study;
mod tables;

/// The compiled part of the package.
#[pyo3::pymodule]
mod _softanvil {
    #[pymodule_export]
    use crate::command::{command, command_options};
    #[pymodule_export]
    use crate::field::StateView;
    #[pymodule_export]
    use crate::records::read_trace;
    #[pymodule_export]
    use crate::run::{Run, run};
    #[pymodule_export]
    use crate::settings::Settings;
    #[pymodule_export]
    use crate::simulation::Simulation;
    #[pymodule_export]
    use crate::study::{run_many, run_rows};
    #[pymodule_export]
    use crate::tables::{fields, kernel_digest, outputs, parameters, presets, target, version};
}
