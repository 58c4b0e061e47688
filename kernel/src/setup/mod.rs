//! From a scenario to its model, with the time step that suits it.

mod assembly;
mod construction;
mod time_step;
mod trial;
