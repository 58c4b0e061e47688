//! The library of an FMU 2.0, loaded and driven as an importer does.

use std::ffi::{CStr, c_char, c_int, c_void};
use std::ptr::null_mut;

use softanvil::variables::references;
use softanvil_kernel::Scenario;

use super::Host;
use super::library::{FOREIGN, Loaded, RECORDED, expect};

type Component = *mut c_void;

/// `fmi2CallbackFunctions`; the library needs none of them.
#[repr(C)]
struct Callbacks {
    logger: *const c_void,
    allocate_memory: *const c_void,
    free_memory: *const c_void,
    step_finished: *const c_void,
    environment: *mut c_void,
}

// Handed to the library, which keeps what it needs.
static CALLBACKS: Callbacks = Callbacks {
    logger: std::ptr::null(),
    allocate_memory: std::ptr::null(),
    free_memory: std::ptr::null(),
    step_finished: std::ptr::null(),
    environment: null_mut(),
};

// SAFETY: constant, and all null.
unsafe impl Sync for Callbacks {}

type Instantiate = unsafe extern "C" fn(
    *const c_char,
    c_int,
    *const c_char,
    *const c_char,
    *const Callbacks,
    c_int,
    c_int,
) -> Component;
type Setup = unsafe extern "C" fn(Component, c_int, f64, f64, c_int, f64) -> c_int;
type Plain = unsafe extern "C" fn(Component) -> c_int;
type SetReal = unsafe extern "C" fn(Component, *const u32, usize, *const f64) -> c_int;
type GetReal = unsafe extern "C" fn(Component, *const u32, usize, *mut f64) -> c_int;
type GetString = unsafe extern "C" fn(Component, *const u32, usize, *mut *const c_char) -> c_int;
type DoStep = unsafe extern "C" fn(Component, f64, f64, c_int) -> c_int;

/// An instance of the FMU.
pub struct Fmu2 {
    component: Component,
    reset: Plain,
    setup: Setup,
    enter: Plain,
    exit: Plain,
    free: unsafe extern "C" fn(Component),
    set_real: SetReal,
    get_real: GetReal,
    get_string: GetString,
    do_step: DoStep,
    made: u64,
    /// Whether the outputs that a master records are read after every communication step.
    pub reads_outputs: bool,
    loaded: Loaded,
}

impl Fmu2 {
    /// An instance of the study's drop on a mesh of the element size of `scenario`; none without the library.
    ///
    /// # Panics
    /// If the library is not one of an FMU, or refuses.
    pub fn load(scenario: &Scenario) -> Option<Self> {
        let loaded = Loaded::new(scenario)?;
        // SAFETY: the types are those of the standard.
        let mut fmu = unsafe {
            let instantiate: Instantiate = loaded.function("fmi2Instantiate");
            let (name, place) = (c"bench".as_ptr(), c"file:///".as_ptr());
            let component = instantiate(name, 1, loaded.token.as_ptr(), place, &CALLBACKS, 0, 0);
            assert!(!component.is_null(), "{FOREIGN}");
            Self {
                component,
                reset: loaded.function("fmi2Reset"),
                setup: loaded.function("fmi2SetupExperiment"),
                enter: loaded.function("fmi2EnterInitializationMode"),
                exit: loaded.function("fmi2ExitInitializationMode"),
                free: loaded.function("fmi2FreeInstance"),
                set_real: loaded.function("fmi2SetReal"),
                get_real: loaded.function("fmi2GetReal"),
                get_string: loaded.function("fmi2GetString"),
                do_step: loaded.function("fmi2DoStep"),
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
        // SAFETY: the component lives until this object is dropped.
        unsafe {
            expect((self.set_real)(self.component, &reference, 1, &value));
            expect((self.setup)(self.component, 0, 0.0, 0.0, 0, 0.0));
            expect((self.enter)(self.component));
            expect((self.exit)(self.component));
        }
        self.made = 0;
    }
}

impl Host for Fmu2 {
    fn restart(&mut self) {
        // SAFETY: as in `initialise`.
        expect(unsafe { (self.reset)(self.component) });
        self.initialise();
    }

    fn advance(&mut self, calls: u64, steps: u64) {
        let mut values = [0.0; RECORDED.len()];
        for _ in 0..calls {
            let (point, step) = (self.made as f64 * self.loaded.dt, steps as f64 * self.loaded.dt);
            // SAFETY: as in `initialise`; the arrays have the lengths that are told.
            unsafe {
                expect((self.do_step)(self.component, point, step, 1));
                if self.reads_outputs {
                    let (outputs, n) = (self.loaded.outputs.as_ptr(), RECORDED.len());
                    expect((self.get_real)(self.component, outputs, n, values.as_mut_ptr()));
                }
            }
            self.made += steps;
        }
        std::hint::black_box(values);
    }

    fn steps_of_drop(&self) -> u64 {
        self.loaded.steps_of_drop
    }

    fn trace_hash(&mut self) -> u64 {
        let mut text = std::ptr::null();
        // SAFETY: as in `initialise`; the text lives until the next call.
        let digits = unsafe {
            expect((self.get_string)(self.component, &references::TRACE_HASH, 1, &mut text));
            CStr::from_ptr(text)
        };
        u64::from_str_radix(&digits.to_string_lossy(), 16).expect("a hexadecimal number")
    }
}

impl Drop for Fmu2 {
    fn drop(&mut self) {
        // SAFETY: nobody uses it any more.
        unsafe { (self.free)(self.component) };
    }
}
