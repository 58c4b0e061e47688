//! The requests of the page and their answers.

use serde::Deserialize;
use serde_json::{Map, Value, json};
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
    /// A drop with all that is drawn of it, under this label, as soon as that is there. Where its run goes on, the answer says
    /// that there is `more`.
    Drop { asked: Asked, label: String },
    /// A little of that run; at its end what it has changed.
    Rest,
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
/// Samples of a run whose end is not awaited, between two looks of the page for what it is asked meanwhile.
const SAMPLES_IN_A_PIECE: usize = 5;
/// Most numbers of the section in all frames together: finer meshes have fewer frames.
const MOST_NUMBERS: u64 = 4_000_000;

/// Answers requests one after another.
#[derive(Default)]
pub struct Session {
    /// The drop that has been shown and whose run goes on.
    underway: Option<Underway>,
}

impl Session {
    /// The answer to `request`, JSON, to which `file` belongs: an object with what was asked for, with `refused` ([`Refusal`]),
    /// or with `failed`, a message.
    pub fn answer(&mut self, request: &[u8], file: &[u8]) -> String {
        let answer = match serde_json::from_slice(request) {
            Ok(request) => self.carry_out(request, file),
            Err(error) => Ok(json!({ "failed": format!("the request is not understood: {error}") })),
        };
        answer.unwrap_or_else(|refusal| json!({ "refused": refusal })).to_string()
    }

    fn carry_out(&mut self, request: Request, file: &[u8]) -> Result<Value, Refusal> {
        Ok(match request {
            Request::Table => json!({ "table": parameters::table(), "legend": drop::legend() }),
            Request::Drop { asked, label } => self.begin(&asked, label)?,
            Request::Rest => self.go_on()?,
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

    fn begin(&mut self, asked: &Asked, label: String) -> Result<Value, Refusal> {
        self.underway = None;
        let mut underway = Underway::new(asked.subject()?, label)?;
        let goes_on = underway.run_until_shown()?;
        let mut all = underway.pictures();
        all.append(&mut underway.outcome(goes_on));
        if goes_on {
            self.underway = Some(underway);
        }
        Ok(Value::Object(all))
    }

    fn go_on(&mut self) -> Result<Value, Refusal> {
        let Some(mut underway) = self.underway.take() else { return Ok(json!({ "failed": "nothing goes on" })) };
        for _ in 0..SAMPLES_IN_A_PIECE {
            if !underway.sample()? {
                return Ok(Value::Object(underway.rest()));
            }
        }
        self.underway = Some(underway);
        Ok(json!({ "more": true }))
    }
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

/// A drop while it is simulated.
struct Underway {
    subject: Subject,
    label: String,
    drop: Drop,
    animation: Animation,
    /// Samples from one frame to the next.
    every: usize,
    /// Samples when the pictures were handed out.
    shown: usize,
}

impl Underway {
    fn new(subject: Subject, label: String) -> Result<Self, Refusal> {
        let drop = Drop::until(&subject.scenario, subject.until).map_err(refused)?;
        let samples = drop.steps() / u64::from(drop.steps_per_sample());
        // A page counts in 32 bits.
        let every = SAMPLES_IN_A_FRAME.max((samples * 8 * drop.elements() as u64 / MOST_NUMBERS) as usize);
        let mut underway = Self { subject, label, drop, animation: Animation::default(), every, shown: 0 };
        underway.take_frame()?;
        Ok(underway)
    }

    fn take_frame(&mut self) -> Result<(), Refusal> {
        self.animation.take(self.drop.simulation()).map_err(|error| refused(error.into()))
    }

    /// One more sample; false at the end of the run.
    fn sample(&mut self) -> Result<bool, Refusal> {
        if !self.drop.sample().map_err(refused)? {
            return Ok(false);
        }
        if (self.drop.samples().len() - 1).is_multiple_of(self.every) {
            self.take_frame()?;
        }
        Ok(true)
    }

    /// Until all is there that is drawn, or the run ends; whether it goes on.
    fn run_until_shown(&mut self) -> Result<bool, Refusal> {
        while !drop::is_shown(self.drop.constants(), self.drop.samples()) {
            if !self.sample()? {
                return Ok(false);
            }
        }
        self.shown = self.drop.samples().len();
        Ok(true)
    }

    fn pictures(&self) -> Map<String, Value> {
        drop::pictures(&self.label, &self.subject.text(), &self.drop.so_far(), &self.animation)
    }

    fn outcome(&self, goes_on: bool) -> Map<String, Value> {
        let run = self.drop.so_far();
        if goes_on { drop::outcome_so_far(&run) } else { drop::outcome(&run) }
    }

    /// What has become of it since its pictures were handed out: everything, if it hit once more.
    fn rest(&self) -> Map<String, Value> {
        let mut rest = self.outcome(false);
        if drop::shown_samples(self.drop.constants(), self.drop.samples()) > self.shown {
            rest.append(&mut self.pictures());
        }
        rest
    }
}
