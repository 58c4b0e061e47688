//! Finds the shared library that cargo built together with the running program.

use std::env::consts::{DLL_PREFIX, DLL_SUFFIX};
use std::path::PathBuf;

use crate::{Error, MODEL_IDENTIFIER};

/// The shared library in the `deps` folder beside the running program, where cargo puts it when it builds a program that
/// depends on it, or else beside the program itself, where cargo puts it when it builds the library alone.
///
/// # Errors
/// No such library; the message tells how to get one.
pub fn find_library() -> Result<PathBuf, Error> {
    let name = format!("{DLL_PREFIX}{MODEL_IDENTIFIER}{DLL_SUFFIX}");
    let beside = std::env::current_exe().ok().and_then(|program| program.parent().map(PathBuf::from));
    let searched: Vec<PathBuf> = beside.into_iter().flat_map(|folder| [folder.join("deps"), folder]).collect();
    let found = searched.iter().map(|folder| folder.join(&name)).find(|path| path.is_file());
    found.ok_or(Error::LibraryNotFound { name, searched })
}
