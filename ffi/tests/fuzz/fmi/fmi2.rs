//! The functions of FMI 2.0 as C declares them.

use std::ffi::{c_char, c_int};
use std::ptr::{null, null_mut};

use softanvil::variables::token;

use super::super::Input;
use super::{Pointer, Standard};

/// `fmi2CallbackFunctions`, none of which is there.
#[repr(C)]
struct Callbacks([*const c_char; 5]);

unsafe extern "C" {
    fn fmi2Instantiate(
        name: *const c_char,
        kind: c_int,
        guid: *const c_char,
        resources: *const c_char,
        callbacks: *const Callbacks,
        visible: c_int,
        logging: c_int,
    ) -> Pointer;
    fn fmi2FreeInstance(instance: Pointer);
    fn fmi2SetupExperiment(
        i: Pointer,
        has_tolerance: c_int,
        tolerance: f64,
        start: f64,
        has_stop: c_int,
        stop: f64,
    ) -> c_int;
    fn fmi2EnterInitializationMode(instance: Pointer) -> c_int;
    fn fmi2ExitInitializationMode(instance: Pointer) -> c_int;
    fn fmi2SetReal(instance: Pointer, references: *const u32, n: usize, values: *const f64) -> c_int;
    fn fmi2SetInteger(instance: Pointer, references: *const u32, n: usize, values: *const c_int) -> c_int;
    fn fmi2SetBoolean(instance: Pointer, references: *const u32, n: usize, values: *const c_int) -> c_int;
    fn fmi2GetReal(instance: Pointer, references: *const u32, n: usize, values: *mut f64) -> c_int;
    fn fmi2GetInteger(instance: Pointer, references: *const u32, n: usize, values: *mut c_int) -> c_int;
    fn fmi2GetBoolean(instance: Pointer, references: *const u32, n: usize, values: *mut c_int) -> c_int;
    fn fmi2GetString(instance: Pointer, references: *const u32, n: usize, values: *mut *const c_char) -> c_int;
    fn fmi2DoStep(instance: Pointer, point: f64, size: f64, no_set: c_int) -> c_int;
    fn fmi2CancelStep(instance: Pointer) -> c_int;
    fn fmi2GetRealStatus(instance: Pointer, kind: c_int, value: *mut f64) -> c_int;
    fn fmi2GetFMUstate(instance: Pointer, state: *mut Pointer) -> c_int;
    fn fmi2SetFMUstate(instance: Pointer, state: Pointer) -> c_int;
    fn fmi2FreeFMUstate(instance: Pointer, state: *mut Pointer) -> c_int;
    fn fmi2SerializedFMUstateSize(instance: Pointer, state: Pointer, size: *mut usize) -> c_int;
    fn fmi2SerializeFMUstate(instance: Pointer, state: Pointer, bytes: *mut u8, size: usize) -> c_int;
    fn fmi2DeSerializeFMUstate(instance: Pointer, bytes: *const u8, size: usize, state: *mut Pointer) -> c_int;
    fn fmi2Terminate(instance: Pointer) -> c_int;
    fn fmi2Reset(instance: Pointer) -> c_int;
}

/// An instance.
pub struct Fmi2(Pointer);

// SAFETY of all blocks: the instance lives, states are null or of this library, arrays have the lengths that are told.
impl Standard for Fmi2 {
    fn instantiate(_: u8) -> Self {
        let guid = format!("{}\0", token());
        let callbacks = Callbacks([null(); 5]);
        // SAFETY: as above.
        let instance = unsafe { fmi2Instantiate(c"fuzz".as_ptr(), 1, guid.as_ptr().cast(), null(), &callbacks, 0, 0) };
        assert!(!instance.is_null());
        Self(instance)
    }

    fn initialize(&self, start: f64, stop: f64) -> i32 {
        // SAFETY: as above.
        unsafe {
            let status = fmi2SetupExperiment(self.0, 0, 0.0, start, 1, stop);
            if status == super::OK { fmi2EnterInitializationMode(self.0) } else { status }
        }
    }

    fn exit_initialization(&self) -> i32 {
        // SAFETY: as above.
        unsafe { fmi2ExitInitializationMode(self.0) }
    }

    fn set_real(&self, reference: u32, value: f64) -> i32 {
        // SAFETY: as above.
        unsafe { fmi2SetReal(self.0, &reference, 1, &value) }
    }

    fn set_choice(&self, reference: u32, value: i32) -> i32 {
        // SAFETY: as above.
        unsafe { fmi2SetInteger(self.0, &reference, 1, &value) }
    }

    fn set_boolean(&self, reference: u32, value: bool) -> i32 {
        // SAFETY: as above.
        unsafe { fmi2SetBoolean(self.0, &reference, 1, &c_int::from(value)) }
    }

    fn reals(&self, references: &[u32], values: &mut [f64]) -> i32 {
        // SAFETY: as above.
        unsafe { fmi2GetReal(self.0, references.as_ptr(), references.len(), values.as_mut_ptr()) }
    }

    fn do_step(&self, point: f64, size: f64) -> i32 {
        // SAFETY: as above.
        unsafe { fmi2DoStep(self.0, point, size, 1) }
    }

    fn save(&self, state: &mut Pointer) -> i32 {
        // SAFETY: as above.
        unsafe { fmi2GetFMUstate(self.0, state) }
    }

    fn restore(&self, state: Pointer) -> i32 {
        // SAFETY: as above.
        unsafe { fmi2SetFMUstate(self.0, state) }
    }

    fn free_state(&self, state: &mut Pointer) -> i32 {
        // SAFETY: as above.
        unsafe { fmi2FreeFMUstate(self.0, state) }
    }

    fn serialize(&self, state: Pointer, bytes: &mut Vec<u8>) -> i32 {
        let mut size = 0;
        // SAFETY: as above.
        unsafe {
            let status = fmi2SerializedFMUstateSize(self.0, state, &mut size);
            if status != super::OK {
                return status;
            }
            bytes.resize(size, 0);
            fmi2SerializeFMUstate(self.0, state, bytes.as_mut_ptr(), size)
        }
    }

    fn deserialize(&self, bytes: &[u8], state: &mut Pointer) -> i32 {
        // SAFETY: as above.
        unsafe { fmi2DeSerializeFMUstate(self.0, bytes.as_ptr(), bytes.len(), state) }
    }

    fn terminate(&self) -> i32 {
        // SAFETY: as above.
        unsafe { fmi2Terminate(self.0) }
    }

    fn reset(&self) -> i32 {
        // SAFETY: as above.
        unsafe { fmi2Reset(self.0) }
    }

    fn other(&self, input: &mut Input) -> i32 {
        let (reference, mut real, mut integer, mut text) = (u32::from(input.word()), 0.0, 0, null());
        // SAFETY: as above.
        unsafe {
            match input.byte() % 7 {
                0 => fmi2GetReal(self.0, &reference, 1, &mut real),
                1 => fmi2GetInteger(self.0, &reference, 1, &mut integer),
                2 => fmi2GetBoolean(self.0, &reference, 1, &mut integer),
                3 => fmi2GetString(self.0, &reference, 1, &mut text),
                4 => fmi2CancelStep(self.0),
                5 => fmi2GetReal(self.0, null(), 3, null_mut()),
                _ => fmi2GetRealStatus(self.0, c_int::from(input.byte()), &mut real),
            }
        }
    }
}

impl Drop for Fmi2 {
    fn drop(&mut self) {
        // SAFETY: nobody uses the instance any more.
        unsafe { fmi2FreeInstance(self.0) }
    }
}
