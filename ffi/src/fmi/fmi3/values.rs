//! Getting and setting variables.

use core::ffi::c_char;

use super::calls;
use super::types::{self, Boolean, Flag, Float64, Int32, Int64, UInt64, ValueReference};
use crate::fmi::foreign::{Array, Room};
use crate::fmi::session::{Session, enter};
use crate::fmi::status::Status;
use crate::instance::{Error, Function};

/// Value references and the number of values that belong to them.
struct Named {
    references: Array<ValueReference>,
    n_references: usize,
    n_values: usize,
}

impl Named {
    /// The references, if the variables have as many values together as the call says.
    fn check(&self, session: &Session) -> Result<&[ValueReference], Error> {
        let references = self.references.items(self.n_references).ok_or(Error::Null { argument: "valueReferences" })?;
        let mut needed = 0_usize;
        for reference in references {
            needed = needed.saturating_add(session.instance.length(*reference)?);
        }
        let given = self.n_values;
        if given == needed { Ok(references) } else { Err(Error::ValueCount { given, needed }) }
    }
}

/// Reads variables; writes all of their values, or none if one is refused. `read` hands each value of a variable on.
fn get<T: Copy>(
    instance: &mut types::Instance,
    function: &Function,
    named: &Named,
    mut values: Room<T>,
    read: impl Fn(&mut Session, ValueReference, &mut dyn FnMut(T)) -> Result<(), Error>,
) -> Status {
    enter(instance, function, |session| {
        let references = named.check(session)?;
        let values = values.items(named.n_values).ok_or(Error::Null { argument: "values" })?;
        // The first needs no trial: nothing is written before it has been read.
        for reference in references.iter().skip(1) {
            read(session, *reference, &mut |_| {})?;
        }
        let mut places = values.iter_mut();
        for reference in references {
            read(session, *reference, &mut |value| {
                if let Some(place) = places.next() {
                    place.write(value);
                }
            })?;
        }
        Ok(())
    })
}

/// Reads quantities and rows of them.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetFloat64(
    mut instance: types::Instance,
    value_references: Array<ValueReference>,
    n_value_references: usize,
    values: Room<Float64>,
    n_values: usize,
) -> Status {
    let named = Named { references: value_references, n_references: n_value_references, n_values };
    get(&mut instance, &calls::GET_FLOAT64, &named, values, |session, reference, put| {
        session.instance.reals(reference, put)
    })
}

/// Reads counts.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetInt32(
    mut instance: types::Instance,
    value_references: Array<ValueReference>,
    n_value_references: usize,
    values: Room<Int32>,
    n_values: usize,
) -> Status {
    let named = Named { references: value_references, n_references: n_value_references, n_values };
    get(&mut instance, &calls::GET_INT32, &named, values, |session, reference, put| {
        session.instance.integer(reference).map(put)
    })
}

/// Reads choices by their numbers.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetInt64(
    mut instance: types::Instance,
    value_references: Array<ValueReference>,
    n_value_references: usize,
    values: Room<Int64>,
    n_values: usize,
) -> Status {
    let named = Named { references: value_references, n_references: n_value_references, n_values };
    get(&mut instance, &calls::GET_INT64, &named, values, |session, reference, put| {
        session.instance.choice(reference).map(|choice| put(i64::from(choice)))
    })
}

/// Reads lengths of arrays.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetUInt64(
    mut instance: types::Instance,
    value_references: Array<ValueReference>,
    n_value_references: usize,
    values: Room<UInt64>,
    n_values: usize,
) -> Status {
    let named = Named { references: value_references, n_references: n_value_references, n_values };
    get(&mut instance, &calls::GET_UINT64, &named, values, |session, reference, put| {
        session.instance.size(reference).map(put)
    })
}

/// Reads states.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetBoolean(
    mut instance: types::Instance,
    value_references: Array<ValueReference>,
    n_value_references: usize,
    values: Room<Boolean>,
    n_values: usize,
) -> Status {
    let named = Named { references: value_references, n_references: n_value_references, n_values };
    get(&mut instance, &calls::GET_BOOLEAN, &named, values, |session, reference, put| {
        session.instance.boolean(reference).map(put)
    })
}

/// Reads texts, which stay valid until the next call on the instance.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetString(
    mut instance: types::Instance,
    value_references: Array<ValueReference>,
    n_value_references: usize,
    values: Room<*const c_char>,
    n_values: usize,
) -> Status {
    let named = Named { references: value_references, n_references: n_value_references, n_values };
    get(&mut instance, &calls::GET_STRING, &named, values, |session, reference, put| {
        let digits = session.instance.text(reference)?;
        put(session.keep_text(digits).as_ptr());
        Ok(())
    })
}

/// Sets variables, each of which has a single value; `set` gets all pairs of references and values.
fn set<T: Copy>(
    instance: &mut types::Instance,
    function: &Function,
    named: &Named,
    values: Array<T>,
    set: impl Fn(&mut Session, &[ValueReference], &[T]) -> Result<(), Error>,
) -> Status {
    enter(instance, function, |session| {
        let references = named.check(session)?;
        let values = values.items(named.n_values).ok_or(Error::Null { argument: "values" })?;
        set(session, references, values)
    })
}

/// Sets quantities.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3SetFloat64(
    mut instance: types::Instance,
    value_references: Array<ValueReference>,
    n_value_references: usize,
    values: Array<Float64>,
    n_values: usize,
) -> Status {
    let named = Named { references: value_references, n_references: n_value_references, n_values };
    set(&mut instance, &calls::SET_FLOAT64, &named, values, |session, references, values| {
        session.instance.set_reals(references.iter().copied().zip(values.iter().copied()))
    })
}

/// Sets counts.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3SetInt32(
    mut instance: types::Instance,
    value_references: Array<ValueReference>,
    n_value_references: usize,
    values: Array<Int32>,
    n_values: usize,
) -> Status {
    let named = Named { references: value_references, n_references: n_value_references, n_values };
    set(&mut instance, &calls::SET_INT32, &named, values, |session, references, values| {
        session.instance.set_counts(references.iter().copied().zip(values.iter().copied()))
    })
}

/// Sets choices by their numbers.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3SetInt64(
    mut instance: types::Instance,
    value_references: Array<ValueReference>,
    n_value_references: usize,
    values: Array<Int64>,
    n_values: usize,
) -> Status {
    let named = Named { references: value_references, n_references: n_value_references, n_values };
    set(&mut instance, &calls::SET_INT64, &named, values, |session, references, values| {
        session.instance.set_choices(references.iter().copied().zip(values.iter().copied()))
    })
}

/// Sets states.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3SetBoolean(
    mut instance: types::Instance,
    value_references: Array<ValueReference>,
    n_value_references: usize,
    values: Array<Flag>,
    n_values: usize,
) -> Status {
    let named = Named { references: value_references, n_references: n_value_references, n_values };
    set(&mut instance, &calls::SET_BOOLEAN, &named, values, |session, references, values| {
        let values = values.iter().map(|value| *value != 0);
        session.instance.set_booleans(references.iter().copied().zip(values))
    })
}

/// Sets lengths of arrays.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3SetUInt64(
    mut instance: types::Instance,
    value_references: Array<ValueReference>,
    n_value_references: usize,
    values: Array<UInt64>,
    n_values: usize,
) -> Status {
    let named = Named { references: value_references, n_references: n_value_references, n_values };
    set(&mut instance, &calls::SET_UINT64, &named, values, |session, references, values| {
        session.instance.set_sizes(references.iter().copied().zip(values.iter().copied()))
    })
}
