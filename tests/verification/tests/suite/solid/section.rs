//! Solids that a section describes: a slice between held ends, a dome, a disc, and pads on them.
//!
//! Reference: the section on the same mesh, whose cells have other diagonals; the bounds are those that the solid is asked for.

use softanvil_verification::problems::solid_section::{Twin, error};
use softanvil_verification::tolerance::{SOLID_PLANE_STRAIN, SOLID_REVOLVED};

fn bears_what_its_section_bears(twin: Twin, bound: f64) {
    for nu in twin.poissons_ratios() {
        let error = error(twin, *nu);
        assert!(error.abs() < bound, "nu {nu}: {error}");
    }
}

#[test]
fn a_slice_between_held_ends_is_in_plane_strain() {
    bears_what_its_section_bears(Twin::Slice, SOLID_PLANE_STRAIN);
}

#[test]
fn a_dome_is_axisymmetric() {
    bears_what_its_section_bears(Twin::Dome, SOLID_REVOLVED);
}

#[test]
fn a_disc_is_axisymmetric() {
    bears_what_its_section_bears(Twin::Disc, SOLID_REVOLVED);
}

#[test]
fn a_loose_pad_on_a_slice_is_in_plane_strain() {
    bears_what_its_section_bears(Twin::PaddedSlice, SOLID_PLANE_STRAIN);
}

#[test]
fn a_loose_pad_on_a_dome_is_axisymmetric() {
    bears_what_its_section_bears(Twin::PaddedDome, SOLID_REVOLVED);
}
