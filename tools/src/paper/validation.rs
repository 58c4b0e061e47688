//! Simulated drops against the paper's table: errors recomputed from values.

use softanvil_kernel::preset::Preset;
use softanvil_kernel::scenario::Formulation;
use softanvil_kernel::{Scenario, Simulation};

use crate::failure::Failure;
use crate::measurement::band::Expected;
use crate::measurement::errors::{errors_percent, mean_absolute};
use crate::measurement::quantity::{COUNT, PEAK_FORCE};
use crate::measurement::reading::{Reading, Record};
use crate::paper::{Case, TABLE_1};
use crate::progress;
use crate::run::{Drop, Run, Until};

/// One energy: the values of the paper and a run of ours.
pub struct TableComparison {
    /// The paper's values.
    pub paper: &'static Case,
    /// Our run.
    pub run: Run,
    /// The run as it was read, with our four numbers.
    pub record: Record,
    /// Where a posterior expects the numbers and the force, if there is one.
    pub expected: Option<Expected>,
}

/// All energies of the paper, with one preset.
///
/// ```
/// use softanvil_tools::measurement::reading::Reading;
/// use softanvil_tools::paper::validation::Validation;
///
/// let preset = softanvil_tools::presets::parse("study-14.7")?;
/// let validation = Validation::new(preset, Reading::PLAIN)?;
/// assert_eq!(validation.cases.len(), 3);
/// assert!(validation.mean_error() < validation.ls_dyna_mean_error());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Validation {
    /// The preset.
    pub preset: &'static Preset,
    /// In which formulation its scenario was simulated.
    pub formulation: Formulation,
    /// How the runs were read.
    pub reading: Reading,
    /// One comparison per energy.
    pub cases: Vec<TableComparison>,
}

impl TableComparison {
    /// Errors of the paper's LS-DYNA model against its experiment, %.
    pub fn ls_dyna_errors(&self) -> [f64; COUNT] {
        errors_percent(&self.paper.ls_dyna, &self.paper.experiment)
    }

    /// Our errors against the experiment, %.
    pub fn softanvil_errors(&self) -> [f64; COUNT] {
        errors_percent(&self.record.values, &self.paper.experiment)
    }
}

impl Validation {
    /// Runs `preset` at every energy of the paper and reads the runs by `reading`.
    ///
    /// # Errors
    /// A preset that is refused or fails, or a reading that the sampling does not carry.
    pub fn new(preset: &'static Preset, reading: Reading) -> Result<Self, Failure> {
        Self::watched(preset, reading, |_, _| Ok(()))
    }

    /// The same; `watch` sees each simulation at its start and after every sample, with the number of its energy.
    ///
    /// # Errors
    /// As [`Validation::new`], and what `watch` refuses.
    pub fn watched(
        preset: &'static Preset,
        reading: Reading,
        watch: impl FnMut(usize, &mut Simulation) -> Result<(), Failure>,
    ) -> Result<Self, Failure> {
        Self::formulated(preset, (preset.scenario)().geometry.formulation, reading, watch)
    }

    /// The same in another formulation than the preset's.
    ///
    /// # Errors
    /// As [`Validation::watched`].
    pub fn formulated(
        preset: &'static Preset,
        formulation: Formulation,
        reading: Reading,
        mut watch: impl FnMut(usize, &mut Simulation) -> Result<(), Failure>,
    ) -> Result<Self, Failure> {
        let mut scenario = (preset.scenario)();
        scenario.geometry.formulation = formulation;
        let ready = || TABLE_1.iter().map(|case| prepare(&scenario, case)).collect::<Result<Vec<_>, _>>();
        let drops = progress::set_up(ready)?;
        let bar = progress::bar(drops.iter().map(Drop::steps).sum());
        let mut cases = Vec::new();
        for (number, (paper, drop)) in TABLE_1.iter().zip(drops).enumerate() {
            bar.set_message(format!("{} J", paper.energy));
            let run = drop.run_watched(|steps, simulation| {
                bar.inc(steps);
                watch(number, simulation)
            })?;
            let record = reading.take(&run).map_err(|error| Failure::Input(error.to_string()))?;
            cases.push(TableComparison { paper, record, run, expected: None });
        }
        Ok(Self { preset, formulation, reading, cases })
    }

    /// The same with what a posterior expects of its impacts.
    pub fn with(mut self, impacts: &[Expected]) -> Self {
        for case in &mut self.cases {
            case.expected = impacts.iter().find(|impact| impact.energy == case.paper.energy).cloned();
        }
        self
    }

    /// Mean of our absolute errors, all energies and quantities, %.
    pub fn mean_error(&self) -> f64 {
        mean_absolute(self.cases.iter().flat_map(TableComparison::softanvil_errors))
    }

    /// Mean of LS-DYNA's absolute errors, all energies and quantities, %.
    pub fn ls_dyna_mean_error(&self) -> f64 {
        mean_absolute(self.cases.iter().flat_map(TableComparison::ls_dyna_errors))
    }

    /// Mean of our absolute errors of the peak force, %.
    pub fn peak_error(&self) -> f64 {
        mean_absolute(self.cases.iter().map(|case| case.softanvil_errors()[PEAK_FORCE]))
    }

    /// Mean of LS-DYNA's absolute errors of the peak force, %.
    pub fn ls_dyna_peak_error(&self) -> f64 {
        mean_absolute(self.cases.iter().map(|case| case.ls_dyna_errors()[PEAK_FORCE]))
    }
}

fn prepare(scenario: &Scenario, case: &Case) -> Result<Drop, Failure> {
    let mut scenario = scenario.clone();
    scenario.impactor = scenario.impactor.with_energy(case.energy);
    Ok(Drop::until(&scenario, Until::Over)?)
}
