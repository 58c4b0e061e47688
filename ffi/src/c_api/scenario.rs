//! Scenario

use core::ffi::c_char;

use softanvil_kernel::parameter::{LAYER_NUMBERS, NUMBERS, TEST_NUMBERS};
use softanvil_kernel::scenario::MAX_LAYERS;
use softanvil_kernel::{Changes, Parameter, Scenario};

use crate::c_api::error::{SoftanvilError, report, status};
use crate::c_api::failure::Failure;
use crate::c_api::ptr;
use crate::c_api::status::SoftanvilStatus;
use crate::c_api::tables::{find_parameter, largest, parameter_of, preset_row};

/// Most layers between core and face.
pub const SOFTANVIL_MAX_LAYERS: u32 = 4;
/// Numbers for parameters that belong to no layer, those of future versions included: the layers' begin here.
pub const SOFTANVIL_LAYERS_BEGIN: u32 = 64;
/// Numbers for the parameters of a layer, those of future versions included.
pub const SOFTANVIL_LAYER_NUMBERS: u32 = 96;
/// Room for parameters in a `SoftanvilScenario`, those of future versions included.
pub const SOFTANVIL_PARAMETER_SLOTS: usize = 448;

const _: () = assert!(SOFTANVIL_MAX_LAYERS as usize == MAX_LAYERS);
const _: () = assert!(SOFTANVIL_LAYERS_BEGIN == TEST_NUMBERS && SOFTANVIL_LAYER_NUMBERS == LAYER_NUMBERS);
const _: () = assert!(SOFTANVIL_PARAMETER_SLOTS == NUMBERS);

/// Description of a drop test. It always comes from `softanvil_scenario_default`; its values may then be changed by
/// `softanvil_scenario_set`, which checks them at once, or directly in `value`, which is checked when it is used.
///
/// What differs from the preset counts as said. Of values that state the same thing (drop height, energy and speed; bulk
/// modulus and Poisson's ratio; time step and safety factor) the one that is said decides; two of them are refused, and so
/// is a value that has no effect beside the others. With another law than the preset's, coefficients that still have the
/// preset's value are 0: those of the law, Prony and Maxwell terms, the slider and tearing.
///
/// `layers.count` (SOFTANVIL_PARAMETER_LAYERS_COUNT) says how many layers there are, layer 0 next to the core. Values of layers
/// that are not there have no effect. A layer that the preset does not have needs a thickness, and is else a plain elastic
/// silicone.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct SoftanvilScenario {
    /// Tells an initialised scenario; do not change.
    pub marker: u32,
    /// Bytes of this structure; do not change.
    pub struct_size: u32,
    /// The `SoftanvilPreset` that it came from; do not change.
    pub preset: u32,
    /// Numbers in use of parameters that belong to no layer; do not change. A library with more parameters takes the preset's
    /// values for the rest.
    pub count: u32,
    /// Numbers in use of the parameters of a layer, likewise; do not change.
    pub layer_count: u32,
    /// Always 0.
    pub reserved_word: u32,
    /// Value of every parameter, SI, at the place of its number; a choice as its number. The rest is 0.
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
        let scenario = scenario?;
        let (struct_size, value) = (size_of::<SoftanvilScenario>() as u32, [0.0; SOFTANVIL_PARAMETER_SLOTS]);
        let (count, layer_count, reserved_word) = (0, 0, 0);
        let mut empty =
            SoftanvilScenario { marker: MARKER, struct_size, preset, count, layer_count, reserved_word, value };
        empty.complete()?;
        scenario.write(empty);
        Ok(())
    })
}

/// Sets a parameter. A value that is refused changes nothing. What several parameters say together is checked by
/// `softanvil_memory_size` and `softanvil_init`.
///
/// @param scenario The scenario to change.
/// @param parameter A `SoftanvilParameter`, or SOFTANVIL_PARAMETER_OF_LAYER of a layer and a `SoftanvilLayer`.
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
    report(error, || scenario?.set(parameter_of(parameter)?, value))
}

/// As `softanvil_scenario_set`, by the parameter's name.
///
/// @param scenario The scenario to change.
/// @param name Name, such as "impactor.mass", or `layers[0].c10` of a layer.
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
    report(error, || scenario?.set(find_parameter(&name?)?, value))
}

/// Reads a parameter.
///
/// @param scenario The scenario.
/// @param parameter A `SoftanvilParameter`, or SOFTANVIL_PARAMETER_OF_LAYER of a layer and a `SoftanvilLayer`.
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
    status(|| scenario?.get(parameter_of(parameter)?).and_then(|number| value.map(|value| value.write(number))))
}

/// As `softanvil_scenario_get`, by the parameter's name.
///
/// @param scenario The scenario.
/// @param name Name, such as "impactor.mass", or `layers[0].c10` of a layer.
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
        value.write(scenario.get(find_parameter(&name)?)?);
        Ok(())
    })
}

impl SoftanvilScenario {
    fn check(&self) -> Result<(), Failure> {
        let whole = self.marker == MARKER && self.struct_size as usize == size_of::<Self>();
        if whole { Ok(()) } else { Err(Failure::Uninitialised { argument: "scenario" }) }
    }

