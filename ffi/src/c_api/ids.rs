//! The stable numbers of the C ABI: the place of a row in these tables is its number, for ever.
//!
//! Names, units, ranges and meanings stay in the kernel's tables; here is only the order. A new row goes to the end of
//! its table, wherever the kernel has put it. The number of an output that the kernel no longer has stays empty.

use softanvil_kernel::preset::{PRESETS, Preset};
use softanvil_kernel::{FIELDS, Field, OUTPUTS, Output, PARAMETERS, Parameter};

/// Presets by number.
pub static PRESET_BY_ID: [&Preset; 3] =
    [preset_row("study"), preset_row("study-14.7"), preset_row("study-incompressible")];

/// Parameters by number, which is also their slot in a `SoftanvilScenario`.
pub static PARAMETER_BY_ID: [&Parameter; 129] = [
    parameter_row("geometry.shape"),
    parameter_row("geometry.formulation"),
    parameter_row("geometry.core_radius"),
    parameter_row("geometry.silicone_thickness"),
    parameter_row("geometry.skin_thickness"),
    parameter_row("geometry.length"),
    parameter_row("geometry.block_width"),
    parameter_row("impactor.motion"),
    parameter_row("impactor.mass"),
    parameter_row("impactor.face_diameter"),
    parameter_row("impactor.gap"),
    parameter_row("impactor.gravity"),
    parameter_row("impactor.drop_by"),
    parameter_row("impactor.drop_height"),
    parameter_row("impactor.drop_energy"),
    parameter_row("impactor.drop_speed"),
    parameter_row("silicone.density"),
    parameter_row("silicone.moduli"),
    parameter_row("silicone.c10"),
    parameter_row("silicone.c01"),
    parameter_row("silicone.c11"),
    parameter_row("silicone.c20"),
    parameter_row("silicone.c02"),
    parameter_row("silicone.volumetric_by"),
    parameter_row("silicone.bulk_modulus"),
    parameter_row("silicone.poissons_ratio"),
    parameter_row("silicone.prony_g_1"),
    parameter_row("silicone.prony_tau_1"),
    parameter_row("silicone.prony_g_2"),
    parameter_row("silicone.prony_tau_2"),
    parameter_row("silicone.prony_g_3"),
    parameter_row("silicone.prony_tau_3"),
    parameter_row("silicone.prony_g_4"),
    parameter_row("silicone.prony_tau_4"),
    parameter_row("silicone.prony_g_5"),
    parameter_row("silicone.prony_tau_5"),
    parameter_row("silicone.slider_stiffness"),
    parameter_row("silicone.slider_yield_stress"),
    parameter_row("core.interface"),
    parameter_row("core.friction_coefficient"),
    parameter_row("face.friction_coefficient"),
    parameter_row("mesh.element_size"),
    parameter_row("time.step_by"),
    parameter_row("time.safety_factor"),
    parameter_row("time.step"),
    parameter_row("time.duration"),
    parameter_row("measurement.force_threshold"),
    parameter_row("geometry.layers"),
    parameter_row("geometry.section"),
    parameter_row("impactor.offset"),
    parameter_row("silicone.law"),
    parameter_row("silicone.c30"),
    parameter_row("silicone.ogden_mu_1"),
    parameter_row("silicone.ogden_alpha_1"),
    parameter_row("silicone.ogden_mu_2"),
    parameter_row("silicone.ogden_alpha_2"),
    parameter_row("silicone.ogden_mu_3"),
    parameter_row("silicone.ogden_alpha_3"),
    parameter_row("silicone.volumetric_law"),
    parameter_row("silicone.maxwell_g_1"),
    parameter_row("silicone.maxwell_beta_1"),
    parameter_row("silicone.maxwell_g_2"),
    parameter_row("silicone.maxwell_beta_2"),
    parameter_row("silicone.maxwell_g_3"),
    parameter_row("silicone.maxwell_beta_3"),
    parameter_row("silicone.maxwell_g_4"),
    parameter_row("silicone.maxwell_beta_4"),
    parameter_row("silicone.maxwell_g_5"),
    parameter_row("silicone.maxwell_beta_5"),
    parameter_row("silicone.tear_stretch"),
    parameter_row("silicone.tear_width"),
    parameter_row("silicone.tear_residual"),
    parameter_row("skin.density"),
    parameter_row("skin.law"),
    parameter_row("skin.moduli"),
    parameter_row("skin.c10"),
    parameter_row("skin.c01"),
    parameter_row("skin.c11"),
    parameter_row("skin.c20"),
    parameter_row("skin.c02"),
    parameter_row("skin.c30"),
    parameter_row("skin.ogden_mu_1"),
    parameter_row("skin.ogden_alpha_1"),
    parameter_row("skin.ogden_mu_2"),
    parameter_row("skin.ogden_alpha_2"),
    parameter_row("skin.ogden_mu_3"),
    parameter_row("skin.ogden_alpha_3"),
    parameter_row("skin.volumetric_law"),
    parameter_row("skin.volumetric_by"),
    parameter_row("skin.bulk_modulus"),
    parameter_row("skin.poissons_ratio"),
    parameter_row("skin.prony_g_1"),
    parameter_row("skin.prony_tau_1"),
    parameter_row("skin.prony_g_2"),
    parameter_row("skin.prony_tau_2"),
    parameter_row("skin.prony_g_3"),
    parameter_row("skin.prony_tau_3"),
    parameter_row("skin.prony_g_4"),
    parameter_row("skin.prony_tau_4"),
    parameter_row("skin.prony_g_5"),
    parameter_row("skin.prony_tau_5"),
    parameter_row("skin.maxwell_g_1"),
    parameter_row("skin.maxwell_beta_1"),
    parameter_row("skin.maxwell_g_2"),
    parameter_row("skin.maxwell_beta_2"),
    parameter_row("skin.maxwell_g_3"),
    parameter_row("skin.maxwell_beta_3"),
    parameter_row("skin.maxwell_g_4"),
    parameter_row("skin.maxwell_beta_4"),
    parameter_row("skin.maxwell_g_5"),
    parameter_row("skin.maxwell_beta_5"),
    parameter_row("skin.slider_stiffness"),
    parameter_row("skin.slider_yield_stress"),
    parameter_row("skin.tear_stretch"),
    parameter_row("skin.tear_width"),
    parameter_row("skin.tear_residual"),
    parameter_row("impactor.prescribed_speed"),
    parameter_row("impactor.prescribed_depth"),
    parameter_row("impactor.prescribed_rise"),
    parameter_row("measurement.channel_class"),
    parameter_row("time.design_compression"),
    parameter_row("silicone.gent_mu"),
    parameter_row("silicone.gent_jm"),
    parameter_row("skin.gent_mu"),
    parameter_row("skin.gent_jm"),
    parameter_row("silicone.arruda_boyce_mu"),
    parameter_row("silicone.arruda_boyce_lambda_m"),
    parameter_row("skin.arruda_boyce_mu"),
    parameter_row("skin.arruda_boyce_lambda_m"),
];

