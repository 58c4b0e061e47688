//! The library of an FMU 2.0, loaded and driven as an importer does.

use std::ffi::{CStr, CString, c_char, c_int, c_void};
use std::path::{Path, PathBuf};
use std::ptr::null_mut;

use libloading::Library;
use softanvil::variables::{Table, references, token};
use softanvil_kernel::{Scenario, Simulation};

use super::Host;

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
pub struct Fmu {
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
    element_size: (u32, f64),
    outputs: Vec<u32>,
    dt: f64,
    steps_of_drop: u64,
    made: u64,
    /// Whether the outputs that a master records are read after every communication step.
    pub reads_outputs: bool,
    _library: Library,
}

/// What a master would record.
const RECORDED: [&str; 4] = ["contact.force", "core.reaction", "impactor.position", "impactor.velocity"];

impl Fmu {
    /// Where `softanvil fmu` leaves the library of this platform, unless `SOFTANVIL_LIBRARY` says otherwise.
    pub fn path() -> PathBuf {
        let built = "../target/fmu/x86_64-unknown-linux-gnu/fmu/libsoftanvil.so";
        std::env::var_os("SOFTANVIL_LIBRARY")
            .map_or_else(|| Path::new(env!("CARGO_MANIFEST_DIR")).join(built), PathBuf::from)
    }

    /// An instance of the study's drop on a mesh of the element size of `scenario`; none without the library.
    ///
    /// # Panics
    /// If the library is not one of an FMU, or refuses.
    pub fn load(scenario: &Scenario) -> Option<Self> {
        let path = Self::path();
        if !path.is_file() {
            return None;
        }
        let kernel = Simulation::new(scenario).expect("a legal scenario");
        let table = Table::new();
        let reference = |name: &str| table.rows().iter().find(|row| row.name == name).expect(name).reference;
        let guid = CString::new(token()).expect("text without zeros");
        // SAFETY: the types are those of the standard; the library has no initialisers.
        let mut fmu = unsafe {
            let library = Library::new(&path).expect("a shared library");
            let instantiate: Instantiate = function(&library, "fmi2Instantiate");
            let component = instantiate(c"bench".as_ptr(), 1, guid.as_ptr(), c"file:///".as_ptr(), &CALLBACKS, 0, 0);
            assert!(!component.is_null(), "{}: not of these sources; build it anew by `softanvil fmu`", path.display());
            Self {
                component,
                reset: function(&library, "fmi2Reset"),
                setup: function(&library, "fmi2SetupExperiment"),
                enter: function(&library, "fmi2EnterInitializationMode"),
                exit: function(&library, "fmi2ExitInitializationMode"),
                free: function(&library, "fmi2FreeInstance"),
                set_real: function(&library, "fmi2SetReal"),
                get_real: function(&library, "fmi2GetReal"),
                get_string: function(&library, "fmi2GetString"),
                do_step: function(&library, "fmi2DoStep"),
                element_size: (reference("mesh.element_size"), scenario.mesh.element_size),
                outputs: RECORDED.map(reference).to_vec(),
                dt: kernel.constants().dt,
                steps_of_drop: kernel.constants().steps_in(scenario.time.duration),
                made: 0,
                reads_outputs: false,
                _library: library,
            }
        };
        fmu.initialise();
        Some(fmu)
    }

    fn initialise(&mut self) {
        let (reference, value) = self.element_size;
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

/// # Safety
/// `F` must be the type of the function `name`.
unsafe fn function<F: Copy>(library: &Library, name: &str) -> F {
    // SAFETY: the caller's guarantee.
    *unsafe { library.get::<F>(name) }.unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn expect(status: c_int) {
    assert_eq!(status, 0, "the FMU refused a call");
}

impl Host for Fmu {
    fn restart(&mut self) {
        // SAFETY: as in `initialise`.
        expect(unsafe { (self.reset)(self.component) });
        self.initialise();
    }

    fn advance(&mut self, calls: u64, steps: u64) {
        let mut values = [0.0; RECORDED.len()];
        for _ in 0..calls {
            let (point, step) = (self.made as f64 * self.dt, steps as f64 * self.dt);
            // SAFETY: as in `initialise`; the arrays have the lengths that are told.
            unsafe {
                expect((self.do_step)(self.component, point, step, 1));
                if self.reads_outputs {
                    let (outputs, n) = (self.outputs.as_ptr(), self.outputs.len());
                    expect((self.get_real)(self.component, outputs, n, values.as_mut_ptr()));
                }
            }
            self.made += steps;
        }
        std::hint::black_box(values);
    }

    fn steps_of_drop(&self) -> u64 {
        self.steps_of_drop
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

impl Drop for Fmu {
    fn drop(&mut self) {
        // SAFETY: nobody uses it any more.
        unsafe { (self.free)(self.component) };
    }
}
