//! The trace of a run as CSV: one line per force sample, every output that changes with time, units in the header.

use softanvil_kernel::{OUTPUTS, Output};

use crate::failure::Failure;
use crate::measurement::reading::Record;
use crate::output::trace_comparison::TraceComparison;
use crate::run::Run;

/// The outputs of a trace. Results of the whole test are no part of it, nor is the force of a single step.
pub fn columns() -> impl Iterator<Item = &'static Output> {
    OUTPUTS.iter().filter(|output| !output.name.starts_with("result.") && output.name != "contact.force_step")
}

/// The trace of `run`, in SI, with as many digits as give back the same bits.
///
/// # Errors
/// What the CSV library refuses.
pub fn csv(run: &Run) -> Result<Vec<u8>, TraceError> {
    let mut text = Vec::new();
    write(run, &mut text)?;
    Ok(text)
}

/// A force as it was read, and the measured one at the same times, the two aligned as for their comparison.
///
/// # Errors
/// What the CSV library refuses.
pub fn of_forces(record: &Record, comparison: Option<&TraceComparison>) -> Result<Vec<u8>, TraceError> {
    let mut csv = csv::Writer::from_writer(Vec::new());
    csv.write_field("time [s]")?;
    csv.write_field("force [N]")?;
    let aligned = comparison.map(|comparison| (&comparison.measured, comparison.score.alignment.lag));
    csv.write_record(aligned.map(|_| "measured force [N]"))?;
    for (i, force) in record.series.force.iter().enumerate() {
        let time = record.series.time(i);
        let measured = aligned.map(|(series, lag)| series.at(time - lag));
        csv.serialize([time, *force].into_iter().chain(measured).collect::<Vec<_>>())?;
    }
    Ok(csv.into_inner().map_err(|error| csv::Error::from(error.into_error()))?)
}

/// Why a trace could not be written.
#[derive(Debug, thiserror::Error)]
#[error("the trace cannot be written: {0}")]
pub struct TraceError(#[from] csv::Error);

fn write(run: &Run, text: &mut Vec<u8>) -> Result<(), csv::Error> {
    let mut csv = csv::Writer::from_writer(text);
    csv.write_field("time [s]")?;
    csv.write_record(columns().map(|output| format!("{} [{}]", output.name, output.unit)))?;
    for sample in run.samples() {
        let values = columns().map(|output| (output.read)(&run.constants, sample));
        csv.serialize(std::iter::once(run.time(sample)).chain(values).collect::<Vec<_>>())?;
    }
    csv.flush()?;
    Ok(())
}

impl From<TraceError> for Failure {
    fn from(error: TraceError) -> Self {
        Self::Failed(error.to_string())
    }
}
