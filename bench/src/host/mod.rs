//! Hosts: whoever makes the steps of a simulation.

mod c_abi;
mod fmu2;
mod fmu3;
mod kernel;
mod library;

use std::time::{Duration, Instant};

pub use c_abi::CAbi;
pub use fmu2::Fmu2;
pub use fmu3::Fmu3;
pub use kernel::Kernel;
pub use library::path as library_path;

/// Makes steps through one of the interfaces.
pub trait Host {
    /// Back to the start of the drop.
    fn restart(&mut self);

    /// Makes `calls` calls of `steps` kernel steps each.
    fn advance(&mut self, calls: u64, steps: u64);

    /// Kernel steps of the whole drop.
    fn steps_of_drop(&self) -> u64;

    /// Digest of the trace so far.
    fn trace_hash(&mut self) -> u64;
}

/// A drop that begins anew when it is over, so that any number of steps can be timed.
pub struct Replay<H> {
    host: H,
    made: u64,
}

impl<H: Host> Replay<H> {
    /// From the start of the drop.
    pub fn new(mut host: H) -> Self {
        host.restart();
        Self { host, made: 0 }
    }

    /// Time of `calls` calls of `steps` kernel steps each; the way back to the start is not in it.
    ///
    /// # Panics
    /// If a call takes more steps than the drop has.
    pub fn time(&mut self, calls: u64, steps: u64) -> Duration {
        let mut total = Duration::ZERO;
        let mut left = calls;
        while left > 0 {
            if self.made + steps > self.host.steps_of_drop() {
                assert!(steps <= self.host.steps_of_drop(), "{steps} steps are more than the drop has");
                self.host.restart();
                self.made = 0;
            }
            let now = left.min((self.host.steps_of_drop() - self.made) / steps);
            let start = Instant::now();
            self.host.advance(now, steps);
            total += start.elapsed();
            self.made += now * steps;
            left -= now;
        }
        total
    }
}

/// Makes the whole drop in calls of `steps` kernel steps, and lowers to the time of each call, s, what `fastest` holds for
/// it. Returns the digest of the trace.
pub fn whole_drop(host: &mut dyn Host, steps: u64, fastest: &mut Vec<f64>) -> u64 {
    host.restart();
    let calls = host.steps_of_drop() / steps;
    fastest.resize(calls as usize, f64::INFINITY);
    for fastest in fastest {
        let start = Instant::now();
        host.advance(1, steps);
        *fastest = fastest.min(start.elapsed().as_secs_f64());
    }
    host.trace_hash()
}
