//! Results for other programs: SI units, the names of the kernel's outputs.

use serde_json::{Map, Value, json};
use softanvil_kernel::preset::Fitted;
use softanvil_kernel::{OUTPUTS, Output, Parameter};

use crate::measurement::band::{Band, Expected};
use crate::measurement::quantity::{COUNT, QUANTITIES};
use crate::output::mesh_quality::mesh_quality;
use crate::output::subject::{self, Subject};
use crate::output::table::IMPACT_RESULTS;
use crate::paper;
use crate::paper::validation::{TableComparison, Validation};
use crate::run::{Ending, Run};

/// Group of the outputs that are results of the whole test; their keys go without it.
const RESULT: &str = "result.";

/// The results of a run; null where there was no impact to have any.
pub fn of_run(run: &Run, subject: &Subject) -> Value {
    let mut object = Map::new();
    object.insert("drop".into(), subject.json());
    let ending = run.ending();
    for output in OUTPUTS {
        match output.name.split_once('.') {
            Some(("result", "complete")) => {}
            Some(("result", key)) => {
                let value = (ending != Ending::NoContact).then(|| run.result(output));
                object.insert(key.into(), value.into());
            }
            Some(("energy", term)) => {
                object.insert(format!("energy_{term}"), run.result(output).into());
            }
            _ => {}
        }
    }
    object.extend(of_ending(run));
    object.insert("steps".into(), run.end().step_index.into());
    object.insert("dt".into(), run.constants.dt.into());
    object.insert("design_stretch".into(), run.constants.design_stretch.into());
    object.insert("elements".into(), run.constants.grid.n_elem().into());
    let quality = mesh_quality(&run.constants.scenario, &run.constants.grid);
    object.insert("mesh_quality".into(), json!({ "smallest": quality.smallest, "mean": quality.mean }));
    object.insert("warnings".into(), subject::warnings(&run.constants, run.end()).into());
    object.insert("trace_hash".into(), run.trace_hash().into());
    Value::Object(object)
}

/// The results of the last of several impacts on the same anvil, and of each in the list `impacts` what
/// [`IMPACT_RESULTS`] names; of a single one its results alone.
pub fn of_impacts(earlier: &[Run], last: &Run, subject: &Subject) -> Value {
    let mut value = of_run(last, subject);
    if !earlier.is_empty() {
        let one = |run: &Run| {
            let results = IMPACT_RESULTS.iter().filter_map(|name| Output::find(name));
            let mut object = of_ending(run);
            let named = results
                .filter_map(|output| Some((output.name.strip_prefix(RESULT)?.into(), run.result(output).into())));
            object.extend(named);
            Value::Object(object)
        };
        value["impacts"] = earlier.iter().chain([last]).map(one).collect();
    }
    value
}

/// How a run ended, and the keys of the results that are those so far.
pub fn of_ending(run: &Run) -> Map<String, Value> {
    let ending = run.ending();
    let cut = OUTPUTS.iter().filter(|output| ending.cuts(output.name));
    let cut = cut.filter_map(|output| output.name.strip_prefix(RESULT)).collect::<Vec<_>>();
    let mut object = Map::new();
    object.insert("complete".into(), (ending == Ending::Complete).into());
    object.insert("ending".into(), ending.key().into());
    object.insert("cut".into(), cut.into());
    object.insert("simulated_time".into(), run.time(run.end()).into());
    object
}

/// The paper's table side by side with ours.
pub fn of_validation(validation: &Validation) -> Value {
    json!({
        "preset": validation.preset.name,
        "formulation": formulation(validation),
        "source": paper::SOURCE,
        "reading": validation.reading.to_string(),
        "fitted": fitted(&validation.preset.fitted),
        "mean_error_percent": validation.mean_error(),
        "peak_force_mean_error_percent": validation.peak_error(),
        "ls_dyna": {
            "fitted": fitted(&paper::FITTED),
            "mean_error_percent": validation.ls_dyna_mean_error(),
            "peak_force_mean_error_percent": validation.ls_dyna_peak_error(),
        },
        "cases": validation.cases.iter().map(of_case).collect::<Vec<_>>(),
    })
}

/// The formulation by its name in scenario files.
fn formulation(validation: &Validation) -> Option<&'static str> {
    let parameter = Parameter::find("geometry.formulation")?;
    parameter.labels().get(validation.formulation as usize).copied()
}

fn fitted(fitted: &Fitted) -> Value {
    json!({ "parameters": fitted.parameters, "numbers": fitted.numbers })
}

fn of_case(case: &TableComparison) -> Value {
    let mut object = Map::new();
    object.insert("energy".into(), case.paper.energy.into());
    object.extend(by_key(&case.record.values));
    object.extend(of_ending(&case.run));
    object.insert("error_percent".into(), by_key(&case.softanvil_errors()).into());
    object.insert("experiment".into(), by_key(&case.paper.experiment).into());
    object.insert("ls_dyna".into(), by_key(&case.paper.ls_dyna).into());
    object.insert("ls_dyna_error_percent".into(), by_key(&case.ls_dyna_errors()).into());
    if let Some(expected) = &case.expected {
        object.insert("bands".into(), of_bands(expected));
    }
    object.insert("energy_residual".into(), case.run.end().energy.residual().into());
    object.insert("trace_hash".into(), case.run.trace_hash().into());
    Value::Object(object)
}

/// The 90 % bands of the four numbers.
pub fn of_bands(expected: &Expected) -> Value {
    let of = |bands: &[Band; COUNT]| -> Map<String, Value> {
        QUANTITIES.iter().zip(bands).map(|(quantity, band)| (quantity.key.into(), json!(band))).collect()
    };
    json!({ "parameters": of(&expected.parameters), "measured": of(&expected.measured) })
}

fn by_key(values: &[f64; COUNT]) -> Map<String, Value> {
    QUANTITIES.iter().zip(values).map(|(quantity, value)| (quantity.key.into(), (*value).into())).collect()
}

/// The text of `value`, indented, with a line break at its end.
pub fn text(value: &Value) -> String {
    format!("{value:#}\n")
}
