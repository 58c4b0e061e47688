//! The identified material, and the files that carry it to the simulation and to other programs.

use softanvil_identify::export::card::{Card, States};
use softanvil_identify::export::{Layer, ReadBackError, abaqus, c_source, ls_dyna, ssv};
use softanvil_identify::law::Mode;
use softanvil_identify::law::volume::Volume;
use softanvil_kernel::material::{Material, Moduli, VolumetricBy};
use softanvil_kernel::{Scenario, preset};

use super::Identification;
use crate::failure::Failure;
use crate::scenario_file;

/// What the data do not identify.
#[derive(Clone)]
pub struct Given {
    /// Which moduli the curves gave.
    pub moduli: Moduli,
    /// Density, kg/m3.
    pub density: f64,
    /// Poisson's ratio.
    pub poissons_ratio: f64,
    /// Layer of the anvil.
    pub layer: Layer,
}

/// A material with the words that belong to it.
pub struct Identified {
    /// The material.
    pub material: Material,
    /// Its layer.
    pub layer: Layer,
    /// Where it comes from and what it is, in lines of plain text.
    pub comment: String,
    /// The states of the data, over which the files have to give the stresses of the material.
    pub states: Vec<States>,
}

/// What is written of a material, and what is not.
pub struct Files {
    /// Names and contents.
    pub written: Vec<(String, Vec<u8>)>,
    /// Names of files that would not give the material back, and why.
    pub refused: Vec<(String, String)>,
}

impl Files {
    /// Takes the file `name` with `text`, if what `read` makes of it is the material of `identified`.
    pub fn add(&mut self, identified: &Identified, name: &str, text: String, read: Result<Card, ReadBackError>) {
        let checked = read.map_err(|error| error.to_string());
        match checked.and_then(|card| card.check(&identified.material, &identified.states)) {
            Ok(()) => self.written.push((name.into(), text.into())),
            Err(reason) => self.refused.push((name.into(), reason)),
        }
    }

    /// Notes that there is no file `name`, because `program` does not have the law of `material`.
    fn lacks(&mut self, name: &str, program: &str, material: &Material) {
        let label = material.law.description().label;
        let reason = match material.law.description().compressible {
            false => format!("{program} has no law {label}"),
            true => format!(
                "the {label} of {program} has one Poisson's ratio for all terms (--poissons-ratio gives them one) and no viscous terms"
            ),
        };
        self.refused.push((name.into(), reason));
    }
}

/// States for a material that no curve was fitted for: uniaxial, half to twice the length.
fn states_without_data() -> Vec<States> {
    vec![(Mode::Uniaxial, (0..=30).map(|k| 0.5 + 0.05 * f64::from(k)).collect())]
}

/// A part of the modulus that stays, at least: the kernel needs an equilibrium.
const SMALLEST_EQUILIBRIUM: f64 = 1e-3;

impl Identified {
    /// The material of `identification`.
    ///
    /// # Errors
    /// Values that the kernel refuses, by name, value and range.
    pub fn new(identification: &Identification, given: &Given) -> Result<Self, Failure> {
        let mut lines = Vec::new();
        let mut material = match identification.law() {
            Some(fit) => {
                let files: Vec<_> = identification.curves.iter().flat_map(|curves| curves.files.clone()).collect();
                lines.push(format!("{} fitted to {}.", fit.law.label, files.join(", ")));
                fit.law.material(&fit.values)
            }
            None => {
                lines.push("No curve was fitted: the elastic law is that of the preset study.".into());
                let study = preset::study().layers[0].material;
                Material { prony_g: [0.0; 5], slider_stiffness: 0.0, slider_yield_stress: 0.0, ..study }
            }
        };
        material.moduli = given.moduli;
        lines.push(match given.moduli {
            Moduli::LongTerm => "The coefficients are long-term moduli (--moduli says otherwise).".into(),
            Moduli::Instantaneous => "The coefficients are instantaneous moduli.".into(),
        });
        material.density = given.density;
        material.volumetric_by = VolumetricBy::PoissonsRatio;
        let measured = match identification.volume {
            Volume::Measured { poissons_ratio, .. } => Some(poissons_ratio),
            Volume::Assumed | Volume::Stated(_) | Volume::OfLaw(_) => None,
        };
        material.poissons_ratio = measured.unwrap_or(given.poissons_ratio);
        let (density, ratio) = (given.density, given.poissons_ratio);
        lines.push(match measured {
            None if material.law.description().compressible => format!("Not identified: density {density} kg/m3,"),
            Some(ratio) => {
                format!("Poisson's ratio {ratio:.4} as in the files. Not identified: density {density} kg/m3,")
            }
            None => format!("Not identified: density {density} kg/m3, Poisson's ratio {ratio},"),
        });
        lines.push("no damping spring, no tear.".into());
        if let Some(relaxed) = &identification.relaxed {
            lines.extend(add_prony(&mut material, relaxed.choice.prony().normalised()));
        }
        lines.extend(identification.caveats.iter().map(|caveat| format!("Caveat: {caveat}.")));
        let states = identification.data.iter().map(|set| (set.mode, set.points.iter().map(|point| point.0).collect()));
        let states: Vec<States> = states.collect();
        let states = if states.is_empty() { states_without_data() } else { states };
        Self::checked(material, given.layer.clone(), lines.join("\n"), states)
    }

    /// The start from the study's scalars.
    ///
    /// # Errors
    /// Never, as its numbers are legal.
    pub fn of_study(layer: Layer) -> Result<Self, Failure> {
        let mut lines =
            vec!["A start from the scalars that the study prints, no fit. They contradict each other:".to_string()];
        lines.extend(softanvil_identify::study::contradictions().iter().map(|line| format!("- {line}.")));
        Self::checked(softanvil_identify::study::material(), layer, lines.join("\n"), states_without_data())
    }

