//! `softanvil fmu`: builds the binaries and packages the FMUs.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use softanvil_fmu::platform::Platform;
use softanvil_fmu::{Error, Version, build, package};

use super::output_files::Overwrite;
use crate::failure::Failure;

/// Package the simulation as FMUs for co-simulation: softanvil-fmi2.fmu and softanvil-fmi3.fmu.
///
/// The binaries are built from the sources of this program by cargo; `--target all` makes the FMUs for every platform.
#[derive(Debug, Args)]
pub struct Options {
    /// Folder for the FMUs, made if it does not exist; FMUs of Softanvil that stand there are replaced
    #[arg(long, value_name = "DIR", default_value = ".")]
    out: PathBuf,
    /// Version of the standard [default: both]
    #[arg(long = "fmi", value_name = "VERSION")]
    versions: Vec<Fmi>,
    /// Platform to build for, as often as needed [default: this one]
    ///
    /// FMI 2.0 has one folder for Linux on 64 bits: with all targets, its FMU has the binary for x86-64 there.
    #[arg(long = "target", value_name = "TARGET")]
    targets: Vec<Target>,
    /// Shared library to package instead of building one, once per platform
    #[arg(long = "library", value_name = "FILE", conflicts_with = "targets")]
    libraries: Vec<PathBuf>,
    #[command(flatten)]
    overwrite: Overwrite,
}

/// Versions of the standard.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Fmi {
    /// FMI 2.0
    #[value(name = "2")]
    Two,
    /// FMI 3.0
    #[value(name = "3")]
    Three,
}

/// Platforms.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Target {
    /// Linux on x86-64
    #[value(name = "x86_64-unknown-linux-gnu")]
    LinuxX86_64,
    /// Linux on 64-bit ARM
    #[value(name = "aarch64-unknown-linux-gnu")]
    LinuxAarch64,
    /// Windows on x86-64
    #[value(name = "x86_64-pc-windows-gnu")]
    WindowsX86_64,
    /// All of them
    All,
}

/// Builds and packages; tells where the FMUs are.
///
/// # Errors
/// A library that cannot be built, found, read or used, and a folder that cannot be written.
pub fn carry_out(options: &Options) -> Result<String, Failure> {
    let plan = |version, libraries| softanvil_fmu::Options { version, libraries, out: options.out.clone() };
    for version in versions(&options.versions) {
        let path = plan(version, Vec::new()).path();
        if !softanvil_fmu::is_ours(&path) {
            options.overwrite.check_file("--out", &path)?;
        }
    }
    let libraries = match options.libraries.as_slice() {
        [] => built(&options.targets)?,
        given => given.iter().map(|path| (None, path.clone())).collect(),
    };
    let mut told = String::new();
    for version in versions(&options.versions) {
        let all = options.targets.contains(&Target::All);
        let fits = |platform: &Option<Platform>| {
            !(all && version == Version::Fmi2 && *platform == Some(Platform::LinuxAarch64))
        };
        let libraries = libraries.iter().filter(|(platform, _)| fits(platform)).map(|(_, path)| path.clone()).collect();
        let path = package(&plan(version, libraries)).map_err(failure)?;
        told += &format!("FMU in {}\n", path.display());
    }
    Ok(told)
}

fn versions(given: &[Fmi]) -> Vec<Version> {
    let wanted = |fmi: Fmi| given.is_empty() || given.iter().any(|one| *one as usize == fmi as usize);
    let both = [(Fmi::Two, Version::Fmi2), (Fmi::Three, Version::Fmi3)];
    both.into_iter().filter(|(fmi, _)| wanted(*fmi)).map(|(_, version)| version).collect()
}

fn built(targets: &[Target]) -> Result<Vec<(Option<Platform>, PathBuf)>, Failure> {
    let host = || Platform::host().ok_or(Failure::Input("this platform needs --target TARGET".to_owned()));
    let mut platforms = Vec::new();
    for target in targets {
        platforms.extend(match target {
            Target::LinuxX86_64 => vec![Platform::LinuxX86_64],
            Target::LinuxAarch64 => vec![Platform::LinuxAarch64],
            Target::WindowsX86_64 => vec![Platform::WindowsX86_64],
            Target::All => Platform::ALL.to_vec(),
        });
    }
    if platforms.is_empty() {
        platforms.push(host()?);
    }
    platforms.into_iter().map(|platform| Ok((Some(platform), build(platform).map_err(failure)?))).collect()
}

fn failure(error: Error) -> Failure {
    match error {
        Error::Archive(_) | Error::Write { .. } | Error::Build { .. } => Failure::Failed(error.to_string()),
        _ => Failure::Input(error.to_string()),
    }
}
