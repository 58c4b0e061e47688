//! What a master can ask after a step. Steps are complete when they return, so nothing is ever pending.

use core::ffi::c_char;

use super::calls;
use super::types::{self, Boolean, DO_STEP_STATUS, Integer, LAST_SUCCESSFUL_TIME, Real, StatusKind, TERMINATED};
use crate::fmi::foreign::Room;
use crate::fmi::session::enter;
use crate::fmi::status::Status;
use crate::instance::{Error, Function, Instance};

/// Answers `function`; a kind that it has no answer for is discarded.
fn answer<T: Copy>(
    component: &mut types::Component,
    function: &Function,
    kind: StatusKind,
    mut value: Room<T>,
    known: impl FnOnce(&Instance) -> Option<T>,
) -> Status {
    let mut discarded = false;
    let status = enter(component, function, |component| {
        if !(DO_STEP_STATUS..=TERMINATED).contains(&kind) {
            return Err(Error::Argument { argument: "fmi2StatusKind", value: i64::from(kind) });
        }
        let value = value.item().ok_or(Error::Null { argument: "value" })?;
        match known(&component.instance) {
            Some(answer) => {
                value.write(answer);
            }
            None => {
                component.log.discard(function.name, &"there is no such status");
                discarded = true;
            }
        }
        Ok(())
    });
    if discarded { Status::DISCARD } else { status }
}

/// How the last step ended.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetStatus(mut component: types::Component, kind: StatusKind, value: Room<Status>) -> Status {
    answer(&mut component, &calls::GET_STATUS, kind, value, |instance| {
        let status = if instance.has_failed() { Status::ERROR } else { Status::OK };
        (kind == DO_STEP_STATUS).then_some(status)
    })
}

/// The time up to which the simulation succeeded.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetRealStatus(mut component: types::Component, kind: StatusKind, value: Room<Real>) -> Status {
    answer(&mut component, &calls::GET_REAL_STATUS, kind, value, |instance| {
        (kind == LAST_SUCCESSFUL_TIME).then(|| instance.time())
    })
}

/// No status is an integer.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetIntegerStatus(
    mut component: types::Component,
    kind: StatusKind,
    value: Room<Integer>,
) -> Status {
    answer(&mut component, &calls::GET_INTEGER_STATUS, kind, value, |_| None)
}

/// Whether the instance wants to end the simulation, which it never does.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetBooleanStatus(
    mut component: types::Component,
    kind: StatusKind,
    value: Room<Boolean>,
) -> Status {
    answer(&mut component, &calls::GET_BOOLEAN_STATUS, kind, value, |_| (kind == TERMINATED).then_some(0))
}

/// No status is a text.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetStringStatus(
    mut component: types::Component,
    kind: StatusKind,
    value: Room<*const c_char>,
) -> Status {
    answer(&mut component, &calls::GET_STRING_STATUS, kind, value, |_| None)
}
