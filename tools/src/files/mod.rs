//! Files that are written whole or not at all, in folders where nothing of others is replaced.

pub mod folder;
pub mod place;
pub mod staging;
