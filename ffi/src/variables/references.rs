//! Value references: fixed numbers, so that a system model that names them survives a new version of the FMU.
//!
//! | range        | variables                                     |
//! |--------------|-----------------------------------------------|
//! | 0            | time                                          |
//! | 1000 to 1999 | parameters that belong to no layer            |
//! | 2000 to 2999 | inputs                                        |
//! | 3000 to 3999 | scalar outputs                                |
//! | 4000 to 4999 | calculated parameters                         |
//! | 5000 to 5999 | outputs that are no quantity (states, texts)  |
//! | 6000 to 6999 | arrays                                        |
//! | 7000 to 7999 | parameters of layers, a hundred for each      |
//!
//! Those of parameters and outputs follow from the numbers in the kernel's rows. A number is never given away twice: what leaves
//! the kernel's tables leaves a gap here.

use softanvil_kernel::parameter::{LAYER_NUMBERS, TEST_NUMBERS};
use softanvil_kernel::{Output, Parameter};

/// Numbers that a layer has.
pub const GROUP: u32 = 100;

/// Parameters that belong to no layer begin here.
const PARAMETERS: u32 = 1000;
/// Scalar outputs begin here.
const OUTPUTS: u32 = 3000;
/// Parameters of the layers begin here.
const LAYERS: u32 = 7000;

/// The independent variable.
pub const TIME: u32 = 0;

/// Inputs.
pub const EXTERNAL_FORCE: u32 = 2000;
/// Height of a driven impactor.
pub const DRIVEN_POSITION: u32 = 2001;
/// Velocity of a driven impactor.
pub const DRIVEN_VELOCITY: u32 = 2002;
/// Rest of the anvil before the next impact.
pub const REST: u32 = 2003;
/// Whether the next impact is asked for.
pub const NEXT_IMPACT: u32 = 2004;

/// The kernel's time.
pub const KERNEL_TIME: u32 = 3500;

/// The kernel's time step.
pub const TIME_STEP: u32 = 4000;
/// Number of elements of the mesh.
pub const ELEMENTS: u32 = 4001;
/// Number of nodes along the surface.
pub const SURFACE_NODES: u32 = 4002;

/// Whether the impactor touches the layer.
pub const CONTACT_ACTIVE: u32 = 5000;
/// Digest of the force samples.
pub const TRACE_HASH: u32 = 5001;
/// Number of the impact.
pub const IMPACT_NUMBER: u32 = 5002;

/// Number of points of the profiles.
pub const SURFACE_POINTS: u32 = 1900;
/// Distance of the surface from the centre line.
pub const SURFACE_X: u32 = 6000;
/// Height of the surface.
pub const SURFACE_HEIGHT: u32 = 6001;
/// Contact pressure along the surface.
pub const SURFACE_CONTACT_PRESSURE: u32 = 6002;

/// Reference of a parameter: 1000 and its number; of a layer's 7000, the hundreds of the layer, and its number there.
pub fn of_parameter(parameter: Parameter) -> u32 {
    let first = parameter.layer().map_or(PARAMETERS, |layer| LAYERS + GROUP * layer as u32);
    first + parameter.id()
}

/// Reference of an output.
pub fn of_output(output: &Output) -> u32 {
    OUTPUTS + output.id
}

const _: () = assert!(LAYER_NUMBERS <= GROUP && TEST_NUMBERS <= SURFACE_POINTS - PARAMETERS);