    fn checked(material: Material, layer: Layer, comment: String, states: Vec<States>) -> Result<Self, Failure> {
        let identified = Self { material, layer, comment, states };
        match identified.scenario().validate() {
            Ok(()) => Ok(identified),
            Err(error) => Err(Failure::Failed(format!("the fitted material cannot be simulated: {error}"))),
        }
    }

    /// The study's scenario with this material.
    pub fn scenario(&self) -> Scenario {
        let mut scenario = anvil(&self.layer);
        scenario.layers[self.layer.place].material = self.material;
        scenario
    }

    /// The files, each of them read back.
    ///
    /// # Errors
    /// Never, as they are made in memory.
    pub fn files(&self) -> Result<Files, Failure> {
        let (material, layer) = (&self.material, &self.layer);
        let mut files = Files { written: Vec::new(), refused: Vec::new() };
        let toml = scenario_file::material_to_toml(&self.scenario(), layer.place, &self.comment);
        let read = self.read_toml(&toml);
        files.add(self, "material.toml", toml, read);
        let text = ssv::text("material", material, layer).map_err(|error| Failure::Failed(error.to_string()))?;
        let read = ssv::read(&text, layer);
        files.add(self, "material.ssv", text, read);
        let text = c_source::text(&self.comment, material, layer);
        let read = c_source::read(&text, layer);
        files.add(self, "material.h", text, read);
        match ls_dyna::text("Softanvil", &self.comment, material) {
            Some(text) => files.add(self, "material-lsdyna.k", text.clone(), ls_dyna::read(&text)),
            None => files.lacks("material-lsdyna.k", "LS-DYNA", material),
        }
        match abaqus::text("SOFTANVIL", &self.comment, material) {
            Some(text) => files.add(self, "material-abaqus.inp", text.clone(), abaqus::read(&text)),
            None => files.lacks("material-abaqus.inp", "Abaqus", material),
        }
        Ok(files)
    }

    /// The material that a scenario or material file makes of the preset's.
    ///
    /// # Errors
    /// A file that is refused.
    pub fn read_toml(&self, text: &str) -> Result<Card, ReadBackError> {
        let scenario =
            scenario_file::parse(text, &anvil(&self.layer)).map_err(|error| ReadBackError::new(error.to_string()))?;
        Ok(Card::of(&scenario.layers[self.layer.place].material))
    }
}

/// Thickness of a pad that nothing is said of, m: the most that rugby union's body padding may have.
const PAD_THICKNESS: f64 = 10e-3;
/// Density of a foam that nothing is said of, kg/m3: rugby union's body padding may have 45, and 15 more. The mass of a pad hardly
/// matters beside that of the impactor.
const FOAM_DENSITY: f64 = 50.0;

/// The study's anvil; where the layer is a skin, with that on a silicone that is as much thinner, and where it is another one, with
/// a pad at its place and plain silicones of the same thickness between.
fn anvil(layer: &Layer) -> Scenario {
    let mut scenario = preset::study();
    let skin = preset::chamois();
    if layer.place == 1 && layer.name == skin.name.as_str() {
        scenario.layers[0].thickness -= skin.thickness;
        scenario.set_layer_count(layer.place + 1);
        scenario.layers[layer.place] = skin;
        return scenario;
    }
    scenario.set_layer_count(layer.place + 1);
    for other in scenario.layers.iter_mut().skip(1) {
        other.thickness = PAD_THICKNESS;
    }
    scenario.layers[layer.place].name = layer.name.as_str().try_into().unwrap_or_default();
    scenario
}

/// Gives the material the terms, which leave it an equilibrium; says so if that changed them.
fn add_prony(material: &mut Material, terms: Vec<(f64, f64)>) -> Option<String> {
    let sum: f64 = terms.iter().map(|term| term.0).sum();
    let scale = if sum > 1.0 - SMALLEST_EQUILIBRIUM { (1.0 - SMALLEST_EQUILIBRIUM) / sum } else { 1.0 };
    for (k, (g, tau)) in terms.into_iter().enumerate() {
        material.prony_g[k] = scale * g;
        material.prony_tau[k] = tau;
    }
    (scale < 1.0).then(|| {
        format!("The data relax to nothing: g was scaled so that {SMALLEST_EQUILIBRIUM} of the modulus stays.")
    })
}

/// What the options give, and the layer's values in the preset study where they leave it open.
pub fn given(moduli: Moduli, density: Option<f64>, poissons_ratio: Option<f64>, layer: Layer, foam: bool) -> Given {
    let own = anvil(&layer).layers[layer.place].material;
    Given {
        moduli,
        density: density.unwrap_or(if foam { FOAM_DENSITY } else { own.density }),
        poissons_ratio: poissons_ratio.unwrap_or(own.poissons_ratio),
        layer,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_no_option_gives_is_the_preset_s() {
        let silicone = preset::study().layers[0].material;
        for (layer, material) in [("silicone", silicone), ("skin", preset::chamois().material)] {
            let layer = Layer::parse(layer).unwrap();
            let left_open = given(Moduli::LongTerm, None, None, layer.clone(), false);
            assert_eq!((left_open.density, left_open.poissons_ratio), (material.density, material.poissons_ratio));
            assert_eq!(given(Moduli::LongTerm, None, Some(0.4), layer, false).poissons_ratio, 0.4);
        }
    }
}
