//! Saving and restoring the whole state of an instance, and derivatives, which do not exist here.

use super::calls;
use super::component::enter;
use super::types::{self, FmuState, FmuStateSlot, Real, Status, ValueReference};
use crate::foreign::{Array, Room};
use crate::instance::Error;

const NO_SLOT: Error = Error::Null { argument: "FMUstate" };

/// Saves the state, into the handle that is given if it is not null.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetFMUstate(mut component: types::Component, mut fmu_state: FmuStateSlot) -> Status {
    enter(&mut component, &calls::GET_FMU_STATE, |component| {
        let handle = fmu_state.get().ok_or(NO_SLOT)?;
        handle.put(component.instance.save()?);
        Ok(())
    })
}

/// Goes back to a saved state.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2SetFMUstate(mut component: types::Component, mut fmu_state: FmuState) -> Status {
    enter(&mut component, &calls::SET_FMU_STATE, |component| {
        component.instance.restore(fmu_state.get().ok_or(NO_SLOT)?)
    })
}

/// Frees a saved state; null is fine.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2FreeFMUstate(mut component: types::Component, mut fmu_state: FmuStateSlot) -> Status {
    enter(&mut component, &calls::FREE_FMU_STATE, |_| {
        if let Some(handle) = fmu_state.get() {
            handle.free();
        }
        Ok(())
    })
}

/// Bytes of a saved state.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2SerializedFMUstateSize(
    mut component: types::Component,
    mut fmu_state: FmuState,
    mut size: Room<usize>,
) -> Status {
    enter(&mut component, &calls::SERIALIZED_FMU_STATE_SIZE, |_| {
        let state = fmu_state.get().ok_or(NO_SLOT)?;
        size.item().ok_or(Error::Null { argument: "size" })?.write(state.bytes().len());
        Ok(())
    })
}

/// Writes a saved state as bytes.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2SerializeFMUstate(
    mut component: types::Component,
    mut fmu_state: FmuState,
    mut serialized_state: Room<u8>,
    size: usize,
) -> Status {
    enter(&mut component, &calls::SERIALIZE_FMU_STATE, |_| {
        let bytes = fmu_state.get().ok_or(NO_SLOT)?.bytes();
        if size != bytes.len() {
            return Err(Error::StateSize { given: size, needed: bytes.len() });
        }
        let room = serialized_state.items(size).ok_or(Error::Null { argument: "serializedState" })?;
        for (to, from) in room.iter_mut().zip(bytes) {
            to.write(*from);
        }
        Ok(())
    })
}

/// Reads back a saved state, into the handle that is given if it is not null.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2DeSerializeFMUstate(
    mut component: types::Component,
    serialized_state: Array<u8>,
    size: usize,
    mut fmu_state: FmuStateSlot,
) -> Status {
    enter(&mut component, &calls::DESERIALIZE_FMU_STATE, |component| {
        let bytes = serialized_state.items(size).ok_or(Error::Null { argument: "serializedState" })?;
        let handle = fmu_state.get().ok_or(NO_SLOT)?;
        handle.put(component.instance.read_state(bytes)?);
        Ok(())
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
