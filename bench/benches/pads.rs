//! Wall time of a drop on a pad against the time that it lasts, and of steps of foams against steps of Mooney-Rivlin:
//! `cargo bench -p softanvil-bench --bench pads`.
//!
//! The drop is that of the preset `rugby-soft-anvil`, 10 mm of foam on the study's anvil, over the study's 15 ms. All that is
//! compared takes turns, with every instruction set that the processor has, and of each piece the fastest in all turns counts.

use std::time::Instant;

use softanvil_bench::host::{Host, Kernel, whole_drop};
use softanvil_bench::{results, scene};
use softanvil_kernel::{InstructionSet, preset};

/// Turns.
const TURNS: usize = 40;

/// Steps of a foam that are timed at once.
const STEPS: u64 = 100;

fn main() {
    let sets = InstructionSet::ALL.into_iter().filter(|set| set.available());
    let figures: Vec<(String, f64)> = sets.flat_map(|set| drop(set).into_iter().chain(foams(set))).collect();
    for (name, figure) in &figures {
        println!("{name}: {figure:.3}");
    }
    results::write("pads", &figures);
}

/// Wall time of the drop over the time that it lasts, and its steps.
fn drop(set: InstructionSet) -> [(String, f64); 2] {
    let mut scenario = preset::rugby_soft_anvil();
    scenario.time.duration = preset::study().time.duration;
    let mut host = Kernel::new(&scenario, set);
    let per_sample = u64::from(host.simulation().constants().steps_per_sample);
    let (mut fastest, steps) = (Vec::new(), host.steps_of_drop());
    for _ in 0..TURNS {
        whole_drop(&mut host, per_sample, &mut fastest);
    }
    let factor = fastest.iter().sum::<f64>() / scenario.time.duration;
    [
        (format!("{set:?}: padded drop, wall time / simulated"), factor),
        (format!("{set:?}: padded drop, steps"), steps as f64),
    ]
}

/// Time of a step of each foam over that of Mooney-Rivlin with the same damping.
fn foams(set: InstructionSet) -> Vec<(String, f64)> {
    let mut hosts: Vec<(&str, Kernel, f64)> = scene::foams()
        .into_iter()
        .map(|(name, material)| (name, Kernel::new(&scene::with_material(material), set), f64::INFINITY))
        .collect();
    for _ in 0..TURNS {
        for (_, host, fastest) in &mut hosts {
            host.restart();
            for _ in 0..10 {
                let start = Instant::now();
                host.advance(1, STEPS);
                *fastest = fastest.min(start.elapsed().as_secs_f64());
            }
        }
    }
    let rubber = hosts[0].2;
    hosts[1..]
        .iter()
        .map(|(name, _, fastest)| (format!("{set:?}: {name} / Mooney-Rivlin 5"), fastest / rubber))
        .collect()
}
