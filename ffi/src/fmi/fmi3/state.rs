//! Saved states.

use super::calls;
use super::types::{self, FmuState, FmuStateSlot};
use crate::fmi::foreign::{Array, Room};
use crate::fmi::session::{deserialize, enter, free_state, restore, save, serialize, serialized_size};
use crate::fmi::status::Status;

/// Saves the state, into the handle that is given if it is not null.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetFMUState(mut instance: types::Instance, fmu_state: FmuStateSlot) -> Status {
    enter(&mut instance, &calls::GET_FMU_STATE, |session| save(session, fmu_state))
}

/// Goes back to a saved state.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3SetFMUState(mut instance: types::Instance, fmu_state: FmuState) -> Status {
    enter(&mut instance, &calls::SET_FMU_STATE, |session| restore(session, fmu_state))
}

/// Frees a saved state; null is fine.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3FreeFMUState(mut instance: types::Instance, fmu_state: FmuStateSlot) -> Status {
    enter(&mut instance, &calls::FREE_FMU_STATE, |_| {
        free_state(fmu_state);
        Ok(())
    })
}

/// Bytes of a saved state.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3SerializedFMUStateSize(
    mut instance: types::Instance,
    fmu_state: FmuState,
    size: Room<usize>,
) -> Status {
    enter(&mut instance, &calls::SERIALIZED_FMU_STATE_SIZE, |_| serialized_size(fmu_state, size))
}

/// Writes a saved state as bytes.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3SerializeFMUState(
    mut instance: types::Instance,
    fmu_state: FmuState,
    serialized_state: Room<u8>,
    size: usize,
) -> Status {
    enter(&mut instance, &calls::SERIALIZE_FMU_STATE, |_| serialize(fmu_state, serialized_state, size))
}

/// Reads back a saved state, into the handle that is given if it is not null.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3DeserializeFMUState(
    mut instance: types::Instance,
    serialized_state: Array<u8>,
    size: usize,
    fmu_state: FmuStateSlot,
) -> Status {
    enter(&mut instance, &calls::DESERIALIZE_FMU_STATE, |session| {
        deserialize(session, serialized_state, size, fmu_state)
    })
}