    fn preset(&self) -> Result<Scenario, Failure> {
        preset_row(self.preset).map(|row| (row.scenario)())
    }

    /// Whether the library that made the scenario has the parameter.
    fn knows(&self, parameter: Parameter) -> bool {
        let count = if parameter.layer().is_some() { self.layer_count } else { self.count };
        parameter.id() < count
    }

    fn set(&mut self, parameter: Parameter, value: f64) -> Result<(), Failure> {
        self.check()?;
        parameter.check(value)?;
        self.complete()?;
        self.put(parameter, value);
        Ok(())
    }

    fn put(&mut self, parameter: Parameter, value: f64) {
        if let Some(slot) = self.value.get_mut(parameter.number() as usize) {
            *slot = value;
        }
    }

    fn get(&self, parameter: Parameter) -> Result<f64, Failure> {
        self.check()?;
        if self.knows(parameter) { Ok(self.slot(parameter)) } else { Ok(parameter.get(&self.preset()?)) }
    }

    fn slot(&self, parameter: Parameter) -> f64 {
        self.value.get(parameter.number() as usize).copied().unwrap_or_default()
    }

    /// Gives parameters that the scenario's library did not have yet the values of its preset.
    fn complete(&mut self) -> Result<(), Failure> {
        let preset = self.preset()?;
        for parameter in Parameter::all() {
            if !self.knows(parameter) {
                self.put(parameter, parameter.get(&preset));
            }
        }
        let in_use = |of_layers| {
            let ids = Parameter::all().filter(|parameter| parameter.layer().is_some() == of_layers);
            largest(ids.map(|parameter| parameter.id()), &[]) + 1
        };
        (self.count, self.layer_count) = (self.count.max(in_use(false)), self.layer_count.max(in_use(true)));
        Ok(())
    }

    /// Refuses a slot that has no meaning and is not 0.
    fn check_reserved(&self) -> Result<(), Failure> {
        if self.reserved_word != 0 {
            let value = f64::from(self.reserved_word);
            return Err(Failure::ReservedSlot { array: "reserved_word", slot: 0, value });
        }
        for (number, value) in (0..).zip(self.value) {
            let is_known = || Parameter::by_number(number).is_some_and(|parameter| self.knows(parameter));
            if value != 0.0 && !is_known() {
                return Err(Failure::ReservedSlot { array: "value", slot: number as usize, value });
            }
        }
        Ok(())
    }

    /// The scenario that this describes: every value is legal, and each that differs from the preset's acts. Apart, so that what
    /// it goes through leaves the stack.
    #[inline(never)]
    pub(crate) fn kernel(&self) -> Result<Scenario, Failure> {
        self.check()?;
        self.check_reserved()?;
        let mut changes = self.start();
        let changes = changes.as_mut().map_err(|failure| *failure)?;
        for parameter in Parameter::all().filter(|parameter| self.knows(*parameter)) {
            changes.set_if_other(parameter, self.slot(parameter))?;
        }
        changes.take_scenario().map_err(Failure::Scenario)
    }

    /// Nothing changed of the preset. Apart, so that the preset leaves the stack.
    #[inline(never)]
    fn start(&self) -> Result<Changes, Failure> {
        self.preset().map(|preset| Changes::of(&preset))
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
        assert_eq!(study().kernel().unwrap(), softanvil_kernel::preset::study());
    }

    #[test]
    fn an_older_scenario_takes_the_preset_for_what_it_does_not_know() {
        let mut older = study();
        (older.count, older.layer_count) = (20, 10);
        older.value[20..64].fill(0.0);
        for layer in 0..MAX_LAYERS as u32 {
            let number = |id| (SOFTANVIL_LAYERS_BEGIN + SOFTANVIL_LAYER_NUMBERS * layer + id) as usize;
            older.value[number(10)..number(SOFTANVIL_LAYER_NUMBERS)].fill(0.0);
        }
        let [size, force, ratio] = ["mesh.element_size", "measurement.force_threshold", "layers[3].poissons_ratio"]
            .map(|name| Parameter::find(name).unwrap());
        assert_eq!(older.kernel().unwrap(), softanvil_kernel::preset::study());
        assert_eq!(older.get(size), study().get(size));
        older.set(size, 4e-3).unwrap();
        assert_eq!(older.kernel().unwrap().mesh.element_size, 4e-3);
        assert_eq!((older.count, older.layer_count), (study().count, study().layer_count));
        assert_eq!([older.slot(force), older.slot(ratio)], [study().slot(force), study().slot(ratio)]);
    }

    #[test]
    fn a_value_in_a_reserved_slot_is_refused() {
        let mut scenario = study();
        scenario.value[SOFTANVIL_PARAMETER_SLOTS - 1] = 1.0;
        let slot = SOFTANVIL_PARAMETER_SLOTS - 1;
        assert_eq!(scenario.kernel(), Err(Failure::ReservedSlot { array: "value", slot, value: 1.0 }));
        let word = SoftanvilScenario { reserved_word: 1, ..study() }.kernel();
        assert_eq!(word, Err(Failure::ReservedSlot { array: "reserved_word", slot: 0, value: 1.0 }));
    }
}
