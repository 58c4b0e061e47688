//! Wall time of the study's drop through kernel, C ABI and FMU: `cargo bench -p softanvil-bench --bench drop`.
//!
//! Every call makes the steps of 50 us; the master of an FMU reads four outputs after each. All hosts take turns, and of each
//! of the calls of a drop the fastest in all drops counts. All must give the same trace. C ABI and FMU take the widest
//! instruction set that they find, whose name the results have: `processor.c` hides others.

use softanvil_bench::host::{CAbi, Fmu2, Fmu3, Host, Kernel, library_path, whole_drop};
use softanvil_bench::results;
use softanvil_kernel::element::{CellConstants, CellHistory};
use softanvil_kernel::tensor::deviator::Deviator;
use softanvil_kernel::{Constants, InstructionSet, Simulation, preset};

/// Drops per host.
const DROPS: usize = 60;

fn main() {
    let scenario = preset::study();
    let simulation = Simulation::new(&scenario).expect("a legal scenario");
    let per_sample = u64::from(simulation.constants().steps_per_sample);
    let mut hosts: Vec<(String, Box<dyn Host>)> = InstructionSet::ALL
        .into_iter()
        .filter(|set| set.available())
        .map(|set| (format!("kernel {set:?}"), Box::new(Kernel::new(&scenario, set)) as Box<dyn Host>))
        .collect();
    hosts.push(("C ABI".into(), Box::new(CAbi::new(&scenario))));
    match (Fmu2::load(&scenario), Fmu3::load(&scenario)) {
        (Some(mut two), Some(mut three)) => {
            (two.reads_outputs, three.reads_outputs) = (true, true);
            hosts.push(("FMU 2.0".into(), Box::new(two)));
            hosts.push(("FMU 3.0".into(), Box::new(three)));
        }
        _ => eprintln!("skipped: the FMU, as {} is not there; `softanvil fmu` builds it", library_path().display()),
    }
    let mut expected = None;
    let mut fastest = vec![Vec::new(); hosts.len()];
    for _ in 0..DROPS {
        for ((name, host), fastest) in hosts.iter_mut().zip(&mut fastest) {
            let hash = whole_drop(host.as_mut(), per_sample, fastest);
            assert_eq!(*expected.get_or_insert(hash), hash, "{name} gives another trace");
        }
    }
    let mut figures = vec![
        ("simulated time s".into(), scenario.time.duration),
        ("triangles".into(), simulation.constants().grid.n_elem() as f64),
        ("steps".into(), hosts[0].1.steps_of_drop() as f64),
    ];
    figures.extend(memory(simulation.constants()));
    figures.extend(hosts.into_iter().zip(fastest).map(|((name, _), calls)| (name, calls.iter().sum())));
    results::write(&format!("drop-{:?}", InstructionSet::best()), &figures);
}

/// Bytes per triangle and per node, those of padding included, from the sizes that the caller of the kernel sees.
fn memory(constants: &Constants) -> [(String, f64); 5] {
    let (size, grid) = (&constants.size, &constants.grid);
    let triangles = grid.n_elem() as f64;
    let nodes = ((grid.n_u + 1) * (grid.n_v + 1)) as f64;
    let bytes = |count: usize, of: usize| (count * of) as f64;
    [
        ("bytes a triangle, constants".into(), bytes(size.model_cells, size_of::<CellConstants>()) / triangles),
        ("bytes a triangle, history".into(), bytes(size.state_cells, size_of::<CellHistory>()) / triangles),
        ("bytes a triangle, viscous terms".into(), bytes(size.state_viscous, size_of::<Deviator>()) / triangles),
        ("bytes a node, model".into(), bytes(size.model_nodes, size_of::<f64>()) / nodes),
        ("bytes a node, state".into(), bytes(size.state_nodes, size_of::<f64>()) / nodes),
    ]
}
