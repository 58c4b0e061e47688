//! Communication steps.

use core::mem::MaybeUninit;

use super::calls;
use super::types::{self, Boolean, Flag, Float64};
use crate::environment::neutral;
use crate::fmi::foreign::Room;
use crate::fmi::session::{Session, enter};
use crate::fmi::status::Status;
use crate::instance::{Advance, Error, Pause};

/// Where the master wants to know what a step tells besides its status.
struct Answer {
    event_handling_needed: Room<Boolean>,
    terminate_simulation: Room<Boolean>,
    early_return: Room<Boolean>,
    last_successful_time: Room<Float64>,
}

impl Answer {
    /// The places, if all are there.
    fn places(&mut self) -> Option<Places<'_>> {
        Some(Places {
            event_handling_needed: self.event_handling_needed.item()?,
            terminate_simulation: self.terminate_simulation.item()?,
            early_return: self.early_return.item()?,
            last_successful_time: self.last_successful_time.item()?,
        })
    }

    /// Tells that nothing was done, where there is a place for it; refused if one is missing.
    #[cold]
    fn decline(&mut self, session: &Session) -> Result<(), Error> {
        let last_successful_time = session.instance.time();
        let flags = [
            ("eventHandlingNeeded", &mut self.event_handling_needed),
            ("terminateSimulation", &mut self.terminate_simulation),
            ("earlyReturn", &mut self.early_return),
        ];
        let mut missing = None;
        for (argument, room) in flags {
            match room.item() {
                Some(room) => {
                    room.write(false);
                }
                None => missing = Some(argument),
            }
        }
        match self.last_successful_time.item() {
            Some(room) => {
                room.write(last_successful_time);
            }
            None => missing = Some("lastSuccessfulTime"),
        }
        missing.map_or(Ok(()), |argument| Err(Error::Null { argument }))
    }
}

/// The places of an answer.
struct Places<'a> {
    event_handling_needed: &'a mut MaybeUninit<Boolean>,
    terminate_simulation: &'a mut MaybeUninit<Boolean>,
    early_return: &'a mut MaybeUninit<Boolean>,
    last_successful_time: &'a mut MaybeUninit<Float64>,
}

impl Places<'_> {
    /// Tells where a step ended.
    fn write(self, session: &Session, event_handling_needed: bool, early_return: bool) {
        self.event_handling_needed.write(event_handling_needed);
        self.terminate_simulation.write(false);
        self.early_return.write(early_return);
        self.last_successful_time.write(session.instance.time());
    }
}

/// Advances the simulation: to the kernel step nearest to the end of the step, or to the first kernel step at whose end the master, who allows early
/// returns, wants to look at an event or has asked for a return. The last successful time is the end of a step that is
/// complete, else the time of the kernel.
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
    let mut watched = None;
    let status = enter(&mut instance, &calls::DO_STEP, |session| {
        // Nothing happens before every argument is known to be there.
        let Some(places) = answer.places() else { return answer.decline(session) };
        let mut advance = match session.instance.begin_step(current_communication_point, communication_step_size) {
            Ok(advance) => advance,
            Err(error) => return answer.decline(session).and(Err(error)),
        };
        if session.updates.call.is_some() {
            watched = Some(advance);
            return Ok(());
        }
        let made = make(session, &mut advance);
        places.write(session, made == Ok(true), made.is_ok() && !advance.is_complete());
        made.map(|_| ())
    });
    match watched {
        Some(advance) => make_watched(&mut instance, &mut answer, advance),
        None => status,
    }
}

/// Makes kernel steps up to where the instance stops; tells whether the master has to handle an event.
#[inline(always)]
fn make(session: &mut Session, advance: &mut Advance) -> Result<bool, Error> {
    let changed = session.instance.advance(advance, pause(session))?;
    Ok(changed && session.instance.event_mode_used())
}

/// Makes the kernel steps of a master who looks at each.
#[inline(never)]
fn make_watched(instance: &mut types::Instance, answer: &mut Answer, mut advance: Advance) -> Status {
    let (mut event_handling_needed, mut return_at) = (false, f64::INFINITY);
    loop {
        let had_none_left = advance.is_complete();
        let status = enter(instance, &calls::DO_STEP, |session| {
            event_handling_needed |= make(session, &mut advance)?;
            Ok(())
        });
        let returns = status != Status::OK
            || had_none_left
            || wants_return(instance, &advance, event_handling_needed, &mut return_at)
            || advance.is_complete();
        if returns {
            return finish(instance, answer, &advance, event_handling_needed, status);
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

/// Shows an intermediate state to the master, if he asked for it; tells whether the step ends here. `return_at` is the earliest time,
/// s, at which he has wanted that; the whole step nearest to it ends there, as at any time that is asked for.
fn wants_return(instance: &mut types::Instance, advance: &Advance, event: bool, return_at: &mut f64) -> bool {
    let Some(session) = instance.get() else { return true };
    let (updates, allowed) = (session.updates, session.early_return_allowed);
    let (time, half_a_step) = neutral(|| (session.instance.time(), 0.5 * session.instance.time_step()));
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
    if requested != 0 {
        *return_at = return_at.min(until);
    }
    allowed && (event || neutral(|| *return_at < time + half_a_step))
}

/// Tells where a step that was watched ended.
fn finish(
    instance: &mut types::Instance,
    answer: &mut Answer,
    advance: &Advance,
    event_handling_needed: bool,
    status: Status,
) -> Status {
    let (Some(session), Some(places)) = (instance.get(), answer.places()) else { return Status::ERROR };
    let early_return = status == Status::OK && !advance.is_complete();
    neutral(|| places.write(session, event_handling_needed, early_return));
    status
}
