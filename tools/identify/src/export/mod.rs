//! A material as other programs read it, each file with a reader of its own that knows the other program's conventions and
//! nothing of the writer: by [`card`] what is read is compared with the material.

pub mod abaqus;
pub mod c_source;
pub mod card;
pub mod ls_dyna;
pub mod ssv;

use softanvil_kernel::material::Material;
use softanvil_kernel::parameter::Kind;
use softanvil_kernel::scenario::{MAX_LAYER_NAME, MAX_LAYERS};
use softanvil_kernel::{Parameter, Scenario, preset};

use crate::law::foam::stress::Term;

/// Which layer of the stack the material is for.
///
/// ```
/// use softanvil_identify::export::{Layer, ssv};
/// use softanvil_identify::law::Law;
///
/// let material = Law::find("neo_hookean").unwrap().material(&[1e5]);
/// let values = ssv::text("skin", &material, &Layer::parse("skin")?)?;
/// assert!(values.contains("layers[1].c10") && !values.contains("layers[0]"));
/// assert_eq!(Layer::parse("pad=0")?, Layer { place: 0, name: "pad".into() });
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Layer {
    /// Its place from the core.
    pub place: usize,
    /// Its name.
    pub name: String,
}

impl Layer {
    /// The first from the core, and what lies on it.
    const NAMES: [&'static str; 2] = ["silicone", "pad"];

    /// The layer that `text` says: its name, its place, or both as in "pad=0". The silicone is the first from the core and every
    /// other name one of the second; a place without a name is that of the silicone, or of a pad.
    ///
    /// # Errors
    /// What is legal.
    pub fn parse(text: &str) -> Result<Self, String> {
        let is_name = |name: &str| {
            name.starts_with(|c: char| c.is_ascii_alphabetic())
                && name.len() <= MAX_LAYER_NAME
                && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
        };
        let (name, place) = match text.split_once('=') {
            Some((name, place)) => (name, place.parse().ok()),
            None => match text.parse() {
                Ok(place) => (Self::NAMES[usize::from(place > 0)], Some(place)),
                Err(_) => (text, Some(usize::from(text != Self::NAMES[0]))),
            },
        };
        let place = place.filter(|place| *place < MAX_LAYERS && is_name(name));
        place.map(|place| Self { place, name: name.into() }).ok_or_else(|| {
            let last = MAX_LAYERS - 1;
            format!("expected the name of a layer, its place from the core, 0 to {last}, or both, as in pad=1")
        })
    }
}

/// The study's anvil, whose `layer` is of `material`.
fn scenario(material: &Material, layer: &Layer) -> Scenario {
    let mut scenario = preset::study();
    scenario.set_layer_count(layer.place + 1);
    scenario.layers[layer.place].material = *material;
    scenario
}

/// Every parameter of the material of `layer` that has an effect, and every coefficient of 0, with its value; a choice as its
/// index.
fn rows(material: &Material, layer: &Layer) -> Vec<(Parameter, f64)> {
    let scenario = scenario(material, layer);
    let acts = |parameter: &Parameter| parameter.without_effect(&scenario).is_none();
    Parameter::of_material(layer.place).filter(acts).map(|parameter| (parameter, parameter.get(&scenario))).collect()
}

/// The material of `layer` that the values `of` parameters make: numbers or labels of choices, as text. Those that are not there
/// keep the values of [`crate::law::blank`].
fn read_rows(of: impl Fn(&Parameter) -> Option<String>, layer: &Layer) -> Result<Material, ReadBackError> {
    let mut scenario = scenario(&crate::law::blank(), layer);
    for parameter in Parameter::of_material(layer.place) {
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
    Ok(scenario.layers[layer.place].material)
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

/// The terms of a foam that are on.
fn foam_terms(material: &Material) -> Vec<Term> {
    let values: Vec<f64> =
        material.law.description().coefficients.iter().map(|c| coefficient(material, c.name)).collect();
    Term::list(&values).into_iter().filter(|term| term.mu != 0.0).collect()
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
