//! The length with which a section in plane strain bears what the solid does.
//!
//! Under a round face a slice of the section is as thick as the face is long there, but at most `geometry.length`. So a smaller
//! length takes off what lies under the ends of the face, from which the rubber of a solid escapes.

use softanvil_kernel::Scenario;
use softanvil_kernel::scenario::{FaceShape, Shape};

use crate::run::{RunError, Until};
use crate::sweep::case::Outcome;

/// Part of the force by which the section may miss the solid.
const TOLERANCE: f64 = 1e-4;
/// Simulations at most; the force changes smoothly with the length, but for what a changed time step does.
const MOST: usize = 20;
/// Smallest part of the widest slice that is tried.
const SMALLEST: f64 = 0.25;

/// What came of the search.
#[derive(Debug)]
pub enum Found {
    /// A length, m, and the section of it.
    Length(f64, Box<Outcome>),
    /// None: the solid bears more than a section of its whole length. The nearest is that of the widest slice, m.
    SolidBearsMore(f64),
    /// None down to a quarter of the widest slice: the solid bears less.
    SolidBearsLess,
}

impl Found {
    /// The length, m, if there is one.
    pub fn length(&self) -> Option<f64> {
        if let Self::Length(length, _) = self { Some(*length) } else { None }
    }

    /// The length, m, or the nearest to it.
    pub fn nearest(&self) -> Option<f64> {
        match self {
            Self::Length(length, _) | Self::SolidBearsMore(length) => Some(*length),
            Self::SolidBearsLess => None,
        }
    }
}

/// The length at which the section of `scenario`, which has come to `whole` with all of it, has the force `wanted` in N.
///
/// The method of false position after Illinois, which halves the value at an end that stays (Dowell and Jarratt, 1971).
///
/// # Errors
/// A section that is refused or fails.
pub fn find(scenario: &Scenario, until: Until, whole: &Outcome, wanted: f64) -> Result<Found, RunError> {
    let excess = |outcome: &Outcome| outcome.force() / wanted - 1.0;
    let of = |length: f64| {
        let mut scenario = scenario.clone();
        scenario.geometry.length = length;
        Outcome::simulate(&scenario, until)
    };
    let (mut long, mut above) = (widest(scenario), excess(whole));
    if above < -TOLERANCE {
        return Ok(Found::SolidBearsMore(long));
    }
    let mut short = SMALLEST * long;
    let mut below = excess(&of(short)?);
    if below > TOLERANCE {
        return Ok(Found::SolidBearsLess);
    }
    let mut was_above = None;
    let mut tried = 0;
    loop {
        let length = (short * above - long * below) / (above - below);
        let section = of(length)?;
        let value = excess(&section);
        tried += 1;
        if value.abs() <= TOLERANCE || tried == MOST {
            return Ok(Found::Length(length, Box::new(section)));
        }
        let is_above = value > 0.0;
        let weight = if was_above == Some(is_above) { 0.5 } else { 1.0 };
        if is_above {
            (long, above, below) = (length, value, weight * below);
        } else {
            (short, below, above) = (length, value, weight * above);
        }
        was_above = Some(is_above);
    }
}

/// Thickness of the widest slice, m: more than that no slice takes of a length.
fn widest(scenario: &Scenario) -> f64 {
    let (geometry, impactor) = (&scenario.geometry, &scenario.impactor);
    let covered = match impactor.shape {
        FaceShape::Rectangular | FaceShape::Bar => impactor.face_length,
        FaceShape::Round | FaceShape::Sphere if geometry.shape == Shape::Block => geometry.length,
        FaceShape::Round | FaceShape::Sphere => impactor.face_diameter,
    };
    covered.min(geometry.length)
}
