//! The functions of FMI 3.0 as C declares them.

use std::ffi::{CStr, c_char, c_int};
use std::ptr::{null, null_mut};

use softanvil::variables::token;

use super::super::Input;
use super::{Pointer, Standard};

/// `fmi3LogMessageCallback`.
type Logger = unsafe extern "C" fn(Pointer, c_int, *const c_char, *const c_char);
/// `fmi3IntermediateUpdateCallback`.
type Update = unsafe extern "C" fn(Pointer, f64, bool, bool, bool, bool, *mut bool, *mut f64);

unsafe extern "C" {
    fn fmi3InstantiateCoSimulation(
        name: *const c_char,
        token: *const c_char,
        resources: *const c_char,
        visible: bool,
        logging: bool,
        events: bool,
        early_return: bool,
        required: *const u32,
        n_required: usize,
        environment: Pointer,
        logger: Option<Logger>,
        update: Option<Update>,
    ) -> Pointer;
    fn fmi3FreeInstance(instance: Pointer);
    fn fmi3EnterInitializationMode(
        i: Pointer,
        has_tolerance: bool,
        tolerance: f64,
        start: f64,
        has_stop: bool,
        stop: f64,
    ) -> c_int;
    fn fmi3ExitInitializationMode(instance: Pointer) -> c_int;
    fn fmi3EnterEventMode(instance: Pointer) -> c_int;
    fn fmi3EnterStepMode(instance: Pointer) -> c_int;
    fn fmi3EnterConfigurationMode(instance: Pointer) -> c_int;
    fn fmi3ExitConfigurationMode(instance: Pointer) -> c_int;
    fn fmi3SetFloat64(i: Pointer, references: *const u32, n: usize, values: *const f64, n_values: usize) -> c_int;
    fn fmi3SetInt64(i: Pointer, references: *const u32, n: usize, values: *const i64, n_values: usize) -> c_int;
    fn fmi3SetBoolean(i: Pointer, references: *const u32, n: usize, values: *const bool, n_values: usize) -> c_int;
    fn fmi3SetUInt64(i: Pointer, references: *const u32, n: usize, values: *const u64, n_values: usize) -> c_int;
    fn fmi3GetFloat64(i: Pointer, references: *const u32, n: usize, values: *mut f64, n_values: usize) -> c_int;
    fn fmi3GetInt64(i: Pointer, references: *const u32, n: usize, values: *mut i64, n_values: usize) -> c_int;
    fn fmi3GetBoolean(i: Pointer, references: *const u32, n: usize, values: *mut bool, n_values: usize) -> c_int;
    fn fmi3GetString(
        i: Pointer,
        references: *const u32,
        n: usize,
        values: *mut *const c_char,
        n_values: usize,
    ) -> c_int;
    fn fmi3DoStep(
        instance: Pointer,
        point: f64,
        size: f64,
        no_set: bool,
        event: *mut bool,
        terminate: *mut bool,
        early_return: *mut bool,
        last_time: *mut f64,
    ) -> c_int;
    fn fmi3GetFMUState(instance: Pointer, state: *mut Pointer) -> c_int;
    fn fmi3SetFMUState(instance: Pointer, state: Pointer) -> c_int;
    fn fmi3FreeFMUState(instance: Pointer, state: *mut Pointer) -> c_int;
    fn fmi3SerializedFMUStateSize(instance: Pointer, state: Pointer, size: *mut usize) -> c_int;
    fn fmi3SerializeFMUState(instance: Pointer, state: Pointer, bytes: *mut u8, size: usize) -> c_int;
    fn fmi3DeserializeFMUState(instance: Pointer, bytes: *const u8, size: usize, state: *mut Pointer) -> c_int;
    fn fmi3Terminate(instance: Pointer) -> c_int;
    fn fmi3Reset(instance: Pointer) -> c_int;
}

/// A message is text.
unsafe extern "C" fn log(_: Pointer, status: c_int, category: *const c_char, message: *const c_char) {
    // SAFETY: the library ends its texts with a zero.
    let [category, message] = [category, message].map(|text| unsafe { CStr::from_ptr(text) }.to_str().unwrap());
    assert!((0..4).contains(&status) && !category.is_empty() && !message.is_empty());
}

/// Asks for an early return at once.
unsafe extern "C" fn update(
    _: Pointer,
    time: f64,
    _: bool,
    _: bool,
    _: bool,
    can: bool,
    asked: *mut bool,
    at: *mut f64,
) {
    // SAFETY: the library gives room for both.
    unsafe { (*asked, *at) = (can, time) }
}

/// An instance.
pub struct Fmi3(Pointer);

