//! Where the columns of nodes stand across the section: evenly, but for the places at which one has to be.

use heapless::Vec;

use crate::features::PADS;
use crate::number::math;
use crate::number::real::consts::FRAC_PI_2;
use crate::number::real::{Real, SAME};
use crate::scenario::{MAX_LAYERS, Outline, Scenario, Shape};

/// Most pieces of half a section: between the edges of three layers and both ends of a face's flat part.
pub const MAX_PIECES: usize = 6;

/// Cells of even width beside each other, of half a section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// Cells from the centre line to its end.
    pub end: usize,
    /// Where it ends, as a part of the way from the centre line to the side.
    pub across: Real,
}

/// The pieces of half a section of a legal `scenario`, from the centre line to the side, behind the last of them that again; a
/// cell is about an element size wide.
pub(super) fn pieces(scenario: &Scenario) -> [Piece; MAX_PIECES] {
    let (mut last, size) = (Piece { end: 0, across: 0.0 }, scenario.mesh.element_size);
    let width = half_width(scenario);
    let breaks = breaks(scenario);
    core::array::from_fn(|_| {
        let further = breaks.iter().copied().filter(|across| *across > last.across);
        let across = further.fold(Real::MAX, |nearest, across| if across < nearest { across } else { nearest });
        if across < Real::MAX {
            let cells = cells_along(width * (across - last.across), size);
            last = Piece { end: last.end.saturating_add(cells as usize), across };
        }
        last
    })
}

/// Width of half the section at half its height, m.
fn half_width(scenario: &Scenario) -> Real {
    match scenario.geometry.shape {
        Shape::Round => half_angle(scenario) * (scenario.geometry.core_radius + 0.5 * scenario.height()),
        Shape::Block => scenario.half_block_width(),
    }
}

/// Angle from the centre line of a round section to its side: a right one, unless the lowest layer ends before.
pub(super) fn half_angle(scenario: &Scenario) -> Real {
    let width = scenario.layers.first().map_or(0.0, |layer| layer.width);
    if width > 0.0 { 0.5 * width / scenario.geometry.core_radius } else { FRAC_PI_2 }
}

/// Where a layer ends, as a part of the way from the centre line to the side of the section; for one that is not there, where the last one does.
pub(super) fn layer_across(scenario: &Scenario, place: usize) -> Real {
    let narrow = |layer: usize| PADS && layer > 0 && scenario.layers.get(layer).is_some_and(|layer| layer.width > 0.0);
    match (0..=place).rev().find(|layer| narrow(*layer)) {
        Some(layer) => scenario.layers.get(layer).map_or(1.0, |of| of.width / scenario.whole_width(layer)),
        None => 1.0,
    }
}

/// Where columns of nodes have to be, and the side; parts of the way to the side, in no order.
fn breaks(scenario: &Scenario) -> Vec<Real, MAX_PIECES> {
    let mut breaks = Vec::new();
    add(&mut breaks, 1.0);
    if !PADS {
        return breaks;
    }
    for place in 0..MAX_LAYERS {
        let across = layer_across(scenario, place);
        if breaks.iter().all(|other| math::abs(other - across) > SAME) {
            add(&mut breaks, across);
        }
    }
    let spacing = 0.5 * scenario.mesh.element_size / half_width(scenario);
    for x in face_edges(scenario).into_iter().flatten() {
        let across = surface_across(scenario, x);
        // An edge beside the layer is none of the mesh. A cell that is far narrower than the others would take a far smaller step.
        if across > spacing && across < 1.0 && breaks.iter().all(|other| math::abs(other - across) > spacing) {
            add(&mut breaks, across);
        }
    }
    breaks
}

/// Adds `across` to the others; there is room for all that may come.
fn add(breaks: &mut Vec<Real, MAX_PIECES>, across: Real) {
    let _ = breaks.push(across);
}

