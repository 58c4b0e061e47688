//! From material tests to coefficients.
//!
//! From the file to the material:
//!
//! 1. [`data`] reads the files of a test machine.
//! 2. [`law`] fits hyperelastic laws to uniaxial, planar and equibiaxial curves and ranks them.
//! 3. [`relaxation`] fits Prony series to stress relaxation.
//! 4. [`export`] writes the material for other programs; [`study`] is a start without data.

pub mod data;
pub mod export;
pub mod law;
mod least_squares;
pub mod relaxation;
pub mod study;
