//! Which parameters act in a scenario: a value that another parameter leaves without effect is not to pass unseen.

use super::{Kind, Parameter};
use crate::error::NoEffect;
use crate::number::real::Real;
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
    TEST.iter().chain(SILICONE).chain(SKIN)
}

/// Whether the parameter called `name` is a coefficient, or switches others on: at 0 there is nothing.
pub(super) fn is_off_at_zero(name: &str) -> bool {
    conditions().any(|condition| match condition.acts {
        Acts::CoefficientUnder(_) => condition.of == name,
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
        const LAW: &str = concat!($layer, ".law");
        const VOLUMETRIC_BY: &str = concat!($layer, ".volumetric_by");
        &[
            coefficient_under(concat!($layer, ".c10"), LAW, &["neo_hookean", "mooney_rivlin", "yeoh"]),
            coefficient_under(concat!($layer, ".c01"), LAW, &["mooney_rivlin"]),
            coefficient_under(concat!($layer, ".c11"), LAW, &["mooney_rivlin"]),
            coefficient_under(concat!($layer, ".c20"), LAW, &["mooney_rivlin", "yeoh"]),
            coefficient_under(concat!($layer, ".c02"), LAW, &["mooney_rivlin"]),
            coefficient_under(concat!($layer, ".c30"), LAW, &["yeoh"]),
            coefficient_under(concat!($layer, ".ogden_mu_1"), LAW, &["ogden"]),
            coefficient_under(concat!($layer, ".ogden_mu_2"), LAW, &["ogden"]),
            coefficient_under(concat!($layer, ".ogden_mu_3"), LAW, &["ogden"]),
            under(concat!($layer, ".ogden_alpha_1"), LAW, &["ogden"]),
            under(concat!($layer, ".ogden_alpha_2"), LAW, &["ogden"]),
            under(concat!($layer, ".ogden_alpha_3"), LAW, &["ogden"]),
            only_with(concat!($layer, ".ogden_alpha_1"), concat!($layer, ".ogden_mu_1")),
            only_with(concat!($layer, ".ogden_alpha_2"), concat!($layer, ".ogden_mu_2")),
            only_with(concat!($layer, ".ogden_alpha_3"), concat!($layer, ".ogden_mu_3")),
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

static SILICONE: &[Condition] = material_conditions!("silicone");
static SKIN: &[Condition] = material_conditions!("skin");
