//! The study's drop with 14.7 J on a Cortex-M7 without an operating system or a heap: runs it, compares it with the golden
//! trace on the device, and says what it took. The template for a program of your own: see the README beside.

#![no_std]
#![no_main]

use cortex_m::Peripherals;
use cortex_m_rt::entry;
use semihosting::println;
use softanvil_firmware::{Counter, INSTRUCTIONS_PER_TICK, anvil, argument, end, flash, stack_high_water, static_ram};
use softanvil_golden::{Checker, Record, Scene, scenes::SAMPLES_PER_RECORD};
use softanvil_kernel::element::{CellConstants, CellHistory, HoopConstants};
use softanvil_kernel::number::real::Real;
use softanvil_kernel::state::{snapshot_size, state_digest};
use softanvil_kernel::tensor::deviator::Deviator;
use softanvil_kernel::{Scenario, Size, StepInput, preset, step};

#[entry]
fn main() -> ! {
    let same = run();
    println!("{}", if same { "the bits of the golden trace" } else { "DIFFERENT from the golden trace" });
    end(same)
}

fn run() -> bool {
    let scene = Scene::find("drop-14.7-J").unwrap();
    let scenario = (scene.scenario)();
    let size = Size::of(&scenario).unwrap();
    let (model, mut state) = anvil::build(&scenario);
    let whole = model.constants.steps_in(scenario.time.duration);
    let steps = argument().map_or(whole, |most| whole.min(most));
    let stride = SAMPLES_PER_RECORD * u64::from(model.constants.steps_per_sample);

    let mut golden = Checker::new(scene.trace);
    let mut same = true;
    let mut work = Work::new();
    let mut counter = Counter::new(Peripherals::take().unwrap().SYST);
    for _ in 0..steps {
        counter.ticks();
        step(&model, &mut state, &StepInput::default()).unwrap();
        work.add(counter.ticks());
        if state.scalars.step_index % stride == 0 && same {
            let record = Record {
                step: state.scalars.step_index,
                force: state.scalars.force.contact,
                position: state.scalars.impactor.position,
                state: state_digest(&model, &state),
            };
            golden.skip_to(record.step);
            if let Err(difference) = golden.check(&record) {
                println!("{difference}");
                same = false;
            }
        }
    }

    let metrics = &state.scalars.metrics;
    println!(
        "peak force {:.1} N, deformation {:.3} mm, {steps} steps",
        metrics.peak_force,
        1e3 * metrics.max_deformation
    );
    println!("state {:016x}, trace {:016x}", state_digest(&model, &state), state.scalars.sampler.trace_hash);
    println!("flash {} bytes, static RAM {} bytes", flash(), static_ram());
    println!("model {} bytes, state {} bytes", model_bytes(&size), state_bytes(&size));
    let grid = &model.constants.grid;
    let nodes = (grid.n_u + 1) * (grid.n_v + 1);
    println!(
        "{} triangles take {} bytes, {nodes} nodes {} bytes, a snapshot {} bytes",
        grid.n_elem(),
        model_bytes(&size) + state_bytes(&size) - node_bytes(&size),
        node_bytes(&size),
        snapshot_size(&model.constants)
    );
    println!("stack {} bytes at most", stack_high_water());
    work.print(steps);
    // What the features `pads` and `solid` are for.
    print_memory("a padded drop", preset::rugby_soft_anvil);
    print_memory("the golden solid", Scene::find("solid").unwrap().scenario);
    same
}

/// Apart, so that its scenario takes no stack beside the drop.
#[inline(never)]
fn print_memory(name: &str, scenario: fn() -> Scenario) {
    let size = Size::of(&scenario()).unwrap();
    println!("{name} takes {} bytes", model_bytes(&size) + state_bytes(&size));
}

fn node_bytes(size: &Size) -> usize {
    (size.model_nodes + size.state_nodes) * size_of::<Real>()
}

fn model_bytes(size: &Size) -> usize {
    size.model_nodes * size_of::<Real>()
        + size.model_cells * size_of::<CellConstants>()
        + size.model_hoops * size_of::<HoopConstants>()
}

fn state_bytes(size: &Size) -> usize {
    size.state_nodes * size_of::<Real>()
        + size.state_cells * size_of::<CellHistory>()
        + size.state_viscous * size_of::<Deviator>()
}

/// Ticks of the steps.
struct Work {
    least: u32,
    most: u32,
    sum: u64,
}

impl Work {
    fn new() -> Self {
        Self { least: u32::MAX, most: 0, sum: 0 }
    }

    fn add(&mut self, ticks: u32) {
        self.least = self.least.min(ticks);
        self.most = self.most.max(ticks);
        self.sum += u64::from(ticks);
    }

    fn print(&self, steps: u64) {
        let [least, most] = [self.least, self.most].map(|ticks| ticks * INSTRUCTIONS_PER_TICK);
        let mean = self.sum * u64::from(INSTRUCTIONS_PER_TICK) / steps;
        println!("instructions per step {mean}, from {least} to {most}");
    }
}
