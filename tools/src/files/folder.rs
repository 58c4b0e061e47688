//! A folder in which files of this program stand beside those of others. A list with the digests of its files tells the
//! program which it wrote and nobody has changed since: those alone it replaces, unless it is told to.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use serde_json::{Value, json};
use softanvil_kernel::number::digest::Digest;

use crate::failure::Failure;
use crate::files::staging;

/// Name of the list.
pub const LIST: &str = "softanvil-files.json";
/// What the list says about its maker.
const GENERATOR: &str = "softanvil";

/// A folder of files.
pub struct Folder {
    path: PathBuf,
    overwrite: bool,
    /// Digests of the files that the program wrote, by name.
    listed: BTreeMap<String, String>,
    /// Files that this run may write, listed or not: such as grow while it runs, and are known by their first line.
    taken: BTreeSet<String>,
}

impl Folder {
    /// The folder at `path`, which need not exist; with `overwrite` every file in it may be replaced.
    pub fn new(path: &Path, overwrite: bool) -> Self {
        Self { path: path.into(), overwrite, listed: read_list(path), taken: BTreeSet::new() }
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Checks that files may be written under `names`.
    ///
    /// # Errors
    /// The first that is there and is not as this program left it.
    pub fn check<'a>(&self, names: impl IntoIterator<Item = &'a str>) -> Result<(), Failure> {
        for name in names {
            let there = std::fs::symlink_metadata(self.path.join(name)).is_ok();
            if there && !self.overwrite && !self.taken.contains(name) && !self.is_own(name) {
                return Err(self.refusal(name));
            }
        }
        // A list of somebody else's must not be lost either.
        let list = self.path.join(LIST);
        match !self.overwrite && self.listed.is_empty() && list.exists() && !is_list(&list) {
            true => Err(self.refusal(LIST)),
            false => Ok(()),
        }
    }

    /// Makes the folder, and takes the file called `name` as one that this run writes: there is none, it is listed, or it
    /// begins with `first_line`, which no file of another kind has.
    ///
    /// # Errors
    /// A file of somebody else's, or a folder that cannot be made.
    pub fn take(&mut self, name: &str, first_line: &str) -> Result<PathBuf, Failure> {
        let path = self.path.join(name);
        let begins = |text: String| text.starts_with(first_line);
        if !std::fs::read_to_string(&path).is_ok_and(begins) {
            self.check([name])?;
        }
        self.make()?;
        self.taken.insert(name.into());
        Ok(path)
    }

    /// Puts `files` in place, all of them or none.
    ///
    /// # Errors
    /// As [`Folder::check`], or the path that cannot be written.
    pub fn write(&mut self, files: &[(String, Vec<u8>)]) -> Result<(), Failure> {
        self.check(files.iter().map(|(name, _)| name.as_str()))?;
        self.make()?;
        for (name, content) in files.iter().filter(|(name, _)| !self.taken.contains(name)) {
            self.listed.insert(name.clone(), digest(content));
        }
        let list = json!({ "generator": GENERATOR, "version": env!("CARGO_PKG_VERSION"), "files": self.listed });
        let list = crate::output::json::text(&list).into_bytes();
        let paths: Vec<PathBuf> = files.iter().map(|(name, _)| self.path.join(name)).collect();
        let list_path = self.path.join(LIST);
        let mut placed: Vec<(&Path, Vec<u8>)> =
            paths.iter().map(PathBuf::as_path).zip(files.iter().map(|(_, content)| content.clone())).collect();
        placed.push((&list_path, list));
        staging::write_files(&placed).map_err(|(path, error)| Failure::writing(&path, error))
    }

