//! From instantiation to the end of an instance.

use core::ffi::{CStr, c_char};

use super::calls;
use super::types::{
    self, Boolean, ClockUpdate, Flag, Float64, InstanceEnvironment, LockPreemption, UnlockPreemption, ValueReference,
};
use crate::environment::neutral;
use crate::fmi::foreign::{Array, Handle, Room, Text};
use crate::fmi::log::{Log, Logger, TextLogger};
use crate::fmi::session::{Session, enter};
use crate::fmi::status::Status;
use crate::fmi::updates::{IntermediateUpdate, IntermediateUpdates};
use crate::instance::{Error, Instance, Mode};
use crate::variables::{Version, token};

/// The version of the standard.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetVersion() -> *const c_char {
    c"3.0".as_ptr()
}

/// Switches categories of messages, errors included.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3SetDebugLogging(
    mut instance: types::Instance,
    logging_on: Flag,
    n_categories: usize,
    categories: Array<Text>,
) -> Status {
    enter(&mut instance, &calls::SET_DEBUG_LOGGING, |session| {
        session.switch_log(logging_on != 0, n_categories, &categories)
    })
}

/// A log, and the reason why no instance can be made for it.
fn open(
    function: &str,
    (name, instantiation_token): (Text, Text),
    (logger, environment, events): (Option<TextLogger>, InstanceEnvironment, Flag),
    other: Option<&'static str>,
) -> Option<Log> {
    let log = Log::new(logger.map_or(Logger::Silent, Logger::Text), environment, events != 0);
    let refusal = if name.get().is_none_or(CStr::is_empty) {
        "the instance name is missing"
    } else if instantiation_token.get().map(CStr::to_bytes) != Some(token().as_bytes()) {
        "the instantiation token is not that of this library: model description and binary do not belong together"
    } else if let Some(other) = other {
        other
    } else {
        log.event(&"instantiated");
        return Some(log);
    };
    log.error(function, &refusal);
    None
}

/// A new instance of the preset; null, with the reason in the log, for what cannot be one, and null if there is no memory for
/// it.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3InstantiateCoSimulation(
    instance_name: Text,
    instantiation_token: Text,
    _resource_path: Text,
    _visible: Flag,
    logging_on: Flag,
    event_mode_used: Flag,
    early_return_allowed: Flag,
    required_intermediate_variables: Array<ValueReference>,
    n_required_intermediate_variables: usize,
    instance_environment: InstanceEnvironment,
    log_message: Option<TextLogger>,
    intermediate_update: Option<IntermediateUpdate>,
) -> types::Instance {
    neutral(|| {
        let mut instance = Instance::new(Version::Fmi3);
        if event_mode_used != 0 {
            instance = instance.with_events();
        }
        let required = required_intermediate_variables.items(n_required_intermediate_variables);
        let refusal = match required.map(|all| all.iter().all(|one| instance.variable(*one).is_ok())) {
            None => Some("requiredIntermediateVariables is null"),
            Some(false) => Some("requiredIntermediateVariables has a value reference that no variable has"),
            Some(true) => None,
        };
        let logger = (log_message, instance_environment, logging_on);
        let names = (instance_name, instantiation_token);
        let Some(log) = open("fmi3InstantiateCoSimulation", names, logger, refusal) else { return Handle::NULL };
        let early_return_allowed = early_return_allowed != 0;
        let updates = IntermediateUpdates { call: intermediate_update, environment: instance_environment };
        let mut session = Session::new(instance, log);
        (session.early_return_allowed, session.updates) = (early_return_allowed, updates);
        Handle::new(session).unwrap_or(Handle::NULL)
    })
}

/// Null: the model description declares co-simulation alone.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3InstantiateModelExchange(
    instance_name: Text,
    instantiation_token: Text,
    _resource_path: Text,
    _visible: Flag,
    logging_on: Flag,
    instance_environment: InstanceEnvironment,
    log_message: Option<TextLogger>,
) -> types::Instance {
    let logger = (log_message, instance_environment, logging_on);
    let reason = "model exchange is not supported, see the model description";
    open("fmi3InstantiateModelExchange", (instance_name, instantiation_token), logger, Some(reason));
    Handle::NULL
}

