//! What a search varies: a parameter of the kernel, or the overstress of a Prony term.

use serde::{Deserialize, Serialize};
use softanvil_kernel::material::{MAX_PRONY_TERMS, Material};
use softanvil_kernel::parameter::Kind;
use softanvil_kernel::{Changes, Parameter, Scenario};

use crate::scenario_file::names;

/// How a range is searched.
#[derive(Clone, Copy, Debug, Default, Deserialize, Serialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub enum Scale {
    /// Equal steps.
    #[default]
    Linear,
    /// Equal factors; the range is above 0.
    Log,
}

/// A range as the problem file states it, in SI.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Range {
    /// Smallest value.
    pub min: f64,
    /// Largest value.
    pub max: f64,
    /// How it is searched.
    #[serde(default)]
    pub scale: Scale,
    /// Where the search starts; without it the scenario's value.
    pub start: Option<f64>,
}

/// What a variable changes.
#[derive(Clone, Copy)]
enum Place {
    Row(Parameter),
    /// g_k / g_inf of a term of a layer: the long-term law and the other terms keep their stress when it changes, which g_k
    /// alone does not give.
    Overstress {
        /// The layer, counted from the core.
        layer: usize,
        /// The term, from 0.
        term: usize,
    },
}

/// A parameter with the range in which it is searched.
pub struct Variable {
    /// Name: that of a parameter, or `overstress_k` of a layer.
    pub name: String,
    /// SI unit.
    pub unit: &'static str,
    /// Its range.
    pub range: Range,
    place: Place,
}

/// The field of the overstress of a Prony term begins so.
const OVERSTRESS: &str = "overstress_";

impl Variable {
    /// The variable called `name` in `scenario`, searched in `range`.
    ///
    /// # Errors
    /// An unknown name, or a range that is empty or not legal for the parameter.
    pub fn new(scenario: &Scenario, name: &str, range: Range) -> Result<Self, String> {
        let place = place(scenario, name)?;
        let (unit, legal) = match place {
            Place::Row(parameter) => (parameter.unit(), parameter.range()),
            Place::Overstress { .. } => ("1", (0.0, 1e4)),
        };
        let refuse =
            |legal: String| Err(format!("{name} from {} to {} {unit} is refused: {legal}", range.min, range.max));
        if range.min.partial_cmp(&range.max) != Some(std::cmp::Ordering::Less) {
            return refuse("expected min below max".into());
        }
        if range.min < legal.0 || range.max > legal.1 {
            return refuse(format!("expected {} to {} {unit}", legal.0, legal.1));
        }
        if range.scale == Scale::Log && range.min <= 0.0 {
            return refuse("scale = \"log\" needs min above 0".into());
        }
        if let Some(start) = range.start
            && !(range.min <= start && start <= range.max)
        {
            return refuse(format!("its start = {start} {unit} has to be in the range"));
        }
        Ok(Self { name: name.into(), unit, range, place })
    }

    /// The parameter that it is; none of what several parameters make.
    pub fn parameter(&self) -> Option<Parameter> {
        match self.place {
            Place::Row(parameter) => Some(parameter),
            Place::Overstress { .. } => None,
        }
    }

    /// The value in `scenario`.
    pub fn get(&self, scenario: &Scenario) -> f64 {
        match self.place {
            Place::Row(parameter) => parameter.get(scenario),
            Place::Overstress { layer, term } => overstress(&scenario.layers[layer].material)[term],
        }
    }

    /// Gives the value at which the search starts.
    ///
    /// # Errors
    /// A value that is refused.
    pub fn give(&self, changes: &mut Changes) -> Result<(), String> {
        match self.place {
            Place::Row(parameter) => {
                let start = self.start(&changes.values().scenario());
                changes.set(parameter, start).map_err(|error| error.to_string())
            }
            Place::Overstress { .. } => Ok(()),
        }
    }

    /// Where the search starts, in the range.
    pub fn start(&self, scenario: &Scenario) -> f64 {
        self.range.start.unwrap_or_else(|| self.get(scenario)).clamp(self.range.min, self.range.max)
    }

