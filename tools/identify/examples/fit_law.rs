//! One law fitted to curves, or one Prony series to a relaxation, in this process: what it leaves and how long it took.
//!
//! `fit_law LAW UNIAXIAL PLANAR EQUIBIAXIAL` or `fit_law prony TERMS RELAXATION` prints `rms [Pa],time [s]`; the time is the
//! shortest of five fits with the data in memory, statistics and stability of the law among it.

use std::error::Error;
use std::time::Instant;

use softanvil_identify::data::curve;
use softanvil_identify::law::fit::{Fit, Settings, Weighting};
use softanvil_identify::law::{DataSet, Law, MODES, Mode};
use softanvil_identify::relaxation::{prony, read as relaxation};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let names: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let (rms, seconds) = match names.as_slice() {
        ["prony", n_term, file] => {
            let n_term: usize = n_term.parse()?;
            let test = relaxation::read(&std::fs::read(file)?, &relaxation::Options::default(), None)?;
            timed(|| Some(prony::fit(n_term, &test.relaxation).statistics.rms))?
        }
        [name, files @ ..] if files.len() == MODES.len() => {
            let law = Law::find(name).ok_or("no such law")?;
            let data = MODES.iter().zip(files).map(|(mode, file)| read(*mode, file)).collect::<Result<Vec<_>, _>>()?;
            let settings = Settings::plain((0.5, 7.6));
            timed(|| Fit::new(law, &data, &settings).map(|fit| fit.statistics.rms))?
        }
        _ => return Err("usage: fit_law LAW UNIAXIAL PLANAR EQUIBIAXIAL, or fit_law prony TERMS RELAXATION".into()),
    };
    println!("{rms:e},{seconds:e}");
    Ok(())
}

fn read(mode: Mode, file: &str) -> Result<DataSet, Box<dyn Error>> {
    let curve = curve::read(file, &std::fs::read(file)?, &curve::Options::default())?;
    let points = curve.repeats.iter().flat_map(|repeat| &repeat.points);
    Ok(DataSet { mode, points: points.map(|point| (point.stretch, point.stress)).collect() })
}

fn timed(fit: impl Fn() -> Option<f64>) -> Result<(f64, f64), &'static str> {
    let mut best = (f64::NAN, f64::INFINITY);
    for _ in 0..5 {
        let start = Instant::now();
        let rms = fit().ok_or("no fit")?;
        let seconds = start.elapsed().as_secs_f64();
        if seconds < best.1 {
            best = (rms, seconds);
        }
    }
    Ok(best)
}
