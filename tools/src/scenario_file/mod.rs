//! Scenario files: TOML in which every parameter `group.field` of the kernel's table is the key `field` of the section
//! `[group]`. Keys left out keep their value in the scenario that the file is read upon; a value that has no effect is
//! refused, and written behind a `#` (`softanvil_kernel::Changes`).

pub mod assign;
mod read;
mod suggestion;
mod write;

pub(crate) use read::from_toml;
pub use read::{ScenarioFileError, parse, read, read_material};
pub(crate) use suggestion::suggestion;
pub use write::{material_to_toml, to_toml};

#[cfg(test)]
mod tests;

/// Group and field of a parameter's name.
fn split(name: &'static str) -> (&'static str, &'static str) {
    name.split_once('.').unwrap_or(("", name))
}
