//! [`Impact`]: the one that is on its way, of several on the same anvil.

use super::clock::Clock;
use super::{Error, Instance};

/// One impact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Impact {
    /// Its number, from 1.
    pub number: u32,
    /// The kernel's time when it began, in the master's terms, s. The kernel counts from there.
    pub start: f64,
    /// Whether the master asked for the next one when the last communication step began. What is asked for from the start
    /// of the experiment on is not another impact.
    pub asked: bool,
}

impl Impact {
    /// The first one, in an experiment from `start` s on.
    pub fn first(start: f64) -> Self {
        Self { number: 1, start, asked: false }
    }
}

impl Instance {
    /// The number of the impact that is on its way, from 1.
    pub fn impact_number(&self) -> u32 {
        self.impact.number
    }

    /// Lets the next impact begin if it is asked for since the last step; the master's clock is `clock`.
    pub(super) fn follow_request(&mut self, clock: &Clock) -> Result<(), Error> {
        let asked = self.inputs.next_impact;
        if asked && !self.impact.asked {
            let Some(simulation) = &mut self.simulation else { return Err(Error::Call { mode: self.mode }) };
            let start = clock.kernel_time(simulation.constants().dt, self.impact.start + simulation.time());
            simulation.next_impact(self.inputs.rest).map_err(Error::Step)?;
            self.impact = Impact { number: self.impact.number.saturating_add(1), start, asked };
        }
        self.impact.asked = asked;
        Ok(())
    }
}

#[cfg(test)]
mod tests;
