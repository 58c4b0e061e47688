//! Getting and setting variables.

use core::ffi::c_char;

use super::calls;
use super::types::{self, Boolean, Integer, Real, ValueReference};
use crate::fmi::foreign::{Array, Room, Text};
use crate::fmi::session::{Session, enter};
use crate::fmi::status::Status;
use crate::instance::{Error, Function};

/// Reads `n` variables; writes all of them, or none if one is refused.
fn get<T: Copy>(
    component: &mut types::Component,
    function: &Function,
    (references, n): (Array<ValueReference>, usize),
    mut values: Room<T>,
    read: impl Fn(&mut Session, ValueReference) -> Result<T, Error>,
) -> Status {
    enter(component, function, |component| {
        let references = references.items(n).ok_or(Error::Null { argument: "vr" })?;
        let values = values.items(n).ok_or(Error::Null { argument: "value" })?;
        // The first needs no trial: nothing is written before it has been read.
        for reference in references.iter().skip(1) {
            read(component, *reference)?;
        }
        for (reference, value) in references.iter().zip(values) {
            value.write(read(component, *reference)?);
        }
        Ok(())
    })
}

/// Reads quantities.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetReal(
    mut component: types::Component,
    vr: Array<ValueReference>,
    nvr: usize,
    value: Room<Real>,
) -> Status {
    get(&mut component, &calls::GET_REAL, (vr, nvr), value, |component, reference| component.instance.real(reference))
}

/// Reads counts and choices.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetInteger(
    mut component: types::Component,
    vr: Array<ValueReference>,
    nvr: usize,
    value: Room<Integer>,
) -> Status {
    get(&mut component, &calls::GET_INTEGER, (vr, nvr), value, |session, reference| {
        session.instance.choice(reference).or_else(|_| session.instance.integer(reference))
    })
}

/// Reads states.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetBoolean(
    mut component: types::Component,
    vr: Array<ValueReference>,
    nvr: usize,
    value: Room<Boolean>,
) -> Status {
    get(&mut component, &calls::GET_BOOLEAN, (vr, nvr), value, |component, reference| {
        component.instance.boolean(reference).map(Boolean::from)
    })
}

/// Reads texts, which stay valid until the next call on the instance.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetString(
    mut component: types::Component,
    vr: Array<ValueReference>,
    nvr: usize,
    value: Room<*const c_char>,
) -> Status {
    get(&mut component, &calls::GET_STRING, (vr, nvr), value, |component, reference| {
        let digits = component.instance.text(reference)?;
        Ok(component.keep_text(digits).as_ptr())
    })
}

/// Sets quantities.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2SetReal(
    mut component: types::Component,
    vr: Array<ValueReference>,
    nvr: usize,
    value: Array<Real>,
) -> Status {
    enter(&mut component, &calls::SET_REAL, |component| {
        let references = vr.items(nvr).ok_or(Error::Null { argument: "vr" })?;
        let values = value.items(nvr).ok_or(Error::Null { argument: "value" })?;
        component.instance.set_reals(references.iter().copied().zip(values.iter().copied()))
    })
}

/// Sets choices.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2SetInteger(
    mut component: types::Component,
    vr: Array<ValueReference>,
    nvr: usize,
    value: Array<Integer>,
) -> Status {
    enter(&mut component, &calls::SET_INTEGER, |component| {
        let references = vr.items(nvr).ok_or(Error::Null { argument: "vr" })?;
        let values = value.items(nvr).ok_or(Error::Null { argument: "value" })?;
        component.instance.set_choices(references.iter().copied().zip(values.iter().copied().map(i64::from)))
    })
}

/// Sets states.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2SetBoolean(
    mut component: types::Component,
    vr: Array<ValueReference>,
    nvr: usize,
    value: Array<Boolean>,
) -> Status {
    enter(&mut component, &calls::SET_BOOLEAN, |component| {
        let references = vr.items(nvr).ok_or(Error::Null { argument: "vr" })?;
        let values = value.items(nvr).ok_or(Error::Null { argument: "value" })?;
        component.instance.set_booleans(references.iter().copied().zip(values.iter().map(|value| *value != 0)))
    })
}

/// Refuses: no String variable can be set.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2SetString(
    mut component: types::Component,
    vr: Array<ValueReference>,
    nvr: usize,
    _value: Array<Text>,
) -> Status {
    enter(&mut component, &calls::SET_STRING, |component| refuse(component, vr, nvr, "String"))
}

/// Setting nothing is fine, anything else refused.
fn refuse(component: &Session, vr: Array<ValueReference>, nvr: usize, asked: &'static str) -> Result<(), Error> {
    match vr.items(nvr).ok_or(Error::Null { argument: "vr" })?.first() {
        Some(reference) => Err(component.instance.refuse_to_set(*reference, asked)),
        None => Ok(()),
    }
}