/// Outputs by number.
pub static OUTPUT_BY_ID: [Option<&Output>; 31] = [
    output_row("contact.force"),
    output_row("contact.force_step"),
    output_row("core.reaction"),
    output_row("impactor.position"),
    output_row("impactor.velocity"),
    output_row("impactor.acceleration"),
    output_row("impactor.deformation"),
    output_row("result.peak_force"),
    output_row("result.max_deformation"),
    output_row("result.impact_duration"),
    output_row("result.impulse"),
    output_row("result.impact_speed"),
    output_row("result.rebound_speed"),
    output_row("result.restitution"),
    output_row("result.contact_time"),
    output_row("energy.impactor_kinetic"),
    output_row("energy.layer_kinetic"),
    output_row("energy.elastic"),
    output_row("energy.viscous"),
    output_row("energy.slider_stored"),
    output_row("energy.slider_dissipation"),
    output_row("energy.friction"),
    output_row("energy.contact"),
    output_row("energy.external"),
    output_row("energy.residual"),
    output_row("contact.half_width"),
    RETIRED, // energy.viscous_dissipation
    output_row("energy.tear"),
    output_row("contact.force_filtered"),
    output_row("model.design_stretch"),
    output_row("result.complete"),
];

/// Fields by number.
pub static FIELD_BY_ID: [&Field; 12] = [
    field_row("node.reference_position"),
    field_row("node.position"),
    field_row("node.displacement"),
    field_row("node.velocity"),
    field_row("node.force"),
    field_row("surface.contact_force"),
    field_row("surface.contact_pressure"),
    field_row("element.pressure"),
    field_row("element.von_mises_stress"),
    field_row("element.principal_stress"),
    field_row("element.cauchy_stress"),
    field_row("element.principal_stretch"),
];