    /// The value at `part` (0 to 1) of the range.
    pub fn value(&self, part: f64) -> f64 {
        let Range { min, max, scale, .. } = self.range;
        match scale {
            // Exact at both ends, and never outside.
            Scale::Linear => (min + part * (max - min)).clamp(min, max),
            Scale::Log if part >= 1.0 => max,
            Scale::Log => (min * (max / min).powf(part)).clamp(min, max),
        }
    }

    /// The part (0 to 1) of the range at which `value` lies.
    pub fn part(&self, value: f64) -> f64 {
        self.range.part(value)
    }
}

impl Range {
    /// The part (0 to 1) of the range at which `value` lies.
    pub fn part(&self, value: f64) -> f64 {
        let Self { min, max, scale, .. } = *self;
        match scale {
            Scale::Linear => (value - min) / (max - min),
            Scale::Log => (value / min).ln() / (max / min).ln(),
        }
    }
}

/// Part of a range next to a bound that counts as on it.
const ON_BOUND: f64 = 1e-3;

impl Variable {
    /// The bound of the range on which `value` lies, in words, if it does: what is best may then lie beyond it.
    pub fn bound(&self, value: f64) -> Option<&'static str> {
        match self.part(value) {
            part if part <= ON_BOUND => Some("lower bound"),
            part if part >= 1.0 - ON_BOUND => Some("upper bound"),
            _ => None,
        }
    }
}

/// Sets all `values` in `scenario`.
///
/// # Errors
/// A value that the kernel refuses.
pub fn apply(variables: &[Variable], values: &[f64], scenario: &mut Scenario) -> Result<(), String> {
    let before: Vec<_> = scenario.layers.iter().map(|layer| overstress(&layer.material)).collect();
    let mut ratios = before.clone();
    for (variable, value) in variables.iter().zip(values) {
        match variable.place {
            Place::Row(parameter) => parameter.set(scenario, *value).map_err(|error| error.to_string())?,
            Place::Overstress { layer, term } => ratios[layer][term] = *value,
        }
    }
    for (layer, (ratios, before)) in scenario.layers.iter_mut().zip(ratios.into_iter().zip(before)) {
        if ratios != before {
            let instantaneous = 1.0 + ratios.iter().sum::<f64>();
            layer.material.prony_g = ratios.map(|ratio| ratio / instantaneous);
        }
    }
    Ok(())
}

/// g_k / g_inf of every term.
fn overstress(material: &Material) -> [f64; MAX_PRONY_TERMS] {
    let g_inf = material.prony_g_inf();
    material.prony_g.map(|g| g / g_inf)
}

fn place(scenario: &Scenario, name: &str) -> Result<Place, String> {
    let overstress = name.rsplit_once('.').and_then(|(group, field)| Some((group, field.strip_prefix(OVERSTRESS)?)));
    if let Some((group, term)) = overstress {
        // The layer is that of any of its parameters.
        let layer = Parameter::find_in(scenario, &format!("{group}.prony_g_1")).and_then(|found| found.layer());
        let layer = layer.filter(|layer| *layer < scenario.layers.len());
        return match (layer, term.parse::<usize>()) {
            (Some(layer), Ok(term @ 1..=MAX_PRONY_TERMS)) => Ok(Place::Overstress { layer, term: term - 1 }),
            (Some(_), _) => {
                let first = format!("{group}.{OVERSTRESS}");
                Err(format!("{name} is unknown: expected {first}1 to {first}{MAX_PRONY_TERMS}"))
            }
            (None, _) => Err(names::unknown(scenario, name)),
        };
    }
    match Parameter::find_in(scenario, name) {
        Some(parameter) if parameter.kind() != Kind::Quantity => {
            Err(format!("{name} is no quantity and cannot be searched: give it under [fixed]"))
        }
        Some(parameter) => check_fits_impacts(&parameter).map(|()| Place::Row(parameter)),
        None => Err(names::unknown(scenario, name)),
    }
}

