//! The hyperfoam law of Ogden and Hill, which changes its volume: its fit to tests whose free directions no instrument saw.
//!
//! [`stress`] has the stress of a term and finds the free stretch of a state, [`search`] the coefficients, [`stability`] says over
//! which stretches they are stable. The closed forms here have the derivatives that a search needs; the kernel's own stresses are
//! those that everything else goes by, and a test holds the two together.

pub mod search;
pub mod stability;
pub mod stress;
