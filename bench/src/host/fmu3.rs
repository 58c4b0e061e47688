//! The library of an FMU 3.0, loaded and driven as an importer does.

use std::ffi::{CStr, c_char, c_int, c_void};
use std::ptr::{null, null_mut};

use softanvil::variables::references;
use softanvil_kernel::Scenario;

use super::Host;
use super::library::{FOREIGN, Loaded, RECORDED, expect};

type Instance = *mut c_void;
type Instantiate = unsafe extern "C" fn(
    *const c_char,
    *const c_char,
    *const c_char,
    bool,
    bool,
    bool,
    bool,
    *const u32,
    usize,
    *mut c_void,
    *const c_void,
    *const c_void,
) -> Instance;
type Enter = unsafe extern "C" fn(Instance, bool, f64, f64, bool, f64) -> c_int;
type Plain = unsafe extern "C" fn(Instance) -> c_int;
type SetFloat64 = unsafe extern "C" fn(Instance, *const u32, usize, *const f64, usize) -> c_int;
type GetFloat64 = unsafe extern "C" fn(Instance, *const u32, usize, *mut f64, usize) -> c_int;
type GetString = unsafe extern "C" fn(Instance, *const u32, usize, *mut *const c_char, usize) -> c_int;
type DoStep = unsafe extern "C" fn(Instance, f64, f64, bool, *mut bool, *mut bool, *mut bool, *mut f64) -> c_int;

/// An instance of the FMU.
pub struct Fmu3 {
    instance: Instance,
    reset: Plain,
    enter: Enter,
    exit: Plain,
    free: unsafe extern "C" fn(Instance),
    set_float64: SetFloat64,
    get_float64: GetFloat64,
    get_string: GetString,
    do_step: DoStep,
    made: u64,
    /// Whether the outputs that a master records are read after every communication step.
    pub reads_outputs: bool,
    loaded: Loaded,
}

impl Fmu3 {
    /// An instance of the study's drop on a mesh of the element size of `scenario`; none without the library.
    ///
    /// # Panics
    /// If the library is not one of an FMU, or refuses.
    pub fn load(scenario: &Scenario) -> Option<Self> {
        let loaded = Loaded::new(scenario)?;
        // SAFETY: the types are those of the standard; no events, no early return, no intermediate update, no log.
        let mut fmu = unsafe {
            let instantiate: Instantiate = loaded.function("fmi3InstantiateCoSimulation");
            let (name, token) = (c"bench".as_ptr(), loaded.token.as_ptr());
            let instance =
                instantiate(name, token, null(), false, false, false, false, null(), 0, null_mut(), null(), null());
            assert!(!instance.is_null(), "{FOREIGN}");
            Self {
                instance,
                reset: loaded.function("fmi3Reset"),
                enter: loaded.function("fmi3EnterInitializationMode"),
                exit: loaded.function("fmi3ExitInitializationMode"),
                free: loaded.function("fmi3FreeInstance"),
                set_float64: loaded.function("fmi3SetFloat64"),
                get_float64: loaded.function("fmi3GetFloat64"),
                get_string: loaded.function("fmi3GetString"),
                do_step: loaded.function("fmi3DoStep"),
                made: 0,
                reads_outputs: false,
                loaded,
            }
        };
        fmu.initialise();
        Some(fmu)
    }

    fn initialise(&mut self) {
        let (reference, value) = self.loaded.element_size;
        // SAFETY: the instance lives until this object is dropped.
        unsafe {
            expect((self.set_float64)(self.instance, &reference, 1, &value, 1));
            expect((self.enter)(self.instance, false, 0.0, 0.0, false, 0.0));
            expect((self.exit)(self.instance));
        }
        self.made = 0;
    }
}

impl Host for Fmu3 {
    fn restart(&mut self) {
        // SAFETY: as in `initialise`.
        expect(unsafe { (self.reset)(self.instance) });
        self.initialise();
    }

    fn advance(&mut self, calls: u64, steps: u64) {
        let mut values = [0.0; RECORDED.len()];
        let (mut event, mut end, mut early, mut reached) = (false, false, false, 0.0);
        for _ in 0..calls {
            let (point, step) = (self.made as f64 * self.loaded.dt, steps as f64 * self.loaded.dt);
            // SAFETY: as in `initialise`; the arrays have the lengths that are told.
            unsafe {
                let done =
                    (self.do_step)(self.instance, point, step, true, &mut event, &mut end, &mut early, &mut reached);
                expect(done);
                if self.reads_outputs {
                    let (outputs, n) = (self.loaded.outputs.as_ptr(), RECORDED.len());
                    expect((self.get_float64)(self.instance, outputs, n, values.as_mut_ptr(), n));
                }
            }
            self.made += steps;
        }
        std::hint::black_box((values, event, end, early, reached));
    }

    fn steps_of_drop(&self) -> u64 {
        self.loaded.steps_of_drop
    }

    fn trace_hash(&mut self) -> u64 {
        let mut text = null();
        // SAFETY: as in `initialise`; the text lives until the next call.
        let digits = unsafe {
            expect((self.get_string)(self.instance, &references::TRACE_HASH, 1, &mut text, 1));
            CStr::from_ptr(text)
        };
        u64::from_str_radix(&digits.to_string_lossy(), 16).expect("a hexadecimal number")
    }
}

impl Drop for Fmu3 {
    fn drop(&mut self) {
        // SAFETY: nobody uses it any more.
        unsafe { (self.free)(self.instance) };
    }
}
