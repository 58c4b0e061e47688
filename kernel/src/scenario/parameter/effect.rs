//! Which parameters act in a scenario: a value that another parameter leaves without effect is not to pass unseen.

use super::{Kind, Parameter};
use crate::error::NoEffect;
use crate::material::{COEFFICIENTS, Coefficient, ElasticLaw, N_COEFFICIENT, Role};
use crate::number::real::Real;
use crate::number::text::same;
use crate::scenario::Scenario;

/// What a parameter needs to act.
pub(super) struct Condition {
    /// Name of the parameter, or a group with its dot.
    pub(super) of: &'static str,
    /// Name of the parameter that decides.
    pub(super) by: &'static str,
    acts: Acts,
}

/// Where a parameter acts.
#[derive(Clone, Copy)]
enum Acts {
    /// Under these choices.
    Under(&'static [&'static str]),
    /// Under these choices; 0 says that there is nothing, which is so under the others, too.
    CoefficientUnder(&'static [&'static str]),
    /// Under the elastic laws that have the coefficient of this place; a modulus of 0 is nothing under the others, too.
    InLaw(usize),
    /// Under this choice, which is made by giving the parameter.
    Chosen(&'static str),
    /// Where the other parameter is not 0.
    Beside,
}

impl Condition {
    pub(super) fn concerns(&self, name: &str) -> bool {
        self.of == name || self.of.ends_with('.') && name.starts_with(self.of)
    }

    /// The index of the choice that is made by giving the parameter.
    pub(super) fn choice(&self) -> Option<usize> {
        match (self.acts, Parameter::find(self.by)?.kind) {
            (Acts::Chosen(label), Kind::Choice { labels, .. }) => labels.iter().position(|known| *known == label),
            _ => None,
        }
    }

    /// What the other parameter says, if that leaves `value` without effect.
    fn obstacle(&self, value: Real, scenario: &Scenario) -> Option<&'static str> {
        let by = Parameter::find(self.by)?;
        let says = match by.kind {
            Kind::Choice { labels, read, .. } => labels.get(read(scenario)).copied().unwrap_or_default(),
            Kind::Real { .. } => "",
        };
        let acts = match self.acts {
            Acts::Under(labels) => labels.contains(&says),
            Acts::CoefficientUnder(labels) => value == 0.0 || labels.contains(&says),
            Acts::InLaw(place) => {
                let law = ElasticLaw::from_repr(by.get(scenario) as usize);
                law.is_some_and(|law| law.places().contains(&place)) || value == 0.0 && is_modulus(place)
            }
            Acts::Chosen(label) => label == says,
            Acts::Beside => by.get(scenario) != 0.0,
        };
        if acts { None } else { Some(says) }
    }
}

impl Parameter {
    /// Why the value of this parameter has no effect in `scenario`; none if it acts.
    pub fn without_effect(&self, scenario: &Scenario) -> Option<NoEffect> {
        let value = self.get(scenario);
        conditions().filter(|condition| condition.concerns(self.name)).find_map(|condition| {
            let says = condition.obstacle(value, scenario)?;
            Some(NoEffect { name: self.name, value, unit: self.unit(), by: condition.by, says })
        })
    }
}

/// Every condition, those first that stand above others.
pub(super) fn conditions() -> impl Iterator<Item = &'static Condition> {
    let coefficients = COEFFICIENTS_OF_SILICONE.iter().chain(&COEFFICIENTS_OF_SKIN);
    TEST.iter().chain(coefficients).chain(SILICONE).chain(SKIN)
}

fn is_modulus(place: usize) -> bool {
    COEFFICIENTS.get(place).is_some_and(Coefficient::is_modulus)
}

/// Whether the parameter called `name` is a coefficient, or switches others on: at 0 there is nothing.
pub(super) fn is_off_at_zero(name: &str) -> bool {
    conditions().any(|condition| match condition.acts {
        Acts::CoefficientUnder(_) => condition.of == name,
        Acts::InLaw(place) => condition.of == name && is_modulus(place),
        Acts::Beside => condition.by == name,
        Acts::Under(_) | Acts::Chosen(_) => false,
    })
}

const fn under(of: &'static str, by: &'static str, choices: &'static [&'static str]) -> Condition {
    Condition { of, by, acts: Acts::Under(choices) }
}

const fn coefficient_under(of: &'static str, by: &'static str, choices: &'static [&'static str]) -> Condition {
    Condition { of, by, acts: Acts::CoefficientUnder(choices) }
}

const fn chosen(of: &'static str, by: &'static str, choice: &'static str) -> Condition {
    Condition { of, by, acts: Acts::Chosen(choice) }
}

