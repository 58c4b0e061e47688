//! Results for other programs: SI units, the names of the kernel's outputs.

use serde_json::{Map, Value, json};
use softanvil_kernel::OUTPUTS;

use crate::paper;
use crate::quantity::{COUNT, QUANTITIES};
use crate::run::Run;
use crate::validation::{Comparison, Validation};

/// Group of the outputs that are results of the whole test; their keys go without it.
const RESULT: &str = "result.";

/// The results of a run.
pub fn of_run(run: &Run) -> Value {
    let mut object = Map::new();
    for output in OUTPUTS {
        if let Some(key) = output.name.strip_prefix(RESULT) {
            object.insert(key.into(), run.result(output).into());
        } else if let Some(term) = output.name.strip_prefix("energy.") {
            object.insert(format!("energy_{term}"), run.result(output).into());
        }
    }
    object.insert("steps".into(), run.end().step_index.into());
    object.insert("dt".into(), run.constants.dt.into());
    object.insert("design_stretch".into(), run.constants.design_stretch.into());
    object.insert("elements".into(), run.constants.grid.n_elem().into());
    object.insert("trace_hash".into(), run.trace_hash().into());
    Value::Object(object)
}

/// The study's table side by side with ours.
pub fn of_validation(validation: &Validation) -> Value {
    json!({
        "preset": validation.preset.name,
        "source": paper::SOURCE,
        "reading": validation.reading.to_string(),
        "mean_error_percent": validation.mean_error(),
        "peak_force_mean_error_percent": validation.peak_error(),
        "ls_dyna": {
            "mean_error_percent": validation.ls_dyna_mean_error(),
            "peak_force_mean_error_percent": validation.ls_dyna_peak_error(),
        },
        "cases": validation.cases.iter().map(of_case).collect::<Vec<_>>(),
    })
}

fn of_case(case: &Comparison) -> Value {
    let mut object = Map::new();
    object.insert("energy".into(), case.paper.energy.into());
    object.extend(by_key(&case.record.values));
    object.insert("error_percent".into(), by_key(&case.softanvil_errors()).into());
    object.insert("experiment".into(), by_key(&case.paper.experiment).into());
    object.insert("ls_dyna".into(), by_key(&case.paper.ls_dyna).into());
    object.insert("ls_dyna_error_percent".into(), by_key(&case.ls_dyna_errors()).into());
    object.insert("energy_residual".into(), case.run.end().energy.residual().into());
    object.insert("trace_hash".into(), case.run.trace_hash().into());
    Value::Object(object)
}

fn by_key(values: &[f64; COUNT]) -> Map<String, Value> {
    QUANTITIES.iter().zip(values).map(|(quantity, value)| (quantity.key.into(), (*value).into())).collect()
}

/// The text of `value`, indented, with a line break at its end.
pub fn text(value: &Value) -> String {
    format!("{value:#}\n")
}