/// The kernel's row called `name`; a name that the kernel does not have stops the compiler.
const fn parameter_row(name: &str) -> &'static Parameter {
    let mut i = 0;
    while i < PARAMETERS.len() {
        if same(PARAMETERS[i].name, name) {
            return &PARAMETERS[i];
        }
        i += 1;
    }
    panic!("the kernel has no such parameter")
}

/// The row of an output that is no more.
const RETIRED: Option<&Output> = None;

/// As [`parameter_row`], for outputs.
const fn output_row(name: &str) -> Option<&'static Output> {
    let mut i = 0;
    while i < OUTPUTS.len() {
        if same(OUTPUTS[i].name, name) {
            return Some(&OUTPUTS[i]);
        }
        i += 1;
    }
    panic!("the kernel has no such output")
}

/// As [`parameter_row`], for presets.
const fn preset_row(name: &str) -> &'static Preset {
    let mut i = 0;
    while i < PRESETS.len() {
        if same(PRESETS[i].name, name) {
            return &PRESETS[i];
        }
        i += 1;
    }
    panic!("the kernel has no such preset")
}

/// As [`parameter_row`], for fields.
const fn field_row(name: &str) -> &'static Field {
    let mut i = 0;
    while i < FIELDS.len() {
        if same(FIELDS[i].name, name) {
            return &FIELDS[i];
        }
        i += 1;
    }
    panic!("the kernel has no such field")
}

const fn same(a: &str, b: &str) -> bool {
    let (a, b) = (a.as_bytes(), b.as_bytes());
    let mut i = 0;
    while i < a.len() && i < b.len() && a[i] == b[i] {
        i += 1;
    }
    i == a.len() && i == b.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_parameter_has_exactly_one_number() {
        for parameter in PARAMETERS {
            let numbers = PARAMETER_BY_ID.iter().filter(|row| row.name == parameter.name).count();
            assert_eq!(numbers, 1, "{}", parameter.name);
        }
        assert_eq!(PARAMETER_BY_ID.len(), PARAMETERS.len());
    }

    #[test]
    fn every_field_has_exactly_one_number() {
        for field in &FIELDS {
            let numbers = FIELD_BY_ID.iter().filter(|row| row.name == field.name).count();
            assert_eq!(numbers, 1, "{}", field.name);
        }
        assert_eq!(FIELD_BY_ID.len(), FIELDS.len());
    }

    #[test]
    fn every_output_has_exactly_one_number() {
        for output in OUTPUTS {
            let numbers = OUTPUT_BY_ID.iter().flatten().filter(|row| row.name == output.name).count();
            assert_eq!(numbers, 1, "{}", output.name);
        }
        assert_eq!(OUTPUT_BY_ID.iter().flatten().count(), OUTPUTS.len());
    }
}
