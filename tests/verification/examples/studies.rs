//! Writes `docs/studies.md`: the section against the solid.

use std::error::Error;
use std::fs;
use std::path::Path;
use std::thread;

use softanvil_verification::problems::reduction::{
    BULK_MODULI, DEPTHS, EDGES, SIZES, label, line, ratios, ratios_with_fine_edge,
};

const HEAD: &str = include_str!("studies/head.txt");
const EDGE: &str = include_str!("studies/edge.txt");
const TAIL: &str = include_str!("studies/tail.txt");
/// By `tests/verification/reduction.py`.
const DROPS: &str = include_str!("studies/drops.txt");
const END: &str = include_str!("studies/end.txt");

/// Poisson's ratio and size of elements against depths.
fn meshes() -> Vec<String> {
    let cases = BULK_MODULI.iter().flat_map(|bulk| SIZES.map(|size| (*bulk, size)));
    cases.map(|(bulk, size)| line(&label(bulk, size), &ratios(bulk, size, &DEPTHS))).collect()
}

/// Width of the cells about the edge of the face against depths.
fn edges() -> Vec<String> {
    let of = |edge: (f64, f64)| ratios_with_fine_edge(BULK_MODULI[1], edge, &DEPTHS);
    EDGES.iter().map(|edge| line(&format!("| {}", 1e3 * edge.0), &of(*edge))).collect()
}

fn main() -> Result<(), Box<dyn Error>> {
    let (meshes, edges) = thread::scope(|scope| {
        let edges = scope.spawn(edges);
        (meshes(), edges.join())
    });
    let edges = edges.map_err(|_| "the study of the edge has failed")?;
    let page = format!("{HEAD}{}\n{EDGE}{}\n{TAIL}{DROPS}{END}", meshes.join("\n"), edges.join("\n"));
    fs::write(Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/studies.md"), page)?;
    Ok(())
}
