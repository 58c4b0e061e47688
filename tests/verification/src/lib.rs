//! What the verification problems share: the tolerances, a driver for one element, and scenarios.

pub mod deformation;
pub mod element;
pub mod scenes;
pub mod tolerance;

/// Compiles and runs the Rust program of the README.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
pub struct Readme;
