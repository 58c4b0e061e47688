//! [`StateView`]: a state that does not change, and its fields as arrays.

use std::sync::Arc;

use numpy::ndarray::{ArrayView, Dim, ShapeBuilder};
use numpy::{IntoPyArray, PyArray, PyArray1, PyArray2, PyArrayDyn, PyArrayMethods};
use pyo3::prelude::*;
use softanvil_kernel::mesh::{TETRAHEDRA, solid_position, tetrahedra};
use softanvil_kernel::result::{Location, Source};
use softanvil_kernel::{FIELDS, Field, Output};
use softanvil_tools::section::Mesh;

use crate::error::{self, IntoPython, OrRaise};
use crate::settings::Settings;

/// A model and its state at one time, which stay as they are. Arrays of its fields keep it alive.
#[pyclass(module = "softanvil._softanvil", frozen)]
pub struct StateView {
    /// What is shown: shared with a simulation until that goes on.
    pub state: Arc<softanvil_kernel::Simulation>,
    /// What it was made of.
    pub settings: Settings,
}

/// Points (n, 2), triangles (n, 3) and place of each triangle among the values of a field of triangles (n,); of a solid (n, 3),
/// and tetrahedra (n, 4).
type MeshArrays<'py> = (Bound<'py, PyArray2<f64>>, Bound<'py, PyArray2<usize>>, Bound<'py, PyArray1<usize>>);

/// What makes another one like it, and with what.
type Reduced = (Py<PyAny>, (Settings, Vec<u8>));

#[pymethods]
impl StateView {
    /// Simulated time, s.
    #[getter]
    fn time(&self) -> f64 {
        self.state.time()
    }

    /// The output called `name`, in SI.
    fn output(&self, py: Python<'_>, name: &str) -> PyResult<f64> {
        output(py, &self.state, name)
    }

    /// A field as an array: of what lies in memory without a copy, and read-only.
    fn field<'py>(slf: &Bound<'py, Self>, name: &str) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let py = slf.py();
        let field = Field::find(name).ok_or_else(|| {
            let names: Vec<_> = FIELDS.iter().map(|field| field.name).collect();
            error::scenario(py, format!("field {name:?} is unknown: expected {}", names.join(", ")))
        })?;
        match field.source {
            Source::Stored(_) if !slf.get().is_solid() => stored(slf, field),
            _ => computed(slf, field),
        }
    }

    /// Whether it is a solid, and no section.
    #[getter]
    fn is_solid(&self) -> bool {
        self.state.constants().grid.is_solid()
    }

    /// Positions of the nodes at rest (n, 2), m, nodes of the triangles (n, 3), and places of these among the values of a field
    /// of triangles (n,). Of a solid positions (n, 3) and nodes of the tetrahedra (n, 4).
    fn mesh<'py>(&self, py: Python<'py>) -> PyResult<MeshArrays<'py>> {
        if self.is_solid() {
            return self.solid_mesh(py);
        }
        let mesh = Mesh::of(&self.state).or_raise(py)?;
        let points: Vec<f64> = mesh.reference.iter().flatten().copied().collect();
        let corners: Vec<usize> = mesh.triangles.iter().flatten().copied().collect();
        Ok((
            points.into_pyarray(py).reshape([mesh.reference.len(), 2])?,
            corners.into_pyarray(py).reshape([mesh.triangles.len(), 3])?,
            mesh.places.into_pyarray(py),
        ))
    }

    /// Outline of what is drawn of the impactor (n, 2), m, from its axis and its lowest point.
    fn impactor<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let outline = Mesh::of(&self.state).or_raise(py)?.impactor();
        outline.iter().flatten().copied().collect::<Vec<_>>().into_pyarray(py).reshape([outline.len(), 2])
    }

    /// Distance of the impactor's axis from the centre line, to the right, m.
    #[getter]
    fn offset(&self) -> f64 {
        self.state.constants().scenario.impactor.offset
    }

    /// Whether only the right half of a section is meshed.
    #[getter]
    fn is_half(&self, py: Python<'_>) -> PyResult<bool> {
        Ok(Mesh::of(&self.state).or_raise(py)?.is_half())
    }

    fn __reduce__(&self, py: Python<'_>) -> PyResult<Reduced> {
        let bytes = softanvil_kernel::Simulation::clone(&self.state).save().or_raise(py)?;
        Ok((py.get_type::<Self>().getattr("of_bytes")?.unbind(), (self.settings.clone(), bytes)))
    }

    /// The state that `bytes` hold, of the model of `settings`.
    #[staticmethod]
    fn of_bytes(py: Python<'_>, settings: Settings, bytes: Vec<u8>) -> PyResult<Self> {
        let scenario = settings.scenario().map_err(|error| error.into_python(py))?;
        let mut state = softanvil_kernel::Simulation::new(&scenario).or_raise(py)?;
        state.restore(&bytes).or_raise(py)?;
        Ok(Self { state: Arc::new(state), settings })
    }
}

