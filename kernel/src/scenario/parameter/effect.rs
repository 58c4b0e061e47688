//! Which parameters act in a scenario: a value that another parameter leaves without effect is not to pass unseen.

use super::Parameter;
use crate::error::{Name, NoEffect, Says};
use crate::material::{COEFFICIENTS, Coefficient, ElasticLaw, N_COEFFICIENT, Role};
use crate::number::real::Real;
use crate::scenario::{MAX_LAYERS, Scenario};

/// What a parameter needs to act.
pub(super) struct Condition {
    /// Name of the parameter; of a layer's the field alone.
    of: &'static str,
    /// Name of the parameter that decides, of the same layer.
    by: &'static str,
    acts: Acts,
}

/// Where a parameter acts.
#[derive(Clone, Copy)]
enum Acts {
    /// Under these choices.
    Under(&'static [&'static str]),
    /// Under the elastic laws that have the coefficient of this place; a modulus of 0 is nothing under the others, too.
    InLaw(usize),
    /// Under the isochoric laws: a compressible one says the mean stress itself.
    BesideIsochoric,
    /// Under this choice, which is made by giving the parameter.
    Chosen(&'static str),
    /// Where the other parameter is not 0.
    Beside,
    /// Of a layer that lies on another one: what the lowest one lies on another parameter says, which is no layer's.
    OnLayer,
}

/// A condition of the parameters of a layer, or of those of none.
#[derive(Clone, Copy)]
pub(super) struct Placed {
    condition: &'static Condition,
    layer: Option<usize>,
}

impl Placed {
    /// The condition at a place among those of the parameters of a layer, or of none.
    #[inline(never)]
    fn at(layer: Option<usize>, place: usize) -> Option<Self> {
        let condition = match (layer, place.checked_sub(COEFFICIENT.len())) {
            (None, _) => TEST.get(place)?,
            (Some(_), None) => COEFFICIENT.get(place)?,
            (Some(_), Some(place)) => LAYER.get(place)?,
        };
        Some(Self { condition, layer })
    }

    /// The parameter that has to act.
    pub(super) fn of(&self) -> Name {
        self.name(self.condition.of)
    }

    /// The parameter that decides.
    pub(super) fn by(&self) -> Name {
        match self.condition.acts {
            Acts::OnLayer => self.condition.by.into(),
            _ => self.name(self.condition.by),
        }
    }

    fn name(&self, text: &'static str) -> Name {
        self.layer.map_or(text.into(), |layer| Name::of_layer(layer, text))
    }

    /// The parameter that decides.
    pub(super) fn decider(&self) -> Option<Parameter> {
        Parameter::named(self.by())
    }

    /// Whether giving the parameter makes a choice.
    pub(super) fn is_choice(&self) -> bool {
        matches!(self.condition.acts, Acts::Chosen(_))
    }

    /// The index of the choice that is made by giving the parameter.
    pub(super) fn choice(&self) -> Option<usize> {
        match self.condition.acts {
            Acts::Chosen(label) => self.decider()?.labels().iter().position(|known| *known == label),
            _ => None,
        }
    }

    /// What the other parameter says, if that leaves `value` without effect.
    fn obstacle(&self, value: Real, scenario: &Scenario) -> Option<Says> {
        let decider = self.decider()?;
        let number = decider.get(scenario);
        let label = decider.labels().get(number as usize).copied();
        let says = label.unwrap_or_default();
        let acts = match self.condition.acts {
            // What has no effect itself decides nothing.
            Acts::Under(labels) => labels.contains(&says) || decider.without_effect(scenario).is_some(),
            Acts::InLaw(place) => {
                let law = ElasticLaw::from_repr(number as usize);
                law.is_some_and(|law| law.places().contains(&place)) || value == 0.0 && is_modulus(place)
            }
            Acts::BesideIsochoric => ElasticLaw::from_repr(number as usize).is_some_and(|law| !law.is_compressible()),
            Acts::Chosen(label) => label == says,
            Acts::Beside => number != 0.0,
            Acts::OnLayer => self.layer != Some(0),
        };
        if acts { None } else { Some(label.map_or(Says::Number(number), Says::Label)) }
    }
}

