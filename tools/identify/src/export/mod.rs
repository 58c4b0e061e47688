//! A material as other programs read it, each file with a reader of its own that knows the other program's conventions and
//! nothing of the writer: by [`card`] what is read is compared with the material.

pub mod abaqus;
pub mod c_source;
pub mod card;
pub mod ls_dyna;
pub mod ssv;

use softanvil_kernel::material::Material;
use softanvil_kernel::parameter::Kind;
use softanvil_kernel::{Parameter, Scenario, preset};

/// Which layer of the anvil the material is for.
///
/// ```
/// use softanvil_identify::export::{Layer, ssv};
/// use softanvil_identify::law::Law;
///
/// let material = Law::find("neo_hookean").unwrap().material(&[1e5]);
/// let values = ssv::text("skin", &material, Layer::Skin)?;
/// assert!(values.contains("layers[1].c10") && !values.contains("layers[0]"));
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Layer {
    /// The first from the core.
    #[default]
    Silicone,
    /// The second, on top of it.
    Skin,
}

impl Layer {
    /// Its place from the core.
    pub fn place(self) -> usize {
        match self {
            Self::Silicone => 0,
            Self::Skin => 1,
        }
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Silicone => "silicone",
            Self::Skin => "skin",
        }
    }
}

/// The study's anvil, whose `layer` is of `material`.
fn scenario(material: &Material, layer: Layer) -> Scenario {
    let mut scenario = preset::study();
    scenario.set_layer_count(layer.place() + 1);
    scenario.layers[layer.place()].material = *material;
    scenario
}

/// Every parameter of the material of `layer` that has an effect, and every coefficient of 0, with its value; a choice as its
/// index.
fn rows(material: &Material, layer: Layer) -> Vec<(Parameter, f64)> {
    let scenario = scenario(material, layer);
    let acts = |parameter: &Parameter| parameter.without_effect(&scenario).is_none();
    Parameter::of_material(layer.place()).filter(acts).map(|parameter| (parameter, parameter.get(&scenario))).collect()
}

/// The material of `layer` that the values `of` parameters make: numbers or labels of choices, as text. Those that are not there
/// keep the values of [`crate::law::blank`].
fn read_rows(of: impl Fn(&Parameter) -> Option<String>, layer: Layer) -> Result<Material, ReadBackError> {
    let mut scenario = scenario(&crate::law::blank(), layer);
    for parameter in Parameter::of_material(layer.place()) {
        let Some(text) = of(&parameter) else { continue };
        let number = match parameter.kind() {
            Kind::Quantity | Kind::Count => text.parse().ok(),
            Kind::Choice { labels } => {
                labels.iter().position(|label| label.eq_ignore_ascii_case(&text)).map(|index| index as f64)
            }
        };
        let number = number.ok_or_else(|| ReadBackError(format!("{} = {text}", parameter.name())))?;
        parameter.set(&mut scenario, number).map_err(|error| ReadBackError(error.to_string()))?;
    }
    Ok(scenario.layers[layer.place()].material)
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
    parameter.labels().get(value as usize).copied()
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
