//! The next impact on the anvil as the last one left it.

use crate::element::{recover, recover_solid};
use crate::error::{ParameterError, StepError};
use crate::material::MaterialModel;
use crate::mesh::TETRAHEDRA;
use crate::model::Model;
use crate::number::real::Real;
use crate::state::{Scalars, SolidState, State};

/// Longest rest between two impacts, s.
pub const LONGEST_REST: Real = 1e9;

impl State<'_> {
    /// Lets the anvil rest for `rest` s, 0 to 10^9, and lifts the impactor, which falls again as at the start: time, samples,
    /// numbers of the test and energies begin anew.
    ///
    /// The anvil keeps its damage: the largest stretch of what tears, the largest energy of what softens. It comes back to its
    /// shape and stands still, without stress in its springs and sliders: what these would hold back is their part in the damping
    /// of an impact, no set that a soft solid keeps. The elastic stress that is left goes back steadily over the rest; overstresses
    /// follow it and decay exactly, by e^(-rest/tau) what they were at its start. Those that are slower than the rest are there at
    /// the next impact. A rest shorter than a step counts as one.
    ///
    /// # Errors
    /// A state that has failed; a rest that is not legal, which changes nothing.
    pub fn next_impact(&mut self, model: &Model, rest: Real) -> Result<(), StepError> {
        if let Some(failure) = self.scalars.failure {
            return Err(failure);
        }
        if !(0.0..=LONGEST_REST).contains(&rest) {
            let error = ParameterError { name: "rest".into(), value: rest, unit: "s", min: 0.0, max: LONGEST_REST };
            return Err(StepError::Input { error, time: self.time(model) });
        }
        let constants = model.constants;
        for (place, layer) in constants.scenario.layers.iter().enumerate() {
            let step = if rest > constants.dt { rest } else { constants.dt };
            self.recover_layer(model, place, &MaterialModel::new(&layer.material, step));
        }
        let solid = core::mem::take(&mut self.nodes.solid);
        for row in self.nodes.all() {
            row.fill(0.0);
        }
        self.nodes.solid = solid;
        SolidState::of(&constants.grid, constants.solid_history_packs, self.nodes.solid).stand_still();
        *self.scalars = Scalars::start(model);
        Ok(())
    }

    /// Lets one layer rest for the time that is the step of `laws`.
    fn recover_layer(&mut self, model: &Model, layer: usize, laws: &MaterialModel) {
        let (grid, axisymmetric) = (&model.constants.grid, model.constants.grid.axisymmetric);
        if grid.is_solid() {
            return self.recover_solid_layer(model, layer, laws);
        }
        let share = (2 * model.constants.n_history_entry()).max(1);
        let entries = self.viscous.chunks_exact_mut(share).map(Some).chain(core::iter::repeat_with(|| None));
        for (block, (history, entries)) in self.cells.iter_mut().zip(entries).enumerate() {
            if grid.layer_of_block(block) == layer {
                recover(laws, axisymmetric, history, entries.unwrap_or_default());
            }
        }
    }

    /// The same in a solid.
    fn recover_solid_layer(&mut self, model: &Model, layer: usize, laws: &MaterialModel) {
        let (grid, packs) = (&model.constants.grid, model.constants.solid_history_packs.max(1));
        let histories = SolidState::of(grid, packs, self.nodes.solid).history;
        for (index, history) in histories.chunks_exact_mut(packs).enumerate() {
            let ([row, _], _) = grid.solid_place(index / TETRAHEDRA);
            if grid.layer_of_row(row) == layer {
                recover_solid(laws, history);
            }
        }
    }
}
