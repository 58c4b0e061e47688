//! What this FMU has not: variables of other types, settable ones of some, clocks, derivatives, model exchange and
//! scheduled execution. Every call is refused, with the reason in the log; reading or setting no variable is fine.

use super::calls::anywhere;
use super::types::{self, Binary, Boolean, Clock, Flag, Float64, Int32, Kind, UInt64, ValueReference};
use crate::fmi::foreign::{Array, Room, Text};
use crate::fmi::session::{Session, enter};
use crate::fmi::status::Status;
use crate::instance::{Error, Function};

/// Why variables of a type are refused.
type Reason = fn(&Session, ValueReference) -> Error;

/// Refuses the first of the variables; naming none is fine.
fn refuse_variables(
    instance: &mut types::Instance,
    function: &Function,
    (references, n): (Array<ValueReference>, usize),
    reason: Reason,
) -> Status {
    enter(instance, function, |session| {
        match references.items(n).ok_or(Error::Null { argument: "valueReferences" })?.first() {
            Some(reference) => Err(reason(session, *reference)),
            None => Ok(()),
        }
    })
}

/// Refuses a capability.
fn refuse(instance: &mut types::Instance, function: &Function, what: &'static str) -> Status {
    enter(instance, function, |_| Err(Error::Unsupported { what }))
}

/// Getter of a type that no variable has.
macro_rules! getter {
    ($name:ident, $value:ty, $type:literal) => {
        #[doc = concat!("Refuses: no variable is of type ", $type, ".")]
        #[unsafe(no_mangle)]
        pub extern "C" fn $name(
            mut instance: types::Instance,
            value_references: Array<ValueReference>,
            n_value_references: usize,
            _values: Room<$value>,
            _n_values: usize,
        ) -> Status {
            let named = (value_references, n_value_references);
            refuse_variables(&mut instance, &anywhere(stringify!($name)), named, |session, reference| {
                session.instance.refuse_to_get(reference, $type)
            })
        }
    };
}

/// Setter of a type of which no variable can be set.
macro_rules! setter {
    ($name:ident, $value:ty, $type:literal) => {
        #[doc = concat!("Refuses: no variable of type ", $type, " can be set.")]
        #[unsafe(no_mangle)]
        pub extern "C" fn $name(
            mut instance: types::Instance,
            value_references: Array<ValueReference>,
            n_value_references: usize,
            _values: Array<$value>,
            _n_values: usize,
        ) -> Status {
            let named = (value_references, n_value_references);
            refuse_variables(&mut instance, &anywhere(stringify!($name)), named, |session, reference| {
                session.instance.refuse_to_set(reference, $type)
            })
        }
    };
}

getter!(fmi3GetFloat32, f32, "Float32");
setter!(fmi3SetFloat32, f32, "Float32");
getter!(fmi3GetInt8, i8, "Int8");
setter!(fmi3SetInt8, i8, "Int8");
getter!(fmi3GetUInt8, u8, "UInt8");
setter!(fmi3SetUInt8, u8, "UInt8");
getter!(fmi3GetInt16, i16, "Int16");
setter!(fmi3SetInt16, i16, "Int16");
getter!(fmi3GetUInt16, u16, "UInt16");
setter!(fmi3SetUInt16, u16, "UInt16");
getter!(fmi3GetUInt32, u32, "UInt32");
setter!(fmi3SetUInt32, u32, "UInt32");
setter!(fmi3SetString, Text, "String");

/// Refuses: no variable is of type Binary.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetBinary(
    mut instance: types::Instance,
    value_references: Array<ValueReference>,
    n_value_references: usize,
    _value_sizes: Room<usize>,
    _values: Room<Binary>,
    _n_values: usize,
) -> Status {
    let named = (value_references, n_value_references);
    refuse_variables(&mut instance, &anywhere("fmi3GetBinary"), named, |session, reference| {
        session.instance.refuse_to_get(reference, "Binary")
    })
}

/// Refuses: no variable is of type Binary.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3SetBinary(
    mut instance: types::Instance,
    value_references: Array<ValueReference>,
    n_value_references: usize,
    _value_sizes: Array<usize>,
    _values: Array<Binary>,
    _n_values: usize,
) -> Status {
    let named = (value_references, n_value_references);
    refuse_variables(&mut instance, &anywhere("fmi3SetBinary"), named, |session, reference| {
        session.instance.refuse_to_set(reference, "Binary")
    })
}

/// Refuses: there are no clocks.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetClock(
    mut instance: types::Instance,
    value_references: Array<ValueReference>,
    n_value_references: usize,
    _values: Room<Clock>,
) -> Status {
    let named = (value_references, n_value_references);
    refuse_variables(&mut instance, &anywhere("fmi3GetClock"), named, |session, reference| {
        session.instance.refuse_to_get(reference, "Clock")
    })
}