/// Refuses what states the drop, because every impact of a problem states its energy.
///
/// # Errors
/// Height, energy and speed of the drop, and the choice between them.
pub fn check_fits_impacts(parameter: &Parameter) -> Result<(), String> {
    let name = parameter.name();
    let states_drop = name.group() == "impactor" && name.field().starts_with("drop_");
    if states_drop { Err(format!("{name} has no effect: every impact has its energy")) } else { Ok(()) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use softanvil_kernel::preset;

    fn range(min: f64, max: f64) -> Range {
        Range { min, max, scale: Scale::Linear, start: None }
    }

    #[test]
    fn the_overstress_of_a_term_leaves_that_of_the_others() {
        let variables = [Variable::new(&preset::study(), "silicone.overstress_1", range(1.0, 60.0)).unwrap()];
        let mut scenario = preset::study();
        let before = overstress(&scenario.layers[0].material)[1];
        apply(&variables, &[7.0], &mut scenario).unwrap();
        let after = overstress(&scenario.layers[0].material);
        assert!((after[0] - 7.0).abs() < 1e-12 && (after[1] - before).abs() < 1e-12, "{after:?}");
        assert_eq!(variables[0].get(&scenario), after[0]);
    }

    /// Each layer has its terms; those of a layer that no variable is of stay as they are, to the last bit.
    #[test]
    fn the_overstress_is_that_of_its_layer() {
        let mut scenario = preset::study();
        scenario.add_layer(preset::chamois()).unwrap();
        let before = scenario.clone();
        let of_skin = Variable::new(&scenario, "skin.overstress_2", range(1.0, 60.0)).unwrap();
        apply(&[of_skin], &[3.0], &mut scenario).unwrap();
        assert_eq!(scenario.layers[0], before.layers[0]);
        assert_eq!(overstress(&scenario.layers[1].material), [0.0, 3.0, 0.0, 0.0, 0.0]);
    }

    #[test]
    fn a_range_is_walked_from_end_to_end() {
        for scale in [Scale::Linear, Scale::Log] {
            let variable = Variable::new(&preset::study(), "silicone.c10", Range { scale, ..range(1e3, 1e6) }).unwrap();
            assert_eq!((variable.value(0.0), variable.value(1.0)), (1e3, 1e6));
            assert!((variable.part(variable.value(0.3)) - 0.3).abs() < 1e-12);
        }
    }

    #[test]
    fn a_value_on_a_bound_is_told_from_one_inside() {
        let variable =
            Variable::new(&preset::study(), "silicone.c10", Range { scale: Scale::Log, ..range(1e3, 1e6) }).unwrap();
        assert_eq!([1e3, 1.001e3, 1e6].map(|value| variable.bound(value).is_some()), [true; 3]);
        assert_eq!((variable.bound(1e3), variable.bound(1e6)), (Some("lower bound"), Some("upper bound")));
        assert_eq!([1.1e3, 1e5, 9e5].map(|value| variable.bound(value)), [None; 3]);
    }

    #[test]
    fn a_refused_range_says_what_is_legal() {
        let refused = |name: &str, range: Range| Variable::new(&preset::study(), name, range).err().unwrap();
        assert!(refused("silicone.c1", range(0.0, 1.0)).contains("did you mean"));
        assert!(refused("silicone.law", range(0.0, 1.0)).contains("[fixed]"));
        assert!(refused("silicone.c10", range(2.0, 1.0)).contains("min below max"));
        assert!(refused("silicone.c10", Range { scale: Scale::Log, ..range(0.0, 1.0) }).contains("above 0"));
        assert!(refused("silicone.density", range(0.0, 1.0)).contains("expected 10 to 20000 kg/m3"));
        assert!(refused("layers[0].rows", range(0.0, 1.0)).contains("[fixed]"));
        assert!(refused("silicone.overstress_9", range(0.0, 1.0)).contains("silicone.overstress_5"));
        assert!(refused("skin.overstress_1", range(0.0, 1.0)).contains("no layer is called skin"));
    }
}
