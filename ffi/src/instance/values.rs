//! Reading and setting variables.

use softanvil_kernel::{Scenario, Simulation};

use super::{Error, Instance, Mode};
use crate::variables::{Inputs, Source, ValueType, Variable};

/// Length of a trace hash in hexadecimal digits.
pub const HASH_DIGITS: usize = 16;

impl Instance {
    /// The simulation, if it belongs to the current scenario and experiment.
    pub(super) fn simulation_at_work(&self) -> Option<&Simulation> {
        match self.mode {
            Mode::Instantiated | Mode::Initialization => None,
            Mode::Step | Mode::Terminated | Mode::Failed => self.simulation.as_ref(),
        }
    }

    /// The simulation whose results are current; in initialization mode that of the scenario as it stands.
    fn results(&mut self) -> Result<&Simulation, Error> {
        if self.mode == Mode::Initialization {
            return self.prepare().map(|simulation| &*simulation);
        }
        self.simulation_at_work().ok_or(Error::Call { mode: self.mode })
    }

    fn variable(&self, reference: u32) -> Result<Variable, Error> {
        self.table.find(reference).copied().ok_or(Error::Unknown { reference })
    }

    /// A quantity.
    ///
    /// # Errors
    /// An unknown reference, another type, or a scenario that cannot be simulated.
    pub fn real(&mut self, reference: u32) -> Result<f64, Error> {
        let variable = self.variable(reference)?;
        let ValueType::Real { .. } = variable.value else { return Err(wrong_type(&variable, "Real")) };
        match variable.source {
            Source::Time => Ok(self.time()),
            Source::Parameter(parameter) => Ok(parameter.get(&self.scenario)),
            Source::Input(input) => Ok(*(input.field)(&mut self.inputs)),
            Source::Output(output) => {
                let simulation = self.results()?;
                Ok((output.read)(simulation.constants(), simulation.scalars()))
            }
            _ => Ok(self.results()?.constants().dt),
        }
    }

    /// A count, or a choice by its number.
    ///
    /// # Errors
    /// As [`Instance::real`].
    pub fn integer(&mut self, reference: u32) -> Result<i32, Error> {
        let variable = self.variable(reference)?;
        match (variable.value, variable.source) {
            (ValueType::Enumeration { .. }, Source::Parameter(parameter)) => Ok(parameter.get(&self.scenario) as i32),
            (ValueType::Integer, _) => Ok(self.results()?.constants().grid.n_elem() as i32),
            _ => Err(wrong_type(&variable, "Integer")),
        }
    }

    /// A state.
    ///
    /// # Errors
    /// As [`Instance::real`].
    pub fn boolean(&mut self, reference: u32) -> Result<bool, Error> {
        let variable = self.variable(reference)?;
        let ValueType::Boolean = variable.value else { return Err(wrong_type(&variable, "Boolean")) };
        Ok(self.results()?.scalars().force.contact > 0.0)
    }

    /// A text: the trace hash in lower-case hexadecimal digits.
    ///
    /// # Errors
    /// As [`Instance::real`].
    pub fn text(&mut self, reference: u32) -> Result<[u8; HASH_DIGITS], Error> {
        let variable = self.variable(reference)?;
        let ValueType::String = variable.value else { return Err(wrong_type(&variable, "String")) };
        Ok(hexadecimal(self.results()?.scalars().sampler.trace_hash))
    }

    /// Sets quantities: all of them, or none if one is refused.
    ///
    /// # Errors
    /// An unknown reference, another type, a variable that cannot be set now, or a value out of range.
    pub fn set_reals(&mut self, values: impl Iterator<Item = (u32, f64)>) -> Result<(), Error> {
        self.set(values, |value| matches!(value, ValueType::Real { .. }), "Real")
    }

    /// Sets choices: all of them, or none if one is refused.
    ///
    /// # Errors
    /// As [`Instance::set_reals`].
    pub fn set_integers(&mut self, values: impl Iterator<Item = (u32, i32)>) -> Result<(), Error> {
        let values = values.map(|(reference, value)| (reference, f64::from(value)));
        self.set(values, |value| matches!(value, ValueType::Enumeration { .. } | ValueType::Integer), "Integer")
    }

    /// Refuses to set what no variable of type `asked` allows.
    ///
    /// # Errors
    /// Always: an unknown reference, another type, or a variable that cannot be set.
    pub fn refuse_to_set(&self, reference: u32, asked: &'static str) -> Error {
        match self.variable(reference) {
            Err(unknown) => unknown,
            Ok(variable) if variable.value.name() != asked => wrong_type(&variable, asked),
            Ok(variable) => read_only(&variable),
        }
    }

    fn set(
        &mut self,
        values: impl Iterator<Item = (u32, f64)>,
        fits: impl Fn(&ValueType) -> bool,
        asked: &'static str,
    ) -> Result<(), Error> {
        let (mut scenario, mut inputs) = (self.scenario, self.inputs);
        for (reference, value) in values {
            let variable = self.variable(reference)?;
            if !fits(&variable.value) {
                return Err(wrong_type(&variable, asked));
            }
            self.set_one(&variable, value, &mut scenario, &mut inputs)?;
        }
        (self.scenario, self.inputs) = (scenario, inputs);
        Ok(())
    }

    fn set_one(
        &self,
        variable: &Variable,
        value: f64,
        scenario: &mut Scenario,
        inputs: &mut Inputs,
    ) -> Result<(), Error> {
        match variable.source {
            Source::Parameter(parameter) if self.simulation_at_work().is_some() => {
                Err(Error::Fixed { name: variable.name, value, unit: parameter.unit() })
            }
            Source::Parameter(parameter) => Ok(parameter.set(scenario, value)?),
            Source::Input(input) => {
                input.check(value)?;
                *(input.field)(inputs) = value;
                Ok(())
            }
            _ => Err(read_only(variable)),
        }
    }
}

fn wrong_type(variable: &Variable, asked: &'static str) -> Error {
    Error::Type { name: variable.name, is: variable.value.name(), asked }
}

fn read_only(variable: &Variable) -> Error {
    Error::ReadOnly { name: variable.name, causality: variable.causality() }
}

/// The digits of `word`, most significant first.
fn hexadecimal(word: u64) -> [u8; HASH_DIGITS] {
    core::array::from_fn(|digit| {
        let nibble = (word >> (60 - 4 * digit)) as u8 & 0xf;
        if nibble < 10 { b'0' + nibble } else { b'a' + nibble - 10 }
    })
}
