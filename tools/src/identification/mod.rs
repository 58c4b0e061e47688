//! From files of test data to a material: what `softanvil fit` works with.
//!
//! [`files`] reads the curves, [`volume`] says what is known of the specimens' volume, [`Identification`] fits and chooses, [`table`] and [`json`] say what came out, and
//! [`material`] holds the files that carry it on.

pub mod files;
pub mod json;
pub mod material;
pub mod table;
pub mod trial;
pub mod volume;

use softanvil_identify::law::fit::{Fit, Settings, predict};
use softanvil_identify::law::parts::{Misfit, Part};
use softanvil_identify::law::volume::Volume;
use softanvil_identify::law::{DataSet, FOAMS, LAWS, Law, Mode, ranking, stability, stress};
use softanvil_identify::relaxation::choice::Choice;
use softanvil_identify::relaxation::read::{self as relaxation, Test};

use crate::failure::Failure;
use files::{Curves, Source};

/// A relaxation test and the series that describe it.
pub struct Relaxed {
    /// The test.
    pub test: Test,
    /// Series of each number of terms.
    pub choice: Choice,
}

/// Fitted laws and series.
pub struct Identification {
    /// The curves, in the order of the options.
    pub curves: Vec<Curves>,
    /// How the specimens' volume behaves.
    pub volume: Volume,
    /// What the laws were fitted to: the isochoric part of the curves; of a foam the curves.
    pub data: Vec<DataSet>,
    /// The laws in the order of the ranking; empty without curves.
    pub fits: Vec<Fit>,
    /// Laws that could not be fitted, and why.
    pub failed: Vec<String>,
    /// Index of the chosen law.
    pub chosen: usize,
    /// How the laws were fitted.
    pub settings: Settings,
    /// What to think of before believing the chosen law.
    pub caveats: Vec<String>,
    /// The relaxation.
    pub relaxed: Option<Relaxed>,
}

/// Stretches over which stability is asked for, unless the data go further: those of the softest layers in a drop.
const STABILITY_RANGE: (f64, f64) = (0.5, 2.0);

/// The same of foams, which a pad presses further together and hardly stretches.
const FOAM_RANGE: (f64, f64) = (0.2, 1.5);

/// What is told if no law can be fitted.
const HINT: &str =
    "Are the columns read as they are meant: strain or stretch (--columns), tension or compression (--direction)?";

/// What is told if only unstable laws can be.
const UNSTABLE: &str = "An unstable law is chosen by --law alone.";

/// What to do with the data.
pub struct Request {
    /// Stretches over which stability is asked for; none for those of the data and of a drop.
    pub stability_range: Option<(f64, f64)>,
    /// How to fit.
    pub settings: Settings,
    /// Law instead of the stable one of lowest residual.
    pub law: Option<&'static Law>,
    /// Whether the laws are those of foams.
    pub foam: bool,
    /// Number of Prony terms instead of the chosen one.
    pub n_term: Option<usize>,
    /// Poisson's ratio, if the user states it.
    pub poissons_ratio: Option<f64>,
}

