//! Interfaces between layers against closed forms.
//!
//! Sources: springs in series; Kolsky, Stress Waves in Solids (1953), reflection and transmission at a change of impedance;
//! v^2 / (2 mu g) for a block that friction stops.

use softanvil_kernel::scenario::{Formulation, LayerInterface};
use softanvil_verification::order::over_cells;
use softanvil_verification::problems::interface::{
    CELLS, ELEMENT_SIZE, FRICTION, closing_gap, reflected, series_springs, sliding_slab, sliding_solid_slab,
    transmitted,
};
use softanvil_verification::tolerance::{CREEP, IMPEDANCE, SERIES_SPRINGS, STOPPING_DISTANCE_ON_LAYER};

#[test]
fn two_layers_are_springs_in_series() {
    for interface in [LayerInterface::Bonded, LayerInterface::Separating] {
        for formulation in [Formulation::PlaneStrain, Formulation::Axisymmetric, Formulation::Solid] {
            let ratio = series_springs(formulation, interface);
            assert!((ratio - 1.0).abs() < SERIES_SPRINGS, "{interface:?}, {formulation:?}: {ratio}");
        }
    }
}

#[test]
fn waves_go_on_and_come_back_at_a_change_of_impedance() {
    for interface in [LayerInterface::Bonded, LayerInterface::Separating] {
        for of in [transmitted, reflected] {
            let errors = CELLS.map(|n| of(interface, n));
            assert!(errors[CELLS.len() - 1].abs() < IMPEDANCE, "{interface:?}: {errors:?}");
            assert!(over_cells(&CELLS, &errors) > 1.0, "{interface:?}: {errors:?}");
        }
    }
}

#[test]
fn friction_stops_a_slab_and_holds_it() {
    for friction in FRICTION {
        let [way, creep] = sliding_slab(friction, ELEMENT_SIZE);
        assert!((way - 1.0).abs() < STOPPING_DISTANCE_ON_LAYER, "{friction}: {way}");
        assert!(creep.abs() < CREEP, "{friction}: {creep}");
    }
}

#[test]
fn friction_stops_a_solid_slab_that_slides_aslant() {
    let [way, creep, aside] = sliding_solid_slab(FRICTION[1], ELEMENT_SIZE);
    assert!((way - 1.0).abs() < STOPPING_DISTANCE_ON_LAYER, "{way}");
    assert!(creep.abs() < CREEP, "{creep}");
    assert!(aside.abs() < STOPPING_DISTANCE_ON_LAYER, "{aside}");
}

/// The force begins in the step in which the slab would go into the layer below, and in none before.
#[test]
fn a_gap_closes_when_it_should() {
    for gap in [1e-3, 0.25e-3] {
        let [time, step] = closing_gap(gap);
        assert!(time <= 1.0 + 1e-9 && time > 1.0 - step - 1e-9, "{gap} m: {time}, {step} each step");
    }
}
