//! The functions of model exchange, which the model description does not declare: some importers will not load a library
//! without them. Every call is refused, with the reason in the log.

use super::types::{self, Boolean, Real};
use crate::fmi::foreign::{Array, Room};
use crate::fmi::session::enter;
use crate::fmi::status::Status;
use crate::instance::{Error, Function};

fn refuse(component: &mut types::Component, name: &'static str) -> Status {
    let anywhere = Function { name, legal: u8::MAX };
    enter(component, &anywhere, |_| Err(Error::Unsupported { what: "model exchange" }))
}

/// Refuses: model exchange is not declared.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2EnterEventMode(mut component: types::Component) -> Status {
    refuse(&mut component, "fmi2EnterEventMode")
}

/// Refuses: model exchange is not declared.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2NewDiscreteStates(mut component: types::Component, _event_info: *mut types::EventInfo) -> Status {
    refuse(&mut component, "fmi2NewDiscreteStates")
}

/// Refuses: model exchange is not declared.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2EnterContinuousTimeMode(mut component: types::Component) -> Status {
    refuse(&mut component, "fmi2EnterContinuousTimeMode")
}

/// Refuses: model exchange is not declared.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2CompletedIntegratorStep(
    mut component: types::Component,
    _no_set_fmu_state_prior_to_current_point: Boolean,
    _enter_event_mode: Room<Boolean>,
    _terminate_simulation: Room<Boolean>,
) -> Status {
    refuse(&mut component, "fmi2CompletedIntegratorStep")
}

/// Refuses: model exchange is not declared.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2SetTime(mut component: types::Component, _time: Real) -> Status {
    refuse(&mut component, "fmi2SetTime")
}

/// Refuses: model exchange is not declared.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2SetContinuousStates(mut component: types::Component, _x: Array<Real>, _nx: usize) -> Status {
    refuse(&mut component, "fmi2SetContinuousStates")
}

/// Refuses: model exchange is not declared.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetDerivatives(mut component: types::Component, _derivatives: Room<Real>, _nx: usize) -> Status {
    refuse(&mut component, "fmi2GetDerivatives")
}

/// Refuses: model exchange is not declared.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetEventIndicators(
    mut component: types::Component,
    _event_indicators: Room<Real>,
    _ni: usize,
) -> Status {
    refuse(&mut component, "fmi2GetEventIndicators")
}

/// Refuses: model exchange is not declared.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetContinuousStates(mut component: types::Component, _x: Room<Real>, _nx: usize) -> Status {
    refuse(&mut component, "fmi2GetContinuousStates")
}

/// Refuses: model exchange is not declared.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetNominalsOfContinuousStates(
    mut component: types::Component,
    _x_nominal: Room<Real>,
    _nx: usize,
) -> Status {
    refuse(&mut component, "fmi2GetNominalsOfContinuousStates")
}