impl Identification {
    /// Fits every law to `curves` and every series to the relaxation in `relaxation`.
    ///
    /// # Errors
    /// A relaxation that is refused, a planar test of a compressible specimen, or no law that can be fitted.
    pub fn new(
        curves: Vec<Curves>,
        relaxation: Option<(&Source, &relaxation::Options)>,
        request: &Request,
    ) -> Result<Self, Failure> {
        let (volume, mut caveats) = match request.foam {
            true => volume::of_foam(&curves, request.poissons_ratio)?,
            false => (volume::of(&curves, request.poissons_ratio)?, Vec::new()),
        };
        let isochoric = |set: &DataSet| DataSet {
            mode: set.mode,
            points: set.points.iter().map(|point| volume.isochoric(set.mode, *point)).collect(),
        };
        let data: Vec<DataSet> = curves.iter().map(|curves| isochoric(&curves.data)).collect();
        let mut settings = request.settings;
        settings.stability_range = request.stability_range.unwrap_or_else(|| stability_range(&data, request.foam));
        settings.poissons_ratio = volume.poissons_ratio().filter(|_| request.foam);
        let laws = if request.foam { FOAMS.iter() } else { LAWS.iter() };
        let (mut fits, mut failed, mut worse) = (Vec::new(), Vec::new(), 0);
        for law in laws.filter(|_| !data.is_empty()) {
            match Fit::new(law, &data, &settings) {
                // Worse than a constant: it says nothing about these data.
                Some(fit) if fit.statistics.r_squared < 0.0 => {
                    let r_squared = fit.statistics.r_squared;
                    failed
                        .push(format!("{} is farther from the data than their mean (R2 = {r_squared:.3})", law.label));
                    worse += 1;
                }
                Some(fit) => fits.push(fit),
                None => failed.push(reason(law, &data, &settings)),
            }
        }
        let fits = ranking::rank(fits);
        if fits.is_empty() && !data.is_empty() {
            return Err(Failure::Failed(format!("no law can be fitted: {}. {HINT}", failed.join("; "))));
        }
        // What remains follows the data only by being unstable, which is no choice to make unasked.
        let any_stable = fits.iter().any(|fit| fit.is_stable && fit.is_usable());
        if request.law.is_none() && worse > 0 && !any_stable {
            let reasons = failed.join("; ");
            return Err(Failure::Failed(format!("no stable law describes the data: {reasons}. {HINT} {UNSTABLE}")));
        }
        let chosen = match request.law {
            Some(law) => position(&fits, law, &failed)?,
            None => ranking::choose(&fits),
        };
        caveats.extend(curves.iter().flat_map(|curves| curves.warnings.iter().cloned()));
        caveats.extend(volume::caveats(&curves, volume));
        caveats.extend(fits.get(chosen).into_iter().flat_map(|fit| ranking::caveats(fit, &fits, &data, &settings)));
        let relaxed = match relaxation {
            Some((source, options)) => Some(Relaxed::new(source, options, fits.get(chosen), volume, request.n_term)?),
            None => None,
        };
        Ok(Self { curves, volume, data, fits, failed, chosen, settings, caveats, relaxed })
    }

    /// Every test, and how far `fit` is from it.
    pub fn misfits(&self, fit: &Fit) -> Vec<(Part, Misfit)> {
        let measured: Vec<f64> = self.data.iter().flat_map(|set| set.points.iter().map(|point| point.1)).collect();
        let stresses = predict(fit.law, &fit.values, &self.data);
        let misfit = |part: Part| {
            let misfit = part.misfit(&stresses, &measured);
            (part, misfit)
        };
        Part::list(&self.data).into_iter().map(misfit).collect()
    }

    /// The chosen law, if there are curves.
    pub fn law(&self) -> Option<&Fit> {
        self.fits.get(self.chosen)
    }
}

impl Relaxed {
    fn new(
        source: &Source,
        options: &relaxation::Options,
        law: Option<&Fit>,
        volume: Volume,
        n_term: Option<usize>,
    ) -> Result<Self, Failure> {
        let elastic = law.map(Fit::elastic);
        let stress = |stretch: f64| {
            let (isochoric, scale) = volume.isochoric(Mode::Uniaxial, (stretch, 1.0));
            elastic.as_ref().map_or(stretch - 1.0, |law| stress::nominal(law, Mode::Uniaxial, &[isochoric])[0] / scale)
        };
        let known: Option<&dyn Fn(f64) -> f64> = if elastic.is_some() { Some(&stress) } else { None };
        let test = relaxation::read(&source.bytes, options, known).map_err(|error| source.refused(&error))?;
        let choice = Choice::new(&test.relaxation, n_term)
            .map_err(|error| Failure::Failed(format!("{}: {error}", source.path.display())))?;
        Ok(Self { test, choice })
    }
}

/// The stretches of the data and of a drop.
fn stability_range(data: &[DataSet], foam: bool) -> (f64, f64) {
    let ranges = data.iter().map(DataSet::stretches);
    let least = if foam { FOAM_RANGE } else { STABILITY_RANGE };
    let (low, high) = ranges.fold(least, |(low, high), (l, h)| (low.min(l), high.max(h)));
    (low.max(stability::SCAN.0), high.min(stability::SCAN.1))
}

fn reason(law: &Law, data: &[DataSet], settings: &Settings) -> String {
    let n_point: usize = data.iter().map(|set| set.points.len()).sum();
    if n_point < law.parameters.len() {
        format!("{} needs {} points or more", law.label, law.parameters.len())
    } else if settings.demand_stability {
        format!("{} has no stable fit", law.label)
    } else {
        format!("{} has no finite residual", law.label)
    }
}

fn position(fits: &[Fit], law: &Law, failed: &[String]) -> Result<usize, Failure> {
    fits.iter().position(|fit| fit.law == law).ok_or_else(|| match failed.iter().find(|f| f.starts_with(law.label)) {
        Some(reason) => Failure::Failed(reason.clone()),
        None => Failure::Input(format!(
            "--law {} needs a curve: --uniaxial, --planar, --equibiaxial or --simple-shear",
            law.name
        )),
    })
}
