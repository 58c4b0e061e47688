//! Reading and setting variables.

use softanvil_kernel::parameter::Values;
use softanvil_kernel::{ParameterError, Simulation};

use super::{Error, Instance, Mode, memory};
use crate::variables::profile::Profile;
use crate::variables::{Inputs, Source, ValueType, Variable, Version};

/// Length of a trace hash in hexadecimal digits.
pub const HASH_DIGITS: usize = 16;

impl Instance {
    /// The simulation, if it belongs to the current scenario and experiment.
    pub(super) fn simulation_at_work(&self) -> Option<&Simulation> {
        if self.mode as u8 & Mode::BEFORE_WORK != 0 { None } else { self.simulation.as_ref() }
    }

    /// The simulation whose results are current; before the first step can be made, that of the scenario as it stands.
    fn results(&mut self) -> Result<&Simulation, Error> {
        if self.mode as u8 & Mode::BEFORE_WORK != 0 {
            return self.prepare().map(|simulation| &*simulation);
        }
        self.simulation_at_work().ok_or(Error::Call { mode: self.mode })
    }

    /// The variable that a master calls `reference`.
    ///
    /// # Errors
    /// There is none in this version of the standard.
    pub fn variable(&self, reference: u32) -> Result<&Variable, Error> {
        let found = self.table.find(reference).filter(|variable| variable.is_in(self.version));
        found.ok_or(Error::Unknown { reference })
    }

    /// How many values a variable has.
    ///
    /// # Errors
    /// An unknown reference.
    pub fn length(&self, reference: u32) -> Result<usize, Error> {
        match self.variable(reference)?.value {
            ValueType::Array { .. } => Ok(self.points as usize),
            _ => Ok(1),
        }
    }

    /// A quantity.
    ///
    /// # Errors
    /// An unknown reference, another type, or a scenario that cannot be simulated.
    pub fn real(&mut self, reference: u32) -> Result<f64, Error> {
        let variable = self.variable(reference)?;
        match (variable.value, variable.source) {
            (ValueType::Real { .. }, source) => self.quantity(source),
            _ => Err(self.wrong_type(variable, self.real_name())),
        }
    }

    /// The values of a quantity or of a row of quantities, one after the other.
    ///
    /// # Errors
    /// As [`Instance::real`].
    pub fn reals(&mut self, reference: u32, put: &mut dyn FnMut(f64)) -> Result<(), Error> {
        let variable = self.variable(reference)?;
        match (variable.value, variable.source) {
            (ValueType::Real { .. }, source) => self.quantity(source).map(put),
            (_, Source::Profile(profile)) => self.along_surface(profile, put),
            _ => Err(self.wrong_type(variable, self.real_name())),
        }
    }

    /// The values of a profile, one after the other.
    #[inline(never)]
    fn along_surface(&mut self, profile: Profile, put: &mut dyn FnMut(f64)) -> Result<(), Error> {
        let points = self.points;
        self.results()?;
        let Some(simulation) = &mut self.simulation else { return Err(Error::Call { mode: self.mode }) };
        let all = simulation.with(|model, state| {
            let view = state.as_view();
            (0..points).for_each(|point| put(profile.at(model, &view, point, points)));
        });
        all.map_err(memory)
    }

    /// The quantity that lives in `source`.
    fn quantity(&mut self, source: Source) -> Result<f64, Error> {
        match source {
            Source::Time => Ok(self.time()),
            Source::KernelTime => Ok(self.kernel_time()),
            Source::Parameter(parameter) => Ok(self.values.get(parameter)),
            Source::Input(input) => Ok(*(input.field)(&mut self.inputs)),
            Source::Output(output) => {
                let simulation = self.results()?;
                Ok((output.read)(simulation.constants(), simulation.scalars()))
            }
            _ => Ok(self.results()?.constants().dt),
        }
    }

