//! Whether a pad meets a standard.

use serde_json::{Value, json};
use softanvil_kernel::parameter::Values;
use softanvil_kernel::scenario::{Body, Ends, Formulation};
use softanvil_kernel::{Parameter, Scenario};

use super::numbers::Numbers;
use super::padding;
use super::standard::{Limit, Quantity, Standard};
use crate::run::Ending;
use crate::text::number::four_digits;

/// What is said of a pad.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// It meets the limits of this level, and of those below it.
    Pass(&'static Limit),
    /// It meets none; the loosest.
    Fail(&'static Limit),
    /// No limit is known.
    NoLimit,
    /// The drop is not that of the standard, by what is changed.
    OtherTest(Vec<String>),
    /// The drop was cut off.
    CutOff,
    /// No standard applies: the preset is none of one.
    NoStandard,
}

impl Verdict {
    /// Of `numbers` of a drop of `scenario` by `standard`, whose own scenario is `preset`.
    pub fn new(numbers: &Numbers, standard: Option<&'static Standard>, scenario: &Scenario, preset: &Scenario) -> Self {
        let Some(standard) = standard else { return Self::NoStandard };
        let changed = changed(scenario, preset);
        if !changed.is_empty() {
            return Self::OtherTest(changed);
        }
        if numbers.ending != Ending::Complete {
            return Self::CutOff;
        }
        let value = judged(numbers, standard.quantity);
        let met = |limit: &&Limit| value < limit.below && limit.single.is_none_or(|single| value <= single);
        match (standard.limits.iter().rev().find(met), standard.limits.first()) {
            (Some(limit), _) => Self::Pass(limit),
            (None, Some(loosest)) => Self::Fail(loosest),
            (None, None) => Self::NoLimit,
        }
    }

    /// In a word or two, for a table.
    pub fn short(&self) -> String {
        match self {
            Self::Pass(limit) => format!("pass, {}", limit.level),
            Self::Fail(_) => "fail".into(),
            Self::NoLimit => "no limit".into(),
            Self::OtherTest(_) => "other test".into(),
            Self::CutOff => "cut off".into(),
            Self::NoStandard => "-".into(),
        }
    }

    /// In a sentence or two, with where the limit is from.
    pub fn text(&self, numbers: &Numbers, standard: Option<&Standard>) -> String {
        let Some(standard) = standard else {
            return "Verdict: none, as the preset is that of no standard (--preset).".into();
        };
        let value = standard.quantity.text(judged(numbers, standard.quantity));
        let head = format!("Verdict by {}: ", standard.name);
        let label = standard.quantity.label();
        let text = match self {
            Self::Pass(limit) => format!("PASS, {}: {label} {value}, {}.", limit.level, of_limit(limit, standard)),
            Self::Fail(limit) => format!("FAIL: {label} {value}, {}: {}.", limit.level, of_limit(limit, standard)),
            Self::NoLimit => format!("no limit known: {label} {value}."),
            Self::OtherTest(changed) => {
                return format!("{head}none, as this is not its test: {}.", changed.join(", "));
            }
            Self::CutOff => return format!("{head}none, as the drop was cut off in contact."),
            Self::NoStandard => return String::new(),
        };
        let one = if standard.limits.is_empty() { "" } else { " One simulated impact stands for the mean of several." };
        format!("{head}{text} {}.{one}", standard.source)
    }

    /// For programs.
    pub fn json(&self) -> Value {
        let (verdict, level) = match self {
            Self::Pass(limit) => ("pass", Some(limit.level)),
            Self::Fail(limit) => ("fail", Some(limit.level)),
            Self::NoLimit => ("no_limit_known", None),
            Self::OtherTest(_) => ("other_test", None),
            Self::CutOff => ("cut_off", None),
            Self::NoStandard => ("no_standard", None),
        };
        let changed = if let Self::OtherTest(changed) = self { changed.clone() } else { Vec::new() };
        json!({ "verdict": verdict, "level": level, "changed": changed })
    }
}

/// What `quantity` judges.
fn judged(numbers: &Numbers, quantity: Quantity) -> f64 {
    match quantity {
        Quantity::TransmittedForce => numbers.transmitted,
        Quantity::PeakAcceleration => numbers.acceleration,
    }
}

/// What `limit` of `standard` asks for, in words.
pub fn of_limit(limit: &Limit, standard: &Standard) -> String {
    let below = standard.quantity.text(limit.below);
    match limit.single {
        Some(single) => format!("to be below {below} in the mean and nowhere above {}", standard.quantity.text(single)),
        None => format!("to be below {below} in the mean"),
    }
}

/// Groups of parameters that say how a test is simulated and measured, not what it is.
const FREE: [&str; 3] = ["mesh", "time", "measurement"];
/// How the parameters begin that state the speed at the start, each in its way.
const START: &str = "impactor.drop_";

/// The section of a solid that is the body of `preset` in three dimensions, and any other scenario as it is.
fn section_of(scenario: &Scenario, preset: &Scenario) -> Scenario {
    let (mut section, geometry) = (scenario.clone(), &scenario.geometry);
    let same_body = match geometry.body {
        Body::Prism => preset.geometry.formulation == Formulation::PlaneStrain && geometry.ends == Ends::Free,
        Body::Revolved => preset.geometry.formulation == Formulation::Axisymmetric,
    };
    if geometry.formulation.is_solid() && same_body {
        section.geometry.formulation = preset.geometry.formulation;
    }
    section
}

/// What of the test itself, the pad aside, is other in `scenario` than in `preset`. In how many dimensions it is simulated is no
/// part of it.
fn changed(scenario: &Scenario, preset: &Scenario) -> Vec<String> {
    let scenario = &section_of(scenario, preset);
    let (pad, own) = (padding::place(scenario), padding::place(preset));
    if pad != own {
        return vec![format!("{pad} layers under the pad instead of {own}")];
    }
    let (now, then) = (Values::of(scenario), Values::of(preset));
    let of_the_test = |parameter: &Parameter| match parameter.layer() {
        Some(place) => place < pad,
        None => {
            let name = parameter.name().to_string();
            !FREE.contains(&parameter.name().group()) && name != "layers.count" && !name.starts_with(START)
        }
    };
    let acts = |parameter: &Parameter| parameter.without_effect(scenario).is_none();
    let is_other = |parameter: &Parameter| {
        let (a, b) = (now.get(*parameter), then.get(*parameter));
        (a - b).abs() > 1e-9 * b.abs()
    };
    let changed = Parameter::of(scenario).filter(of_the_test).filter(acts).filter(is_other);
    let mut texts: Vec<String> =
        changed.map(|parameter| described(&parameter, now.get(parameter), then.get(parameter))).collect();
    let [speed, own] = [scenario, preset].map(|scenario| scenario.impactor.start_speed());
    if (speed - own).abs() > 1e-6 * own {
        texts.push(format!("{} m/s at the start instead of {}", four_digits(speed), four_digits(own)));
    }
    texts
}

fn described(parameter: &Parameter, now: f64, then: f64) -> String {
    let text = |value: f64| match parameter.labels().get(value as usize) {
        Some(label) => (*label).to_string(),
        None => format!("{value}"),
    };
    format!("{} = {} instead of {}", parameter.name(), text(now), text(then))
}

#[cfg(test)]
mod tests {
    use super::*;
    use softanvil_kernel::preset;

    #[test]
    fn the_body_of_a_test_in_three_dimensions_is_its_test() {
        for preset in [preset::rugby_soft_anvil(), preset::en1621_1()] {
            let mut solid = preset.clone();
            solid.geometry.formulation = Formulation::Solid;
            assert_eq!(changed(&solid, &preset), Vec::<String>::new());
            let other = match solid.geometry.body {
                Body::Prism => Body::Revolved,
                Body::Revolved => Body::Prism,
            };
            solid.geometry.body = other;
            assert!(changed(&solid, &preset)[0].starts_with("geometry.formulation = solid instead of"));
        }
        let mut held = preset::rugby_soft_anvil();
        (held.geometry.formulation, held.geometry.ends) = (Formulation::Solid, Ends::Held);
        assert!(!changed(&held, &preset::rugby_soft_anvil()).is_empty());
    }
}
