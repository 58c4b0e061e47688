//! Scenario files: TOML in which every parameter `group.field` of the kernel's tables is the key `field` of the section
//! `[group]`, and every layer from the core to the surface a table `[[layers]]`, or a section of its name. Keys left out keep
//! their value in the scenario that the file is read upon; a value that has no effect is refused, and written behind a `#`
//! (`softanvil_kernel::Changes`).

pub mod assign;
pub mod names;
mod read;
mod write;

#[cfg(feature = "command-line")]
pub(crate) use read::from_toml;
pub use read::{ScenarioFileError, parse, parse_material, read, read_material};
pub use write::{material_to_toml, to_toml};

#[cfg(test)]
mod tests;