/// Null: the model description declares co-simulation alone.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3InstantiateScheduledExecution(
    instance_name: Text,
    instantiation_token: Text,
    _resource_path: Text,
    _visible: Flag,
    logging_on: Flag,
    instance_environment: InstanceEnvironment,
    log_message: Option<TextLogger>,
    _clock_update: Option<ClockUpdate>,
    _lock_preemption: Option<LockPreemption>,
    _unlock_preemption: Option<UnlockPreemption>,
) -> types::Instance {
    let logger = (log_message, instance_environment, logging_on);
    let reason = "scheduled execution is not supported, see the model description";
    open("fmi3InstantiateScheduledExecution", (instance_name, instantiation_token), logger, Some(reason));
    Handle::NULL
}

/// Ends an instance, in whatever mode but from within its own step; null is fine.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3FreeInstance(mut instance: types::Instance) {
    if enter(&mut instance, &calls::FREE_INSTANCE, |_| Ok(())) == Status::OK {
        instance.free();
    }
}

/// Sets start and end of the experiment and begins initialization; a tolerance has no meaning for a fixed step.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3EnterInitializationMode(
    mut instance: types::Instance,
    _tolerance_defined: Flag,
    _tolerance: Float64,
    start_time: Float64,
    stop_time_defined: Flag,
    stop_time: Float64,
) -> Status {
    enter(&mut instance, &calls::ENTER_INITIALIZATION_MODE, |session| {
        session.instance.setup(start_time, (stop_time_defined != 0).then_some(stop_time))?;
        session.instance.enter_initialization();
        Ok(())
    })
}

/// Builds the model.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3ExitInitializationMode(mut instance: types::Instance) -> Status {
    enter(&mut instance, &calls::EXIT_INITIALIZATION_MODE, Session::exit_initialization)
}

/// Begins the handling of an event.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3EnterEventMode(mut instance: types::Instance) -> Status {
    enter(&mut instance, &calls::ENTER_EVENT_MODE, |session| session.instance.enter(Mode::Event))
}

/// Ends the handling of an event.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3EnterStepMode(mut instance: types::Instance) -> Status {
    enter(&mut instance, &calls::ENTER_STEP_MODE, |session| session.instance.enter(Mode::Step))
}

/// Tells that an event needs no iteration: what changes has changed during the step.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3UpdateDiscreteStates(
    mut instance: types::Instance,
    discrete_states_need_update: Room<Boolean>,
    terminate_simulation: Room<Boolean>,
    nominals_of_continuous_states_changed: Room<Boolean>,
    values_of_continuous_states_changed: Room<Boolean>,
    next_event_time_defined: Room<Boolean>,
    mut next_event_time: Room<Float64>,
) -> Status {
    let flags = [
        ("discreteStatesNeedUpdate", discrete_states_need_update),
        ("terminateSimulation", terminate_simulation),
        ("nominalsOfContinuousStatesChanged", nominals_of_continuous_states_changed),
        ("valuesOfContinuousStatesChanged", values_of_continuous_states_changed),
        ("nextEventTimeDefined", next_event_time_defined),
    ];
    enter(&mut instance, &calls::UPDATE_DISCRETE_STATES, |_| {
        for (argument, mut flag) in flags {
            flag.item().ok_or(Error::Null { argument })?.write(false);
        }
        next_event_time.item().ok_or(Error::Null { argument: "nextEventTime" })?.write(0.0);
        Ok(())
    })
}

/// Begins the setting of structural parameters.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3EnterConfigurationMode(mut instance: types::Instance) -> Status {
    enter(&mut instance, &calls::ENTER_CONFIGURATION_MODE, |session| session.instance.enter(Mode::Configuration))
}

/// Ends the setting of structural parameters.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3ExitConfigurationMode(mut instance: types::Instance) -> Status {
    enter(&mut instance, &calls::EXIT_CONFIGURATION_MODE, |session| session.instance.enter(Mode::Instantiated))
}

/// Ends the simulation.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3Terminate(mut instance: types::Instance) -> Status {
    enter(&mut instance, &calls::TERMINATE, |session| {
        session.terminate();
        Ok(())
    })
}

/// Back to a new instance.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3Reset(mut instance: types::Instance) -> Status {
    enter(&mut instance, &calls::RESET, |session| {
        session.reset();
        Ok(())
    })
}
