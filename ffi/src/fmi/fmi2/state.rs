//! Saving and restoring the whole state of an instance, and derivatives, which do not exist here.

use super::calls;
use super::types::{self, Byte, FmuState, FmuStateSlot, Real, ValueReference};
use crate::fmi::foreign::{Array, Room};
use crate::fmi::session::{deserialize, enter, free_state, restore, save, serialize, serialized_size};
use crate::fmi::status::Status;
use crate::instance::Error;

/// Saves the state, into the handle that is given if it is not null.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetFMUstate(mut component: types::Component, fmu_state: FmuStateSlot) -> Status {
    enter(&mut component, &calls::GET_FMU_STATE, |session| save(session, fmu_state))
}

/// Goes back to a saved state.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2SetFMUstate(mut component: types::Component, fmu_state: FmuState) -> Status {
    enter(&mut component, &calls::SET_FMU_STATE, |session| restore(session, fmu_state))
}

/// Frees a saved state; null is fine.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2FreeFMUstate(mut component: types::Component, fmu_state: FmuStateSlot) -> Status {
    enter(&mut component, &calls::FREE_FMU_STATE, |_| {
        free_state(fmu_state);
        Ok(())
    })
}

/// Bytes of a saved state.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2SerializedFMUstateSize(
    mut component: types::Component,
    fmu_state: FmuState,
    size: Room<usize>,
) -> Status {
    enter(&mut component, &calls::SERIALIZED_FMU_STATE_SIZE, |_| serialized_size(fmu_state, size))
}

/// Writes a saved state as bytes.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2SerializeFMUstate(
    mut component: types::Component,
    fmu_state: FmuState,
    serialized_state: Room<Byte>,
    size: usize,
) -> Status {
    enter(&mut component, &calls::SERIALIZE_FMU_STATE, |_| serialize(fmu_state, serialized_state, size))
}

/// Reads back a saved state, into the handle that is given if it is not null.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2DeSerializeFMUstate(
    mut component: types::Component,
    serialized_state: Array<Byte>,
    size: usize,
    fmu_state: FmuStateSlot,
) -> Status {
    enter(&mut component, &calls::DESERIALIZE_FMU_STATE, |session| {
        deserialize(session, serialized_state, size, fmu_state)
    })
}

/// Refuses: providesDirectionalDerivative is false.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetDirectionalDerivative(
    mut component: types::Component,
    _unknown: Array<ValueReference>,
    _n_unknown: usize,
    _known: Array<ValueReference>,
    _n_known: usize,
    _dv_known: Array<Real>,
    _dv_unknown: Room<Real>,
) -> Status {
    enter(&mut component, &calls::GET_DIRECTIONAL_DERIVATIVE, |_| {
        Err(Error::Unsupported { what: "the directional derivative" })
    })
}
