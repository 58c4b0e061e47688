//! Many drops at once, and many small models one after another: `cargo bench -p softanvil-bench --bench scaling`.
//!
//! Every thread makes drops of a state of its own of one shared model. The states lie side by side in one piece of memory,
//! or each on pages of its own. Their sizes are whole cache lines, so that none is shared, but what a core fetches ahead of
//! need may be another's. What the cores allow at best is told by a loop on registers alone. One thread and all of them take turns. The
//! threads begin each slice of a drop together, a slice is as long as its slowest thread, and the fastest of all rounds
//! counts: other programs fall out.

use std::hint::{black_box, spin_loop};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use softanvil_bench::pages::Pages;
use softanvil_bench::registers::arithmetic;
use softanvil_bench::{results, scene};
use softanvil_kernel::element::{CellConstants, CellHistory, HoopConstants};
use softanvil_kernel::tensor::deviator::Deviator;
use softanvil_kernel::{
    InstructionSet, Model, ModelMemory, SAMPLING_INTERVAL, Scalars, Scenario, Size, State, StateMemory, StepInput,
    preset, step,
};

/// Rounds of each kind; in each, every thread makes one drop.
const ROUNDS: usize = 100;

/// Sums and products per chain in a slice: about as long as a slice of a drop.
const LENGTH: usize = 8000;

/// Samples' worth of steps that each small model makes in a round.
const SMALL_STEPS: usize = 64;

fn main() {
    let mut figures = Vec::new();
    threads(&mut figures);
    small_models(&mut figures);
    results::write("scaling", &figures);
}

fn threads(figures: &mut Vec<(String, f64)>) {
    let n = thread::available_parallelism().map_or(1, usize::from);
    with_model(&preset::study(), |model| {
        let mut memory = Memory::new(&model.constants.size, n);
        let mut own: Vec<Memory> = (0..n).map(|_| Memory::new(&model.constants.size, 1)).collect();
        let on_registers = || {
            black_box(arithmetic(InstructionSet::best(), LENGTH));
        };
        let [mut one, mut apart, mut together, mut alone, mut registers] = [const { Fastest(Vec::new()) }; 5];
        for _ in 0..ROUNDS {
            one.round(drops(model, own[..1].iter_mut().flat_map(Memory::states).collect()));
            apart.round(drops(model, own.iter_mut().flat_map(Memory::states).collect()));
            together.round(drops(model, memory.states()));
            alone.round(vec![on_registers]);
            registers.round(vec![on_registers; n]);
        }
        figures.push(("threads".into(), n as f64));
        figures.push(("efficiency, registers alone".into(), alone.total() / registers.total()));
        figures.push(("efficiency, own memory".into(), one.total() / apart.total()));
        figures.push(("efficiency, memory side by side".into(), one.total() / together.total()));
    });
}

/// The fastest time of each slice of a drop, s.
struct Fastest(Vec<f64>);

impl Fastest {
    /// Lets every worker make the slices of a drop in a thread of its own, all at once.
    fn round<W: FnMut() + Send>(&mut self, workers: Vec<W>) {
        let slices = (preset::study().time.duration / SAMPLING_INTERVAL) as usize;
        let (n, ready) = (workers.len(), AtomicUsize::new(0));
        let times: Vec<Vec<f64>> = thread::scope(|scope| {
            let spawn = |mut work: W| {
                let ready = &ready;
                scope.spawn(move || {
                    let mut slice = |number: usize| {
                        ready.fetch_add(1, Ordering::AcqRel);
                        while ready.load(Ordering::Acquire) < n * (number + 1) {
                            spin_loop();
                        }
                        let start = Instant::now();
                        work();
                        start.elapsed().as_secs_f64()
                    };
                    (0..slices).map(&mut slice).collect()
                })
            };
            let threads: Vec<_> = workers.into_iter().map(spawn).collect();
            threads.into_iter().map(|thread| thread.join().expect("a thread")).collect()
        });
        self.0.resize(slices, f64::INFINITY);
        for (slice, fastest) in self.0.iter_mut().enumerate() {
            *fastest = fastest.min(times.iter().map(|times| times[slice]).fold(0.0, f64::max));
        }
    }

