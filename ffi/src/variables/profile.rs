//! Profiles along the surface: arrays, which FMI 3.0 has and FMI 2.0 has not.
//!
//! The points of a profile are spread evenly over the surface at rest, from its first node to its last; values between
//! nodes are interpolated. With as many points as the surface has nodes (`model.surface_nodes`) they are the nodes'.

use softanvil_kernel::contact::surface::{contact_pressure, surface_position};
use softanvil_kernel::{Model, StateView};

/// Points of a profile unless the master says otherwise: the nodes of the preset's surface.
pub const START_POINTS: u64 = 25;

/// Fewest and most points of a profile.
pub const POINTS: (u64, u64) = (2, 10_000);

/// What a profile shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Profile {
    /// Distance from the centre line, m.
    X,
    /// Height above the undeformed anvil's top, m.
    Height,
    /// Contact pressure, Pa.
    ContactPressure,
}

impl Profile {
    /// The value at the node of `column`.
    fn at_node(self, model: &Model, state: &StateView, column: usize) -> f64 {
        let value = match self {
            Self::X => surface_position(model, state, column).map(|position| position[0]),
            Self::Height => surface_position(model, state, column).map(|p| p[1] - model.constants.top_height),
            Self::ContactPressure => contact_pressure(model, state, column),
        };
        value.unwrap_or_default()
    }

    /// The value at `point` of `points`, counted from 0.
    pub fn at(self, model: &Model, state: &StateView, point: u64, points: u64) -> f64 {
        let cells = model.constants.grid.n_u as u64;
        let intervals = points.saturating_sub(1).max(1);
        // Whole numbers, so that a point on a node is exactly there.
        let column = (point * cells / intervals).min(cells);
        let part = (point * cells % intervals) as f64 / intervals as f64;
        let here = self.at_node(model, state, column as usize);
        if part > 0.0 { here + part * (self.at_node(model, state, column as usize + 1) - here) } else { here }
    }
}
