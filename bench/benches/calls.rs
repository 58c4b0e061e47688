//! What a call costs beyond the kernel's own steps: `cargo bench -p softanvil-bench --bench calls`.
//!
//! Each interface makes the same steps in one call and in one call each; the difference, by the number of calls, is the
//! overhead of a call. Both ways take turns, and the fastest of each counts, so that other programs on the machine fall
//! out. On a mesh of few elements, where a step is short, because the overhead depends on no mesh.

use softanvil_bench::host::{CAbi, Fmu2, Fmu3, Host, Kernel, Replay, library_path};
use softanvil_bench::{results, scene};
use softanvil_kernel::InstructionSet;

/// Calls in a slice.
const CALLS: u64 = 60;

/// Slices of each kind.
const SLICES: usize = 8000;

fn main() {
    let scenario = scene::tiny();
    let mut figures = Vec::new();
    measure(&mut figures, "kernel", Some(Kernel::new(&scenario, InstructionSet::best())));
    measure(&mut figures, "C ABI", Some(CAbi::new(&scenario)));
    measure(&mut figures, "FMI 2", Fmu2::load(&scenario));
    measure(&mut figures, "FMI 3", Fmu3::load(&scenario));
    if !library_path().is_file() {
        eprintln!("skipped: FMI, as {} is not there; `softanvil fmu` builds it", library_path().display());
    }
    results::write("calls", &figures);
}

/// Overhead of a call and time of a step without it, ns.
fn measure(figures: &mut Vec<(String, f64)>, name: &str, host: Option<impl Host>) {
    let Some(host) = host else { return };
    let mut replay = Replay::new(host);
    let (mut at_once, mut one_by_one) = (f64::INFINITY, f64::INFINITY);
    for _ in 0..SLICES {
        at_once = at_once.min(replay.time(1, CALLS).as_secs_f64());
        one_by_one = one_by_one.min(replay.time(CALLS, 1).as_secs_f64());
    }
    figures.push((format!("overhead: {name}"), 1e9 * (one_by_one - at_once) / (CALLS - 1) as f64));
    figures.push((format!("step: {name}"), 1e9 * at_once / CALLS as f64));
}