const fn only_with(of: &'static str, by: &'static str) -> Condition {
    Condition { of, by, acts: Acts::Beside }
}

/// What does not belong to a material.
static TEST: &[Condition] = &[
    under("skin.", "geometry.layers", &["two"]),
    coefficient_under("geometry.skin_thickness", "geometry.layers", &["two"]),
    under("geometry.core_radius", "geometry.shape", &["round"]),
    under("geometry.block_width", "geometry.shape", &["block"]),
    under("geometry.length", "geometry.formulation", &["plane_strain"]),
    under("impactor.mass", "impactor.motion", &["drop"]),
    under("impactor.gravity", "impactor.motion", &["drop"]),
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

macro_rules! material_conditions {
    ($layer:literal) => {{
        const VOLUMETRIC_BY: &str = concat!($layer, ".volumetric_by");
        &[
            chosen(concat!($layer, ".bulk_modulus"), VOLUMETRIC_BY, "bulk_modulus"),
            chosen(concat!($layer, ".poissons_ratio"), VOLUMETRIC_BY, "poissons_ratio"),
            only_with(concat!($layer, ".prony_tau_1"), concat!($layer, ".prony_g_1")),
            only_with(concat!($layer, ".prony_tau_2"), concat!($layer, ".prony_g_2")),
            only_with(concat!($layer, ".prony_tau_3"), concat!($layer, ".prony_g_3")),
            only_with(concat!($layer, ".prony_tau_4"), concat!($layer, ".prony_g_4")),
            only_with(concat!($layer, ".prony_tau_5"), concat!($layer, ".prony_g_5")),
            only_with(concat!($layer, ".maxwell_beta_1"), concat!($layer, ".maxwell_g_1")),
            only_with(concat!($layer, ".maxwell_beta_2"), concat!($layer, ".maxwell_g_2")),
            only_with(concat!($layer, ".maxwell_beta_3"), concat!($layer, ".maxwell_g_3")),
            only_with(concat!($layer, ".maxwell_beta_4"), concat!($layer, ".maxwell_g_4")),
            only_with(concat!($layer, ".maxwell_beta_5"), concat!($layer, ".maxwell_g_5")),
            only_with(concat!($layer, ".slider_yield_stress"), concat!($layer, ".slider_stiffness")),
            only_with(concat!($layer, ".tear_width"), concat!($layer, ".tear_stretch")),
            only_with(concat!($layer, ".tear_residual"), concat!($layer, ".tear_stretch")),
        ]
    }};
}

static COEFFICIENTS_OF_SILICONE: [Condition; N_CONDITION] =
    coefficient_conditions(super::material::SILICONE, "silicone.law");
static COEFFICIENTS_OF_SKIN: [Condition; N_CONDITION] = coefficient_conditions(super::material::SKIN, "skin.law");

/// A condition for each coefficient of the elastic laws, and another for those that shape the term of a modulus.
const N_CONDITION: usize = {
    let (mut n, mut place) = (N_COEFFICIENT, 0);
    while place < N_COEFFICIENT {
        n += !COEFFICIENTS[place].is_modulus() as usize;
        place += 1;
    }
    n
};

/// The conditions of the coefficients among the `rows` of a layer, whose choice of a law is called `law`.
const fn coefficient_conditions(rows: &'static [Parameter], law: &'static str) -> [Condition; N_CONDITION] {
    let mut conditions = [const { only_with("", "") }; N_CONDITION];
    let (mut n, mut place) = (0, 0);
    while place < N_COEFFICIENT {
        let of = row_of(rows, COEFFICIENTS[place].name);
        conditions[n] = Condition { of, by: law, acts: Acts::InLaw(place) };
        n += 1;
        if let Role::Shape { of: modulus } = COEFFICIENTS[place].role {
            conditions[n] = only_with(of, row_of(rows, modulus));
            n += 1;
        }
        place += 1;
    }
    conditions
}

/// The whole name of the row whose name ends with a dot and `field`.
const fn row_of(rows: &'static [Parameter], field: &str) -> &'static str {
    let mut i = 0;
    while i < rows.len() {
        let (name, at) = (rows[i].name, rows[i].name.len().saturating_sub(field.len()));
        if at > 0 && name.as_bytes()[at - 1] == b'.' && same(name.split_at(at).1, field) {
            return name;
        }
        i += 1;
    }
    panic!("a coefficient without a row")
}

static SILICONE: &[Condition] = material_conditions!("silicone");
static SKIN: &[Condition] = material_conditions!("skin");
