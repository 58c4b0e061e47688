//! What is in a Softanvil FMU besides the binary, and the packager that puts it together.
//!
//! * [`description`] writes `modelDescription.xml` from the variable table of `softanvil-ffi`, [`terminals`] what FMI 3.0
//!   has besides,
//! * [`documentation`] the page that explains the variables, [`mod@reference`] the results to compare with,
//! * [`mod@build`] makes the binary of a platform, [`platform`] tells for which one a library was built,
//! * `archive` the zip file, byte for byte the same for the same content.

mod archive;
pub mod build;
pub mod description;
pub mod documentation;
mod error;
pub mod platform;
pub mod reference;
pub mod terminals;

use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};

use memchr::memmem;

pub use build::build;
pub use error::Error;
pub use softanvil::variables::Version;

use archive::Archive;
use platform::Platform;

/// Name of the library in the FMU, and of the model in identifiers.
pub const MODEL_IDENTIFIER: &str = "softanvil";

/// What to package and where.
///
/// ```
/// use softanvil_fmu::{Options, Version, is_ours, package};
///
/// let folder = tempfile::tempdir()?;
/// let library = folder.path().join("libsoftanvil.so");
/// # // The head of one and the name of a function, which is all that the packager looks at.
/// # let mut head = b"\x7fELF\x02\x01\x01".to_vec();
/// # head.resize(64, 0);
/// # head[18] = 62;
/// # head.extend_from_slice(b"fmi3InstantiateCoSimulation\0");
/// # std::fs::write(&library, head)?;
/// let options = Options { version: Version::Fmi3, libraries: vec![library], out: folder.path().join("made") };
/// let fmu = package(&options)?;
/// assert!(fmu == options.path() && fmu.ends_with("made/softanvil-fmi3.fmu"));
/// assert!(is_ours(&fmu));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Options {
    /// Version of the standard.
    pub version: Version,
    /// Shared libraries of Softanvil, one per platform.
    pub libraries: Vec<PathBuf>,
    /// Folder for the FMU; made if it does not exist.
    pub out: PathBuf,
}

impl Options {
    /// The FMU that they make.
    pub fn path(&self) -> PathBuf {
        let number = match self.version {
            Version::Fmi2 => 2,
            Version::Fmi3 => 3,
        };
        self.out.join(format!("{MODEL_IDENTIFIER}-fmi{number}.fmu"))
    }
}

/// Whether the file at `path` is an FMU of this model.
pub fn is_ours(path: &Path) -> bool {
    let described = || -> Option<String> {
        let mut archive = zip::ZipArchive::new(fs::File::open(path).ok()?).ok()?;
        let mut text = String::new();
        archive.by_name("modelDescription.xml").ok()?.read_to_string(&mut text).ok()?;
        Some(text)
    };
    described().is_some_and(|text| text.contains(&format!("modelIdentifier=\"{MODEL_IDENTIFIER}\"")))
}

/// Packages an FMU for co-simulation and returns its path, `softanvil-fmi2.fmu` or `softanvil-fmi3.fmu` in the folder asked
/// for.
///
/// # Errors
/// A library that cannot be read, that is none, or of a platform that occurs twice, and what the file system refuses. A
/// file of that name is either complete and new, or as it was.
pub fn package(options: &Options) -> Result<PathBuf, Error> {
    let mut archive = Archive::new();
    archive.add("modelDescription.xml", description::xml(options.version).as_bytes())?;
    match options.version {
        Version::Fmi2 => archive.add("model.png", ICON)?,
        Version::Fmi3 => {
            archive.add("terminalsAndIcons/icon.png", ICON)?;
            archive.add("terminalsAndIcons/terminalsAndIcons.xml", terminals::xml().as_bytes())?;
        }
    }
    archive.add("documentation/index.html", documentation::page(options.version).as_bytes())?;
    for (name, picture) in PICTURES {
        archive.add(&format!("documentation/{name}"), picture)?;
    }
    for (name, text) in LICENSES {
        archive.add(&format!("documentation/licenses/{name}"), text)?;
    }
    archive.add(&format!("{}/fmi-ls-manifest.xml", reference::FOLDER), reference::manifest().as_bytes())?;
    archive.add(&format!("{}/{}", reference::FOLDER, reference::RESULTS), &reference::results()?)?;
    add_libraries(&mut archive, options)?;
    let path = options.path();
    write_whole(&path, &archive.finish()?)?;
    Ok(path)
}

/// The icon.
const ICON: &[u8] = include_bytes!("../assets/icon.png");

/// Pictures of the documentation.
const PICTURES: [(&str, &[u8]); 3] = [
    ("icon.svg", include_bytes!("../assets/icon.svg")),
    ("force-time.svg", include_bytes!("../assets/force-time.svg")),
    ("coupling.svg", include_bytes!("../assets/coupling.svg")),
];

/// Licence texts: of this project, and of what is linked into the library.
const LICENSES: [(&str, &[u8]); 4] = [
    ("license.txt", include_bytes!("../assets/licenses/license.txt")),
    ("MIT.txt", include_bytes!("../assets/licenses/MIT.txt")),
    ("Apache-2.0.txt", include_bytes!("../assets/licenses/Apache-2.0.txt")),
    ("libm.txt", include_bytes!("../assets/licenses/libm.txt")),
];

/// What an importer calls first.
fn first_function(version: Version) -> &'static str {
    match version {
        Version::Fmi2 => "fmi2Instantiate",
        Version::Fmi3 => "fmi3InstantiateCoSimulation",
    }
}

fn add_libraries(archive: &mut Archive, options: &Options) -> Result<(), Error> {
    let mut packed: Vec<&str> = Vec::new();
    for path in &options.libraries {
        let library = fs::read(path).map_err(|source| Error::Read { path: path.clone(), source })?;
        let platform = Platform::of(&library).ok_or_else(|| Error::NotALibrary { path: path.clone() })?;
        let function = first_function(options.version);
        // As in a table of symbols: programs may have the bare words.
        if memmem::find(&library, format!("{function}\0").as_bytes()).is_none() {
            return Err(Error::NoFmi { path: path.clone(), function });
        }
        let (folder, extension) = (platform.folder(options.version), platform.extension());
        if packed.contains(&folder) {
            return Err(Error::Twice { path: path.clone(), platform: folder });
        }
        packed.push(folder);
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
