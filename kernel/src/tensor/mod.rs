//! Tensors of the section, with one shear component in the plane and none out of it, and of the solid.

pub mod deviator;
pub mod kinematics;
pub mod solid_deviator;
pub mod solid_kinematics;
pub mod stretch;
pub mod symmetric;
