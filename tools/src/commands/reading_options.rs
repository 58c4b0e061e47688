//! The options that say how a simulated impact is read.

use clap::Args;

use crate::failure::Failure;
use crate::measurement::reading::{Noise, Reading, Threshold};
use crate::measurement::series::Sensor;

/// How the impact is read.
#[derive(Debug, Args)]
#[command(next_help_heading = "How the impact is read")]
pub struct ReadingOptions {
    /// Force that is read: on the impactor, as in the paper's LS-DYNA figures, or of the load cells under the core
    #[arg(long, value_enum, default_value_t)]
    force: Sensor,
    /// Channel frequency class of the filter on the force in Hz (60, 180, 600, 1000; SAE J211, ISO 6487), both ways
    #[arg(long, value_name = "HZ", allow_negative_numbers = true)]
    cfc: Option<f64>,
    /// Force from which on the impact lasts, in N, or as a part of the peak (5%); without it the scenario's
    #[arg(long, value_name = "N|%", allow_hyphen_values = true)]
    threshold: Option<Threshold>,
    /// Standard deviation of a load cell's error in N, for every 20 kHz sample
    #[arg(long, value_name = "N", default_value_t = 0.0, allow_negative_numbers = true)]
    noise: f64,
    /// Standard deviation of the error of its calibration in %, one for the record
    #[arg(long, value_name = "%", default_value_t = 0.0, allow_negative_numbers = true)]
    calibration_error: f64,
    /// Seed of both errors
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// Read the deformation in the frames of a 10 kHz camera, instead of in every step
    #[arg(long)]
    camera: bool,
}

impl ReadingOptions {
    /// The reading.
    ///
    /// # Errors
    /// A value that is refused.
    pub fn reading(&self) -> Result<Reading, Failure> {
        for (option, value, unit) in [("noise", self.noise, "N"), ("calibration-error", self.calibration_error, "%")] {
            if !(value >= 0.0 && value.is_finite()) {
                return Err(Failure::Input(format!(
                    "--{option} = {value} {unit} is refused: expected 0 {unit} or more"
                )));
            }
        }
        if let Some(class) = self.cfc {
            crate::measurement::series::check_channel_class(class)
                .map_err(|error| Failure::Input(format!("--cfc is refused: {error}")))?;
        }
        Ok(Reading {
            sensor: self.force,
            channel_class: self.cfc,
            threshold: self.threshold,
            noise: Noise { force: self.noise, calibration: self.calibration_error / 100.0, seed: self.seed },
            camera: self.camera,
        })
    }
}
