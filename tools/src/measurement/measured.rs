//! A measured impact from a file, resampled as simulated ones are.

use std::path::Path;

use softanvil_kernel::scenario::{Impactor, Motion};
use softanvil_records::channel::Filter;
use softanvil_records::trace::{self, Expected, Options};
use softanvil_records::understood::Understood;

use crate::measurement::series::Series;

/// Bytes of a file, at most.
const MAX_BYTES: u64 = 2_000_000_000;

/// A measured impact.
#[derive(Clone, Debug)]
pub struct Measured {
    /// Its force.
    pub series: Series,
    /// Largest deformation, m, if the file has a displacement.
    pub deformation: Option<f64>,
    /// How the force was filtered, if the file says it.
    pub filter: Option<Filter>,
    /// How the file was read.
    pub understood: Understood,
}

impl Measured {
    /// Reads the file at `path`; the simulated `impactor` tells what is plausible.
    ///
    /// # Errors
    /// A file that cannot be read or understood, or in two ways, with its name.
    pub fn read(path: &Path, options: &Options, impactor: &Impactor) -> Result<Self, String> {
        let refuse = |error: String| format!("{}: {error}", path.display());
        let size =
            std::fs::metadata(path).map_err(|error| format!("{} cannot be read: {error}", path.display()))?.len();
        if size > MAX_BYTES {
            return Err(refuse(format!("a file of {size} bytes is refused: expected {MAX_BYTES} at most")));
        }
        let bytes = std::fs::read(path).map_err(|error| format!("{} cannot be read: {error}", path.display()))?;
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        Self::understand(&name, &bytes, options, impactor).map_err(refuse)
    }

    /// Reads `bytes`, those of a file called `name`, likewise.
    ///
    /// # Errors
    /// Bytes that cannot be understood, or in two ways, with the name.
    pub fn of(name: &str, bytes: &[u8], options: &Options, impactor: &Impactor) -> Result<Self, String> {
        Self::understand(name, bytes, options, impactor).map_err(|error| format!("{name}: {error}"))
    }

    fn understand(name: &str, bytes: &[u8], options: &Options, impactor: &Impactor) -> Result<Self, String> {
        let expected = expected(impactor);
        let trace = trace::read(name, bytes, options, expected.as_ref()).map_err(|error| error.to_string())?;
        let series = Series::resampled(&trace.times, &trace.forces).map_err(|error| error.to_string())?;
        let (deformation, filter, understood) = (trace.deformation, trace.filter, trace.understood);
        Ok(Self { series, deformation, filter, understood })
    }

    /// Whether the force has gone through a filter that must not act a second time.
    pub fn is_filtered(&self) -> bool {
        matches!(self.filter, Some(Filter::Class(_) | Filter::Filtered))
    }

    /// Warns where the file says that its force has gone through another filter than the simulated one will, of
    /// `channel_class`, Hz.
    pub fn compare_filters(&mut self, channel_class: Option<f64>) {
        let warning = match (self.filter, channel_class) {
            (Some(Filter::Class(class)), Some(other)) if f64::from(class) == other => return,
            (Some(Filter::Class(class)), _) => {
                format!("the trace is filtered by CFC {class}: --cfc {class} reads the simulated force alike")
            }
            (Some(Filter::Filtered), _) => "the trace is filtered, and its title does not say how".into(),
            _ => return,
        };
        self.understood.warnings.push(warning);
    }
}

/// What a record of this drop should show.
pub fn expected(impactor: &Impactor) -> Option<Expected> {
    let speed = impactor.start_speed();
    (impactor.motion != Motion::Prescribed && speed > 0.0).then_some(Expected { mass: impactor.mass, speed })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measurement::curve_score::CurveScore;
    use softanvil_kernel::preset;

    /// A half sine of 4000 N and 8 ms in a record of a second, behind which the mass rests on the anvil.
    #[test]
    fn the_mass_at_rest_is_none_of_the_impact() {
        let row = |i: i32| {
            let time = -5e-3 + f64::from(i) * 5e-5;
            let push = if time > 0.0 && time < 8e-3 { 4e3 * (std::f64::consts::PI * time / 8e-3).sin() } else { 0.0 };
            format!("{time:.5},{:.3}\n", push + if time > 0.5 { 49.0 } else { 0.0 })
        };
        let text = "time (s),force (N)\n".to_string() + &(0..=20_100).map(row).collect::<String>();
        let impactor = preset::study().impactor;
        let Measured { series, .. } = Measured::of("r.csv", text.as_bytes(), &Options::default(), &impactor).unwrap();
        // 159 samples at 20 kHz, and 2/pi of the peak over 8 ms.
        assert!((series.duration(20.0) - 7.95e-3).abs() < 1e-9, "{}", series.duration(20.0));
        assert!((series.impulse(20.0) - 20.372).abs() < 1e-2, "{}", series.impulse(20.0));
        let score = CurveScore::new(&series, &series, 20.0).unwrap();
        assert!((score.rating() - 1.0).abs() < 1e-9, "{score:?}");
    }
}
