//! Reference results in the form of the layered standard FMI-LS-REF: every continuous output of the default experiment, for
//! whoever wants to see that his importer, or his platform, computes the same.

use softanvil::instance::{Error as InstanceError, Instance};
use softanvil::variables::{Source, Table, Version};
use softanvil_kernel::{SAMPLING_INTERVAL, preset};

use crate::Error;
use crate::description::document;

/// Folder of the layered standard in an FMU.
pub const FOLDER: &str = "extra/org.fmi-standard.fmi-ls-ref";

/// Name of the file of results.
pub const RESULTS: &str = "default_experiment.csv";

/// The manifest.
pub fn manifest() -> String {
    document(|xml| {
        xml.create_element("fmiReferences")
            .with_attributes([
                ("xmlns:fmi-ls", "http://fmi-standard.org/fmi-ls-manifest"),
                ("fmi-ls:fmi-ls-name", "org.fmi-standard.fmi-ls-ref"),
                ("fmi-ls:fmi-ls-version", "1.0.0-alpha.1"),
                ("fmi-ls:fmi-ls-description", "Reference results of the default experiment"),
            ])
            .write_inner_content(|xml| {
                xml.create_element("Related")
                    .with_attributes([
                        ("type", "text/csv"),
                        ("source", RESULTS),
                        ("role", "result"),
                        ("description", "outputs of the default experiment, with all digits"),
                    ])
                    .write_empty()?;
                Ok(())
            })?;
        Ok(())
    })
}

/// The results: time and every continuous scalar output, in SI, a row per communication step, digits that give back the
/// same bits.
///
/// # Errors
/// The preset cannot be simulated, which no change that passes the tests brings about.
pub fn results() -> Result<Vec<u8>, Error> {
    let table = Table::new();
    let outputs: Vec<_> = table.rows().iter().filter(|v| matches!(v.source, Source::Output(_))).collect();
    let mut csv = csv::Writer::from_writer(Vec::new());
    csv.write_record(
        std::iter::once("time".to_owned()).chain(outputs.iter().map(|variable| variable.name.to_string())),
    )?;
    let mut instance = Instance::new(Version::Fmi3);
    instance.enter_initialization();
    instance.exit_initialization()?;
    let steps = (preset::study().time.duration / SAMPLING_INTERVAL).round() as u64;
    for step in 0..=steps {
        let values = outputs.iter().map(|variable| instance.real(variable.reference));
        let values = values.collect::<Result<Vec<f64>, InstanceError>>()?;
        csv.write_record(std::iter::once(instance.time()).chain(values).map(|value| format!("{value:?}")))?;
        if step < steps {
            instance.do_step(instance.time(), SAMPLING_INTERVAL)?;
        }
    }
    csv.into_inner().map_err(|error| Error::Results(error.to_string()))
}