    /// A length of arrays.
    ///
    /// # Errors
    /// As [`Instance::real`].
    pub fn size(&self, reference: u32) -> Result<u64, Error> {
        let variable = self.variable(reference)?;
        match variable.value {
            ValueType::Size { .. } => Ok(self.points),
            _ => Err(self.wrong_type(variable, "UInt64")),
        }
    }

    /// A choice by its number.
    ///
    /// # Errors
    /// As [`Instance::real`].
    pub fn choice(&self, reference: u32) -> Result<i32, Error> {
        let variable = self.variable(reference)?;
        match (variable.value, variable.source) {
            (ValueType::Enumeration { .. }, Source::Parameter(parameter)) => Ok(self.values.get(parameter) as i32),
            _ => Err(self.wrong_type(variable, "Enumeration")),
        }
    }

    /// A count.
    ///
    /// # Errors
    /// As [`Instance::real`].
    pub fn integer(&mut self, reference: u32) -> Result<i32, Error> {
        let variable = self.variable(reference)?;
        let ValueType::Integer { .. } = variable.value else {
            return Err(self.wrong_type(variable, self.integer_name()));
        };
        match variable.source {
            Source::Parameter(parameter) => Ok(self.values.get(parameter) as i32),
            Source::ImpactNumber => Ok(i32::try_from(self.impact.number).unwrap_or(i32::MAX)),
            Source::SurfaceNodes => Ok(self.results()?.constants().grid.n_u as i32 + 1),
            _ => Ok(self.results()?.constants().grid.n_elem() as i32),
        }
    }

    /// A state.
    ///
    /// # Errors
    /// As [`Instance::real`].
    pub fn boolean(&mut self, reference: u32) -> Result<bool, Error> {
        let variable = self.variable(reference)?;
        let ValueType::Boolean = variable.value else { return Err(self.wrong_type(variable, "Boolean")) };
        match variable.source {
            Source::NextImpact => Ok(self.inputs.next_impact),
            _ => Ok(self.results()?.scalars().force.contact > 0.0),
        }
    }

    /// A text: the trace hash in lower-case hexadecimal digits.
    ///
    /// # Errors
    /// As [`Instance::real`].
    pub fn text(&mut self, reference: u32) -> Result<[u8; HASH_DIGITS], Error> {
        let variable = self.variable(reference)?;
        let ValueType::String = variable.value else { return Err(self.wrong_type(variable, "String")) };
        Ok(hexadecimal(self.results()?.scalars().sampler.trace_hash))
    }

    /// Sets quantities: all of them, or none if one is refused.
    ///
    /// # Errors
    /// An unknown reference, another type, a variable that cannot be set now, or a value out of range.
    pub fn set_reals(&mut self, values: impl Iterator<Item = (u32, f64)>) -> Result<(), Error> {
        self.set(values, |value| matches!(value, ValueType::Real { .. }), self.real_name())
    }

    /// Sets choices: all of them, or none if one is refused.
    ///
    /// # Errors
    /// As [`Instance::set_reals`].
    pub fn set_choices(&mut self, values: impl Iterator<Item = (u32, i64)>) -> Result<(), Error> {
        // Every number of a choice is exact as a float, and no number that is not becomes one.
        let values = values.map(|(reference, value)| (reference, value as f64));
        // FMI 2.0 sets choices and counts by the same function.
        let (asked, counts_too) = match self.version {
            Version::Fmi2 => ("Integer", true),
            Version::Fmi3 => ("Enumeration", false),
        };
        let fits = |value: &ValueType| match value {
            ValueType::Enumeration { .. } => true,
            ValueType::Integer { .. } => counts_too,
            _ => false,
        };
        self.set(values, fits, asked)
    }

    /// Sets counts: all of them, or none if one is refused.
    ///
    /// # Errors
    /// As [`Instance::set_reals`].
    pub fn set_counts(&mut self, values: impl Iterator<Item = (u32, i32)>) -> Result<(), Error> {
        let values = values.map(|(reference, value)| (reference, f64::from(value)));
        self.set(values, |value| matches!(value, ValueType::Integer { .. }), self.integer_name())
    }

