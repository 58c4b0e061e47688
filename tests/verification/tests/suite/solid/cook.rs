//! Cook's membrane as a solid between held faces, nearly incompressible: no locking.
//!
//! Source: as of the section (`problems/cook.rs`), whose plain triangles, each with a pressure of its own, show what locking is.

use softanvil_verification::body::Pressure;
use softanvil_verification::order::extrapolate;
use softanvil_verification::problems::cook::{self, FINITE_REFERENCE, LINEAR_REFERENCE};
use softanvil_verification::problems::solid_cook::{CELLS, FINITE_CELLS, finite_tip, linear_tip};
use softanvil_verification::tolerance::{COOK_FINITE_LIMIT, COOK_LIMIT, SOLID_COOK, relative_error};

#[test]
fn linear_deflection() {
    let tips = CELLS.map(linear_tip);
    for (n, tip) in CELLS.into_iter().zip(tips) {
        let locked = cook::linear_tip(n, Pressure::Triangle);
        assert!(locked < tip && tip < LINEAR_REFERENCE, "{n} cells: {tip}, plain triangles {locked}");
    }
    assert!(relative_error(tips[3], LINEAR_REFERENCE) < SOLID_COOK, "{tips:?}");
    let sizes = CELLS.map(|n| 1.0 / n as f64);
    let (limit, order) = extrapolate([sizes[1], sizes[2], sizes[3]], [tips[1], tips[2], tips[3]]);
    assert!(relative_error(limit, LINEAR_REFERENCE) < COOK_LIMIT, "{tips:?}, limit {limit}, order {order}");
}

#[test]
fn finite_strain_deflection() {
    let tips = FINITE_CELLS.map(finite_tip);
    for (n, tip) in FINITE_CELLS.into_iter().zip(tips) {
        let [locked, _] = cook::finite_tip(n, Pressure::Triangle);
        assert!(locked < tip && tip < FINITE_REFERENCE, "{n} cells: {tip}, plain triangles {locked}");
    }
    let (limit, order) = extrapolate(FINITE_CELLS.map(|n| 1.0 / n as f64), tips);
    assert!(relative_error(limit, FINITE_REFERENCE) < COOK_FINITE_LIMIT, "{tips:?}, limit {limit}, order {order}");
}
