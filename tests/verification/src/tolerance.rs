//! Every tolerance of the verification problems, with its reason.

/// Closed forms evaluated by the element at prescribed corner positions: round-off of some hundred operations.
pub const CLOSED_FORM: f64 = 1e-11;

/// Patch test: residual force of an interior node relative to the largest internal force of a node, round-off.
pub const PATCH: f64 = 1e-11;

/// Ramp of a Prony series, relative to the peak: the recurrence is exact for the linear ramp of the elastic stress, which
/// a strain of 10^-4 leaves nonlinear to the order of the strain.
pub const PRONY_RAMP: f64 = 1e-3;

/// Slider loop at a shear of 1 %: the closed form is that of small strain, the next order is the square of the shear.
pub const SLIDER_LOOP: f64 = 1e-3;

/// Stress left by ten turns, relative to the spring stiffness: round-off of the stretch in each step.
pub const ROTATION_DRIFT: f64 = 1e-10;

/// Free fall: the impactor follows the exact parabola, contact is found to within one step.
pub const FREE_FALL: f64 = 1e-12;

/// Mass on a linear spring: waves in the layer are of the order sqrt(layer mass / mass) = 0.3 %, the strain of 0.3 %
/// makes the law nonlinear to the same order.
pub const SPRING: f64 = 0.01;

/// Energy residual over impact energy (0.1 % is the requirement).
pub const ENERGY_RESIDUAL: f64 = 1e-3;

/// Momentum balance over the impulse: round-off of some thousand steps.
pub const MOMENTUM: f64 = 1e-9;

/// Peak force and deformation between the default mesh and one twice as fine.
pub const MESH: f64 = 0.03;

/// Penetration of the face over the element size: contact is a constraint, what is left is round-off.
pub const PENETRATION: f64 = 1e-9;

/// Mirror images and two halves against the whole: round-off, grown over some thousand steps of contact.
pub const SYMMETRY: f64 = 1e-8;

/// The value `measured` against `reference`, relative.
pub fn relative_error(measured: f64, reference: f64) -> f64 {
    (measured - reference).abs() / reference.abs()
}
