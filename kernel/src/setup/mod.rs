//! From a scenario to its model, with the time step that suits it.

mod assembly;
mod construction;
mod numbers;
mod solid_assembly;
mod time_step;
mod trial;
