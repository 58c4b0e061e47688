//! Thick cylinder between held ends and thick sphere under internal pressure, as solids.
//!
//! Source: Lame's solutions, Timoshenko and Goodier, Theory of Elasticity (1970).

use softanvil_verification::order::over_cells;
use softanvil_verification::problems::solid_lame::{POISSONS_RATIOS, Wall, errors};
use softanvil_verification::tolerance::{
    SECOND_ORDER, SOLID_LAME_DISPLACEMENT, SOLID_LAME_LARGEST, SOLID_LAME_LARGEST_ORDER, SOLID_LAME_PRESSURE,
    SOLID_LAME_PRESSURE_ORDER,
};

#[test]
fn displacement_and_pressure() {
    for (wall, largest_order) in Wall::ALL.into_iter().zip(SOLID_LAME_LARGEST_ORDER) {
        for nu in POISSONS_RATIOS {
            let errors: Vec<_> = wall.cells().iter().map(|n| errors(wall, nu, *n)).collect();
            let judge = |what: &str, errors: Vec<f64>, bound: f64, least: f64| {
                let order = over_cells(wall.cells(), &errors);
                let finest = errors[errors.len() - 1];
                assert!(
                    finest < bound && order > least,
                    "{wall:?}, nu = {nu}, {what}: order {order}, errors {errors:?}"
                );
            };
            let displacements = errors.iter().map(|e| e.displacement).collect();
            judge("displacement", displacements, SOLID_LAME_DISPLACEMENT, SECOND_ORDER);
            judge("largest", errors.iter().map(|e| e.largest).collect(), SOLID_LAME_LARGEST, largest_order);
            let pressures = errors.iter().map(|e| e.pressure).collect();
            judge("pressure", pressures, SOLID_LAME_PRESSURE, SOLID_LAME_PRESSURE_ORDER);
        }
    }
}
