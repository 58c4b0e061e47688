//! docs/reference/outputs.md: outputs and fields.

use softanvil_kernel::result::Location;
use softanvil_kernel::{FIELDS, INPUTS, OUTPUTS};

use super::{code, compare, number, table};

#[test]
fn the_page_of_the_outputs_is_that_of_the_tables() {
    let outputs = OUTPUTS.iter().map(|output| {
        vec![code(output.name), output.unit.into(), output.id.to_string(), output.description.to_string()]
    });
    let inputs = INPUTS.iter().map(|input| {
        let (low, high) = input.range;
        let motion = format!("{:?}", input.motion).to_lowercase();
        vec![code(input.name), input.unit.into(), format!("{} to {}", number(low), number(high)), code(motion)]
    });
    let fields = FIELDS.iter().map(|field| {
        let location = match field.location {
            Location::Node => "nodes",
            Location::Surface => "nodes of the surface",
            Location::Element => "elements",
        };
        let components = field.components.to_string();
        let description = field.description.to_string();
        vec![code(field.name), field.unit.into(), location.into(), components, field.id.to_string(), description]
    });
    let text = format!(
        "## Outputs\nScalar results at the current time. C (`softanvil_output`), the FMU, Python and Rust read them by these \
         names or numbers; the numbers stay for ever. [theory.md](../theory.md#numbers-of-the-test) defines those of the test.\n\n\
         {}## Fields\nResults at every node, surface node or element. Rows go from the core to the surface, columns from the \
         centre line outwards, or from left to right in a full section; an element is a triangle, two to a cell, or a \
         tetrahedron of a solid, six to a cell.\n\n{}## Inputs\nWhat C, the FMU, Python and Rust may give with a \
         call. Each acts under one choice of `impactor.motion`.\n\n{}",
        table(&["name", "unit", "number", "meaning"], outputs),
        table(&["name", "unit", "where", "components", "number", "meaning"], fields),
        table(&["name", "unit", "legal", "acts under"], inputs)
    );
    compare("outputs.md", "Outputs, fields and inputs", &text);
}
