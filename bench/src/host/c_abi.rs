//! The functions of `softanvil.h`, called as C does: through their addresses, one opaque simulation in lent memory.

use std::ffi::c_void;
use std::hint::black_box;
use std::ptr::{null, null_mut};

use softanvil::c_api::error::SoftanvilError;
use softanvil::c_api::header::SoftanvilSimulation;
use softanvil::c_api::scenario::{SoftanvilScenario, softanvil_scenario_default, softanvil_scenario_set_by_name};
use softanvil::c_api::simulation::{
    SoftanvilInput, softanvil_init, softanvil_memory_size, softanvil_reset, softanvil_step, softanvil_trace_hash,
};
use softanvil::c_api::status::SoftanvilStatus;
use softanvil_kernel::{Scenario, Simulation};

use super::Host;
use crate::pages::Pages;

type Step =
    unsafe extern "C" fn(*mut SoftanvilSimulation, u64, *const SoftanvilInput, *mut SoftanvilError) -> SoftanvilStatus;

/// A simulation behind the C ABI.
pub struct CAbi {
    _memory: Pages<u8>,
    simulation: *mut SoftanvilSimulation,
    step: Step,
    steps_of_drop: u64,
}

impl CAbi {
    /// The study's drop on a mesh of the element size of `scenario`.
    ///
    /// # Panics
    /// If the library refuses it.
    pub fn new(scenario: &Scenario) -> Self {
        let kernel = Simulation::new(scenario).expect("a legal scenario");
        let steps_of_drop = kernel.constants().steps_in(scenario.time.duration);
        let (mut size, mut alignment, mut simulation) = (0, 0, null_mut());
        let mut given = std::mem::MaybeUninit::<SoftanvilScenario>::uninit();
        // SAFETY: every pointer is to a value of its type that outlives the call, and the scenario is filled first.
        let memory = unsafe {
            expect(softanvil_scenario_default(0, given.as_mut_ptr()));
            let name = c"mesh.element_size".as_ptr();
            expect(softanvil_scenario_set_by_name(given.as_mut_ptr(), name, scenario.mesh.element_size, null_mut()));
            expect(softanvil_memory_size(given.as_ptr(), &mut size, &mut alignment, null_mut()));
            let mut memory = Pages::new(0, size);
            let address = memory.items().as_mut_ptr().cast::<c_void>();
            expect(softanvil_init(address, size, given.as_ptr(), &mut simulation, null_mut()));
            memory
        };
        Self { _memory: memory, simulation, step: black_box(softanvil_step as Step), steps_of_drop }
    }
}

fn expect(status: SoftanvilStatus) {
    assert_eq!(status as i32, SoftanvilStatus::Ok as i32, "{status:?}");
}

impl Host for CAbi {
    fn restart(&mut self) {
        // SAFETY: the simulation lives in memory that this object owns.
        expect(unsafe { softanvil_reset(self.simulation) });
    }

    fn advance(&mut self, calls: u64, steps: u64) {
        for _ in 0..calls {
            // SAFETY: as above; input and error may be null.
            expect(unsafe { (self.step)(self.simulation, steps, null(), null_mut()) });
        }
    }

    fn steps_of_drop(&self) -> u64 {
        self.steps_of_drop
    }

    fn trace_hash(&mut self) -> u64 {
        let mut hash = 0;
        // SAFETY: as above.
        expect(unsafe { softanvil_trace_hash(self.simulation, &mut hash) });
        hash
    }
}
