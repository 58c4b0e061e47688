//! From the tables of a test machine to curves in SI units.
//!
//! The crate `softanvil-records` reads the files. [`curve`] makes stretches and nominal stresses of their columns (with
//! [`specimen`], [`touch`] for where they begin, and [`shear`] for a shear), [`volume`] reads the volume beside them, [`cycles`] tells loading from unloading, [`repeats`] makes one curve
//! of several specimens, and [`thinned`] fewer points of very many.

pub mod curve;
pub mod cycles;
pub mod point;
pub mod repeats;
pub mod shear;
pub mod specimen;
pub mod thinned;
pub mod touch;
pub mod volume;
