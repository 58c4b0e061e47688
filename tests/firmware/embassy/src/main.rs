//! The study's drop with 14.7 J as a task of Embassy beside others: one task simulates an interval of the force's samples at a time and
//! lets the others run, another one takes the samples. The bits are those of the golden trace, however the tasks take turns.

#![no_std]
#![no_main]

use embassy_executor::Spawner;
use embassy_futures::yield_now;
use embassy_sync::{blocking_mutex::raw::ThreadModeRawMutex, channel::Channel};
use semihosting::println;
use softanvil_firmware::{anvil, end};
use softanvil_golden::Scene;
use softanvil_kernel::number::real::Real;
use softanvil_kernel::state::state_digest;
use softanvil_kernel::{Model, State, StepInput, steps};

/// What one task tells the other.
enum Message {
    /// Contact force at the end of a sampling interval, N.
    Force(Real),
    /// The drop is over; the digest of its last state.
    End(u64),
}

/// A task that is slower than the simulation holds it up, and loses nothing.
static MESSAGES: Channel<ThreadModeRawMutex, Message, 1> = Channel::new();

#[embassy_executor::task]
async fn simulate(model: Model<'static>, mut state: State<'static>) {
    let last = model.constants.steps_in(model.constants.scenario.time.duration);
    let stride = u64::from(model.constants.steps_per_sample);
    while state.scalars.step_index < last {
        steps(&model, &mut state, stride, &StepInput::default()).unwrap();
        MESSAGES.send(Message::Force(state.scalars.force.contact)).await;
    }
    MESSAGES.send(Message::End(state_digest(&model, &state))).await;
}

/// What else a board does.
#[embassy_executor::task]
async fn blink(turns: &'static core::sync::atomic::AtomicU32) {
    loop {
        turns.fetch_add(1, core::sync::atomic::Ordering::Relaxed);
        yield_now().await;
    }
}

#[embassy_executor::main]
async fn main(spawner: Spawner) {
    static TURNS: core::sync::atomic::AtomicU32 = core::sync::atomic::AtomicU32::new(0);
    let scene = Scene::find("drop-14.7-J").unwrap();
    let (model, state) = anvil::build(&(scene.scenario)());
    spawner.spawn(simulate(model, state).unwrap());
    spawner.spawn(blink(&TURNS).unwrap());
    let (mut peak, mut samples) = (0.0, 0);
    let digest = loop {
        match MESSAGES.receive().await {
            Message::Force(force) => (peak, samples) = (if force > peak { force } else { peak }, samples + 1),
            Message::End(digest) => break digest,
        }
    };
    let turns = TURNS.load(core::sync::atomic::Ordering::Relaxed);
    println!("largest sample {peak:.1} N of {samples}, another task had {turns} turns");
    println!("state {digest:016x}");
    let same = Some(digest) == scene.last_state() && turns > 0;
    println!("{}", if same { "the bits of the golden trace" } else { "DIFFERENT from the golden trace" });
    end(same)
}
