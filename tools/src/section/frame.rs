//! The section at one time: fields of the kernel, copied while the simulation runs.

use softanvil_kernel::state::Scalars;
use softanvil_kernel::{Field, Model, ModelError, Simulation, StateView};

/// Fields at one time.
#[derive(Clone, Debug)]
pub struct Frame {
    /// Simulated time, s.
    pub time: f64,
    /// The numbers that are not arrays.
    pub scalars: Scalars,
    fields: Vec<(&'static str, Vec<f64>)>,
}

impl Frame {
    /// Copies `fields` from the present of `simulation`.
    ///
    /// # Errors
    /// Never in practice, as [`Simulation::with`].
    pub fn take(simulation: &mut Simulation, fields: &[&'static Field]) -> Result<Self, ModelError> {
        let (time, scalars) = (simulation.time(), *simulation.scalars());
        let fields = simulation.with(|model, state| {
            let view = state.as_view();
            fields.iter().map(|field| (field.name, copy(field, model, &view))).collect()
        })?;
        Ok(Self { time, scalars, fields })
    }

    /// Values of the field `name`: row by row, the components of a place together; empty if it was not copied.
    pub fn values(&self, name: &str) -> &[f64] {
        self.fields.iter().find(|(field, _)| *field == name).map_or(&[], |(_, values)| values)
    }

    /// Height of the face above the undeformed top, m.
    pub fn face(&self) -> f64 {
        self.scalars.impactor.position
    }
}

/// Values of `field`, row by row.
fn copy(field: &Field, model: &Model, view: &StateView) -> Vec<f64> {
    let [rows, columns] = field.shape(model);
    let mut values = Vec::with_capacity(rows * columns * field.components);
    for (row, column) in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column))) {
        values.extend((0..field.components).filter_map(|c| field.value(model, view, row, column, c)));
    }
    values
}