/// Refuses: there are no clocks.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3SetClock(
    mut instance: types::Instance,
    value_references: Array<ValueReference>,
    n_value_references: usize,
    _values: Array<Clock>,
) -> Status {
    let named = (value_references, n_value_references);
    refuse_variables(&mut instance, &anywhere("fmi3SetClock"), named, |session, reference| {
        session.instance.refuse_to_set(reference, "Clock")
    })
}

/// Refuses: there are no clocks.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetIntervalDecimal(
    mut instance: types::Instance,
    value_references: Array<ValueReference>,
    n_value_references: usize,
    _intervals: Room<Float64>,
    _qualifiers: Room<Kind>,
) -> Status {
    let named = (value_references, n_value_references);
    refuse_variables(&mut instance, &anywhere("fmi3GetIntervalDecimal"), named, |session, reference| {
        session.instance.refuse_to_get(reference, "Clock")
    })
}

/// Refuses: there are no clocks.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetIntervalFraction(
    mut instance: types::Instance,
    value_references: Array<ValueReference>,
    n_value_references: usize,
    _counters: Room<UInt64>,
    _resolutions: Room<UInt64>,
    _qualifiers: Room<Kind>,
) -> Status {
    let named = (value_references, n_value_references);
    refuse_variables(&mut instance, &anywhere("fmi3GetIntervalFraction"), named, |session, reference| {
        session.instance.refuse_to_get(reference, "Clock")
    })
}

/// Refuses: there are no clocks.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetShiftDecimal(
    mut instance: types::Instance,
    value_references: Array<ValueReference>,
    n_value_references: usize,
    _shifts: Room<Float64>,
) -> Status {
    let named = (value_references, n_value_references);
    refuse_variables(&mut instance, &anywhere("fmi3GetShiftDecimal"), named, |session, reference| {
        session.instance.refuse_to_get(reference, "Clock")
    })
}

/// Refuses: there are no clocks.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetShiftFraction(
    mut instance: types::Instance,
    value_references: Array<ValueReference>,
    n_value_references: usize,
    _counters: Room<UInt64>,
    _resolutions: Room<UInt64>,
) -> Status {
    let named = (value_references, n_value_references);
    refuse_variables(&mut instance, &anywhere("fmi3GetShiftFraction"), named, |session, reference| {
        session.instance.refuse_to_get(reference, "Clock")
    })
}

/// Refuses: there are no clocks.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3SetIntervalDecimal(
    mut instance: types::Instance,
    value_references: Array<ValueReference>,
    n_value_references: usize,
    _intervals: Array<Float64>,
) -> Status {
    let named = (value_references, n_value_references);
    refuse_variables(&mut instance, &anywhere("fmi3SetIntervalDecimal"), named, |session, reference| {
        session.instance.refuse_to_set(reference, "Clock")
    })
}

/// Refuses: there are no clocks.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3SetIntervalFraction(
    mut instance: types::Instance,
    value_references: Array<ValueReference>,
    n_value_references: usize,
    _counters: Array<UInt64>,
    _resolutions: Array<UInt64>,
) -> Status {
    let named = (value_references, n_value_references);
    refuse_variables(&mut instance, &anywhere("fmi3SetIntervalFraction"), named, |session, reference| {
        session.instance.refuse_to_set(reference, "Clock")
    })
}

/// Refuses: there are no clocks.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3SetShiftDecimal(
    mut instance: types::Instance,
    value_references: Array<ValueReference>,
    n_value_references: usize,
    _shifts: Array<Float64>,
) -> Status {
    let named = (value_references, n_value_references);
    refuse_variables(&mut instance, &anywhere("fmi3SetShiftDecimal"), named, |session, reference| {
        session.instance.refuse_to_set(reference, "Clock")
    })
}

/// Refuses: there are no clocks.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3SetShiftFraction(
    mut instance: types::Instance,
    value_references: Array<ValueReference>,
    n_value_references: usize,
    _counters: Array<UInt64>,
    _resolutions: Array<UInt64>,
) -> Status {
    let named = (value_references, n_value_references);
    refuse_variables(&mut instance, &anywhere("fmi3SetShiftFraction"), named, |session, reference| {
        session.instance.refuse_to_set(reference, "Clock")
    })
}

/// Refuses: providesPerElementDependencies is false.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetNumberOfVariableDependencies(
    mut instance: types::Instance,
    _value_reference: ValueReference,
    _n_dependencies: Room<usize>,
) -> Status {
    refuse(&mut instance, &anywhere("fmi3GetNumberOfVariableDependencies"), "the dependency of single elements")
}

/// Refuses: providesPerElementDependencies is false.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetVariableDependencies(
    mut instance: types::Instance,
    _dependent: ValueReference,
    _element_indices_of_dependent: Room<usize>,
    _independents: Room<ValueReference>,
    _element_indices_of_independents: Room<usize>,
    _dependency_kinds: Room<Kind>,
    _n_dependencies: usize,
) -> Status {
    refuse(&mut instance, &anywhere("fmi3GetVariableDependencies"), "the dependency of single elements")
}

