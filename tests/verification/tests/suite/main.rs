//! The verification suite, in one program because every part links the same solvers.

mod closed_forms;
mod drop;
mod elastic_laws;
mod fields;
mod flat_contact;
mod frequency;
mod harmonic;
mod histories;
mod impactor;
mod instruction_sets;
mod layers;
mod maxwell;
mod ogden;
mod patch;
mod plausible;
mod presets;
mod problems;
mod rings;
mod sections;
mod single;
mod slider;
mod small_strain;
mod stability;
mod tear;
mod viscoelastic;
mod volumetric;
