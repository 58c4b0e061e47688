//! [`Simulation`]: a drop, or a driven face, step by step.

use std::sync::Arc;

use numpy::{IntoPyArray, PyArray2, PyArrayMethods, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use softanvil_kernel::state::state_digest;
use softanvil_kernel::{StepError, StepInput};

use crate::error::OrRaise;
use crate::field::{StateView, find_output, output};
use crate::interrupt::interruptible;
use crate::settings::Settings;

/// A simulation that goes on by hand.
#[pyclass(module = "softanvil._softanvil")]
pub struct Simulation {
    /// Shared with the arrays of its fields: the next step makes a copy then.
    state: Arc<softanvil_kernel::Simulation>,
    settings: Settings,
}

impl Simulation {
    /// The state to change.
    fn own(&mut self) -> &mut softanvil_kernel::Simulation {
        Arc::make_mut(&mut self.state)
    }
}

/// Steps between two looks at whether they are still wanted.
const CHUNK: u64 = 20_000;

#[pymethods]
impl Simulation {
    /// The start of the drop of `settings`.
    #[new]
    fn new(py: Python<'_>, settings: Settings) -> PyResult<Self> {
        let scenario = settings.scenario().or_raise(py)?;
        let state = py.detach(|| softanvil_kernel::Simulation::new(&scenario)).or_raise(py)?;
        Ok(Self { state: Arc::new(state), settings })
    }

    /// One that goes on from `view`.
    #[staticmethod]
    fn of_view(view: &StateView) -> Self {
        Self { state: Arc::clone(&view.state), settings: view.settings.clone() }
    }

    /// What is simulated.
    #[getter]
    fn settings(&self) -> Settings {
        self.settings.clone()
    }

    /// Simulated time, s.
    #[getter]
    fn time(&self) -> f64 {
        self.state.time()
    }

    /// Simulated time after so many steps, s.
    fn time_of(&self, step_index: u64) -> f64 {
        self.state.constants().time(step_index)
    }

    /// Steps made.
    #[getter]
    fn step_index(&self) -> u64 {
        self.state.scalars().step_index
    }

    /// Time step, s.
    #[getter]
    fn dt(&self) -> f64 {
        self.state.constants().dt
    }

    /// Steps in a sampling interval of 50 us.
    #[getter]
    fn steps_per_sample(&self) -> u32 {
        self.state.constants().steps_per_sample
    }

    /// Steps that cover `duration` s, in whole sampling intervals.
    fn steps_in(&self, duration: f64) -> u64 {
        self.state.constants().steps_in(duration)
    }

    /// Fingerprint of the force samples so far.
    #[getter]
    fn trace_hash(&self) -> String {
        format!("{:016x}", self.state.scalars().sampler.trace_hash)
    }

    /// Fingerprint of the whole state.
    fn digest(&mut self, py: Python<'_>) -> PyResult<String> {
        let digest = self.own().with(|model, state| state_digest(model, state)).or_raise(py)?;
        Ok(format!("{digest:016x}"))
    }

    /// The output called `name`, in SI.
    fn output(&self, py: Python<'_>, name: &str) -> PyResult<f64> {
        output(py, &self.state, name)
    }

    /// The state as it is now, which does not change when the simulation goes on.
    fn view(&self) -> StateView {
        StateView { state: Arc::clone(&self.state), settings: self.settings.clone() }
    }

    /// Makes `n` steps. Ctrl-C ends many of a falling or resting face early.
    fn step(
        &mut self,
        py: Python<'_>,
        n: u64,
        external_force: f64,
        position: Option<f64>,
        velocity: Option<f64>,
    ) -> PyResult<()> {
        let input = StepInput { external_force, driven_position: position, driven_velocity: velocity };
        let state = self.own();
        if n <= CHUNK || position.is_some() || velocity.is_some() {
            // One call is one way of the face.
            return py.detach(|| state.step(n, &input)).or_raise(py);
        }
        interruptible(py, |stop| {
            let mut left = n;
            while left > 0 && !stop.load(std::sync::atomic::Ordering::Relaxed) {
                let now = left.min(CHUNK);
                state.step(now, &input)?;
                left -= now;
            }
            Ok::<_, StepError>(())
        })?
        .or_raise(py)
    }

    /// Makes `n` steps for every row of the inputs, and gives the `names` outputs after each, (rows, names).
    fn step_rows<'py>(
        &mut self,
        py: Python<'py>,
        n: u64,
        external_force: PyReadonlyArray1<'py, f64>,
        position: Option<PyReadonlyArray1<'py, f64>>,
        velocity: Option<PyReadonlyArray1<'py, f64>>,
        names: Vec<String>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let outputs = names.iter().map(|name| find_output(py, name)).collect::<PyResult<Vec<_>>>()?;
        let force = external_force.as_slice()?;
        let optional = |array: &Option<PyReadonlyArray1<'py, f64>>| {
            array.as_ref().map(|array| array.as_slice().map(<[f64]>::to_vec)).transpose()
        };
        let (position, velocity) = (optional(&position)?, optional(&velocity)?);
        if [&position, &velocity].into_iter().flatten().any(|array| array.len() != force.len()) {
            return Err(PyValueError::new_err("inputs of one call have the same length"));
        }
        let force = force.to_vec();
        let (rows, columns) = (force.len(), outputs.len());
        let state = self.own();
        let values = interruptible(py, |stop| {
            let mut values = Vec::with_capacity(rows * columns);
            for (row, external_force) in force.into_iter().enumerate() {
                if stop.load(std::sync::atomic::Ordering::Relaxed) {
                    break;
                }
                let of_row = |array: &Option<Vec<f64>>| array.as_ref().map(|array| array[row]);
                let (driven_position, driven_velocity) = (of_row(&position), of_row(&velocity));
                state.step(n, &StepInput { external_force, driven_position, driven_velocity })?;
                values.extend(outputs.iter().map(|output| (output.read)(state.constants(), state.scalars())));
            }
            Ok::<_, StepError>(values)
        })?;
        values.or_raise(py)?.into_pyarray(py).reshape([rows, columns])
    }

    /// Lets the anvil rest for `rest` s, and the impactor fall again.
    fn next_impact(&mut self, py: Python<'_>, rest: f64) -> PyResult<()> {
        self.own().next_impact(rest).or_raise(py)
    }

    /// Back to the start.
    fn reset(&mut self, py: Python<'_>) -> PyResult<()> {
        self.own().reset().or_raise(py)
    }

    /// The state as bytes.
    fn save<'py>(&mut self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        Ok(PyBytes::new(py, &self.own().save().or_raise(py)?))
    }

    /// Goes on from the state that `bytes` hold.
    fn restore(&mut self, py: Python<'_>, bytes: &[u8]) -> PyResult<()> {
        self.own().restore(bytes).or_raise(py)
    }
}
