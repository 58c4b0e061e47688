//! Calibration: the parameters with which simulated impacts come closest to measured ones.
//!
//! 1. [`problem`] is the file that says what is searched for; [`variable`] a parameter with its bounds, [`target`] the
//!    measured impacts, [`possible`] which numbers they can have, [`material_test`] tests of the material by itself, which [`uniaxial`] computes, [`prior`] a softer
//!    demand of the same kind.
//! 2. [`objective`] turns values into a score: it simulates the impacts and compares.
//! 3. [`search`] looks for the lowest score with CMA-ES and restarts; every evaluation goes to the [`log`], from which an
//!    interrupted search continues.
//! 4. [`result`] is what came out: the best values, whether the search has converged ([`convergence`]), and the
//!    [`spread`] of values that are about as good, from which [`determined`] tells what the data determine;
//!    [`front`] is what impacts and material tests cost each other.
//! 5. [`uncertainty`] goes on from there to the posterior of the values, and to bands of what they predict.

pub mod convergence;
pub mod determined;
pub mod front;
pub mod log;
pub mod material_test;
pub mod objective;
pub mod possible;
pub mod prior;
pub mod problem;
pub mod result;
pub mod search;
pub mod spread;
pub mod target;
pub mod uncertainty;
pub mod uniaxial;
pub mod variable;
