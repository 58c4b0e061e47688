//! Known parameters from traces with noise: `softanvil calibrate` gives them back within the spread that it states.

use std::fmt::Write;
use std::path::Path;
use std::sync::atomic::AtomicBool;

use fcmaes_core::Rng;
use softanvil_tools::calibration::log::Log;
use softanvil_tools::calibration::objective::scenario;
use softanvil_tools::calibration::problem::Problem;
use softanvil_tools::calibration::result::Found;
use softanvil_tools::calibration::search::search;
use softanvil_tools::files::folder::Folder;
use softanvil_tools::measurement::series::{Sensor, Series};
use softanvil_tools::run::Run;

/// c10, Pa, and Poisson's ratio: the one scales the force, the other the duration as well.
const TRUTH: [f64; 2] = [150e3, 0.35];

const PROBLEM: &str = r#"
[search]
evaluations = 1000

[fixed]
"mesh.element_size" = 7.5e-3
"silicone.law" = "neo_hookean"

[parameters]
"silicone.c10" = { min = 2e4, max = 6e5, scale = "log", start = 6e4 }
"silicone.poissons_ratio" = { min = 0.2, max = 0.49, start = 0.47 }

[[impact]]
energy = 14.7
trace = "measured.csv"
"#;

/// Samples before the contact: 10 ms.
const BEFORE: usize = 200;

/// Writes the trace of the truth to `folder`, 10 ms after its beginning, with normal errors of `noise` times the peak.
fn measure(folder: &Path, exact: &Series, noise: f64, seed: u64) {
    let mut random = Rng::new(1000 + seed);
    let deviation = noise * exact.peak();
    let forces = std::iter::repeat_n(0.0, BEFORE).chain(exact.force.iter().copied());
    let mut text = String::from("time [s],force [N]\n");
    for (i, force) in forces.enumerate() {
        let _ = writeln!(text, "{},{}", i as f64 * exact.interval, force + random.normreal(0.0, deviation));
    }
    std::fs::write(folder.join("measured.csv"), text).unwrap();
}

fn exact() -> Series {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("measured.csv"), "time [s],force [N]\n0,0\n0.008,2000\n0.016,0\n").unwrap();
    let problem = Problem::parse(PROBLEM, folder.path()).unwrap();
    let mut truth = scenario(&problem, &TRUTH).unwrap();
    truth.impactor = truth.impactor.with_energy(14.7);
    let run: Run = softanvil_tools::run::Drop::until(&truth, problem.until).unwrap().run(|_| {}).unwrap();
    Series::of_run(&run, Sensor::Contact)
}

/// What came of one search: the values and, of each, the ends of its spread.
struct Recovered {
    values: Vec<f64>,
    spread: Vec<[f64; 2]>,
    converged: bool,
    r_squared: f64,
}

impl Recovered {
    fn covers(&self, index: usize) -> bool {
        let [min, max] = self.spread[index];
        (min..=max).contains(&TRUTH[index])
    }
}

fn recover(exact: &Series, noise: f64, seed: u64) -> Recovered {
    let folder = tempfile::tempdir().unwrap();
    measure(folder.path(), exact, noise, seed);
    let mut problem = Problem::parse(PROBLEM, folder.path()).unwrap();
    problem.search.seed = 1 + seed;
    let mut log = Log::open(&mut Folder::new(folder.path(), false), &problem, false).unwrap();
    let descents = search(&problem, &mut log, &AtomicBool::new(false), &|_, _| {}).unwrap();
    let found = Found::new(&problem, &log.entries, descents).unwrap();
    Recovered {
        values: found.entry.values.clone(),
        spread: found.spread.iter().map(|spread| [spread.min, spread.max]).collect(),
        converged: found.convergence.is_reached(),
        r_squared: found.evaluation.impacts[0].curve.unwrap().r_squared,
    }
}

fn line(noise: f64, seed: u64, recovered: &Recovered) -> String {
    let of = |index: usize| {
        let [min, max] = recovered.spread[index];
        format!("{:.5e} ({min:.5e} to {max:.5e})", recovered.values[index])
    };
    let (r_squared, converged) = (recovered.r_squared, recovered.converged);
    format!("{noise} {seed}: {}, {}, R2 {r_squared:.4}, converged {converged}", of(0), of(1))
}

#[test]
fn known_parameters_come_back_through_noise() {
    let exact = exact();
    for (noise, seed) in [(0.0, 0), (0.05, 2)] {
        let recovered = recover(&exact, noise, seed);
        let line = line(noise, seed, &recovered);
        assert!(recovered.converged && (0..2).all(|index| recovered.covers(index)), "{line}");
        // The errors themselves, so that a spread over everything does not pass.
        for (value, truth) in recovered.values.iter().zip(TRUTH) {
            assert!((value / truth - 1.0).abs() < 1e-3 + 2.0 * noise, "{line}");
        }
    }
}

/// All of it: 20 repeats at each of four levels of noise. Minutes, therefore by
/// `cargo test --release -p softanvil --test suite -- --ignored --nocapture recovery`.
#[test]
#[ignore = "80 searches take minutes"]
fn recovery_at_every_noise() {
    let exact = exact();
    for noise in [0.0, 0.01, 0.02, 0.05] {
        let repeats: Vec<Recovered> = (0..20)
            .map(|seed| {
                let recovered = recover(&exact, noise, seed);
                println!("{}", line(noise, seed, &recovered));
                recovered
            })
            .collect();
        for (index, truth) in TRUTH.into_iter().enumerate() {
            let covered = repeats.iter().filter(|recovered| recovered.covers(index)).count();
            let mean = |of: &dyn Fn(&Recovered) -> f64| repeats.iter().map(of).sum::<f64>() / 20.0;
            let error = |recovered: &Recovered| recovered.values[index] - truth;
            let (bias, rms) = (mean(&error), mean(&|recovered| error(recovered).powi(2)).sqrt());
            let half = mean(&|recovered| 0.5 * (recovered.spread[index][1] - recovered.spread[index][0]));
            println!(
                "{noise}, parameter {index}: {covered} of 20 spreads hold the truth; bias {:.4} %, rms error {:.4} %, half \
                 the spread {:.4} % of the truth",
                100.0 * bias / truth,
                100.0 * rms / truth,
                100.0 * half / truth
            );
            assert_eq!(covered, 20, "{noise}, parameter {index}");
        }
    }
}
