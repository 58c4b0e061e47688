//! The computations behind the verification problems, shared by the tests and the table.

pub mod bar_wave;
pub mod bonded_strip;
pub mod checkerboard;
pub mod closed_forms;
pub mod contact_convergence;
pub mod cook;
pub mod coulomb_block;
pub mod cylinder;
pub mod foam;
pub mod harmonic;
pub mod hertz;
pub mod impactor;
pub mod indentation;
pub mod interface;
pub mod lame;
pub mod maxwell;
pub mod patch;
pub mod patch_distorted;
pub mod reduction;
pub mod slider;
pub mod softening;
pub mod solid_section;
pub mod swinging_plate;
pub mod tear;
pub mod viscoelastic;
pub mod volumetric;