    /// Removes the files called `names`, those that are there; to be called after [`Folder::check`] and before
    /// [`Folder::write`], which writes the list anew.
    ///
    /// # Errors
    /// The path that cannot be removed.
    pub fn remove<'a>(&mut self, names: impl IntoIterator<Item = &'a str>) -> Result<(), Failure> {
        for name in names {
            let path = self.path.join(name);
            if std::fs::symlink_metadata(&path).is_ok() {
                std::fs::remove_file(&path).map_err(|error| Failure::writing(&path, error))?;
            }
            self.listed.remove(name);
        }
        Ok(())
    }

    fn make(&self) -> Result<(), Failure> {
        std::fs::create_dir_all(&self.path).map_err(|error| Failure::writing(&self.path, error))
    }

    /// Whether the file called `name` is listed and has its digest.
    fn is_own(&self, name: &str) -> bool {
        let content = std::fs::read(self.path.join(name));
        content.is_ok_and(|content| self.listed.get(name) == Some(&digest(&content)))
    }

    fn refusal(&self, name: &str) -> Failure {
        Failure::Input(format!(
            "--out {} is refused: {name} is there and not as this program left it; --overwrite replaces it",
            self.path.display()
        ))
    }
}

/// Names and digests of the list in `folder`; none if there is no list of ours.
fn read_list(folder: &Path) -> BTreeMap<String, String> {
    let text = std::fs::read_to_string(folder.join(LIST)).unwrap_or_default();
    let list: Value = serde_json::from_str(&text).unwrap_or_default();
    if list["generator"] != GENERATOR {
        return BTreeMap::new();
    }
    let files = list["files"].as_object().cloned().unwrap_or_default();
    files.into_iter().filter_map(|(name, digest)| Some((name, digest.as_str()?.to_string()))).collect()
}

fn is_list(path: &Path) -> bool {
    let text = std::fs::read_to_string(path).unwrap_or_default();
    serde_json::from_str::<Value>(&text).is_ok_and(|list| list["generator"] == GENERATOR)
}

/// Digest of a content, 16 hexadecimal digits.
pub fn digest(content: &[u8]) -> String {
    let mut digest = Digest::new();
    digest.word(content.len() as u64);
    for bytes in content.chunks(size_of::<u64>()) {
        let mut word = [0; size_of::<u64>()];
        word[..bytes.len()].copy_from_slice(bytes);
        digest.word(u64::from_le_bytes(word));
    }
    format!("{:016x}", digest.value())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(name: &str, content: &str) -> (String, Vec<u8>) {
        (name.into(), content.into())
    }

    #[test]
    fn own_files_are_replaced_and_changed_or_foreign_ones_are_not() {
        let place = tempfile::tempdir().unwrap();
        let path = place.path();
        let read = |name: &str| std::fs::read_to_string(path.join(name)).unwrap();
        Folder::new(path, false).write(&[file("a", "1"), file("b", "1")]).unwrap();
        Folder::new(path, false).write(&[file("a", "2")]).unwrap();
        assert_eq!((read("a"), read("b")), ("2".into(), "1".into()));
        std::fs::write(path.join("b"), "mine").unwrap();
        let error = Folder::new(path, false).write(&[file("a", "3"), file("b", "3")]).unwrap_err().to_string();
        assert!(error.contains("b is there and not as this program left it"), "{error}");
        assert_eq!((read("a"), read("b")), ("2".into(), "mine".into()));
        Folder::new(path, true).write(&[file("b", "3")]).unwrap();
        assert_eq!(read("b"), "3");
        // What was overwritten is the program's own from then on, as is the file that the first run wrote.
        Folder::new(path, false).write(&[file("a", "4"), file("b", "4")]).unwrap();
    }

    #[test]
    fn a_file_that_grows_is_known_by_its_first_line_and_a_foreign_list_is_left_alone() {
        let place = tempfile::tempdir().unwrap();
        let path = place.path();
        std::fs::write(path.join("log"), "a,b\n1,2\n").unwrap();
        assert!(Folder::new(path, false).take("log", "a,b,c\n").is_err());
        let mut folder = Folder::new(path, false);
        folder.take("log", "a,b\n").unwrap();
        folder.write(&[file("log", "a,b\n3,4\n")]).unwrap();
        std::fs::write(path.join(LIST), "{}").unwrap();
        assert!(Folder::new(path, false).write(&[file("new", "1")]).unwrap_err().to_string().contains(LIST));
        assert!(!path.join("new").exists());
    }

    #[test]
    fn a_digest_tells_contents_apart_that_differ_by_zeros_at_the_end() {
        assert_ne!(digest(b"a"), digest(b"a\0"));
        assert_ne!(digest(b""), digest(b"\0"));
    }
}
