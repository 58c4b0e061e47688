//! Scenario

use core::ffi::c_char;

use softanvil_kernel::{Changes, Scenario};

use crate::c_api::error::{SoftanvilError, report, status};
use crate::c_api::failure::Failure;
use crate::c_api::ids::{PARAMETER_BY_ID, PRESET_BY_ID};
use crate::c_api::ptr;
use crate::c_api::status::SoftanvilStatus;
use crate::c_api::tables::{find_parameter, parameter_row};

/// Room for parameters in a `SoftanvilScenario`, those of future versions included.
pub const SOFTANVIL_PARAMETER_SLOTS: usize = 256;

/// Description of a drop test. It always comes from `softanvil_scenario_default`; its values may then be changed by
/// `softanvil_scenario_set`, which checks them at once, or directly in `value`, which is checked when it is used.
///
/// What differs from the preset counts as said. Of values that state the same thing (drop height, energy and speed; bulk
/// modulus and Poisson's ratio; time step and safety factor) the one that is said decides; two of them are refused, and so
/// is a value that has no effect beside the others. With another law than the preset's, coefficients that still have the
/// preset's value are 0: those of the law, Prony and Maxwell terms, the slider and tearing. Another number of layers needs
/// the thickness of the silicone as well.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct SoftanvilScenario {
    /// Tells an initialised scenario; do not change.
    pub marker: u32,
    /// Bytes of this structure; do not change.
    pub struct_size: u32,
    /// The `SoftanvilPreset` that it came from; do not change.
    pub preset: u32,
    /// Slots of `value` in use; do not change. A library with more parameters takes the preset's values for the rest.
    pub count: u32,
    /// Value of every parameter, SI, at the place of its `SoftanvilParameter`; a choice as its number. The rest is 0.
    pub value: [f64; SOFTANVIL_PARAMETER_SLOTS],
}

/// "SASC", least significant byte first.
const MARKER: u32 = u32::from_le_bytes(*b"SASC");

/// Fills a scenario with a preset.
///
/// @param preset A `SoftanvilPreset`.
/// @param scenario The scenario to fill.
/// @return NULL_POINTER, MISALIGNED, UNKNOWN_ID.
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_scenario_default(preset: u32, scenario: *mut SoftanvilScenario) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    let scenario = unsafe { ptr::out(scenario, "scenario") };
    status(|| {
        let (scenario, kernel) = (scenario?, preset_scenario(preset)?);
        let mut value = [0.0; SOFTANVIL_PARAMETER_SLOTS];
        for (slot, row) in value.iter_mut().zip(PARAMETER_BY_ID) {
            *slot = row.get(&kernel);
        }
        let (struct_size, count) = (size_of::<SoftanvilScenario>() as u32, PARAMETER_BY_ID.len() as u32);
        scenario.write(SoftanvilScenario { marker: MARKER, struct_size, preset, count, value });
        Ok(())
    })
}

/// Sets a parameter. A value that is refused changes nothing. What several parameters say together is checked by
/// `softanvil_memory_size` and `softanvil_init`.
///
/// @param scenario The scenario to change.
/// @param parameter A `SoftanvilParameter`.
/// @param value Value in the parameter's SI unit; a choice as its number.
/// @param error Details of a failure, or NULL.
/// @return NULL_POINTER, MISALIGNED, UNINITIALISED, UNKNOWN_ID, ILLEGAL_VALUE.
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_scenario_set(
    scenario: *mut SoftanvilScenario,
    parameter: u32,
    value: f64,
    error: *mut SoftanvilError,
) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    let (scenario, error) = unsafe { (ptr::exclusive(scenario, "scenario"), ptr::optional_out(error, "error")) };
    report(error, || scenario?.set(parameter, value))
}

/// As `softanvil_scenario_set`, by the parameter's name.
///
/// @param scenario The scenario to change.
/// @param name Name, such as "impactor.mass".
/// @param value Value in the parameter's SI unit; a choice as its number.
/// @param error Details of a failure, or NULL.
/// @return NULL_POINTER, MISALIGNED, UNINITIALISED, UNKNOWN_NAME, ILLEGAL_VALUE.
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_scenario_set_by_name(
    scenario: *mut SoftanvilScenario,
    name: *const c_char,
    value: f64,
    error: *mut SoftanvilError,
) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    let (scenario, name, error) =
        unsafe { (ptr::exclusive(scenario, "scenario"), ptr::name(name, "name"), ptr::optional_out(error, "error")) };
    report(error, || scenario?.set(find_parameter(&name?)?.0, value))
}

/// Reads a parameter.
///
/// @param scenario The scenario.
/// @param parameter A `SoftanvilParameter`.
/// @param value Value in the parameter's SI unit; a choice as its number.
/// @return NULL_POINTER, MISALIGNED, UNINITIALISED, UNKNOWN_ID.
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_scenario_get(
    scenario: *const SoftanvilScenario,
    parameter: u32,
    value: *mut f64,
) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    let (scenario, value) = unsafe { (ptr::shared(scenario, "scenario"), ptr::out(value, "value")) };
    status(|| scenario?.get(parameter).and_then(|number| value.map(|value| value.write(number))))
}