/// Distances from the centre line of the last columns under the flat part of a face that does not cover the anvil, or of that
/// under the lowest point of a bar, m.
///
/// A node bears what lies halfway to its neighbours, so the last one under a face is half a cell inside its edge: the force
/// on a punch then converges from within some per cent, which it does not with a node at the edge (`docs/verification.md`,
/// indentation). The mesh is even about the centre line, so a face beside it has an edge on either side of it.
fn face_edges(scenario: &Scenario) -> [Option<Real>; 2] {
    let (outline, offset) = (Outline::of(scenario), scenario.impactor.offset);
    if outline.radius == 0.0 {
        return [None; 2];
    }
    let half_a_cell = 0.5 * scenario.mesh.element_size * surface_half_width(scenario) / half_width(scenario);
    let last = math::max(0.0, outline.flat - half_a_cell);
    if scenario.has_both_sides() {
        [Some(math::abs(offset + last)), Some(math::abs(offset - last))]
    } else {
        [Some(last), None]
    }
}

/// Width of half the section along its surface, m.
fn surface_half_width(scenario: &Scenario) -> Real {
    match scenario.geometry.shape {
        Shape::Round => half_angle(scenario) * (scenario.geometry.core_radius + scenario.height()),
        Shape::Block => half_width(scenario),
    }
}

/// Where the surface is `x` m from the centre line.
fn surface_across(scenario: &Scenario, x: Real) -> Real {
    match scenario.geometry.shape {
        Shape::Round => {
            let sine = x / (scenario.geometry.core_radius + scenario.height());
            if sine < 1.0 { math::asin(sine) / half_angle(scenario) } else { 1.0 }
        }
        Shape::Block => x / half_width(scenario),
    }
}

/// Cells of about `size` m along `length` m, at least one.
pub(super) fn cells_along(length: Real, size: Real) -> Real {
    math::max(1.0, math::round(length / size))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Grid, reference_position, solid_position};
    use crate::scenario::{FaceShape, Formulation, Section, preset};

    /// How far the mesh reaches from the centre line, m.
    fn reach(scenario: &Scenario) -> Real {
        let grid = Grid::new(scenario).expect("a legal scenario");
        let nodes = (0..=grid.n_v).flat_map(|v| (0..=grid.n_u).map(move |u| (u, v)));
        let x = nodes.map(|(u, v)| {
            if grid.is_solid() {
                solid_position(scenario, &grid, [u, v, 0])[0]
            } else {
                reference_position(scenario, &grid, u, v)[0]
            }
        });
        x.fold(0.0, |most, x| math::max(most, math::abs(x)))
    }

    #[test]
    fn a_block_is_as_wide_as_it_is_given_wherever_the_face_ends() {
        let mut block = preset::elastic();
        block.geometry.shape = Shape::Block;
        (block.geometry.block_width, block.geometry.length) = (0.03, 0.15);
        let mut solid = block.clone();
        (solid.geometry.formulation, solid.mesh.element_size) = (Formulation::Solid, 5e-3);
        assert!(math::abs(reach(&solid) - 0.015) < 1e-12, "{}", reach(&solid));
        block.geometry.section = Section::Full;
        (block.impactor.face_width, block.impactor.face_length, block.impactor.face_diameter) = (0.03, 0.15, 0.04);
        for shape in [FaceShape::Rectangular, FaceShape::Bar] {
            block.impactor.shape = shape;
            for offset in [-0.02, -0.01, 0.0, 0.004, 0.01, 0.014, 0.03] {
                block.impactor.offset = offset;
                assert!(math::abs(reach(&block) - 0.015) < 1e-12, "{shape:?} at {offset}: {}", reach(&block));
            }
        }
    }

    #[test]
    fn a_layer_on_a_round_core_is_as_wide_as_it_is_given() {
        let mut scenario = preset::study();
        scenario.layers[0].width = 0.05;
        scenario.geometry.section = Section::Full;
        scenario.impactor.face_diameter = 0.06;
        let angle = 0.5 * 0.05 / scenario.geometry.core_radius;
        let side = (scenario.geometry.core_radius + scenario.thickness()) * math::sin(angle);
        for offset in [0.0, 0.01, 0.02, 0.03] {
            scenario.impactor.offset = offset;
            assert!(math::abs(reach(&scenario) - side) < 1e-12, "{offset}: {}", reach(&scenario));
        }
    }
}
