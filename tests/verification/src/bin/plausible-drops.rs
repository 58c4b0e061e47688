//! Random plausible drops on an anvil, on a stack, on a pad of foam alone and, once in a while, on a solid, each with the step
//! that the kernel chooses for it: how many are refused, what energy and momentum leave unexplained, and how many steps were
//! too many.
//!
//!     cargo run --release -p softanvil-verification --bin plausible-drops -- [COUNT [SEED]] [OPTIONS]

use std::path::PathBuf;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use clap::Parser;
use serde_json::json;
use softanvil_kernel::{Scenario, Simulation};
use softanvil_verification::agreement::Start;
use softanvil_verification::bearing::{Sides, pressed_energy};
use softanvil_verification::deformation::Samples;
use softanvil_verification::plausible::{self, LOOKS, Outcome, outcome_of, summary};
use softanvil_verification::tolerance::{LAYER_PENETRATION, MOMENTUM, PLAUSIBLE_RESIDUAL, STEPS_OVER_HINDSIGHT};

/// One drop in so many is on a solid, which takes as long as some hundred others.
const SOLIDS: u64 = 512;
/// One drop in so many is made again, as is every one on a solid: cut into calls, saved and restored, and on other threads.
const CALLS: u64 = 4;
/// One drop in so many is made again with every instruction set, which takes as long as all other ways.
const SETS: u64 = 16;
/// Looks at a drop, where many are made.
const FEW_LOOKS: u64 = 60;
/// A drop of so many times the energy that presses the layers flat, by an estimate without a mesh, has no solution.
const MORE_THAN_BORNE: f64 = 1.5;

/// Random plausible drops, none of which may be refused.
#[derive(Parser)]
struct Options {
    /// Drops.
    #[arg(default_value_t = 300)]
    count: u64,
    /// Which drops.
    #[arg(default_value_t = 1)]
    seed: u64,
    /// Number of the first drop: that of a finding, with a COUNT of 1, makes it again.
    #[arg(long, default_value_t = 0)]
    first: u64,
    /// Seconds after which no drop is begun.
    #[arg(long)]
    seconds: Option<u64>,
    /// Elements of random sizes of 4 to 10 mm, which are quicker, and fewer looks at each drop. What so coarse a mesh cannot follow
    /// is made again with elements of 3 mm, and counted.
    #[arg(long)]
    coarse: bool,
    /// Make one drop in four and each on a solid again, cut into calls, saved and restored and, on a solid, on other threads, and one in
    /// 16 with every instruction set: to the same bits.
    #[arg(long)]
    ways: bool,
    /// Where counts and findings go, as JSON.
    #[arg(long)]
    json: Option<PathBuf>,
}

/// What came of all drops.
#[derive(Default)]
struct Tally {
    drops: u64,
    solids: u64,
    /// Drops that a coarse mesh could not follow.
    too_coarse: u64,
    /// Drops that were refused, and had to be.
    unbearable: u64,
    findings: Vec<String>,
    residual: f64,
    penetration: f64,
    momentum: f64,
    steps_over_hindsight: Vec<f64>,
}

impl Tally {
    fn add(&mut self, result: Result<Outcome, String>, about: &str) {
        let outcome = match result {
            Ok(outcome) => outcome,
            Err(error) => return self.find(&error, about),
        };
        let judged = [
            ("residual of the energy", outcome.residual, &mut self.residual, PLAUSIBLE_RESIDUAL),
            ("penetration in cells", outcome.penetration, &mut self.penetration, LAYER_PENETRATION),
            ("change of momentum unexplained", outcome.momentum, &mut self.momentum, MOMENTUM),
        ];
        let mut beyond = Vec::new();
        for (what, value, worst, limit) in judged {
            *worst = worst.max(value);
            if value.is_nan() || value >= limit {
                beyond.push(format!("{what} {value:.1e}, above {limit:.1e}"));
            }
        }
        beyond.iter().for_each(|finding| self.find(finding, about));
        self.steps_over_hindsight.push(outcome.steps_over_hindsight);
    }

    fn find(&mut self, finding: &str, about: &str) {
        println!("{finding}: {about}");
        self.findings.push(format!("{finding}: {about}"));
    }

