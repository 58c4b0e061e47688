//! How wide the layers are.

use crate::number::real::Real;
use crate::number::real::consts::PI;
use crate::scenario::{Scenario, Shape};

impl Scenario {
    /// Width along the lower side of a layer that went on to the side of the section, m.
    pub(crate) fn whole_width(&self, place: usize) -> Real {
        let lowest = self.layers.first().map_or(0.0, |layer| layer.width);
        match self.geometry.shape {
            Shape::Block => 2.0 * self.half_block_width(),
            Shape::Round => {
                let core = self.geometry.core_radius;
                let radius = core + self.height_below(place);
                if lowest > 0.0 { lowest * (radius / core) } else { PI * radius }
            }
        }
    }

    /// Half of the width of a block, m: that of the geometry, or of the lowest layer.
    pub(crate) fn half_block_width(&self) -> Real {
        let lowest = self.layers.first().map_or(0.0, |layer| layer.width);
        0.5 * if lowest > 0.0 { lowest } else { self.geometry.block_width }
    }

    /// Height of the lower side of a layer above the core at rest, m.
    fn height_below(&self, place: usize) -> Real {
        let below = self.layers.iter().take(place).fold(0.0, |sum, layer| sum + layer.thickness);
        (0..=place).fold(below, |sum, layer| sum + self.gap_below(layer))
    }

    /// Most that the layer `place` may be wide along its lower side, m: as wide as what it lies on.
    pub(crate) fn width_below(&self, place: usize) -> Real {
        let core = match self.geometry.shape {
            Shape::Block => self.geometry.block_width,
            Shape::Round => PI * self.geometry.core_radius,
        };
        let narrow = (1..place).rev().find_map(|layer| {
            let width = self.layers.get(layer)?.width;
            if width > 0.0 { Some(width / self.whole_width(layer)) } else { None }
        });
        if place == 0 { core } else { narrow.unwrap_or(1.0) * self.whole_width(place) }
    }
}
