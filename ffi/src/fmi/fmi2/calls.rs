//! Which function is legal in which mode: the table of the standard, section 4.2.4, as masks.
//!
//! A step that fails leads to the standard's error state, where results can still be read and the instance be reset or
//! restored.

use crate::instance::{Function, Mode};

const INSTANTIATED: u8 = Mode::Instantiated as u8;
const INITIALIZATION: u8 = Mode::Initialization as u8;
const STEP: u8 = Mode::Step as u8;
const TERMINATED: u8 = Mode::Terminated as u8;
const FAILED: u8 = Mode::Failed as u8;

const ALWAYS: u8 = INSTANTIATED | INITIALIZATION | STEP | TERMINATED | FAILED;
const READABLE: u8 = INITIALIZATION | STEP | TERMINATED | FAILED;
const SETTABLE: u8 = INSTANTIATED | INITIALIZATION | STEP;
const SAVABLE: u8 = INSTANTIATED | INITIALIZATION | STEP | TERMINATED;
const STEPPED: u8 = STEP | TERMINATED | FAILED;

const fn function(name: &'static str, legal: u8) -> Function {
    Function { name, legal }
}

pub(super) const SET_DEBUG_LOGGING: Function = function("fmi2SetDebugLogging", ALWAYS);
pub(super) const SETUP_EXPERIMENT: Function = function("fmi2SetupExperiment", INSTANTIATED);
pub(super) const ENTER_INITIALIZATION_MODE: Function = function("fmi2EnterInitializationMode", INSTANTIATED);
pub(super) const EXIT_INITIALIZATION_MODE: Function = function("fmi2ExitInitializationMode", INITIALIZATION);
pub(super) const TERMINATE: Function = function("fmi2Terminate", STEP);
pub(super) const RESET: Function = function("fmi2Reset", ALWAYS);
pub(super) const GET_REAL: Function = function("fmi2GetReal", READABLE);
pub(super) const GET_INTEGER: Function = function("fmi2GetInteger", READABLE);
pub(super) const GET_BOOLEAN: Function = function("fmi2GetBoolean", READABLE);
pub(super) const GET_STRING: Function = function("fmi2GetString", READABLE);
pub(super) const SET_REAL: Function = function("fmi2SetReal", SETTABLE);
pub(super) const SET_INTEGER: Function = function("fmi2SetInteger", SETTABLE);
pub(super) const SET_BOOLEAN: Function = function("fmi2SetBoolean", SETTABLE);
pub(super) const SET_STRING: Function = function("fmi2SetString", SETTABLE);
pub(super) const GET_FMU_STATE: Function = function("fmi2GetFMUstate", SAVABLE);
pub(super) const SET_FMU_STATE: Function = function("fmi2SetFMUstate", ALWAYS);
pub(super) const FREE_FMU_STATE: Function = function("fmi2FreeFMUstate", ALWAYS);
pub(super) const SERIALIZED_FMU_STATE_SIZE: Function = function("fmi2SerializedFMUstateSize", ALWAYS);
pub(super) const SERIALIZE_FMU_STATE: Function = function("fmi2SerializeFMUstate", ALWAYS);
pub(super) const DESERIALIZE_FMU_STATE: Function = function("fmi2DeSerializeFMUstate", ALWAYS);
pub(super) const GET_DIRECTIONAL_DERIVATIVE: Function = function("fmi2GetDirectionalDerivative", READABLE);
pub(super) const SET_REAL_INPUT_DERIVATIVES: Function = function("fmi2SetRealInputDerivatives", SETTABLE);
pub(super) const GET_REAL_OUTPUT_DERIVATIVES: Function = function("fmi2GetRealOutputDerivatives", STEPPED);
pub(super) const DO_STEP: Function = function("fmi2DoStep", STEP);
pub(super) const CANCEL_STEP: Function = function("fmi2CancelStep", ALWAYS);
pub(super) const GET_STATUS: Function = function("fmi2GetStatus", STEPPED);
pub(super) const GET_REAL_STATUS: Function = function("fmi2GetRealStatus", STEPPED);
pub(super) const GET_INTEGER_STATUS: Function = function("fmi2GetIntegerStatus", STEPPED);
pub(super) const GET_BOOLEAN_STATUS: Function = function("fmi2GetBooleanStatus", STEPPED);
pub(super) const GET_STRING_STATUS: Function = function("fmi2GetStringStatus", STEPPED);