    /// Sets states: all of them, or none if one is refused.
    ///
    /// # Errors
    /// As [`Instance::set_reals`].
    pub fn set_booleans(&mut self, values: impl Iterator<Item = (u32, bool)>) -> Result<(), Error> {
        let values = values.map(|(reference, value)| (reference, f64::from(u8::from(value))));
        self.set(values, |value| matches!(value, ValueType::Boolean), "Boolean")
    }

    /// Sets lengths of arrays: all of them, or none if one is refused.
    ///
    /// # Errors
    /// As [`Instance::set_reals`], and any mode but configuration mode.
    pub fn set_sizes(&mut self, values: impl Iterator<Item = (u32, u64)>) -> Result<(), Error> {
        let mut points = self.points;
        for (reference, value) in values {
            let variable = self.variable(reference)?;
            let ValueType::Size { range: (min, max) } = variable.value else {
                return Err(self.wrong_type(variable, "UInt64"));
            };
            if self.mode != Mode::Configuration {
                return Err(Error::Structural { name: variable.name });
            }
            if value < min || value > max {
                let (name, value) = (variable.name, value as f64);
                return Err(Error::Value(ParameterError { name, value, unit: "1", min: min as f64, max: max as f64 }));
            }
            points = value;
        }
        self.points = points;
        Ok(())
    }

    /// Refuses to set what no variable of type `asked` allows.
    ///
    /// # Errors
    /// Always: an unknown reference, another type, or a variable that cannot be set.
    pub fn refuse_to_set(&self, reference: u32, asked: &'static str) -> Error {
        match self.variable(reference) {
            Err(unknown) => unknown,
            Ok(variable) if variable.value.name(self.version) != asked => self.wrong_type(variable, asked),
            Ok(variable) => read_only(variable),
        }
    }

    /// Refuses to read what no variable of type `asked` has.
    pub fn refuse_to_get(&self, reference: u32, asked: &'static str) -> Error {
        match self.variable(reference) {
            Err(unknown) => unknown,
            Ok(variable) => self.wrong_type(variable, asked),
        }
    }

    /// What quantities are called in this version.
    fn real_name(&self) -> &'static str {
        ValueType::Real { unit: "1", range: None }.name(self.version)
    }

    /// What counts are called in this version.
    fn integer_name(&self) -> &'static str {
        ValueType::Integer { range: None }.name(self.version)
    }

    fn wrong_type(&self, variable: &Variable, asked: &'static str) -> Error {
        Error::Type { name: variable.name, is: variable.value.name(self.version), asked }
    }

    fn set(
        &mut self,
        values: impl Iterator<Item = (u32, f64)>,
        fits: impl Fn(&ValueType) -> bool,
        asked: &'static str,
    ) -> Result<(), Error> {
        let (mut parameters, mut inputs) = (self.values.clone(), self.inputs);
        for (reference, value) in values {
            let variable = self.variable(reference)?;
            if !fits(&variable.value) {
                return Err(self.wrong_type(variable, asked));
            }
            if self.mode == Mode::Configuration {
                return Err(Error::Structural { name: variable.name });
            }
            self.set_one(variable, value, &mut parameters, &mut inputs)?;
        }
        (self.inputs, self.values) = (inputs.in_scenario(&parameters.scenario()), parameters);
        Ok(())
    }

    fn set_one(
        &self,
        variable: &Variable,
        value: f64,
        parameters: &mut Values,
        inputs: &mut Inputs,
    ) -> Result<(), Error> {
        match variable.source {
            Source::Parameter(parameter) if self.simulation_at_work().is_some() => {
                Err(Error::Fixed { name: variable.name, value, unit: parameter.unit() })
            }
            Source::Parameter(parameter) => Ok(parameters.set(parameter, value)?),
            Source::Input(input) => Ok(input.set(inputs, value)?),
            Source::NextImpact => {
                inputs.next_impact = value != 0.0;
                Ok(())
            }
            _ => Err(read_only(variable)),
        }
    }
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

#[cfg(test)]
mod tests;