/// As `softanvil_scenario_get`, by the parameter's name.
///
/// @param scenario The scenario.
/// @param name Name, such as "impactor.mass".
/// @param value Value in the parameter's SI unit; a choice as its number.
/// @return NULL_POINTER, MISALIGNED, UNINITIALISED, UNKNOWN_NAME.
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_scenario_get_by_name(
    scenario: *const SoftanvilScenario,
    name: *const c_char,
    value: *mut f64,
) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    let (scenario, name, value) =
        unsafe { (ptr::shared(scenario, "scenario"), ptr::name(name, "name"), ptr::out(value, "value")) };
    status(|| {
        let (scenario, name, value) = (scenario?, name?, value?);
        value.write(scenario.get(find_parameter(&name)?.0)?);
        Ok(())
    })
}

fn preset_scenario(preset: u32) -> Result<Scenario, Failure> {
    let unknown = Failure::UnknownId { argument: "preset", id: preset, count: PRESET_BY_ID.len() };
    PRESET_BY_ID.get(preset as usize).map(|row| (row.scenario)()).ok_or(unknown)
}

impl SoftanvilScenario {
    fn check(&self) -> Result<(), Failure> {
        let whole = self.marker == MARKER && self.struct_size as usize == size_of::<Self>();
        if whole { Ok(()) } else { Err(Failure::Uninitialised { argument: "scenario" }) }
    }

    fn set(&mut self, parameter: u32, value: f64) -> Result<(), Failure> {
        self.check()?;
        parameter_row(parameter)?.check(value)?;
        self.complete()?;
        if let Some(slot) = self.value.get_mut(parameter as usize) {
            *slot = value;
        }
        Ok(())
    }

    fn get(&self, parameter: u32) -> Result<f64, Failure> {
        self.check()?;
        parameter_row(parameter)?;
        let mut whole = *self;
        whole.complete()?;
        let unknown = Failure::UnknownId { argument: "parameter", id: parameter, count: whole.count as usize };
        whole.value.get(parameter as usize).copied().ok_or(unknown)
    }

    /// Gives parameters that the scenario's library did not have yet the values of its preset.
    fn complete(&mut self) -> Result<(), Failure> {
        let used = self.count as usize;
        if used >= PARAMETER_BY_ID.len() {
            return Ok(());
        }
        let preset = preset_scenario(self.preset)?;
        for (slot, row) in self.value.iter_mut().zip(PARAMETER_BY_ID).skip(used) {
            *slot = row.get(&preset);
        }
        self.count = PARAMETER_BY_ID.len() as u32;
        Ok(())
    }

    /// The scenario that this describes: every value is legal, and each that differs from the preset's acts.
    pub(crate) fn to_kernel(self) -> Result<Scenario, Failure> {
        self.check()?;
        let preset = preset_scenario(self.preset)?;
        let mut kernel = preset;
        for (slot, value) in self.value.iter().enumerate().skip((self.count as usize).min(PARAMETER_BY_ID.len())) {
            if *value != 0.0 {
                return Err(Failure::ReservedSlot { array: "value", slot, value: *value });
            }
        }
        for (value, row) in self.value.iter().zip(PARAMETER_BY_ID).take(self.count as usize) {
            row.set(&mut kernel, *value)?;
        }
        Changes::between(&preset, &kernel).apply().map_err(Failure::Scenario)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn study() -> SoftanvilScenario {
        let mut scenario = core::mem::MaybeUninit::uninit();
        // SAFETY: valid for writes; written if the status says so.
        unsafe {
            assert_eq!(softanvil_scenario_default(0, scenario.as_mut_ptr()), SoftanvilStatus::Ok);
            scenario.assume_init()
        }
    }

    #[test]
    fn a_preset_survives_the_way_through_c() {
        assert_eq!(study().to_kernel().unwrap(), softanvil_kernel::preset::study());
    }

    #[test]
    fn an_older_scenario_takes_the_preset_for_what_it_does_not_know() {
        let mut older = study();
        older.count = 40;
        older.value[40..].fill(0.0);
        assert_eq!(older.to_kernel().unwrap(), softanvil_kernel::preset::study());
        assert_eq!(older.get(41).unwrap(), study().value[41]);
        older.set(41, 4e-3).unwrap();
        assert_eq!(older.to_kernel().unwrap().mesh.element_size, 4e-3);
        assert_eq!((older.count, older.value[42]), (study().count, study().value[42]));
    }

    #[test]
    fn a_value_in_a_reserved_slot_is_refused() {
        let mut scenario = study();
        scenario.value[SOFTANVIL_PARAMETER_SLOTS - 1] = 1.0;
        let slot = SOFTANVIL_PARAMETER_SLOTS - 1;
        assert_eq!(scenario.to_kernel(), Err(Failure::ReservedSlot { array: "value", slot, value: 1.0 }));
    }
}
