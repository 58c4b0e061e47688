//! Platforms: what an FMU calls them, what Rust calls them, and for which one a library was built.

use softanvil::variables::Version;

/// A platform that FMUs are made for.
///
/// ```
/// use softanvil_fmu::Version;
/// use softanvil_fmu::platform::Platform;
///
/// let platform = Platform::of_target("aarch64-unknown-linux-gnu").unwrap();
/// assert_eq!(platform.folder(Version::Fmi3), "aarch64-linux");
/// assert_eq!(Platform::of(b"#!/bin/sh\n"), None);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Platform {
    /// Linux on x86-64.
    LinuxX86_64,
    /// Linux on 64-bit ARM.
    LinuxAarch64,
    /// Windows on x86-64.
    WindowsX86_64,
}

/// `e_machine` of x86-64 in ELF.
const ELF_X86_64: u16 = 62;
/// `e_machine` of 64-bit ARM in ELF.
const ELF_AARCH64: u16 = 183;
/// `Machine` of x86-64 in PE.
const PE_X86_64: u16 = 0x8664;

impl Platform {
    /// Every platform.
    pub const ALL: [Self; 3] = [Self::LinuxX86_64, Self::LinuxAarch64, Self::WindowsX86_64];

    /// The platform of `library`; none if it is no library or of another platform.
    pub fn of(library: &[u8]) -> Option<Self> {
        if library.starts_with(b"\x7fELF") {
            return match half_word(library, 18)? {
                ELF_X86_64 => Some(Self::LinuxX86_64),
                ELF_AARCH64 => Some(Self::LinuxAarch64),
                _ => None,
            };
        }
        let header = usize::from(half_word(library, 60)?);
        let is_windows = library.starts_with(b"MZ") && library.get(header..header + 4)? == b"PE\0\0";
        (is_windows && half_word(library, header + 4)? == PE_X86_64).then_some(Self::WindowsX86_64)
    }

    /// The platform that Rust calls `target`.
    pub fn of_target(target: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|platform| platform.target() == target)
    }

    /// The platform that this program runs on.
    pub fn host() -> Option<Self> {
        match (std::env::consts::OS, std::env::consts::ARCH) {
            ("linux", "x86_64") => Some(Self::LinuxX86_64),
            ("linux", "aarch64") => Some(Self::LinuxAarch64),
            ("windows", "x86_64") => Some(Self::WindowsX86_64),
            _ => None,
        }
    }

    /// Rust's name.
    pub fn target(self) -> &'static str {
        match self {
            Self::LinuxX86_64 => "x86_64-unknown-linux-gnu",
            Self::LinuxAarch64 => "aarch64-unknown-linux-gnu",
            Self::WindowsX86_64 => "x86_64-pc-windows-gnu",
        }
    }

    /// Name of the folder under `binaries`. FMI 2.0 has one name for Linux on 64 bits, whatever the processor.
    pub fn folder(self, version: Version) -> &'static str {
        match (version, self) {
            (Version::Fmi2, Self::LinuxX86_64 | Self::LinuxAarch64) => "linux64",
            (Version::Fmi2, Self::WindowsX86_64) => "win64",
            (Version::Fmi3, Self::LinuxX86_64) => "x86_64-linux",
            (Version::Fmi3, Self::LinuxAarch64) => "aarch64-linux",
            (Version::Fmi3, Self::WindowsX86_64) => "x86_64-windows",
        }
    }

    /// Extension of shared libraries.
    pub fn extension(self) -> &'static str {
        match self {
            Self::LinuxX86_64 | Self::LinuxAarch64 => "so",
            Self::WindowsX86_64 => "dll",
        }
    }
}

fn half_word(bytes: &[u8], at: usize) -> Option<u16> {
    bytes.get(at..at + 2)?.try_into().map(u16::from_le_bytes).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_heads_of_the_two_formats_are_told_apart() {
        let mut elf = b"\x7fELF\x02\x01\x01".to_vec();
        elf.resize(64, 0);
        assert_eq!(Platform::of(&elf), None);
        elf[18] = 62;
        assert_eq!(Platform::of(&elf), Some(Platform::LinuxX86_64));
        elf[18] = 183;
        assert_eq!(Platform::of(&elf), Some(Platform::LinuxAarch64));
        let mut pe = b"MZ".to_vec();
        pe.resize(128, 0);
        pe[60] = 64;
        pe[64..70].copy_from_slice(b"PE\0\0\x64\x86");
        assert_eq!(Platform::of(&pe), Some(Platform::WindowsX86_64));
        for other in [&b""[..], b"MZ", b"\x7fELF", b"#!/bin/sh\n"] {
            assert_eq!(Platform::of(other), None);
        }
    }

    #[test]
    fn names_lead_back_to_their_platform() {
        for platform in Platform::ALL {
            assert_eq!(Platform::of_target(platform.target()), Some(platform));
        }
        assert_eq!(Platform::of_target("wasm32-unknown-unknown"), None);
    }
}
