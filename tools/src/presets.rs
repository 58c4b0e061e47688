//! The kernel's presets on the command line.

use softanvil_kernel::preset::{PRESETS, Preset};

/// The preset called `name`, for clap.
///
/// # Errors
/// The names that there are.
pub fn parse(name: &str) -> Result<&'static Preset, String> {
    PRESETS.iter().find(|preset| preset.name == name).ok_or_else(|| {
        let names: Vec<_> = PRESETS.iter().map(|preset| preset.name).collect();
        format!("legal is {}", names.join(", "))
    })
}
