//! [`Impact`]: the one that is on its way, of several on the same anvil.

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

    /// The next one, which the master asks for, from `start` s on.
    pub fn next(&self, start: f64) -> Self {
        Self { number: self.number.saturating_add(1), start, asked: true }
    }
}

#[cfg(test)]
mod tests;
