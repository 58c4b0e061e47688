//! The edge of the face on a solid, between two slices of nodes: the force follows it, where nodes alone would bear a whole slice or
//! none of it.

use softanvil_kernel::Simulation;
use softanvil_kernel::mesh::{Grid, solid_position};
use softanvil_kernel::scenario::{Formulation, Interface, StepBy};
use softanvil_verification::problems::reduction;
use softanvil_verification::tolerance::{EDGE_FALL, EDGE_RISE};

/// Half of the length of the anvil, m: slices of 3.75 mm.
const END: f64 = 22.5e-3;
const SLICES: usize = 6;

/// Force at a depth of 1 mm under a face with a flat part of this radius, m, on slices that are the same for every radius.
fn force(flat: f64) -> f64 {
    let mut scenario = reduction::scenario(Formulation::Solid, reduction::BULK_MODULI[1], 3.75e-3);
    let face = &mut scenario.impactor;
    (scenario.geometry.length, face.face_diameter) = (2.0 * END, 2.0 * (flat + 1e-3));
    (scenario.time.step_by, scenario.time.step) = (StepBy::Given, 5e-6);
    assert_eq!(scenario.core.interface, Interface::Bonded);
    let grid = Grid::new(&scenario).expect("a legal mesh");
    assert_eq!(grid.slices.half, SLICES);
    let position = |node: [usize; 3]| {
        let [x, y, _] = solid_position(&scenario, &grid, node);
        [x, y, END * node[2] as f64 / SLICES as f64]
    };
    let mut simulation = Simulation::with_node_positions(&scenario, &position).expect("a legal anvil");
    reduction::forces(&mut simulation, &[1e-3])[0]
}

#[test]
fn force_follows_an_edge_that_moves_across_a_cell() {
    let flat = |eighth: u32| 12.0e-3 + 3.75e-3 * f64::from(eighth) / 8.0;
    let forces: Vec<f64> = (0..=8).map(|eighth| force(flat(eighth))).collect();
    let rises: Vec<f64> = forces.windows(2).map(|pair| pair[1] / pair[0] - 1.0).collect();
    let rise = forces[8] / forces[0] - 1.0;
    assert!(rises.iter().all(|part| (-EDGE_FALL..EDGE_RISE * rise).contains(part)), "{forces:?}");
}
