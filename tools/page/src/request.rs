//! The requests of the page and their answers.

use serde::Deserialize;
use serde_json::{Value, json};
use softanvil_kernel::Simulation;
use softanvil_tools::output::subject::Subject;
use softanvil_tools::output::trace;
use softanvil_tools::page::asked::{Asked, Refusal};
use softanvil_tools::page::{drop, parameters};
use softanvil_tools::plot::curve::Curve;
use softanvil_tools::plot::{self, Balance, Picture};
use softanvil_tools::run::{Drop, Run, RunError};
use softanvil_tools::scenario_file;
use softanvil_tools::section::Animation;

use crate::measured;

/// What the page asks for.
#[derive(Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
enum Request {
    /// What does not depend on a drop: parameters, presets, legends.
    Table,
    /// A drop with all that is drawn of it, under this label.
    Drop { asked: Asked, label: String },
    /// Its scenario as a file.
    Toml { asked: Asked },
    /// Its trace as a file.
    Csv { asked: Asked },
    /// A measured trace, the file beside the request, to be drawn over the force of a drop.
    Measured { asked: Asked, name: String, beside: Curve },
    /// Bands of colour over stresses, Pa.
    Levels { range: [f64; 2] },
    /// A picture of curves.
    Picture { of: Of, size: [u32; 2], window: Option<[f64; 2]> },
}

/// What a picture shows.
#[derive(Deserialize)]
#[serde(rename_all = "snake_case")]
enum Of {
    ForceTime(Vec<Curve>),
    ForceDeformation(Vec<Curve>),
    Energy(Balance),
}

/// A frame of the section is kept for every so many samples: the page draws those between by interpolation.
const SAMPLES_IN_A_FRAME: usize = 6;
/// Most numbers of the section in all frames together: finer meshes have fewer frames.
const MOST_NUMBERS: usize = 4_000_000;

/// The answer to `request`, JSON, to which `file` belongs: an object with what was asked for, with `refused` ([`Refusal`]), or
/// with `failed`, a message.
pub fn answer(request: &[u8], file: &[u8]) -> String {
    let answer = match serde_json::from_slice(request) {
        Ok(request) => carry_out(request, file).unwrap_or_else(|refusal| json!({ "refused": refusal })),
        Err(error) => json!({ "failed": format!("the request is not understood: {error}") }),
    };
    answer.to_string()
}

fn carry_out(request: Request, file: &[u8]) -> Result<Value, Refusal> {
    Ok(match request {
        Request::Table => json!({ "table": parameters::table(), "legend": drop::legend() }),
        Request::Drop { asked, label } => simulate(&asked.subject()?, &label)?,
        Request::Toml { asked } => json!({ "text": scenario_file::to_toml(&asked.subject()?.scenario) }),
        Request::Csv { asked } => {
            let csv = trace::csv(&run(&asked.subject()?)?).map_err(|error| Refusal::of(error.to_string()))?;
            json!({ "text": String::from_utf8_lossy(&csv) })
        }
        Request::Measured { asked, name, beside } => {
            measured::read(&asked.subject()?, &name, file, &beside).map_err(Refusal::of)?
        }
        Request::Levels { range } => drop::levels(range),
        Request::Picture { of, size, window } => {
            picture(of, size, window).unwrap_or_else(|failed| json!({ "failed": failed }))
        }
    })
}

fn picture(of: Of, size: [u32; 2], window: Option<[f64; 2]>) -> Result<Value, String> {
    let picture = match of {
        Of::ForceTime(curves) => Picture::ForceTime(curves),
        Of::ForceDeformation(curves) => Picture::ForceDeformation(curves),
        Of::Energy(balance) => Picture::Energy(balance),
    };
    let bare = plot::bare(picture, size, window).map_err(|error| error.to_string())?;
    serde_json::to_value(bare).map_err(|error| error.to_string())
}

fn run(subject: &Subject) -> Result<Run, Refusal> {
    let drop = Drop::until(&subject.scenario, subject.until).map_err(refused)?;
    drop.run(|_| {}).map_err(refused)
}

fn refused(error: RunError) -> Refusal {
    Refusal::of(error.to_string())
}

fn simulate(subject: &Subject, label: &str) -> Result<Value, Refusal> {
    let drop = Drop::until(&subject.scenario, subject.until).map_err(refused)?;
    let samples = drop.steps() / u64::from(drop.steps_per_sample());
    let numbers = 8 * drop.elements();
    let every = SAMPLES_IN_A_FRAME.max(samples as usize * numbers / MOST_NUMBERS);
    let (mut animation, mut sample) = (Animation::default(), 0);
    let run = drop.run_watched(|_, simulation: &mut Simulation| {
        sample += 1;
        if (sample - 1) % every != 0 {
            return Ok(());
        }
        animation.take(simulation).map_err(RunError::from)
    });
    let run = run.map_err(refused)?;
    Ok(drop::of(label, &subject.text(), &run, &animation))
}
