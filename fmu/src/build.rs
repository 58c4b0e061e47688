//! Builds the binary of an FMU from the sources of this project with cargo: the FMI functions alone, without the standard
//! library, so that nothing is needed but the C library, and without anything that differs between two builds.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::platform::Platform;
use crate::{Error, MODEL_IDENTIFIER};

/// Cargo's profile for the binary.
const PROFILE: &str = "fmu";

/// Builds the library of `platform`; cargo's messages go to the standard error.
///
/// # Errors
/// No sources, no cargo, or a build that failed.
pub fn build(platform: Platform) -> Result<PathBuf, Error> {
    let root = sources()?;
    let manifest = root.join(MANIFEST);
    let folder = root.join("target/fmu");
    let failed = |reason: String| Error::Build { target: platform.target(), hint: hint(platform), reason };
    let status = command(platform, &manifest, &folder).status().map_err(|error| failed(error.to_string()))?;
    if !status.success() {
        return Err(failed(status.to_string()));
    }
    let name = match platform {
        Platform::WindowsX86_64 => format!("{MODEL_IDENTIFIER}.dll"),
        _ => format!("lib{MODEL_IDENTIFIER}.so"),
    };
    Ok(folder.join(platform.target()).join(PROFILE).join(name))
}

/// The manifest that is built, in the folder of the sources.
const MANIFEST: &str = "ffi/Cargo.toml";

/// The folder of the sources: the working folder or this program's, or one above. It is not compiled in: programs that are built in two
/// places would differ, and those that are copied would lead to a folder of another machine.
fn sources() -> Result<PathBuf, Error> {
    let working = std::env::current_dir().unwrap_or_default();
    let program = std::env::current_exe().unwrap_or_default();
    let mut folders = working.ancestors().chain(program.ancestors());
    let found = folders.find(|folder| folder.join(MANIFEST).is_file() && folder.join("include/softanvil.h").is_file());
    found.map(Path::to_path_buf).ok_or(Error::NoSources { root: working })
}

fn command(platform: Platform, manifest: &Path, folder: &Path) -> Command {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(cargo);
    command.args([
        "rustc",
        "--quiet",
        "--lib",
        "--no-default-features",
        "--features",
        "pads,solid",
        "--crate-type",
        "cdylib",
    ]);
    command.args(["--profile", PROFILE, "--target", platform.target()]);
    command.arg("--manifest-path").arg(manifest).arg("--target-dir").arg(folder).arg("--");
    // No identifier and no date in the file; and the C library, which nothing else brings in.
    command.args(match platform {
        Platform::WindowsX86_64 => &["-Clink-arg=-Wl,--no-insert-timestamp"][..],
        _ => &["-Clink-arg=-Wl,--build-id=none", "-Clink-arg=-lc"][..],
    });
    if platform == Platform::LinuxAarch64 && Platform::host() != Some(platform) {
        command.arg("-Clinker=aarch64-linux-gnu-gcc");
    }
    command
}

/// What a machine may lack.
fn hint(platform: Platform) -> &'static str {
    match platform {
        Platform::LinuxX86_64 => "it needs cargo, `rustup target add x86_64-unknown-linux-gnu` and gcc",
        Platform::LinuxAarch64 => {
            "it needs cargo, `rustup target add aarch64-unknown-linux-gnu` and aarch64-linux-gnu-gcc (Debian's \
             gcc-aarch64-linux-gnu and libc6-dev-arm64-cross)"
        }
        Platform::WindowsX86_64 => {
            "it needs cargo, `rustup target add x86_64-pc-windows-gnu` and x86_64-w64-mingw32-gcc (Debian's \
             gcc-mingw-w64-x86-64)"
        }
    }
}
