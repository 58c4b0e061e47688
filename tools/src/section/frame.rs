//! The section at one time: fields of the kernel, copied while the simulation runs.

use softanvil_kernel::mesh::TETRAHEDRA;
use softanvil_kernel::result::Location;
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

    /// The same of the whole of a solid.
    ///
    /// # Errors
    /// As [`Self::take`].
    pub fn whole(simulation: &mut Simulation, fields: &[&'static Field]) -> Result<Self, ModelError> {
        let (time, scalars) = (simulation.time(), *simulation.scalars());
        let fields = simulation.with(|model, state| {
            let view = state.as_view();
            let values =
                |field: &&'static Field| (field.name, copy_places(field, model, &view, field.shape(model), &|at| at));
            fields.iter().map(values).collect()
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

/// Values of `field`, row by row, of a solid those in the plane z = 0.
fn copy(field: &Field, model: &Model, view: &StateView) -> Vec<f64> {
    let grid = &model.constants.grid;
    if !grid.is_solid() {
        return copy_places(field, model, view, field.shape(model), &|at| at);
    }
    let (slices, centre) = (grid.node_slices(), grid.centre_w);
    match field.location {
        Location::Node => {
            let shape = [grid.node_rows(), grid.n_u + 1];
            copy_places(field, model, view, shape, &|[row, column]| [row * slices + centre, column])
        }
        Location::Surface => copy_places(field, model, view, [1, grid.n_u + 1], &|[_, column]| [centre, column]),
        Location::Element => copy_places(field, model, view, [grid.n_v, 2 * grid.n_u], &|[row, column]| {
            // The tetrahedra that have a face in the plane, below the diagonal and above it.
            [row * grid.n_w + centre, TETRAHEDRA * (column / 2) + if column % 2 == 0 { 2 } else { 0 }]
        }),
    }
}

/// Values of `field` in rows and columns of this `shape`, each from the `place` of its row and column.
fn copy_places(
    field: &Field,
    model: &Model,
    view: &StateView,
    [rows, columns]: [usize; 2],
    place: &dyn Fn([usize; 2]) -> [usize; 2],
) -> Vec<f64> {
    let mut values = Vec::with_capacity(rows * columns * field.components);
    for at in (0..rows).flat_map(|row| (0..columns).map(move |column| [row, column])) {
        let [row, column] = place(at);
        values.extend((0..field.components).filter_map(|c| field.value(model, view, row, column, c)));
    }
    values
}
