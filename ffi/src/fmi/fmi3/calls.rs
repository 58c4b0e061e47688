//! Which function is legal in which mode: the state machine of the standard, sections 2.3 and 4.2.1, as masks.
//!
//! A step that fails leads to a state where results can still be read and the instance be reset or restored.

use crate::instance::{Function, Mode};

const INSTANTIATED: u8 = Mode::Instantiated as u8;
const CONFIGURATION: u8 = Mode::Configuration as u8;
const INITIALIZATION: u8 = Mode::Initialization as u8;
const EVENT: u8 = Mode::Event as u8;
const STEP: u8 = Mode::Step as u8;
const INTERMEDIATE_UPDATE: u8 = Mode::IntermediateUpdate as u8;
const TERMINATED: u8 = Mode::Terminated as u8;
const FAILED: u8 = Mode::Failed as u8;

const SAVABLE: u8 = INSTANTIATED | CONFIGURATION | INITIALIZATION | EVENT | STEP | TERMINATED;
const ALWAYS: u8 = SAVABLE | FAILED;
/// After instantiation the start values can be read, and what follows from them.
const READABLE: u8 = INSTANTIATED | INITIALIZATION | EVENT | STEP | INTERMEDIATE_UPDATE | TERMINATED | FAILED;
const SETTABLE: u8 = INSTANTIATED | CONFIGURATION | INITIALIZATION | EVENT | STEP;

const fn function(name: &'static str, legal: u8) -> Function {
    Function { name, legal }
}

/// A function whose refusal does not depend on the mode.
pub(super) const fn anywhere(name: &'static str) -> Function {
    function(name, ALWAYS | INTERMEDIATE_UPDATE)
}

pub(super) const SET_DEBUG_LOGGING: Function = function("fmi3SetDebugLogging", ALWAYS);
pub(super) const ENTER_INITIALIZATION_MODE: Function = function("fmi3EnterInitializationMode", INSTANTIATED);
pub(super) const EXIT_INITIALIZATION_MODE: Function = function("fmi3ExitInitializationMode", INITIALIZATION);
pub(super) const ENTER_EVENT_MODE: Function = function("fmi3EnterEventMode", STEP);
pub(super) const ENTER_STEP_MODE: Function = function("fmi3EnterStepMode", EVENT);
pub(super) const UPDATE_DISCRETE_STATES: Function = function("fmi3UpdateDiscreteStates", EVENT);
pub(super) const ENTER_CONFIGURATION_MODE: Function = function("fmi3EnterConfigurationMode", INSTANTIATED);
pub(super) const EXIT_CONFIGURATION_MODE: Function = function("fmi3ExitConfigurationMode", CONFIGURATION);
pub(super) const TERMINATE: Function = function("fmi3Terminate", STEP | EVENT);
pub(super) const RESET: Function = function("fmi3Reset", ALWAYS);
pub(super) const FREE_INSTANCE: Function = function("fmi3FreeInstance", ALWAYS);
pub(super) const DO_STEP: Function = function("fmi3DoStep", STEP);
pub(super) const GET_FLOAT64: Function = function("fmi3GetFloat64", READABLE);
pub(super) const GET_INT32: Function = function("fmi3GetInt32", READABLE);
pub(super) const GET_INT64: Function = function("fmi3GetInt64", READABLE);
pub(super) const GET_UINT64: Function = function("fmi3GetUInt64", READABLE);
pub(super) const GET_BOOLEAN: Function = function("fmi3GetBoolean", READABLE);
pub(super) const GET_STRING: Function = function("fmi3GetString", READABLE);
pub(super) const SET_FLOAT64: Function = function("fmi3SetFloat64", SETTABLE);
pub(super) const SET_INT32: Function = function("fmi3SetInt32", SETTABLE);
pub(super) const SET_INT64: Function = function("fmi3SetInt64", SETTABLE);
pub(super) const SET_UINT64: Function = function("fmi3SetUInt64", SETTABLE);
pub(super) const SET_BOOLEAN: Function = function("fmi3SetBoolean", SETTABLE);
pub(super) const GET_FMU_STATE: Function = function("fmi3GetFMUState", SAVABLE);
pub(super) const SET_FMU_STATE: Function = function("fmi3SetFMUState", ALWAYS);
pub(super) const FREE_FMU_STATE: Function = function("fmi3FreeFMUState", ALWAYS);
pub(super) const SERIALIZED_FMU_STATE_SIZE: Function = function("fmi3SerializedFMUStateSize", ALWAYS);
pub(super) const SERIALIZE_FMU_STATE: Function = function("fmi3SerializeFMUState", ALWAYS);
pub(super) const DESERIALIZE_FMU_STATE: Function = function("fmi3DeserializeFMUState", ALWAYS);
