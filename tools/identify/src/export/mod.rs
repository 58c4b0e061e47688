//! A material as other programs read it, each file with a reader of its own that knows the other program's conventions and
//! nothing of the writer: by [`card`] what is read is compared with the material.

pub mod abaqus;
pub mod c_source;
pub mod card;
pub mod ls_dyna;
pub mod ssv;

use softanvil_kernel::material::Material;
use softanvil_kernel::parameter::Kind;
use softanvil_kernel::scenario::Layers;
use softanvil_kernel::{PARAMETERS, Parameter, preset};

/// Which layer of the anvil the material is for.
///
/// ```
/// use softanvil_identify::export::{Layer, ssv};
/// use softanvil_identify::law::Law;
///
/// let material = Law::find("neo_hookean").unwrap().material(&[1e5]);
/// let values = ssv::text("skin", &material, Layer::Skin)?;
/// assert!(values.contains("skin.c10") && !values.contains("silicone."));
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Layer {
    /// Parameters `silicone.*`.
    #[default]
    Silicone,
    /// Parameters `skin.*`.
    Skin,
}

impl Layer {
    /// Group of its parameters.
    pub fn group(self) -> &'static str {
        match self {
            Self::Silicone => "silicone",
            Self::Skin => "skin",
        }
    }
}

/// Every parameter of the material of `layer` that has an effect, and every coefficient of 0, with its value; a choice as its
/// index.
fn rows(material: &Material, layer: Layer) -> Vec<(&'static Parameter, f64)> {
    let mut scenario = preset::study();
    match layer {
        Layer::Silicone => scenario.layers[0].material = *material,
        Layer::Skin => (scenario.skin, scenario.geometry.layers) = (*material, Layers::Two),
    }
    let acts = |parameter: &&Parameter| parameter.without_effect(&scenario).is_none();
    let of_layer =
        |parameter: &&Parameter| parameter.name.split_once('.').is_some_and(|(group, _)| group == layer.group());
    PARAMETERS.iter().filter(of_layer).filter(acts).map(|parameter| (parameter, parameter.get(&scenario))).collect()
}

/// The material of `layer` that the values `of` parameters, by name, make: numbers or labels of choices, as text. Those that
/// are not there keep the values of [`crate::law::blank`].
fn read_rows(of: impl Fn(&str) -> Option<String>, layer: Layer) -> Result<Material, ReadBackError> {
    let mut scenario = preset::study();
    (scenario.layers[0].material, scenario.skin) = (crate::law::blank(), crate::law::blank());
    for parameter in
        PARAMETERS.iter().filter(|p| p.name.split_once('.').is_some_and(|(group, _)| group == layer.group()))
    {
        let Some(text) = of(parameter.name) else { continue };
        let number = match parameter.kind {
            Kind::Real { .. } => text.parse().ok(),
            Kind::Choice { labels, .. } => {
                labels.iter().position(|label| label.eq_ignore_ascii_case(&text)).map(|index| index as f64)
            }
        };
        let number = number.ok_or_else(|| ReadBackError(format!("{} = {text}", parameter.name)))?;
        parameter.set(&mut scenario, number).map_err(|error| ReadBackError(error.to_string()))?;
    }
    Ok(if layer == Layer::Skin { scenario.skin } else { scenario.layers[0].material })
}

/// The coefficient called `name` of a law that has it; 0 of others.
fn coefficient(material: &Material, name: &str) -> f64 {
    let has_it = material.law.description().coefficients.iter().any(|coefficient| coefficient.name == name);
    material.coefficient(name).filter(|_| has_it).unwrap_or(0.0)
}

/// The terms of an Ogden law that are on: (mu, alpha).
fn ogden_terms(material: &Material) -> Vec<(f64, f64)> {
    let coefficients = material.law.description().coefficients;
    let values: Vec<f64> = coefficients.iter().map(|c| coefficient(material, c.name)).collect();
    values.chunks_exact(2).map(|term| (term[0], term[1])).filter(|(mu, _)| *mu != 0.0).collect()
}

/// What a reader of a file stumbles upon.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{0} cannot be read back")]
pub struct ReadBackError(pub(crate) String);

impl ReadBackError {
    /// `what` is missing or no number.
    pub fn new(what: impl Into<String>) -> Self {
        Self(what.into())
    }
}

/// The label of a choice; none for a number.
fn label(parameter: &Parameter, value: f64) -> Option<&'static str> {
    match parameter.kind {
        Kind::Choice { labels, .. } => labels.get(value as usize).copied(),
        Kind::Real { .. } => None,
    }
}

/// The terms of a Prony series that are on: (g_i, tau_i).
fn prony_terms(material: &Material) -> impl Iterator<Item = (f64, f64)> {
    material.prony_g.into_iter().zip(material.prony_tau).filter(|(g, _)| *g > 0.0)
}

/// (G_i, beta_i) of the Prony terms and of the additive Maxwell terms.
pub(super) fn viscous(material: &Material) -> impl Iterator<Item = (f64, f64)> {
    let scale = material.shear_modulus_inf() / material.prony_g_inf();
    let maxwell = material.maxwell_g.into_iter().zip(material.maxwell_beta).filter(|(g, _)| *g > 0.0);
    prony_terms(material).map(move |(g, tau)| (scale * g, 1.0 / tau)).chain(maxwell)
}
