//! The kernel's presets on the command line.

use softanvil_kernel::preset::{PRESETS, Preset};

/// The preset called `name`, for clap.
///
/// # Errors
/// The names that there are.
pub fn parse(name: &str) -> Result<&'static Preset, String> {
    PRESETS.iter().find(|preset| preset.name == name).ok_or_else(|| {
        let names: Vec<_> = PRESETS.iter().map(|preset| preset.name).collect();
        format!("expected {}", names.join(", "))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use softanvil_kernel::preset::Fitted;

    #[test]
    fn descriptions_say_how_many_parameters_were_fitted_to_how_many_numbers() {
        for preset in PRESETS.iter().filter(|preset| preset.fitted != Fitted::NONE) {
            let fitted =
                format!("{} parameters fitted to the {} numbers", preset.fitted.parameters, preset.fitted.numbers);
            assert!(preset.description.contains(&fitted), "{}: {fitted}", preset.name);
        }
        let [all, part] = [PRESETS[0], PRESETS[1]].map(|preset| preset.fitted.to_string());
        assert_eq!(Fitted::NONE.to_string(), "no parameter fitted to any of the numbers");
        assert_eq!(all, "5 parameters fitted to all 12 numbers, none predicted");
        assert_eq!(part, "4 parameters fitted to 4 of the 12 numbers, the other 8 predicted");
    }
}
