//! Communication steps.

use super::calls;
use super::types::{self, Boolean, Flag, Float64};
use crate::environment::neutral;
use crate::foreign::Room;
use crate::instance::{Advance, Error, Pause};
use crate::session::{Session, Status, enter};

/// What a step tells besides its status.
struct Outcome {
    event_handling_needed: Boolean,
    early_return: Boolean,
    last_successful_time: Float64,
}

/// Where the master wants to know it.
struct Answer {
    event_handling_needed: Room<Boolean>,
    terminate_simulation: Room<Boolean>,
    early_return: Room<Boolean>,
    last_successful_time: Room<Float64>,
}

impl Answer {
    /// Writes every argument; refused, with those that are there written, if one is null.
    fn write(&mut self, outcome: &Outcome) -> Result<(), Error> {
        let flags = [
            ("eventHandlingNeeded", &mut self.event_handling_needed, outcome.event_handling_needed),
            ("terminateSimulation", &mut self.terminate_simulation, false),
            ("earlyReturn", &mut self.early_return, outcome.early_return),
        ];
        let mut missing = None;
        for (argument, room, value) in flags {
            match room.item() {
                Some(room) => {
                    room.write(value);
                }
                None => missing = Some(argument),
            }
        }
        match self.last_successful_time.item() {
            Some(room) => {
                room.write(outcome.last_successful_time);
            }
            None => missing = Some("lastSuccessfulTime"),
        }
        missing.map_or(Ok(()), |argument| Err(Error::Null { argument }))
    }
}

/// Advances the simulation: to the end of the step, or to the first kernel step at whose end the master, who allows early
/// returns, wants to look at an event or has asked for a return.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3DoStep(
    mut instance: types::Instance,
    current_communication_point: Float64,
    communication_step_size: Float64,
    _no_set_fmu_state_prior_to_current_point: Flag,
    event_handling_needed: Room<Boolean>,
    terminate_simulation: Room<Boolean>,
    early_return: Room<Boolean>,
    last_successful_time: Room<Float64>,
) -> Status {
    let mut answer = Answer { event_handling_needed, terminate_simulation, early_return, last_successful_time };
    let mut begun = None;
    // Nothing happens before every argument is known to be there.
    let status = enter(&mut instance, &calls::DO_STEP, |session| {
        let last_successful_time = session.instance.time();
        answer.write(&Outcome { event_handling_needed: false, early_return: false, last_successful_time })?;
        begun = Some(session.instance.begin_step(current_communication_point, communication_step_size)?);
        Ok(())
    });
    let Some(mut advance) = begun else { return status };
    let mut event_handling_needed = false;
    loop {
        let status = enter(&mut instance, &calls::DO_STEP, |session| {
            let changed = session.instance.advance(&mut advance, pause(session))?;
            event_handling_needed |= changed && session.instance.event_mode_used();
            Ok(())
        });
        let returns = status != Status::OK
            || wants_return(&mut instance, &advance, event_handling_needed)
            || advance.is_complete();
        if returns {
            return finish(&mut instance, &mut answer, &advance, event_handling_needed, status);
        }
    }
}

/// Where the instance stops on its way.
fn pause(session: &Session) -> Pause {
    match (session.updates.call, session.instance.event_mode_used() && session.early_return_allowed) {
        (Some(_), _) => Pause::AtSteps,
        (None, true) => Pause::AtEvents,
        (None, false) => Pause::Never,
    }
}

/// Shows an intermediate state to the master, if he asked for it; tells whether the step ends here.
fn wants_return(instance: &mut types::Instance, advance: &Advance, event: bool) -> bool {
    let Some(session) = instance.get() else { return true };
    let (updates, allowed) = (session.updates, session.early_return_allowed);
    let time = neutral(|| session.instance.time());
    let Some(call) = updates.call else { return allowed && event };
    // The callback may read variables: from here to its end nothing borrows the session.
    session.instance.set_intermediate_update(true);
    let (mut requested, mut until) = (0, time);
    let can_return = allowed && !advance.is_complete();
    // SAFETY: the master's own function, with places that live through the call.
    unsafe { call(updates.environment, time, false, true, true, can_return, &raw mut requested, &raw mut until) };
    if let Some(session) = instance.get() {
        session.instance.set_intermediate_update(false);
    }
    allowed && (event || (requested != 0 && until <= time))
}

/// Tells where the step ended.
fn finish(
    instance: &mut types::Instance,
    answer: &mut Answer,
    advance: &Advance,
    event_handling_needed: bool,
    status: Status,
) -> Status {
    let Some(session) = instance.get() else { return Status::ERROR };
    let last_successful_time = neutral(|| session.instance.time());
    let early_return = status == Status::OK && !advance.is_complete();
    let _ = answer.write(&Outcome { event_handling_needed, early_return, last_successful_time });
    status
}
