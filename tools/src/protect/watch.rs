//! What happens within the layers while a drop is simulated: how far each is compressed, and how far stretched.

use softanvil_kernel::{Field, Simulation};

use crate::failure::Failure;
use crate::section::Frame;

/// Extremes of a layer over a run.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Extremes {
    /// Largest compression in the middle of the section, as a part of the thickness at rest.
    pub compression: f64,
    /// Largest principal stretch of a triangle, of a solid of a tetrahedron.
    pub stretch: f64,
}

/// Extremes of all layers, from the core to the surface.
#[derive(Clone, Debug, Default)]
pub struct Watch {
    layers: Vec<Extremes>,
}

const DISPLACEMENT: &str = "node.displacement";
const STRETCH: &str = "element.principal_stretch";
/// Components of a displacement, the vertical one last.
const COMPONENTS: usize = 2;

impl Watch {
    /// Takes the present of `simulation`.
    ///
    /// # Errors
    /// Never in practice, as [`Simulation::with`].
    pub fn take(&mut self, simulation: &mut Simulation) -> Result<(), Failure> {
        let field = |name| Field::find(name).into_iter().collect::<Vec<&'static Field>>();
        let (middle, whole) =
            (Frame::take(simulation, &field(DISPLACEMENT))?, Frame::whole(simulation, &field(STRETCH))?);
        let constants = simulation.constants();
        let (grid, layers) = (&constants.grid, &constants.scenario.layers);
        self.layers.resize(layers.len(), Extremes { compression: 0.0, stretch: 1.0 });
        let height = |row: usize| {
            let node = row * (grid.n_u + 1) + grid.centre;
            middle.values(DISPLACEMENT).get(COMPONENTS * node + 1).copied().unwrap_or_default()
        };
        let row = whole.values(STRETCH).len() / grid.n_v.max(1);
        for (place, (extremes, layer)) in self.layers.iter_mut().zip(layers).enumerate() {
            let rows = grid.rows_of(place);
            // Layers that are not glued have rows of nodes of their own between them.
            let [lower, upper] = [grid.node_row(rows.start), grid.node_row(rows.end.saturating_sub(1)) + 1];
            let compression = (height(lower) - height(upper)) / layer.thickness;
            let stretches = whole.values(STRETCH).get(row * rows.start..row * rows.end).unwrap_or_default();
            extremes.compression = extremes.compression.max(compression);
            extremes.stretch = stretches.iter().fold(extremes.stretch, |largest, stretch| largest.max(*stretch));
        }
        Ok(())
    }

    /// The extremes so far.
    pub fn layers(&self) -> &[Extremes] {
        &self.layers
    }
}
