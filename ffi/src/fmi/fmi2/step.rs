//! Communication steps.

use super::calls;
use super::types::{self, Boolean, Integer, Real, ValueReference};
use crate::fmi::foreign::{Array, Room};
use crate::fmi::session::enter;
use crate::fmi::status::Status;
use crate::instance::Error;

/// Advances the simulation.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2DoStep(
    mut component: types::Component,
    current_communication_point: Real,
    communication_step_size: Real,
    _no_set_fmu_state_prior_to_current_point: Boolean,
) -> Status {
    enter(&mut component, &calls::DO_STEP, move |component| {
        component.instance.do_step(current_communication_point, communication_step_size)
    })
}

/// Refuses: canRunAsynchronuously is false.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2CancelStep(mut component: types::Component) -> Status {
    enter(&mut component, &calls::CANCEL_STEP, |_| Err(Error::Unsupported { what: "an asynchronous step" }))
}

/// Refuses: canInterpolateInputs is false.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2SetRealInputDerivatives(
    mut component: types::Component,
    _vr: Array<ValueReference>,
    _nvr: usize,
    _order: Array<Integer>,
    _value: Array<Real>,
) -> Status {
    enter(&mut component, &calls::SET_REAL_INPUT_DERIVATIVES, |_| {
        Err(Error::Unsupported { what: "the interpolation of inputs" })
    })
}

/// Refuses: maxOutputDerivativeOrder is 0.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetRealOutputDerivatives(
    mut component: types::Component,
    _vr: Array<ValueReference>,
    _nvr: usize,
    _order: Array<Integer>,
    _value: Room<Real>,
) -> Status {
    enter(&mut component, &calls::GET_REAL_OUTPUT_DERIVATIVES, |_| {
        Err(Error::Unsupported { what: "the derivative of an output" })
    })
}
