//! Files and folders that appear complete or not at all: written next to their place, then renamed into it.

use std::fs::Permissions;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use tempfile::{Builder, NamedTempFile, TempDir};

/// Puts several files in place: all are written before the first appears.
///
/// # Errors
/// The path that cannot be written, and why.
pub fn write_files(files: &[(&Path, Vec<u8>)]) -> Result<(), (PathBuf, io::Error)> {
    let mut staged = Vec::new();
    for (path, content) in files {
        staged.push(stage_file(path, content).map_err(|error| (path.to_path_buf(), error))?);
    }
    for (file, place) in staged {
        file.persist(&place).map_err(|error| (place, error.error))?;
    }
    Ok(())
}

/// A file next to the place of `path`, and that place.
fn stage_file(path: &Path, content: &[u8]) -> io::Result<(NamedTempFile, PathBuf)> {
    let place = place_of(path)?;
    let mut builder = Builder::new();
    if let Some(permissions) = shared(0o666) {
        builder.permissions(permissions);
    }
    let folder = parent(&place);
    if !folder.is_dir() {
        return Err(io::Error::other(format!("there is no folder {}", folder.display())));
    }
    // Without the name of the temporary file, which nobody asked for.
    let unnamed = |error: io::Error| io::Error::from(error.kind());
    let mut file = builder.prefix(PREFIX).tempfile_in(folder).map_err(unnamed)?;
    file.write_all(content).map_err(unnamed)?;
    Ok((file, place))
}

/// Where a file called `path` belongs: where links lead, but only to what renaming may replace.
fn place_of(path: &Path) -> io::Result<PathBuf> {
    match path.metadata() {
        Err(_) => Ok(path.into()),
        Ok(there) if there.is_file() => path.canonicalize(),
        Ok(_) => Err(io::Error::other("it is there and is no file")),
    }
}

/// A folder next to `place`, to be filled and then given to [`replace_folder`]; removed if it is not.
///
/// # Errors
/// A parent folder that does not exist or cannot be written.
pub fn stage_folder(place: &Path) -> io::Result<TempDir> {
    let mut builder = Builder::new();
    if let Some(permissions) = shared(0o777) {
        builder.permissions(permissions);
    }
    builder.prefix(PREFIX).tempdir_in(parent(place))
}

/// Renames `staged` to `place`. A folder that stands there is removed, and put back if the renaming fails.
///
/// # Errors
/// What the file system refuses; `place` is as before then.
pub fn replace_folder(staged: TempDir, place: &Path) -> io::Result<()> {
    if !place.exists() {
        std::fs::rename(staged.path(), place)?;
    } else {
        let old = stage_folder(place)?;
        let kept = old.path().join("old");
        std::fs::rename(place, &kept)?;
        if let Err(error) = std::fs::rename(staged.path(), place) {
            std::fs::rename(&kept, place)?;
            return Err(error);
        }
    }
    // It has moved: there is nothing left to clean up.
    let _ = staged.keep();
    Ok(())
}

/// What names of things not yet in place begin with.
const PREFIX: &str = ".softanvil-";

/// The folder in which `path` stands.
pub fn parent(path: &Path) -> &Path {
    match path.parent() {
        Some(parent) if parent != Path::new("") => parent,
        _ => Path::new("."),
    }
}

/// The permissions that a file made in the ordinary way has (less the umask); temporary ones are private otherwise.
#[cfg(unix)]
fn shared(mode: u32) -> Option<Permissions> {
    Some(std::os::unix::fs::PermissionsExt::from_mode(mode))
}

#[cfg(not(unix))]
fn shared(_mode: u32) -> Option<Permissions> {
    None
}