    fn median_steps(&mut self) -> f64 {
        let ratios = &mut self.steps_over_hindsight;
        ratios.sort_by(f64::total_cmp);
        ratios.get(ratios.len() / 2).copied().unwrap_or(f64::NAN)
    }
}

fn is_solid(index: u64) -> bool {
    index % SOLIDS == SOLIDS - 1
}

fn scenario(index: u64, samples: &mut Samples) -> Scenario {
    match index % 3 {
        _ if is_solid(index) => plausible::solid(samples),
        0 => plausible::scenario(samples),
        1 => plausible::stack(samples),
        _ => plausible::foam(samples),
    }
}

/// Makes the drop, and leaves its start if it is to be made in other ways.
fn drop(scenario: &Scenario, options: &Options) -> Result<(Outcome, Option<Start>), String> {
    let mut simulation = Simulation::new(scenario).map_err(|error| error.to_string())?;
    let start = options.ways.then(|| Start::new(&simulation)).transpose()?;
    let few = options.coarse || simulation.constants().grid.is_solid();
    Ok((outcome_of(&mut simulation, if few { FEW_LOOKS } else { LOOKS })?, start))
}

/// Makes it in other ways.
fn compare(index: u64, (outcome, start): (Outcome, Option<Start>), samples: &mut Samples) -> Result<Outcome, String> {
    if let Some(start) = start {
        if is_solid(index) || index.is_multiple_of(CALLS) {
            start.check_calls(outcome.digest, samples)?;
        }
        if index.is_multiple_of(SETS) {
            start.check_sets(outcome.digest)?;
        }
    }
    Ok(outcome)
}

/// Makes the drop with this number.
fn try_drop(index: u64, options: &Options, tally: &mut Tally) {
    let mut samples = plausible::samples_of(options.seed, index);
    let is_solid = is_solid(index);
    let mut scenario = scenario(index, &mut samples);
    let size = scenario.mesh.element_size;
    if options.coarse && !is_solid {
        scenario.mesh.element_size = 4e-3 + 3e-3 * (1.0 + samples.number());
    }
    tally.drops += 1;
    tally.solids += u64::from(is_solid);
    let mut result = drop(&scenario, options);
    if result.is_err() && scenario.mesh.element_size > size {
        scenario.mesh.element_size = size;
        result = drop(&scenario, options);
        tally.too_coarse += u64::from(result.is_ok());
    }
    if result.is_err() && scenario.impactor.drop_energy > MORE_THAN_BORNE * pressed_energy(&scenario, 0.0, Sides::Rigid)
    {
        tally.unbearable += 1;
        return;
    }
    let result = result.and_then(|made| compare(index, made, &mut samples));
    tally.add(result, &format!("drop {index} of seed {} ({})", options.seed, summary(&scenario)));
}

fn main() -> ExitCode {
    let options = Options::parse();
    let (begun, mut tally) = (Instant::now(), Tally::default());
    for index in options.first..options.first.saturating_add(options.count) {
        if options.seconds.is_some_and(|seconds| begun.elapsed() >= Duration::from_secs(seconds)) {
            break;
        }
        try_drop(index, &options, &mut tally);
    }
    let median = tally.median_steps();
    let Tally { drops, solids, too_coarse, unbearable, findings, residual, penetration, momentum, .. } = &tally;
    println!(
        "{} findings in {drops} drops, {solids} of them on solids, {too_coarse} made again with small elements, {unbearable} refused that press \
         their layers flat; largest residual {residual:.1e} of the energy; deepest \
         penetration {penetration:.1e} of a cell; momentum unexplained {momentum:.1e}; median of steps over hindsight {median:.2}",
        findings.len()
    );
    if let Some(path) = &options.json {
        let report = json!({
            "drops": drops, "solids": solids, "too_coarse": too_coarse, "unbearable": unbearable, "findings": findings, "residual": residual, "penetration": penetration,
            "momentum": momentum, "steps_over_hindsight": median,
        });
        if let Err(error) = std::fs::write(path, format!("{report:#}\n")) {
            eprintln!("{}: {error}", path.display());
            return ExitCode::FAILURE;
        }
    }
    if findings.is_empty() && (options.coarse || median <= STEPS_OVER_HINDSIGHT) {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}
