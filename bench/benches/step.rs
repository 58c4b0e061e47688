//! Time of a step, per triangle: against the number of triangles, per elastic law, per overlay, per instruction set; and
//! of a snapshot. `cargo bench -p softanvil-bench --bench step`.
//!
//! A step of a drop costs the same in every state, so the steps of the whole drop are timed, over and over.

use std::hint::black_box;
use std::time::Duration;

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use softanvil_bench::host::{Host, Kernel, Replay};
use softanvil_bench::scene;
use softanvil_kernel::mesh::Grid;
use softanvil_kernel::number::pack::LANES;
use softanvil_kernel::state::{restore, save, snapshot_size};
use softanvil_kernel::{InstructionSet, Scenario, preset};

criterion_group! {
    name = benches;
    config = Criterion::default()
        .warm_up_time(Duration::from_millis(200))
        .measurement_time(Duration::from_secs(1))
        .without_plots();
    targets = size, law, overlay, foam, instruction_set, snapshot
}
criterion_main!(benches);

/// Times single steps of `scenario`; criterion's throughput is in triangles.
fn step(group: &mut BenchmarkGroup<WallTime>, name: &str, scenario: &Scenario, set: InstructionSet) {
    let mut kernel = Kernel::new(scenario, set);
    group.throughput(Throughput::Elements(kernel.simulation().constants().grid.n_elem() as u64));
    let mut replay = Replay::new(kernel);
    group.bench_function(BenchmarkId::from_parameter(name), |bencher| {
        bencher.iter_custom(|iterations| replay.time(iterations, 1));
    });
}

fn size(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("size");
    for element_size in scene::ELEMENT_SIZES {
        let scenario = scene::sized(element_size);
        let grid = Grid::new(&scenario).expect("a legal scenario");
        let lanes = 100 * grid.n_u / (grid.blocks_per_row() * LANES);
        let name = format!("{} triangles, {lanes} % of the lanes", grid.n_elem());
        step(&mut group, &name, &scenario, InstructionSet::best());
    }
}

fn law(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("law");
    for (name, material) in scene::laws() {
        step(&mut group, name, &scene::with_material(material), InstructionSet::best());
    }
}

fn overlay(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("overlay");
    for (name, material) in scene::overlays() {
        step(&mut group, &name, &scene::with_material(material), InstructionSet::best());
    }
}

fn foam(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("foam");
    for (name, material) in scene::foams() {
        step(&mut group, name, &scene::with_material(material), InstructionSet::best());
    }
}

fn instruction_set(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("instruction set");
    for set in InstructionSet::ALL.into_iter().filter(|set| set.available()) {
        step(&mut group, &format!("{set:?}"), &preset::study(), set);
    }
}

/// A snapshot of the study's state in the middle of the drop, saved and restored.
fn snapshot(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("snapshot");
    let mut kernel = Kernel::new(&preset::study(), InstructionSet::best());
    let half = kernel.steps_of_drop() / 2;
    kernel.advance(1, half);
    let mut bytes = vec![0; snapshot_size(kernel.simulation().constants())];
    let work = kernel.simulation().with(|model, state| {
        group.bench_function("save", |bencher| {
            bencher.iter(|| save(black_box(model), state, &mut bytes).expect("a sound state"));
        });
        group.bench_function("restore", |bencher| {
            bencher.iter(|| restore(model, state, black_box(&bytes)).expect("a sound snapshot"));
        });
    });
    work.expect("memory of the right size");
}
