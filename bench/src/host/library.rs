//! The library of an FMU: where it is, and what both versions of the standard need to drive it.

use std::ffi::{CString, c_int};
use std::path::{Path, PathBuf};

use libloading::Library;
use softanvil::variables::{Table, token};
use softanvil_kernel::{Scenario, Simulation};

/// What a master would record.
pub(super) const RECORDED: [&str; 4] = ["contact.force", "core.reaction", "impactor.position", "impactor.velocity"];

/// A loaded library, and what a master knows of a drop before it begins.
pub(super) struct Loaded {
    pub(super) library: Library,
    pub(super) token: CString,
    pub(super) element_size: (u32, f64),
    pub(super) outputs: [u32; RECORDED.len()],
    pub(super) dt: f64,
    pub(super) steps_of_drop: u64,
}

/// Where `softanvil fmu` leaves the library of this platform, unless `SOFTANVIL_LIBRARY` says otherwise.
pub fn path() -> PathBuf {
    let built = format!("../target/fmu/{}-unknown-linux-gnu/fmu/libsoftanvil.so", std::env::consts::ARCH);
    std::env::var_os("SOFTANVIL_LIBRARY")
        .map_or_else(|| Path::new(env!("CARGO_MANIFEST_DIR")).join(built), PathBuf::from)
}

impl Loaded {
    /// The library, for the study's drop on a mesh of the element size of `scenario`; none if it is not there.
    pub(super) fn new(scenario: &Scenario) -> Option<Self> {
        let path = path();
        if !path.is_file() {
            return None;
        }
        let kernel = Simulation::new(scenario).expect("a legal scenario");
        let table = Table::new();
        let reference = |name: &str| table.rows().iter().find(|row| row.name == name).expect(name).reference;
        Some(Self {
            // SAFETY: the library has no initialisers.
            library: unsafe { Library::new(&path) }.expect("a shared library"),
            token: CString::new(token().as_str()).expect("text without zeros"),
            element_size: (reference("mesh.element_size"), scenario.mesh.element_size),
            outputs: RECORDED.map(reference),
            dt: kernel.constants().dt,
            steps_of_drop: kernel.constants().steps_in(scenario.time.duration),
        })
    }

    /// The function `name`.
    ///
    /// # Safety
    /// `F` must be its type.
    pub(super) unsafe fn function<F: Copy>(&self, name: &str) -> F {
        // SAFETY: the caller's guarantee.
        *unsafe { self.library.get::<F>(name) }.unwrap_or_else(|error| panic!("{name}: {error}"))
    }
}

/// Stops at a call that the FMU refuses.
pub(super) fn expect(status: c_int) {
    assert_eq!(status, 0, "the FMU refused a call");
}

/// The message for a library of other sources.
pub(super) const FOREIGN: &str = "the library is not of these sources; build it anew by `softanvil fmu`";
