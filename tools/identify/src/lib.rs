//! From material tests to coefficients.
//!
//! From the file to the material:
//!
//! 1. [`data`] reads the files of a test machine.
//! 2. [`law`] fits hyperelastic laws to uniaxial, planar and equibiaxial curves and ranks them.
pub mod data;
pub mod law;
pub mod relaxation;