impl StateView {
    /// Nodes and tetrahedra of a solid, in the order of its fields: rows from the core to the surface, slices of a row.
    fn solid_mesh<'py>(&self, py: Python<'py>) -> PyResult<MeshArrays<'py>> {
        let constants = self.state.constants();
        let (grid, columns) = (&constants.grid, constants.grid.n_u + 1);
        let places = |rows: usize, slices: usize, columns: usize| {
            let row = move |v| (0..slices).flat_map(move |w| (0..columns).map(move |u| [u, v, w]));
            (0..rows).flat_map(row)
        };
        let position = |place| solid_position(&constants.scenario, grid, place);
        let points: Vec<f64> = places(grid.node_rows(), grid.node_slices(), columns).flat_map(position).collect();
        let number = |[u, v, w]: [usize; 3]| (v * grid.node_slices() + w) * columns + u;
        let cells: Vec<_> = places(grid.n_v, grid.n_w, grid.n_u)
            .enumerate()
            .filter(|(_, [u, v, w])| grid.has_cell(*u, *v, *w))
            .collect();
        let of_cells = cells.iter().flat_map(|(cell, _)| (0..TETRAHEDRA).map(move |t| TETRAHEDRA * cell + t));
        let elements: Vec<usize> = of_cells.collect();
        let tetrahedra = cells.iter().flat_map(|(_, place)| tetrahedra(grid, *place));
        let position = |node: usize| [0, 1, 2].map(|axis| points[3 * node + axis]);
        let corners: Vec<usize> = tetrahedra.flat_map(|cell| right_handed(cell.map(number), position)).collect();
        Ok((
            points.into_pyarray(py).reshape([grid.node_rows() * grid.node_slices() * columns, 3])?,
            corners.into_pyarray(py).reshape([elements.len(), 4])?,
            elements.into_pyarray(py),
        ))
    }
}

/// The nodes of a tetrahedron in the order that gives it a positive volume.
fn right_handed([a, b, c, d]: [usize; 4], position: impl Fn(usize) -> [f64; 3]) -> [usize; 4] {
    let edge = |node| [0, 1, 2].map(|axis| position(node)[axis] - position(a)[axis]);
    let [[x1, y1, z1], [x2, y2, z2], [x3, y3, z3]] = [b, c, d].map(edge);
    let volume = x1 * (y2 * z3 - z2 * y3) - y1 * (x2 * z3 - z2 * x3) + z1 * (x2 * y3 - y2 * x3);
    if volume < 0.0 { [a, b, d, c] } else { [a, b, c, d] }
}

/// The output called `name` of `state`.
///
/// # Errors
/// That there is none, with those that there are.
pub fn output(py: Python<'_>, state: &softanvil_kernel::Simulation, name: &str) -> PyResult<f64> {
    Ok((find_output(py, name)?.read)(state.constants(), state.scalars()))
}

/// The output called `name`.
///
/// # Errors
/// That there is none, with those that there are.
pub fn find_output(py: Python<'_>, name: &str) -> PyResult<&'static Output> {
    Output::find(name).ok_or_else(|| {
        let names: Vec<_> = softanvil_kernel::OUTPUTS.iter().map(|output| output.name).collect();
        error::scenario(py, format!("output {name:?} is unknown: expected {}", names.join(", ")))
    })
}

/// Where the numbers of a stored field lie: the address of the first, and numbers from one row, column and component to the next.
struct Layout {
    first: *const f64,
    shape: [usize; 3],
    strides: [usize; 3],
}

/// An array over the memory of the state, which the array keeps alive.
fn stored<'py>(owner: &Bound<'py, StateView>, field: &Field) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    let py = owner.py();
    let layout = owner.get().state.read(|model, view| {
        let [rows, columns] = field.shape(model);
        let [first, second] = [field.strided(model, view, 0)?, field.strided(model, view, 1)?];
        let apart = (second.data.as_ptr() as usize).checked_sub(first.data.as_ptr() as usize)? / size_of::<f64>();
        Some(Layout { first: first.data.as_ptr(), shape: [rows, columns, 2], strides: [first.row_stride, 1, apart] })
    });
    let Some(layout) = layout.or_raise(py)? else { return computed(owner, field) };
    // SAFETY: both components lie in one array of the state, the second behind the first, with so many rows and columns each
    // (`Field::strided`). The state is never changed as long as it is shared, and the array shares it through its owner.
    let array = unsafe {
        let view = ArrayView::from_shape_ptr(Dim(layout.shape).strides(Dim(layout.strides)), layout.first);
        PyArray::borrow_from_array(&view, owner.clone().into_any())
    };
    array.readwrite().make_nonwriteable();
    shaped(array.to_dyn(), field)
}

/// A new array of the values.
fn computed<'py>(owner: &Bound<'py, StateView>, field: &Field) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    let py = owner.py();
    let state = &owner.get().state;
    let values = py.detach(|| {
        state.read(|model, view| {
            let [rows, columns] = field.shape(model);
            let mut values = Vec::with_capacity(rows * columns * field.components);
            for row in 0..rows {
                for column in 0..columns {
                    for component in 0..field.components {
                        values.push(field.value(model, view, row, column, component).unwrap_or(f64::NAN));
                    }
                }
            }
            ([rows, columns, field.components], values)
        })
    });
    let (shape, values) = values.or_raise(py)?;
    shaped(values.into_pyarray(py).reshape(shape)?.to_dyn(), field)
}

/// Without the axis of rows of a surface that has one row, and that of components of what has one.
fn shaped<'py>(array: &Bound<'py, PyArrayDyn<f64>>, field: &Field) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    let mut array = array.clone().into_any();
    if field.components == 1 {
        array = array.call_method1("squeeze", (2,))?;
    }
    if field.location == Location::Surface && array.getattr("shape")?.get_item(0)?.extract::<usize>()? == 1 {
        array = array.call_method1("squeeze", (0,))?;
    }
    Ok(array.cast_into()?)
}
