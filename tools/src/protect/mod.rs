//! What a pad is worth: the numbers of a drop on it beside those on the bare anvil, and the verdict of a standard.
//!
//! [`padding`] says which layers are the pad, [`watch`] what happens within the layers while a drop is simulated, [`numbers`] what
//! came of it, [`standard`] what a standard asks for and [`verdict`] whether that holds; [`trial`] does all of it for several pads,
//! which [`table`], [`json`] and [`picture`] show.

pub mod json;
pub mod numbers;
pub mod padding;
pub mod picture;
pub mod standard;
pub mod table;
pub mod trial;
pub mod verdict;
pub mod watch;
