//! A short bonded anvil with free ends, pressed by a face that covers it.
//!
//! Reference: felupe with hexahedra between the same nodes (`tests/verification/reference/solid_press.py`), which are softer
//! than tetrahedra; both come closer to each other as the cells get smaller.

use softanvil_verification::problems::solid_press::{SAME_MESH, error};
use softanvil_verification::tolerance::{SOLID_HEXAHEDRA, SOLID_HEXAHEDRA_GAIN};

#[test]
fn another_program_with_the_same_nodes_needs_the_same_force() {
    let [coarse, fine] = [0, 1].map(|mesh| error(mesh, SAME_MESH[mesh]));
    assert!(fine.abs() < SOLID_HEXAHEDRA, "{coarse}, then {fine}");
    assert!(coarse / fine > SOLID_HEXAHEDRA_GAIN, "{coarse}, then {fine}");
}
