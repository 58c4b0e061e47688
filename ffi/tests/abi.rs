//! Sizes, alignments, offsets and status numbers on the Rust side against `tests/c/abi.inc`, which `tests/c/abi.c`
//! checks on the C side.

use std::mem::{align_of, offset_of, size_of};

use softanvil::c_api::error::SoftanvilError;
use softanvil::c_api::fields::{SoftanvilFieldInfo, SoftanvilView};
use softanvil::c_api::scenario::*;
use softanvil::c_api::simulation::SoftanvilInput;
use softanvil::c_api::status::SoftanvilStatus;
use softanvil::c_api::tables::{SoftanvilOutputInfo, SoftanvilParameterInfo};

macro_rules! structure {
    ($lines:ident, $type:ident: $($field:ident)*) => {
        $lines.push(format!("SIZE({}, {})", stringify!($type), size_of::<$type>()));
        $lines.push(format!("ALIGNMENT({}, {})", stringify!($type), align_of::<$type>()));
        $($lines.push(format!(
            "FIELD({}, {}, {})", stringify!($type), stringify!($field), offset_of!($type, $field)
        ));)*
    };
}

#[test]
fn the_layout_is_the_frozen_one() {
    let mut lines = vec![format!("SIZE(SoftanvilStatus, {})", size_of::<SoftanvilStatus>())];
    lines.extend(SoftanvilStatus::ALL.iter().map(|status| {
        let name = format!("{status:?}").chars().fold(String::new(), |name, c| match c {
            c if c.is_uppercase() => format!("{name}_{c}"),
            c => name + &c.to_uppercase().to_string(),
        });
        format!("VALUE(SOFTANVIL_STATUS{name}, {})", *status as i32)
    }));
    lines.push(format!("VALUE(SOFTANVIL_PARAMETER_SLOTS, {SOFTANVIL_PARAMETER_SLOTS})"));
    lines.push(format!("VALUE(SOFTANVIL_MAX_LAYERS, {SOFTANVIL_MAX_LAYERS})"));
    lines.push(format!("VALUE(SOFTANVIL_LAYERS_BEGIN, {SOFTANVIL_LAYERS_BEGIN})"));
    lines.push(format!("VALUE(SOFTANVIL_LAYER_NUMBERS, {SOFTANVIL_LAYER_NUMBERS})"));
    structure!(lines, SoftanvilError: status parameter element reserved_word value min max time reserved text);
    structure!(lines, SoftanvilScenario: marker struct_size preset count layer_count reserved_word value);
    structure!(lines, SoftanvilInput: marker struct_size external_force driven_position reserved driven_velocity);
    structure!(lines, SoftanvilParameterInfo: id choices is_whole layer min max reserved name unit description);
    structure!(lines, SoftanvilOutputInfo: id reserved_word reserved name unit description);
    structure!(lines, SoftanvilFieldInfo: id components reserved name unit description);
    structure!(lines, SoftanvilView: data rows columns row_stride column_stride reserved);
    let frozen = include_str!("../../tests/c/abi.inc").lines().skip(1).collect::<Vec<_>>();
    assert_eq!(lines, frozen);
}
