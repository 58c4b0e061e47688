//! From instantiation to the end of an instance.

use core::ffi::{CStr, c_char};

use super::calls;
use super::types::{self, Boolean, CO_SIMULATION, CallbackFunctions, FmuType, Real};
use crate::environment::neutral;
use crate::fmi::foreign::{Array, Given, Handle, Text};
use crate::fmi::log::{Log, Logger, Name};
use crate::fmi::session::{Session, enter};
use crate::fmi::status::Status;
use crate::instance::Instance;
use crate::variables::{Version, token};

/// "default": 64-bit numbers, 32-bit integers.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetTypesPlatform() -> *const c_char {
    c"default".as_ptr()
}

/// The version of the standard.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetVersion() -> *const c_char {
    c"2.0".as_ptr()
}

/// Switches categories of messages; errors are always told.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2SetDebugLogging(
    mut component: types::Component,
    logging_on: Boolean,
    n_categories: usize,
    categories: Array<Text>,
) -> Status {
    enter(&mut component, &calls::SET_DEBUG_LOGGING, |session| {
        session.switch_log(logging_on != 0, n_categories, &categories)
    })
}

/// A new instance; null, with the reason in the log, for what cannot be one, and null if there is no memory for it.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2Instantiate(
    instance_name: Text,
    fmu_type: FmuType,
    guid: Text,
    _resource_location: Text,
    functions: Given<CallbackFunctions>,
    _visible: Boolean,
    logging_on: Boolean,
) -> types::Component {
    neutral(|| {
        let Some(callbacks) = functions.get() else { return Handle::NULL };
        let name = instance_name.get().unwrap_or_default();
        let Some(own_name) = Name::new(name) else { return Handle::NULL };
        let logger = callbacks.logger.map_or(Logger::Silent, |logger| Logger::Format(logger, own_name));
        let log = Log::new(logger, callbacks.environment, logging_on != 0);
        let refusal = if name.is_empty() {
            "the instance name is missing"
        } else if fmu_type != CO_SIMULATION {
            "fmuType is refused: expected fmi2CoSimulation (1)"
        } else if guid.get().map(CStr::to_bytes) != Some(token().as_bytes()) {
            "the GUID is not that of this library: model description and binary do not belong together"
        } else {
            log.event(&"instantiated");
            return Handle::new(Session::new(Instance::new(Version::Fmi2), log)).unwrap_or(Handle::NULL);
        };
        log.error("fmi2Instantiate", &refusal);
        Handle::NULL
    })
}

/// Ends an instance, in whatever mode; null is fine.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2FreeInstance(mut component: types::Component) {
    component.free();
}

/// Sets start and end of the experiment; a tolerance has no meaning for a fixed step.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2SetupExperiment(
    mut component: types::Component,
    _tolerance_defined: Boolean,
    _tolerance: Real,
    start_time: Real,
    stop_time_defined: Boolean,
    stop_time: Real,
) -> Status {
    enter(&mut component, &calls::SETUP_EXPERIMENT, |session| {
        session.instance.setup(start_time, (stop_time_defined != 0).then_some(stop_time))
    })
}

/// Begins initialization.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2EnterInitializationMode(mut component: types::Component) -> Status {
    enter(&mut component, &calls::ENTER_INITIALIZATION_MODE, |session| {
        session.instance.enter_initialization();
        Ok(())
    })
}

/// Builds the model.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2ExitInitializationMode(mut component: types::Component) -> Status {
    enter(&mut component, &calls::EXIT_INITIALIZATION_MODE, Session::exit_initialization)
}

/// Ends the simulation.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2Terminate(mut component: types::Component) -> Status {
    enter(&mut component, &calls::TERMINATE, |session| {
        session.terminate();
        Ok(())
    })
}

/// Back to a new instance.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2Reset(mut component: types::Component) -> Status {
    enter(&mut component, &calls::RESET, |session| {
        session.reset();
        Ok(())
    })
}
