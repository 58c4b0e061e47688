//! Time of a step of a solid, per tetrahedron, on one core and on all: `cargo bench -p softanvil-bench --bench solid`.
//!
//! The law has five coefficients, two Prony terms, and the slider or not; the face is on the layer from the start. The meshes are
//! the default's quarter of the study's anvil, and the whole of it with about as many tetrahedra as the study has. All take turns,
//! and the fastest slice counts.

use std::time::Instant;

use rayon::ThreadPool;
use softanvil_bench::host::{Host, Kernel};
use softanvil_bench::{results, scene};
use softanvil_kernel::InstructionSet;
use softanvil_kernel::scenario::Symmetry;

/// Turns.
const TURNS: usize = 30;

/// Steps that are timed at once, and how often in a turn.
const STEPS: u64 = 8;
const SLICES: usize = 10;

/// Meshes: what they are called, the part of the anvil, and the size of an element, m.
const MESHES: [(&str, Symmetry, f64); 2] =
    [("quarter, 3 mm", Symmetry::Quarter, 3e-3), ("whole, 2.6 mm", Symmetry::Full, 2.6e-3)];

fn main() {
    let all = std::thread::available_parallelism().map_or(1, usize::from);
    let pools = [1, all]
        .map(|threads| rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool of threads"));
    let mut figures = vec![("threads".into(), all as f64)];
    for (mesh, symmetry, size) in MESHES {
        let sets = InstructionSet::ALL.into_iter().filter(|set| set.available());
        let mut rows: Vec<Row> = sets
            .flat_map(|set| scene::overlays().into_iter().map(move |overlay| (set, overlay)))
            .filter(|(_, (name, _))| name.starts_with("2 "))
            .map(|(set, (overlay, material))| Row {
                name: format!("{set:?}; {mesh}; {overlay}"),
                kernel: Kernel::new(&scene::solid(material, symmetry, size), set),
                fastest: [f64::INFINITY; 2],
            })
            .collect();
        for _ in 0..TURNS {
            for row in &mut rows {
                row.turn(&pools);
            }
        }
        for row in &mut rows {
            let tetrahedra = row.kernel.simulation().constants().grid.n_elem() as f64;
            for (threads, fastest) in ["one core", "all cores"].into_iter().zip(row.fastest) {
                figures.push((format!("{}, {threads}", row.name), 1e9 * fastest / STEPS as f64 / tetrahedra));
            }
        }
        let tetrahedra = rows[0].kernel.simulation().constants().grid.n_elem() as f64;
        figures.push((format!("{mesh}, tetrahedra"), tetrahedra));
    }
    results::write("solid", &figures);
}

/// A scenario with an instruction set, and the fastest slice on one core and on all, s.
struct Row {
    name: String,
    kernel: Kernel,
    fastest: [f64; 2],
}

impl Row {
    fn turn(&mut self, pools: &[ThreadPool; 2]) {
        for (pool, fastest) in pools.iter().zip(&mut self.fastest) {
            self.kernel.restart();
            for _ in 0..SLICES {
                let time = pool.install(|| {
                    let start = Instant::now();
                    self.kernel.advance(1, STEPS);
                    start.elapsed().as_secs_f64()
                });
                *fastest = fastest.min(time);
            }
        }
    }
}
