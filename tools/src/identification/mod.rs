//! From files of test data to a material: what `softanvil fit` works with.
//!
//! [`files`] reads the curves, [`Identification`] fits and chooses, [`table`] and [`json`] say what came out, and
//! [`material`] holds the files that carry it on.

pub mod files;
pub mod json;
pub mod material;
pub mod table;
pub mod trial;

use softanvil_identify::law::fit::{Fit, Settings};
use softanvil_identify::law::{LAWS, Law, Mode, ranking, stability, stress};
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

/// What to do with the data.
pub struct Request {
    /// Stretches over which stability is asked for; none for those of the data and of a drop.
    pub stability_range: Option<(f64, f64)>,
    /// How to fit.
    pub settings: Settings,
    /// Law instead of the stable one of lowest residual.
    pub law: Option<&'static Law>,
    /// Number of Prony terms instead of the chosen one.
    pub n_term: Option<usize>,
}

impl Identification {
    /// Fits every law to `curves` and every series to the relaxation in `relaxation`.
    ///
    /// # Errors
    /// A relaxation that is refused, or no law that can be fitted.
    pub fn new(
        curves: Vec<Curves>,
        relaxation: Option<(&Source, &relaxation::Options)>,
        request: &Request,
    ) -> Result<Self, Failure> {
        let data: Vec<_> = curves.iter().map(|curves| curves.data.clone()).collect();
        let mut settings = request.settings;
        settings.stability_range = request.stability_range.unwrap_or_else(|| stability_range(&curves));
        let (mut fits, mut failed) = (Vec::new(), Vec::new());
        for law in LAWS.iter().filter(|_| !data.is_empty()) {
            match Fit::new(law, &data, &settings) {
                Some(fit) => fits.push(fit),
                None => failed.push(reason(law, &data, &settings)),
            }
        }
        let fits = ranking::rank(fits);
        if fits.is_empty() && !data.is_empty() {
            return Err(Failure::Failed(format!("no law can be fitted: {}", failed.join("; "))));
        }
        let chosen = match request.law {
            Some(law) => position(&fits, law, &failed)?,
            None => ranking::choose(&fits),
        };
        if let Some(fit) = fits.get(chosen).filter(|fit| fit.statistics.r_squared < 0.0) {
            return Err(worse_than_the_mean(fit.law.label, fit.statistics.r_squared));
        }
        let caveats = fits.get(chosen).map_or_else(Vec::new, |fit| ranking::caveats(fit, &fits, &data, &settings));
        let relaxed = match relaxation {
            Some((source, options)) => Some(Relaxed::new(source, options, fits.get(chosen), request.n_term)?),
            None => None,
        };
        Ok(Self { curves, fits, failed, chosen, settings, caveats, relaxed })
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
        n_term: Option<usize>,
    ) -> Result<Self, Failure> {
        let elastic = law.map(Fit::elastic);
        let stress = |stretch: f64| {
            elastic.as_ref().map_or(stretch - 1.0, |law| stress::nominal(law, Mode::Uniaxial, &[stretch])[0])
        };
        let known: Option<&dyn Fn(f64) -> f64> = if elastic.is_some() { Some(&stress) } else { None };
        let test = relaxation::read(&source.bytes, options, known).map_err(|error| source.refused(&error))?;
        let choice = Choice::new(&test.relaxation, n_term);
        let (terms, r_squared) = (choice.prony().terms.len(), choice.prony().statistics.r_squared);
        if r_squared < 0.0 {
            return Err(worse_than_the_mean(&format!("a series of {terms} terms"), r_squared));
        }
        Ok(Self { test, choice })
    }
}

/// What is said instead of a result that explains less than the mean of the data.
fn worse_than_the_mean(what: &str, r_squared: f64) -> Failure {
    Failure::Failed(format!(
        "{what} fits worse than the mean of the data does (R2 {r_squared:.3}): that is no result; look at columns, units, \
         measures and signs (--columns, --direction, --strain-measure, --stress-measure)"
    ))
}

/// The stretches of the data and of a drop.
fn stability_range(curves: &[Curves]) -> (f64, f64) {
    let stretches = curves.iter().flat_map(|curves| curves.data.points.iter().map(|point| point.0));
    let (low, high) = stretches.fold(STABILITY_RANGE, |(low, high), stretch| (low.min(stretch), high.max(stretch)));
    (low.max(stability::SCAN.0), high.min(stability::SCAN.1))
}

fn reason(law: &Law, data: &[softanvil_identify::law::DataSet], settings: &Settings) -> String {
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
        None => Failure::Input(format!("--law {} needs a curve: --uniaxial, --planar or --equibiaxial", law.name)),
    })
}