    fn total(&self) -> f64 {
        self.0.iter().sum()
    }
}

/// Workers that make the steps of 50 us of a drop in each of the memories.
fn drops<'m>(model: &'m Model, memories: Vec<StateMemory<'m>>) -> Vec<impl FnMut() + Send> {
    let worker = |memory| {
        let mut state = State::new(model, memory).expect("memory of the right size");
        move || {
            for _ in 0..model.constants.steps_per_sample {
                step(model, &mut state, &StepInput::default()).expect("a stable run");
            }
        }
    };
    memories.into_iter().map(worker).collect()
}

/// Models of few triangles that step in turns, as in a sweep over them.
fn small_models(figures: &mut Vec<(String, f64)>) {
    let scenario = scene::sized(scene::ELEMENT_SIZES[0]);
    with_model(&scenario, |model| {
        let triangles = model.constants.grid.n_elem();
        for n in [1, 16, 256] {
            let mut memory = Memory::new(&model.constants.size, n);
            let states: Result<Vec<_>, _> =
                memory.states().into_iter().map(|memory| State::new(model, memory)).collect();
            let mut states = states.expect("memory of the right size");
            let mut fastest = Duration::MAX;
            for _ in 0..8 * ROUNDS / n.min(16) {
                states.iter_mut().for_each(|state| state.reset(model));
                let start = Instant::now();
                for state in &mut states {
                    for _ in 0..SMALL_STEPS {
                        step(model, state, &StepInput::default()).expect("a stable run");
                    }
                }
                fastest = fastest.min(start.elapsed());
            }
            let update = 1e9 * fastest.as_secs_f64() / (n * SMALL_STEPS * triangles) as f64;
            figures.push((format!("ns per update: {n} models of {triangles} triangles"), update));
        }
    });
}

fn with_model(scenario: &Scenario, work: impl FnOnce(&Model)) {
    let size = Size::of(scenario).expect("a legal scenario");
    let mut nodes = Pages::new(0.0, size.model_nodes);
    let mut cells = Pages::new(CellConstants::ZERO, size.model_cells);
    let mut hoops = Pages::new(HoopConstants::ZERO, size.model_hoops);
    let (nodes, cells, hoops) = (nodes.items(), cells.items(), hoops.items());
    let memory = ModelMemory { constants: &mut None, nodes, cells, hoops };
    let mut state = Memory::new(&size, 1);
    let state = &mut state.states()[0];
    work(&Model::new(scenario, memory, state).expect("a legal scenario"));
}

/// Memory of states, side by side.
struct Memory {
    size: Size,
    /// Each on pages of its own, as it would be on the stack of its thread.
    scalars: Vec<Pages<Scalars>>,
    nodes: Pages<f64>,
    cells: Pages<CellHistory>,
    viscous: Pages<Deviator>,
}

impl Memory {
    fn new(size: &Size, n: usize) -> Self {
        Self {
            size: *size,
            scalars: (0..n).map(|_| Pages::new(Scalars::BLANK, 1)).collect(),
            nodes: Pages::new(0.0, n * size.state_nodes),
            cells: Pages::new(CellHistory::REST, n * size.state_cells),
            viscous: Pages::new(Deviator::ZERO, n * size.state_viscous),
        }
    }

    fn states(&mut self) -> Vec<StateMemory<'_>> {
        let nodes = self.nodes.items().chunks_exact_mut(self.size.state_nodes);
        let cells = self.cells.items().chunks_exact_mut(self.size.state_cells);
        let viscous = self.viscous.items().chunks_exact_mut(self.size.state_viscous.max(1));
        let scalars = self.scalars.iter_mut().flat_map(Pages::items);
        let memory = |(scalars, ((nodes, cells), viscous))| StateMemory { scalars, nodes, cells, viscous };
        scalars.zip(nodes.zip(cells).zip(viscous)).map(memory).collect()
    }
}