impl Parameter {
    /// Why the value of this parameter has no effect in `scenario`; none if it acts.
    pub fn without_effect(&self, scenario: &Scenario) -> Option<NoEffect> {
        self.refused(self.get(scenario), scenario, scenario.layers.len())
    }

    /// Why `value` of this parameter has no effect in `scenario`, of whose layers only the first `layers` count; none if it
    /// acts.
    pub(super) fn refused(&self, value: Real, scenario: &Scenario, layers: usize) -> Option<NoEffect> {
        if self.layer().is_some_and(|layer| layer >= layers) {
            return Some(self.of_absent_layer(value, layers));
        }
        conditions_of(self.layer()).filter(|condition| condition.of() == self.name()).find_map(|condition| {
            let says = condition.obstacle(value, scenario)?;
            Some(NoEffect { name: self.name(), value, unit: self.unit(), by: condition.by(), says })
        })
    }

    /// Whether the parameter is a coefficient, or switches others on: at 0 there is nothing.
    pub(super) fn is_off_at_zero(&self) -> bool {
        conditions_of(self.layer()).any(|placed| match placed.condition.acts {
            Acts::InLaw(place) => placed.of() == self.name() && is_modulus(place),
            Acts::Beside => placed.by() == self.name(),
            Acts::Under(_) | Acts::BesideIsochoric | Acts::Chosen(_) | Acts::OnLayer => false,
        })
    }
}

/// Every condition, those first that stand above others.
pub(super) fn conditions() -> impl Iterator<Item = Placed> + Clone {
    (0..=MAX_LAYERS).flat_map(|place| conditions_of(place.checked_sub(1)))
}

/// The conditions of the parameters of a layer, or of those of none.
fn conditions_of(layer: Option<usize>) -> impl Iterator<Item = Placed> + Clone {
    let count = if layer.is_some() { COEFFICIENT.len() + LAYER.len() } else { TEST.len() };
    (0..count).filter_map(move |place| Placed::at(layer, place))
}

fn is_modulus(place: usize) -> bool {
    COEFFICIENTS.get(place).is_some_and(Coefficient::is_modulus)
}

const fn under(of: &'static str, by: &'static str, choices: &'static [&'static str]) -> Condition {
    Condition { of, by, acts: Acts::Under(choices) }
}

const fn chosen(of: &'static str, by: &'static str, choice: &'static str) -> Condition {
    Condition { of, by, acts: Acts::Chosen(choice) }
}

const fn beside_isochoric(of: &'static str) -> Condition {
    Condition { of, by: "law", acts: Acts::BesideIsochoric }
}

const fn on_layer(of: &'static str, by: &'static str) -> Condition {
    Condition { of, by, acts: Acts::OnLayer }
}

const fn only_with(of: &'static str, by: &'static str) -> Condition {
    Condition { of, by, acts: Acts::Beside }
}

