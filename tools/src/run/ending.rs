//! How a run ended, and which of its numbers are those of the whole impact.

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// The impactor has touched the layer and left it.
    Complete,
    /// A press is at its depth.
    Held,
    /// The impactor still touches the layer, or presses it further.
    InContact,
    /// The impactor has not touched the layer.
    NoContact,
}

/// Stands behind a number that is the one so far.
pub const MARK: &str = "*";

impl Ending {
    /// Name for programs.
    pub fn key(self) -> &'static str {
        match self {
            Self::Complete => "complete",
            Self::Held => "held",
            Self::InContact => "in_contact",
            Self::NoContact => "no_contact",
        }
    }

    /// Whether the output called `name` has no final value by then.
    pub fn cuts(self, name: &str) -> bool {
        let lasting = ["impact_duration", "impulse", "rebound_speed", "restitution", "contact_time"];
        let largest = ["peak_force", "max_deformation"];
        let Some(field) = name.strip_prefix("result.") else { return false };
        match self {
            Self::Complete | Self::NoContact => false,
            Self::Held => lasting.contains(&field),
            Self::InContact => lasting.contains(&field) || largest.contains(&field),
        }
    }

    /// `text`, the value of the output called `name`, marked if it is not final; a dash if there was no impact.
    pub fn marked(self, name: &str, text: String) -> String {
        match self {
            Self::NoContact if name.starts_with("result.") => "-".into(),
            _ if self.cuts(name) => text + MARK,
            _ => text,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_press_at_its_depth_has_a_final_force_and_no_final_impulse() {
        assert!(!Ending::Held.cuts("result.peak_force") && Ending::Held.cuts("result.impulse"));
        assert!(Ending::InContact.cuts("result.peak_force") && !Ending::InContact.cuts("result.impact_speed"));
        assert!(!Ending::InContact.cuts("energy.elastic") && !Ending::Complete.cuts("result.impulse"));
        assert_eq!(Ending::InContact.marked("result.impulse", "1.45".into()), "1.45*");
        assert_eq!(Ending::NoContact.marked("result.impulse", "0.00".into()), "-");
    }
}
