//! Uncertainty: how far the measured numbers leave the parameters open, and what that means for predictions.
//!
//! 1. [`options`] is the section `[uncertainty]` of a problem file; [`error_model`] the likelihood of the measured numbers,
//!    with the probabilities of [`normal`].
//! 2. [`waves`] goes from a converged search to samples: it simulates points, which [`runs`] remembers, fits an
//!    [`emulator`] to them, and samples the [`density`] with the [`sampler`].
//! 3. [`posterior`] is the file with the samples, [`summary`] what it tells, [`predict`] the bands that follow for an impact.

pub mod density;
pub mod emulator;
pub mod error_model;
mod infer;
pub mod normal;
pub mod options;
mod outcome;
pub mod posterior;
pub mod predict;
pub mod runs;
pub mod sampler;
pub mod shipped;
pub mod summary;
pub mod waves;

pub use infer::infer;
pub use outcome::Outcome;
