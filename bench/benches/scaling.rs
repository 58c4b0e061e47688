//! Many drops at once, and many small models one after another: `cargo bench -p softanvil-bench --bench scaling`.
//!
//! Every thread makes drops of a state of its own of one shared model. The states lie side by side in one piece of memory,
//! or each in its own: were lines of the cache shared in the first case, it would be slower. One thread and all of them
//! take turns, and the fastest round counts, which is as long as its slowest thread.

use std::sync::Barrier;
use std::thread;
use std::time::{Duration, Instant};

use softanvil_bench::{results, scene};
use softanvil_kernel::element::{CellConstants, CellHistory, HoopConstants};
use softanvil_kernel::lanes::Deviator;
use softanvil_kernel::{Model, ModelMemory, Scalars, Scenario, Size, State, StateMemory, StepInput, preset, step};

/// Rounds of each kind; in each, every thread makes one drop.
const ROUNDS: usize = 60;

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
    let (mut one, mut apart, mut together) = (Duration::MAX, Duration::MAX, Duration::MAX);
    with_model(&preset::study(), |model| {
        let mut memory = Memory::new(&model.constants.size, n);
        let mut own: Vec<Memory> = (0..n).map(|_| Memory::new(&model.constants.size, 1)).collect();
        for _ in 0..ROUNDS {
            one = one.min(round(model, own[..1].iter_mut().flat_map(Memory::states).collect()));
            apart = apart.min(round(model, own.iter_mut().flat_map(Memory::states).collect()));
            together = together.min(round(model, memory.states()));
        }
    });
    let efficiency = |many: Duration| one.as_secs_f64() / many.as_secs_f64();
    figures.push(("threads".into(), n as f64));
    figures.push(("efficiency, own memory".into(), efficiency(apart)));
    figures.push(("efficiency, memory side by side".into(), efficiency(together)));
}

/// Time of one drop in every memory at once.
fn round(model: &Model, memories: Vec<StateMemory>) -> Duration {
    let (constants, barrier) = (&model.constants, Barrier::new(memories.len()));
    let steps = constants.steps_in(constants.scenario.time.duration);
    thread::scope(|scope| {
        let threads: Vec<_> = memories
            .into_iter()
            .map(|memory| {
                let barrier = &barrier;
                scope.spawn(move || {
                    let mut state = State::new(model, memory).expect("memory of the right size");
                    barrier.wait();
                    let start = Instant::now();
                    for _ in 0..steps {
                        step(model, &mut state, &StepInput::default()).expect("a stable run");
                    }
                    start.elapsed()
                })
            })
            .collect();
        threads.into_iter().map(|thread| thread.join().expect("a thread")).max().unwrap_or_default()
    })
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
            for _ in 0..ROUNDS * 16 / n.min(16) {
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
    let mut nodes = vec![0.0; size.model_nodes];
    let mut cells = vec![CellConstants::ZERO; size.model_cells];
    let mut hoops = vec![HoopConstants::ZERO; size.model_hoops];
    let memory = ModelMemory { constants: &mut None, nodes: &mut nodes, cells: &mut cells, hoops: &mut hoops };
    work(&Model::new(scenario, memory).expect("a legal scenario"));
}

/// Memory of states, side by side.
struct Memory {
    size: Size,
    scalars: Vec<Scalars>,
    nodes: Vec<f64>,
    cells: Vec<CellHistory>,
    viscous: Vec<Deviator>,
}

impl Memory {
    fn new(size: &Size, n: usize) -> Self {
        Self {
            size: *size,
            scalars: vec![Scalars::BLANK; n],
            nodes: vec![0.0; n * size.state_nodes],
            cells: vec![CellHistory::REST; n * size.state_cells],
            viscous: vec![Deviator::ZERO; n * size.state_viscous],
        }
    }

    fn states(&mut self) -> Vec<StateMemory<'_>> {
        let nodes = self.nodes.chunks_exact_mut(self.size.state_nodes);
        let cells = self.cells.chunks_exact_mut(self.size.state_cells);
        let viscous = self.viscous.chunks_exact_mut(self.size.state_viscous.max(1));
        let arrays = nodes.zip(cells).zip(viscous);
        let memory = |(scalars, ((nodes, cells), viscous))| StateMemory { scalars, nodes, cells, viscous };
        self.scalars.iter_mut().zip(arrays).map(memory).collect()
    }
}
