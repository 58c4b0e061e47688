//! Force of the bonded round layer under a frictionless face, quasi-static, at 5 mm deflection.
//!
//! Reference: the problem itself on finer meshes. The requirement is an order of at least 1.5 and 2 % at the default
//! element size. The equilibrium of each mesh is found by Newton's method on the kernel's forces; that the kernel's own
//! steps and contact settle at the same force is shown once.

use softanvil_kernel::scenario::Formulation;
use softanvil_verification::problems::contact_convergence::{
    BULK_MODULI, SIZES, scenario, settled_force, static_forces, study,
};
use softanvil_verification::tolerance::{CONTACT_DEFAULT, CONTACT_ORDER, SETTLED, relative_error};

fn converges(formulation: Formulation, bulk_modulus: f64) {
    let study = study(formulation, bulk_modulus, &SIZES);
    let (forces, order) = (&study.forces, study.order);
    assert!(order >= CONTACT_ORDER, "order {order}: {forces:?} N, {:?}", study.errors);
    let error = relative_error(forces[0], forces[SIZES.len() - 1]);
    assert!(error < CONTACT_DEFAULT, "{forces:?} N");
}

#[test]
fn plane_strain_nearly_incompressible() {
    converges(Formulation::PlaneStrain, BULK_MODULI[0]);
}

#[test]
fn plane_strain() {
    converges(Formulation::PlaneStrain, BULK_MODULI[1]);
}

#[test]
fn axisymmetric_nearly_incompressible() {
    converges(Formulation::Axisymmetric, BULK_MODULI[0]);
}

#[test]
fn axisymmetric() {
    converges(Formulation::Axisymmetric, BULK_MODULI[1]);
}

#[test]
fn the_steps_settle_at_the_equilibrium() {
    for formulation in [Formulation::PlaneStrain, Formulation::Axisymmetric] {
        let scenario = scenario(formulation, BULK_MODULI[0], SIZES[0]);
        let (settled, forces) = (settled_force(&scenario), static_forces(&scenario));
        let equilibrium = forces[forces.len() - 1];
        assert!(relative_error(settled, equilibrium) < SETTLED, "{settled} N against {equilibrium} N");
    }
}
