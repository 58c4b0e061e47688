//! What a misspelt name may have been.

use softanvil_kernel::PARAMETERS;

use super::split;

/// The known name most like `name`, if one is like it.
pub(crate) fn suggestion(name: &str) -> String {
    /// Below this similarity (0 to 1) a suggestion confuses more than it helps.
    const SIMILAR: f64 = 0.8;
    let groups = PARAMETERS.iter().map(|parameter| split(parameter.name).0);
    PARAMETERS
        .iter()
        .map(|parameter| parameter.name)
        .chain(groups)
        .map(|known| (strsim::jaro_winkler(known, name), known))
        .filter(|(similarity, _)| *similarity > SIMILAR)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map_or_else(String::new, |(_, known)| format!(" (did you mean {known}?)"))
}