// SAFETY of all blocks: the instance lives, states are null or of this library, arrays have the lengths that are told.
impl Standard for Fmi3 {
    fn instantiate(options: u8) -> Self {
        let [logging, events, early_return, updates] = [0x10, 0x20, 0x40, 0x80].map(|bit| options & bit != 0);
        let token = format!("{}\0", token());
        let update = updates.then_some(update as Update);
        // SAFETY: as above.
        let instance = unsafe {
            let (name, token) = (c"fuzz".as_ptr(), token.as_ptr().cast());
            fmi3InstantiateCoSimulation(
                name,
                token,
                null(),
                false,
                logging,
                events,
                early_return,
                null(),
                0,
                null_mut(),
                Some(log),
                update,
            )
        };
        assert!(!instance.is_null());
        Self(instance)
    }

    fn initialize(&self, start: f64, stop: f64) -> i32 {
        // SAFETY: as above.
        unsafe { fmi3EnterInitializationMode(self.0, false, 0.0, start, true, stop) }
    }

    fn exit_initialization(&self) -> i32 {
        // SAFETY: as above.
        unsafe { fmi3ExitInitializationMode(self.0) }
    }

    fn set_real(&self, reference: u32, value: f64) -> i32 {
        // SAFETY: as above.
        unsafe { fmi3SetFloat64(self.0, &reference, 1, &value, 1) }
    }

    fn set_choice(&self, reference: u32, value: i32) -> i32 {
        // SAFETY: as above.
        unsafe { fmi3SetInt64(self.0, &reference, 1, &i64::from(value), 1) }
    }

    fn set_boolean(&self, reference: u32, value: bool) -> i32 {
        // SAFETY: as above.
        unsafe { fmi3SetBoolean(self.0, &reference, 1, &value, 1) }
    }

    fn reals(&self, references: &[u32], values: &mut [f64]) -> i32 {
        // SAFETY: as above.
        unsafe { fmi3GetFloat64(self.0, references.as_ptr(), references.len(), values.as_mut_ptr(), values.len()) }
    }

    fn do_step(&self, point: f64, size: f64) -> i32 {
        let (mut flags, mut last) = ([false; 3], f64::NAN);
        let [event, terminate, early] = &mut flags;
        // SAFETY: as above.
        let status = unsafe { fmi3DoStep(self.0, point, size, true, event, terminate, early, &mut last) };
        assert!(status != super::OK || (last.is_finite() && !flags[1]), "{status} {last}");
        if status == super::OK && flags[0] {
            // SAFETY: as above.
            unsafe { fmi3EnterEventMode(self.0) };
        }
        status
    }

    fn save(&self, state: &mut Pointer) -> i32 {
        // SAFETY: as above.
        unsafe { fmi3GetFMUState(self.0, state) }
    }

    fn restore(&self, state: Pointer) -> i32 {
        // SAFETY: as above.
        unsafe { fmi3SetFMUState(self.0, state) }
    }

    fn free_state(&self, state: &mut Pointer) -> i32 {
        // SAFETY: as above.
        unsafe { fmi3FreeFMUState(self.0, state) }
    }

    fn serialize(&self, state: Pointer, bytes: &mut Vec<u8>) -> i32 {
        let mut size = 0;
        // SAFETY: as above.
        unsafe {
            let status = fmi3SerializedFMUStateSize(self.0, state, &mut size);
            if status != super::OK {
                return status;
            }
            bytes.resize(size, 0);
            fmi3SerializeFMUState(self.0, state, bytes.as_mut_ptr(), size)
        }
    }

    fn deserialize(&self, bytes: &[u8], state: &mut Pointer) -> i32 {
        // SAFETY: as above.
        unsafe { fmi3DeserializeFMUState(self.0, bytes.as_ptr(), bytes.len(), state) }
    }

    fn terminate(&self) -> i32 {
        // SAFETY: as above.
        unsafe { fmi3Terminate(self.0) }
    }

    fn reset(&self) -> i32 {
        // SAFETY: as above.
        unsafe { fmi3Reset(self.0) }
    }

    fn other(&self, input: &mut Input) -> i32 {
        let (reference, mut real, mut integer, mut flag, mut text) = (u32::from(input.word()), 0.0, 0, false, null());
        // SAFETY: as above.
        unsafe {
            match input.byte() % 10 {
                0 => fmi3GetFloat64(self.0, &reference, 1, &mut real, 1),
                1 => fmi3GetInt64(self.0, &reference, 1, &mut integer, 1),
                2 => fmi3GetBoolean(self.0, &reference, 1, &mut flag, 1),
                3 => fmi3GetString(self.0, &reference, 1, &mut text, 1),
                4 => fmi3SetUInt64(self.0, &reference, 1, &u64::from(input.word()), 1),
                5 => fmi3GetFloat64(self.0, null(), 3, null_mut(), 3),
                6 => fmi3EnterEventMode(self.0),
                7 => fmi3EnterStepMode(self.0),
                8 => fmi3EnterConfigurationMode(self.0),
                _ => fmi3ExitConfigurationMode(self.0),
            }
        }
    }
}

impl Drop for Fmi3 {
    fn drop(&mut self) {
        // SAFETY: nobody uses the instance any more.
        unsafe { fmi3FreeInstance(self.0) }
    }
}
