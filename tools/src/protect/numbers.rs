//! The numbers by which pads are judged.

use softanvil_kernel::Output;
use softanvil_records::unit::GRAVITY;

use super::padding;
use super::watch::Extremes;
use crate::measurement::series::{Sensor, Series};
use crate::run::{Ending, Run};

/// What came of a drop.
#[derive(Clone, Debug)]
pub struct Numbers {
    /// How the simulation ended: of a drop that was cut off, the numbers are those so far.
    pub ending: Ending,
    /// Largest reaction of the core, which load cells under the anvil see, N.
    pub transmitted: f64,
    /// Largest contact force over the impactor's weight, which an accelerometer in it sees, in g.
    pub acceleration: f64,
    /// Time over which the contact force is at or above the threshold, s.
    pub duration: f64,
    /// Impulse of the contact force, N s.
    pub impulse: f64,
    /// Kinetic energy of the impactor before the contact, J.
    pub energy: f64,
    /// What of it the impactor does not have any more after the rebound, J.
    pub absorbed: f64,
    /// Rebound speed over impact speed.
    pub restitution: f64,
    /// Largest deformation of the stack under the impactor, m.
    pub deformation: f64,
    /// Thickness of the pad at rest, m.
    pub pad_thickness: f64,
    /// The layers, from the core to the surface.
    pub layers: Vec<LayerNumbers>,
}

/// What happened to a layer.
#[derive(Clone, Debug)]
pub struct LayerNumbers {
    /// Its name, or its place.
    pub name: String,
    /// Whether it belongs to the pad.
    pub is_pad: bool,
    /// See [`Extremes`].
    pub extremes: Extremes,
    /// Stretch at which it begins to tear, if it does so at any.
    pub tear_stretch: Option<f64>,
}

impl LayerNumbers {
    /// Whether it has begun to tear; none of a layer that is said not to.
    pub fn has_torn(&self) -> Option<bool> {
        Some(self.extremes.stretch > self.tear_stretch?)
    }
}

impl Numbers {
    /// Of `run`, with the `extremes` of its layers.
    pub fn new(run: &Run, extremes: &[Extremes]) -> Self {
        let scenario = &run.constants.scenario;
        let result = |name: &str| Output::find(name).map_or(f64::NAN, |output| run.result(output));
        let (mass, restitution) = (scenario.impactor.mass, result("result.restitution"));
        let energy = 0.5 * mass * result("result.impact_speed").powi(2);
        let pad = padding::place(scenario);
        let layer = |(place, extremes): (usize, &Extremes)| {
            let layer = scenario.layers.get(place);
            let name = layer.map(|layer| layer.name.to_string()).filter(|name| !name.is_empty());
            LayerNumbers {
                name: name.unwrap_or_else(|| format!("layers[{place}]")),
                is_pad: place >= pad,
                extremes: *extremes,
                tear_stretch: layer.map(|layer| layer.material.tear_stretch).filter(|stretch| *stretch > 0.0),
            }
        };
        Self {
            ending: run.ending(),
            transmitted: Series::of_run(run, Sensor::Core).peak(),
            acceleration: result("result.peak_force") / (mass * GRAVITY),
            duration: result("result.impact_duration"),
            impulse: result("result.impulse"),
            energy,
            absorbed: energy * (1.0 - restitution * restitution),
            restitution,
            deformation: result("result.max_deformation"),
            pad_thickness: padding::thickness(scenario),
            layers: extremes.iter().enumerate().map(layer).collect(),
        }
    }

    /// Largest compression of a layer of the pad, as a part of its thickness.
    pub fn pad_compression(&self) -> f64 {
        let pad = self.layers.iter().filter(|layer| layer.is_pad);
        pad.map(|layer| layer.extremes.compression).fold(0.0, f64::max)
    }
}
