//! The monitor of the step's stability: what tells in time that a step was too large.

use crate::element::Block;
use crate::error::StepError;
use crate::model::Model;
use crate::number::math;
use crate::number::pack::LANES;
use crate::number::real::Real;
use crate::number::vector::Simd;
use crate::state::{EnergyBalance, State};
use crate::step::stable_step::{Look, critical_time_step};
use crate::step::window::MonitorWindow;

/// Compares the step with the current limit of this step's share of the cells, as the internal forces have found them: the
/// same number in every step, so that all have had their turn after [`MONITOR_PERIOD`] steps at most.
///
/// # Errors
/// The cell with the smallest limit, where that of one of them is below the step.
#[inline(always)]
pub(crate) fn check<S: Simd>(simd: S, model: &Model, state: &State) -> Result<(), StepError> {
    let share = MonitorWindow::new(model.cells.len() * LANES, state.scalars.step_index);
    let squared = model.constants.dt * model.constants.dt;
    for turn in 0..share.count {
        let (index, start) = (share.cell(turn) / LANES, share.cell(turn) % LANES);
        let (Some(constants), Some(history)) = (model.cells.get(index), state.cells.get(index)) else { continue };
        let block = Block { laws: model.constants.laws_of(index), constants, hoop: model.hoops.get(index) };
        for chunk in start / S::WIDTH..(start + share.group).div_ceil(S::WIDTH) {
            let look = Look { chunk, block, history, squared, find: false };
            let Some(lost) = simd.apart(look) else { continue };
            let (first, end) = (start.max(chunk * S::WIDTH), (start + share.group).min((chunk + 1) * S::WIDTH));
            if lost.get(first..end).unwrap_or_default().iter().any(|lost| *lost > 0.0) {
                return Err(failure(model, state));
            }
        }
    }
    Ok(())
}

/// The error of the cell with the smallest limit.
#[cold]
#[inline(never)]
pub(super) fn failure(model: &Model, state: &State) -> StepError {
    let (limit, element) = critical_time_step(model, state);
    let constants = &model.constants;
    StepError::Unstable { element, time: constants.time(state.scalars.step_index), limit, step: constants.dt }
}

/// Part of the energy at hand that the kinetic energy of the layer may be below zero. Catching nodes at the face brings it
/// there for one step, by the energy of single nodes.
const NEGATIVE_PART: Real = 0.01;

/// Looks for an instability that grows between two visits of the monitor.
///
/// A mode above its limit turns round in every step, so that its kinetic energy 1/2 m v(n-1/2) v(n+1/2) is negative and
/// grows, which nothing else does in two steps running. The balance still holds the last step's; `layer_kinetic` is that of
/// this one, J.
///
/// # Errors
/// The cell with the smallest limit.
#[inline(always)]
pub(crate) fn guard(model: &Model, state: &State, layer_kinetic: Real) -> Result<(), StepError> {
    if grows(&state.scalars.energy, layer_kinetic) {
        return Err(failure(model, state));
    }
    Ok(())
}

/// Whether the kinetic energies of this step and of the last, which `balance` holds, are below zero by more than those of single
/// nodes.
#[inline(always)]
fn grows(balance: &EnergyBalance, layer_kinetic: Real) -> bool {
    let before = balance.at_forces.kinetic;
    if layer_kinetic >= 0.0 || before >= 0.0 {
        return false;
    }
    let at_hand = math::abs(balance.external) + math::abs(balance.elastic) + math::abs(balance.viscous);
    let least = -math::max(layer_kinetic, before);
    least > NEGATIVE_PART * at_hand && least > Real::EPSILON
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_kinetic_energies_below_zero_in_two_steps_running_are_an_instability() {
        let balance = |layer_kinetic, external| {
            let mut balance = EnergyBalance::ZERO;
            (balance.at_forces.kinetic, balance.external) = (layer_kinetic, external);
            balance
        };
        // A mode that doubles in every step; a node that was caught; round-off.
        for (before, now, expected) in
            [(-0.2, -0.4, true), (0.3, -0.4, false), (-0.4, 0.1, false), (-0.11, -0.4, false), (-1e-17, -1e-17, false)]
        {
            assert_eq!(grows(&balance(before, 12.0), now), expected, "{before} J, then {now} J");
        }
        // Nothing but round-off is at hand.
        assert!(!grows(&balance(-1e-20, 0.0), -1e-20));
    }
}
