//! A folder that a command may replace.

use std::fs;
use std::path::{Path, PathBuf};

use crate::failure::Failure;
use crate::files::folder::digest;
use crate::files::staging;

/// What a folder of ours holds.
pub struct Kind {
    /// The option that names it.
    pub option: &'static str,
    /// What it is, for people.
    pub what: &'static str,
    /// The files in a folder that are ours; none if it is not.
    pub listed_files: fn(&Path) -> Vec<Listed>,
}

/// A file that a folder of ours should have.
pub struct Listed {
    /// Its name.
    pub name: String,
    /// Digest of what was written, if it was kept.
    pub digest: Option<String>,
}

/// A folder that may be written: it does not exist, is empty, or holds what we wrote and nothing else.
pub struct OwnFolder(PathBuf);

impl OwnFolder {
    /// Checks `folder`; with `overwrite` files of ours may have been changed since.
    ///
    /// # Errors
    /// Anything there that is not ours, or no place for a folder.
    pub fn new(folder: &Path, kind: &Kind, overwrite: bool) -> Result<Self, Failure> {
        let refuse =
            |reason: String| Err(Failure::Input(format!("{} {} is refused: {reason}", kind.option, folder.display())));
        if folder.file_name().is_none() {
            return refuse("expected the name of a folder".into());
        }
        if fs::symlink_metadata(folder).is_err() {
            let parent = staging::parent(folder);
            return match parent.is_dir() {
                true => Ok(Self(folder.into())),
                false => refuse(format!("there is no folder {}", parent.display())),
            };
        }
        match foreign_entry(folder, kind, overwrite) {
            Ok(None) => Ok(Self(fs::canonicalize(folder).unwrap_or_else(|_| folder.into()))),
            Ok(Some(Foreign::Changed(name))) => {
                refuse(format!("{name} in it was changed since it was written; --overwrite replaces it"))
            }
            Ok(Some(Foreign::Other(name))) => {
                refuse(format!("it holds {name}, which is no part of {} and will not be deleted", kind.what))
            }
            Err(error) => refuse(format!("it is there and is no folder that can be read ({error})")),
        }
    }

    /// The folder.
    pub fn path(&self) -> &Path {
        &self.0
    }
}

/// What speaks against a folder.
enum Foreign {
    /// Something that we did not put there.
    Other(String),
    /// A file of ours that somebody has changed.
    Changed(String),
}

/// The first thing in `folder` that is not as we left it.
fn foreign_entry(folder: &Path, kind: &Kind, overwrite: bool) -> std::io::Result<Option<Foreign>> {
    let ours = (kind.listed_files)(folder);
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let name = entry.file_name().to_string_lossy().into_owned();
        let Some(listed) = ours.iter().find(|listed| listed.name == name) else {
            return Ok(Some(Foreign::Other(name)));
        };
        if !entry.file_type()?.is_file() {
            return Ok(Some(Foreign::Other(name)));
        }
        if let (Some(written), false) = (&listed.digest, overwrite)
            && digest(&fs::read(entry.path())?) != *written
        {
            return Ok(Some(Foreign::Changed(name)));
        }
    }
    Ok(None)
}