/// What does not belong to a layer.
static TEST: &[Condition] = &[
    under("geometry.core_radius", "geometry.shape", &["round"]),
    under("geometry.block_width", "geometry.shape", &["block"]),
    under("geometry.section", "geometry.formulation", &["plane_strain", "axisymmetric"]),
    under("geometry.body", "geometry.formulation", &["solid"]),
    under("geometry.symmetry", "geometry.formulation", &["solid"]),
    under("geometry.ends", "geometry.formulation", &["solid"]),
    under("geometry.ends", "geometry.body", &["prism"]),
    under("geometry.length", "geometry.formulation", &["plane_strain", "solid"]),
    under("geometry.length", "geometry.body", &["prism"]),
    under("impactor.mass", "impactor.motion", &["drop"]),
    under("impactor.face_diameter", "impactor.shape", &["round", "sphere", "bar"]),
    under("impactor.face_width", "impactor.shape", &["rectangular"]),
    under("impactor.face_length", "impactor.shape", &["rectangular", "bar"]),
    under("impactor.gravity", "impactor.motion", &["drop"]),
    under("impactor.rail_friction", "impactor.motion", &["drop"]),
    under("impactor.rail_damping", "impactor.motion", &["drop"]),
    under("impactor.drop_by", "impactor.motion", &["drop"]),
    under("impactor.drop_height", "impactor.motion", &["drop"]),
    under("impactor.drop_energy", "impactor.motion", &["drop"]),
    under("impactor.drop_speed", "impactor.motion", &["drop"]),
    chosen("impactor.drop_height", "impactor.drop_by", "height"),
    chosen("impactor.drop_energy", "impactor.drop_by", "energy"),
    chosen("impactor.drop_speed", "impactor.drop_by", "speed"),
    under("impactor.prescribed_speed", "impactor.motion", &["prescribed"]),
    under("impactor.prescribed_depth", "impactor.motion", &["prescribed"]),
    under("impactor.prescribed_rise", "impactor.motion", &["prescribed"]),
    under("core.friction_coefficient", "core.interface", &["frictional"]),
    chosen("time.safety_factor", "time.step_by", "safety_factor"),
    chosen("time.step", "time.step_by", "given"),
    under("time.design_compression", "impactor.motion", &["driven"]),
    under("time.design_compression", "time.step_by", &["safety_factor"]),
];

/// What belongs to a layer, but for the coefficients of the elastic laws.
static LAYER: &[Condition] = &[
    beside_isochoric("volumetric_law"),
    beside_isochoric("volumetric_by"),
    beside_isochoric("bulk_modulus"),
    beside_isochoric("poissons_ratio"),
    chosen("bulk_modulus", "volumetric_by", "bulk_modulus"),
    chosen("poissons_ratio", "volumetric_by", "poissons_ratio"),
    only_with("prony_tau_1", "prony_g_1"),
    only_with("prony_tau_2", "prony_g_2"),
    only_with("prony_tau_3", "prony_g_3"),
    only_with("prony_tau_4", "prony_g_4"),
    only_with("prony_tau_5", "prony_g_5"),
    only_with("maxwell_beta_1", "maxwell_g_1"),
    only_with("maxwell_beta_2", "maxwell_g_2"),
    only_with("maxwell_beta_3", "maxwell_g_3"),
    only_with("maxwell_beta_4", "maxwell_g_4"),
    only_with("maxwell_beta_5", "maxwell_g_5"),
    only_with("slider_yield_stress", "slider_stiffness"),
    on_layer("interface", "core.interface"),
    on_layer("friction_coefficient", "core.interface"),
    under("friction_coefficient", "interface", &["frictional"]),
    on_layer("gap", "core.interface"),
    under("gap", "interface", &["frictional", "separating"]),
    only_with("tear_width", "tear_stretch"),
    only_with("tear_residual", "tear_stretch"),
    only_with("softening_m", "softening_r"),
    only_with("softening_beta", "softening_r"),
];

/// A coefficient acts in the laws that have it; one that shapes the term of a modulus, where that is not 0 as well.
static COEFFICIENT: [Condition; N_CONDITION] = {
    let mut conditions = [const { only_with("", "") }; N_CONDITION];
    let (mut n, mut place) = (0, 0);
    while place < N_COEFFICIENT {
        let of = COEFFICIENTS[place].name;
        conditions[n] = Condition { of, by: "law", acts: Acts::InLaw(place) };
        n += 1;
        if let Role::Shape { of: modulus } = COEFFICIENTS[place].role {
            conditions[n] = only_with(of, modulus);
            n += 1;
        }
        place += 1;
    }
    conditions
};

const N_CONDITION: usize = {
    let (mut n, mut place) = (N_COEFFICIENT, 0);
    while place < N_COEFFICIENT {
        n += !COEFFICIENTS[place].is_modulus() as usize;
        place += 1;
    }
    n
};
