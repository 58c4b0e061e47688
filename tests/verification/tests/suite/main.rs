//! The verification suite, in one program because every part links the same solvers.

mod closed_forms;
mod driven;
mod drop;
mod effects;
mod elastic_laws;
mod fields;
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
mod sections;
mod single;
mod slider;
mod stability;
mod tear;
mod viscoelastic;
mod volumetric;