/// Refuses: providesDirectionalDerivatives is false.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetDirectionalDerivative(
    mut instance: types::Instance,
    _unknowns: Array<ValueReference>,
    _n_unknowns: usize,
    _knowns: Array<ValueReference>,
    _n_knowns: usize,
    _seed: Array<Float64>,
    _n_seed: usize,
    _sensitivity: Room<Float64>,
    _n_sensitivity: usize,
) -> Status {
    refuse(&mut instance, &anywhere("fmi3GetDirectionalDerivative"), "the directional derivative")
}

/// Refuses: providesAdjointDerivatives is false.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetAdjointDerivative(
    mut instance: types::Instance,
    _unknowns: Array<ValueReference>,
    _n_unknowns: usize,
    _knowns: Array<ValueReference>,
    _n_knowns: usize,
    _seed: Array<Float64>,
    _n_seed: usize,
    _sensitivity: Room<Float64>,
    _n_sensitivity: usize,
) -> Status {
    refuse(&mut instance, &anywhere("fmi3GetAdjointDerivative"), "the adjoint derivative")
}

/// Refuses: maxOutputDerivativeOrder is 0.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetOutputDerivatives(
    mut instance: types::Instance,
    _value_references: Array<ValueReference>,
    _n_value_references: usize,
    _orders: Array<Int32>,
    _values: Room<Float64>,
    _n_values: usize,
) -> Status {
    refuse(&mut instance, &anywhere("fmi3GetOutputDerivatives"), "the derivative of an output")
}

/// Refuses: providesEvaluateDiscreteStates is false.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3EvaluateDiscreteStates(mut instance: types::Instance) -> Status {
    refuse(&mut instance, &anywhere("fmi3EvaluateDiscreteStates"), "the evaluation of discrete states")
}

/// Refuses: model exchange is not declared.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3EnterContinuousTimeMode(mut instance: types::Instance) -> Status {
    refuse(&mut instance, &anywhere("fmi3EnterContinuousTimeMode"), "model exchange")
}

/// Refuses: model exchange is not declared.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3CompletedIntegratorStep(
    mut instance: types::Instance,
    _no_set_fmu_state_prior_to_current_point: Flag,
    _enter_event_mode: Room<Boolean>,
    _terminate_simulation: Room<Boolean>,
) -> Status {
    refuse(&mut instance, &anywhere("fmi3CompletedIntegratorStep"), "model exchange")
}

/// Refuses: model exchange is not declared.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3SetTime(mut instance: types::Instance, _time: Float64) -> Status {
    refuse(&mut instance, &anywhere("fmi3SetTime"), "model exchange")
}

/// Refuses: model exchange is not declared.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3SetContinuousStates(
    mut instance: types::Instance,
    _continuous_states: Array<Float64>,
    _n_continuous_states: usize,
) -> Status {
    refuse(&mut instance, &anywhere("fmi3SetContinuousStates"), "model exchange")
}

/// Refuses: model exchange is not declared.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetContinuousStateDerivatives(
    mut instance: types::Instance,
    _derivatives: Room<Float64>,
    _n: usize,
) -> Status {
    refuse(&mut instance, &anywhere("fmi3GetContinuousStateDerivatives"), "model exchange")
}

/// Refuses: model exchange is not declared.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetEventIndicators(
    mut instance: types::Instance,
    _event_indicators: Room<Float64>,
    _n: usize,
) -> Status {
    refuse(&mut instance, &anywhere("fmi3GetEventIndicators"), "model exchange")
}

/// Refuses: model exchange is not declared.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetContinuousStates(
    mut instance: types::Instance,
    _continuous_states: Room<Float64>,
    _n: usize,
) -> Status {
    refuse(&mut instance, &anywhere("fmi3GetContinuousStates"), "model exchange")
}

/// Refuses: model exchange is not declared.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetNominalsOfContinuousStates(
    mut instance: types::Instance,
    _nominals: Room<Float64>,
    _n: usize,
) -> Status {
    refuse(&mut instance, &anywhere("fmi3GetNominalsOfContinuousStates"), "model exchange")
}

/// Refuses: model exchange is not declared.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetNumberOfEventIndicators(mut instance: types::Instance, _n: Room<usize>) -> Status {
    refuse(&mut instance, &anywhere("fmi3GetNumberOfEventIndicators"), "model exchange")
}

/// Refuses: model exchange is not declared.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetNumberOfContinuousStates(mut instance: types::Instance, _n: Room<usize>) -> Status {
    refuse(&mut instance, &anywhere("fmi3GetNumberOfContinuousStates"), "model exchange")
}

/// Refuses: scheduled execution is not declared.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3ActivateModelPartition(
    mut instance: types::Instance,
    _clock_reference: ValueReference,
    _activation_time: Float64,
) -> Status {
    refuse(&mut instance, &anywhere("fmi3ActivateModelPartition"), "scheduled execution")
}
