//! Tensors of the section: one shear component in the plane, none out of it.

pub mod deviator;
pub mod kinematics;
pub mod stretch;
