//! Where the columns of nodes stand across the section: evenly, but for the places at which one has to be.

use heapless::Vec;

use crate::features::PADS;
use crate::number::math;
use crate::number::real::consts::FRAC_PI_2;
use crate::number::real::{Real, SAME};
use crate::scenario::{MAX_LAYERS, Outline, Scenario, Section, Shape};

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
    let mut breaks = breaks(scenario).into_iter();
    core::array::from_fn(|_| {
        if let Some(across) = breaks.next() {
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

/// Where columns of nodes have to be, and the side, in order; parts of the way to the side.
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
        // A cell that is far narrower than the others would take a far smaller step.
        if across > spacing && breaks.iter().all(|other| math::abs(other - across) > spacing) {
            add(&mut breaks, across);
        }
    }
    breaks
}

/// Puts `across` in its place among the others; there is room for all that may come.
fn add(breaks: &mut Vec<Real, MAX_PIECES>, across: Real) {
    let mut last = across;
    for place in breaks.iter_mut().filter(|place| **place > across) {
        core::mem::swap(place, &mut last);
    }
    // There is room, by `MAX_PIECES`.
    let _ = breaks.push(last);
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
    match scenario.geometry.section {
        Section::Half => [Some(last), None],
        Section::Full => [Some(math::abs(offset + last)), Some(math::abs(offset - last))],
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
