//! The table of outputs: name, unit and meaning of every scalar result, in one place.
//!
//! The C ABI, the FMU and the command line read from this table.

use crate::model::Constants;
use crate::number::real::Real;
use crate::state::Scalars;

/// One row of the table.
///
/// ```
/// use softanvil_kernel::{OUTPUTS, Output, Simulation, StepInput, preset};
///
/// let mut anvil = Simulation::new(&preset::study())?;
/// anvil.run(15e-3, &StepInput::default())?;
/// let peak = Output::find("result.peak_force").unwrap();
/// assert_eq!(Some((peak.read)(anvil.constants(), anvil.scalars())), anvil.output("result.peak_force"));
///
/// // A line of a table, and the line above it.
/// let names: Vec<String> = OUTPUTS.iter().map(|output| format!("{} [{}]", output.name, output.unit)).collect();
/// let row: Vec<f64> = OUTPUTS.iter().map(|output| (output.read)(anvil.constants(), anvil.scalars())).collect();
/// assert!(names.contains(&"result.peak_force [N]".into()) && row.iter().all(|value| value.is_finite()));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
pub struct Output {
    /// Its number, for ever: no other output gets it, even when this one is no more.
    pub id: u32,
    /// Structured name, `group.field`.
    pub name: &'static str,
    /// SI unit; "1" for ratios.
    pub unit: &'static str,
    /// The value at the current time.
    pub read: fn(&Constants, &Scalars) -> Real,
    /// Meaning, one line.
    pub description: &'static str,
}

impl Output {
    /// The row called `name`.
    pub fn find(name: &str) -> Option<&'static Output> {
        OUTPUTS.iter().find(|output| output.name == name)
    }
}

const fn output(
    id: u32,
    name: &'static str,
    unit: &'static str,
    read: fn(&Constants, &Scalars) -> Real,
    description: &'static str,
) -> Output {
    Output { id, name, unit, read, description }
}

/// Ids of outputs that are no more, which no other output gets: `energy.viscous_dissipation`.
pub const RETIRED_OUTPUTS: &[u32] = &[26];

/// Every scalar output.
pub static OUTPUTS: &[Output] = &[
    output(
        0,
        "contact.force",
        "N",
        |_, s| s.sampler.last.contact_force,
        "contact force on the impactor, mean over the last complete sampling interval of 50 us",
    ),
    output(
        1,
        "contact.force_step",
        "N",
        |_, s| s.force.contact,
        "contact force on the impactor in the last step alone, with the impulses of single nodes in it",
    ),
    output(
        28,
        "contact.force_filtered",
        "N",
        |_, s| s.sampler.filter.value(),
        "contact.force after the forward pass of the channel filter measurement.channel_class, which lags as any running \
         filter does; the standards' figure without lag needs a second pass backwards over the whole record",
    ),
    output(
        25,
        "contact.half_width",
        "m",
        |_, s| s.contact_half_width,
        "half of the width over which the face touches the anvil (radius if axisymmetric)",
    ),
    output(
        2,
        "core.reaction",
        "N",
        |_, s| s.sampler.last.core_reaction,
        "force of the layer on the core (what load cells under it see), mean over the last sampling interval",
    ),
    output(
        3,
        "impactor.position",
        "m",
        |_, s| s.impactor.position,
        "height of the face above the undeformed anvil; negative while it presses",
    ),
    output(4, "impactor.velocity", "m/s", |_, s| s.impactor.velocity, "velocity of the impactor, upwards"),
    output(
        5,
        "impactor.acceleration",
        "m/s2",
        |_, s| s.impactor.acceleration,
        "acceleration of the impactor in the last step, upwards",
    ),
    output(
        6,
        "impactor.deformation",
        "m",
        |_, s| s.impactor.deformation(),
        "depth of the face below the undeformed anvil",
    ),
    output(7, "result.peak_force", "N", |_, s| s.metrics.peak_force, "largest contact force so far (of contact.force)"),
    output(8, "result.max_deformation", "m", |_, s| s.metrics.max_deformation, "largest deformation so far"),
    output(
        9,
        "result.impact_duration",
        "s",
        |_, s| s.metrics.impact_duration(),
        "time covered by contact.force at or above measurement.force_threshold",
    ),
    output(10, "result.impulse", "N.s", |_, s| s.metrics.impulse, "impulse of the contact force so far"),
    output(11, "result.impact_speed", "m/s", |_, s| s.metrics.impact_speed, "downward speed before the first contact"),
    output(
        12,
        "result.rebound_speed",
        "m/s",
        |_, s| s.metrics.rebound_speed,
        "upward speed after the last contact so far; negative while the impactor still falls",
    ),
    output(13, "result.restitution", "1", |_, s| s.metrics.restitution(), "rebound speed over impact speed"),
    output(
        14,
        "result.contact_time",
        "s",
        |_, s| s.metrics.contact_time,
        "time from the first to the last contact so far",
    ),
    output(
        30,
        "result.complete",
        "1",
        |_, s| if s.contact_has_ended() { 1.0 } else { 0.0 },
        "1 once the face has touched and is clear of the layer for a whole sampling interval; at 0 the other results are \
         those so far",
    ),
    output(15, "energy.impactor_kinetic", "J", |_, s| s.energy.impactor_kinetic, "kinetic energy of the impactor"),
    output(16, "energy.layer_kinetic", "J", |_, s| s.energy.layer_kinetic, "kinetic energy of the layer"),
    output(17, "energy.elastic", "J", |_, s| s.energy.elastic, "long-term elastic energy of the layer"),
    output(
        18,
        "energy.viscous",
        "J",
        |_, s| s.energy.viscous,
        "work done on the viscous overstress, dissipated or still in its springs",
    ),
    output(19, "energy.slider_stored", "J", |_, s| s.energy.slider_stored, "energy in the damping springs"),
    output(
        20,
        "energy.slider_dissipation",
        "J",
        |_, s| s.energy.slider_dissipation,
        "energy dissipated by the sliders",
    ),
    output(27, "energy.tear", "J", |_, s| s.energy.tear, "energy dissipated by tearing"),
    output(31, "energy.softening", "J", |_, s| s.energy.softening, "energy dissipated by softening"),
    output(21, "energy.friction", "J", |_, s| s.energy.friction, "energy dissipated by friction"),
    output(22, "energy.contact", "J", |_, s| s.energy.contact, "energy lost in catching nodes of finite mass"),
    output(32, "energy.guide", "J", |_, s| s.energy.guide, "energy dissipated on the rails of the impactor"),
    output(23, "energy.external", "J", |_, s| s.energy.external, "energy at the start and work from outside"),
    output(
        24,
        "energy.residual",
        "J",
        |_, s| s.energy.residual(),
        "external energy that the other terms leave unexplained",
    ),
    output(
        29,
        "model.design_stretch",
        "1",
        |c, _| c.design_stretch,
        "smallest principal stretch in the section that the time step was chosen for; 1 where the step was given",
    ),
];
