//! Files that are written whole or not at all, in folders where nothing of others is replaced.

pub mod folder;
pub mod own_folder;
pub mod staging;
