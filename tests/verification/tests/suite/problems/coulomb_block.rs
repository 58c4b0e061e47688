//! A block slides on the frictional core and stops after v^2 / (2 mu g).
//!
//! Source: Coulomb's law, uniform deceleration mu g of a rigid block.

use softanvil_verification::problems::coulomb_block::{ELEMENT_SIZE, FRICTION, stopping_distance};
use softanvil_verification::tolerance::{STOPPING_DISTANCE, relative_error};

#[test]
fn stopping_distance_of_a_block() {
    for friction in FRICTION {
        let [distance, reference] = stopping_distance(friction, ELEMENT_SIZE);
        assert!(relative_error(distance, reference) < STOPPING_DISTANCE, "{distance} m against {reference} m");
    }
}
