//! What is in a Softanvil FMU besides the binary, and the packager that puts it together.
//!
//! * [`description`] writes `modelDescription.xml` from the variable table of `softanvil-ffi`,
//! * [`documentation`] the page that explains the variables,
//! * [`archive`] the zip file, byte for byte the same for the same content,
//! * [`platform`] tells for which platform a library was built, [`library`] finds the one that cargo built.

pub mod archive;
pub mod description;
pub mod documentation;
mod error;
pub mod library;
pub mod platform;

use std::fs;
use std::path::{Path, PathBuf};

pub use error::Error;
pub use library::find_library;

use archive::Archive;
use platform::Platform;

/// Name of the library in the FMU, and of the model in identifiers.
pub const MODEL_IDENTIFIER: &str = "softanvil";

/// What to package and where.
#[derive(Clone, Debug)]
pub struct Options {
    /// Shared libraries of Softanvil, one per platform.
    pub libraries: Vec<PathBuf>,
    /// Folder for the FMU; made if it does not exist.
    pub out: PathBuf,
}

/// Packages an FMU for FMI 2.0 co-simulation and returns its path, `softanvil-fmi2.fmu` in the folder asked for.
///
/// # Errors
/// A library that cannot be read, that is none, or of a platform that occurs twice, and what the file system refuses. A
/// file of that name is either complete and new, or as it was.
pub fn package(options: &Options) -> Result<PathBuf, Error> {
    let mut archive = Archive::new();
    archive.add("modelDescription.xml", description::fmi2().as_bytes())?;
    archive.add("model.png", include_bytes!("../assets/icon.png"))?;
    archive.add("documentation/index.html", documentation::page().as_bytes())?;
    archive.add("documentation/icon.svg", include_bytes!("../assets/icon.svg"))?;
    for (name, text) in LICENSES {
        archive.add(&format!("documentation/licenses/{name}"), text)?;
    }
    add_libraries(&mut archive, &options.libraries)?;
    let path = options.out.join(format!("{MODEL_IDENTIFIER}-fmi2.fmu"));
    write_whole(&path, &archive.finish()?)?;
    Ok(path)
}

/// Licence texts: of this project, and of what is linked into the library.
const LICENSES: [(&str, &[u8]); 4] = [
    ("license.txt", include_bytes!("../assets/licenses/license.txt")),
    ("MIT.txt", include_bytes!("../../LICENSE-MIT")),
    ("Apache-2.0.txt", include_bytes!("../../LICENSE-APACHE")),
    ("libm.txt", include_bytes!("../assets/licenses/libm.txt")),
];

fn add_libraries(archive: &mut Archive, libraries: &[PathBuf]) -> Result<(), Error> {
    let mut packed: Vec<Platform> = Vec::new();
    for path in libraries {
        let library = fs::read(path).map_err(|source| Error::Read { path: path.clone(), source })?;
        let platform = Platform::of(&library).ok_or_else(|| Error::NotALibrary { path: path.clone() })?;
        if packed.contains(&platform) {
            return Err(Error::Twice { path: path.clone(), platform: platform.fmi2_folder() });
        }
        packed.push(platform);
        let (folder, extension) = (platform.fmi2_folder(), platform.extension());
        archive.add(&format!("binaries/{folder}/{MODEL_IDENTIFIER}.{extension}"), &library)?;
    }
    if packed.is_empty() { Err(Error::NoLibrary) } else { Ok(()) }
}

/// Writes beside the target and renames, so that nobody ever sees half a file.
fn write_whole(path: &Path, content: &[u8]) -> Result<(), Error> {
    let refused = |source| Error::Write { path: path.to_path_buf(), source };
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(refused)?;
    }
    let part = path.with_extension("fmu.part");
    let written = fs::write(&part, content).and_then(|()| fs::rename(&part, path));
    written.map_err(|source| {
        let _ = fs::remove_file(&part);
        refused(source)
    })
}
