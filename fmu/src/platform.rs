//! For which platform a shared library was built, from the head of the file.

/// A platform that FMI 2.0 has a folder for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Platform {
    /// Linux on x86-64.
    LinuxX86_64,
    /// Windows on x86-64.
    WindowsX86_64,
}

/// `e_machine` of x86-64 in ELF.
const ELF_X86_64: u16 = 62;
/// `Machine` of x86-64 in PE.
const PE_X86_64: u16 = 0x8664;

impl Platform {
    /// The platform of `library`; none if it is no library or of another platform.
    pub fn of(library: &[u8]) -> Option<Self> {
        if library.starts_with(b"\x7fELF") {
            return (half_word(library, 18)? == ELF_X86_64).then_some(Self::LinuxX86_64);
        }
        let header = usize::from(half_word(library, 60)?);
        let is_windows = library.starts_with(b"MZ") && library.get(header..header + 4)? == b"PE\0\0";
        (is_windows && half_word(library, header + 4)? == PE_X86_64).then_some(Self::WindowsX86_64)
    }

    /// Name of the folder under `binaries` in FMI 2.0.
    pub fn fmi2_folder(self) -> &'static str {
        match self {
            Self::LinuxX86_64 => "linux64",
            Self::WindowsX86_64 => "win64",
        }
    }

    /// Extension of shared libraries.
    pub fn extension(self) -> &'static str {
        match self {
            Self::LinuxX86_64 => "so",
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
        let mut pe = b"MZ".to_vec();
        pe.resize(128, 0);
        pe[60] = 64;
        pe[64..70].copy_from_slice(b"PE\0\0\x64\x86");
        assert_eq!(Platform::of(&pe), Some(Platform::WindowsX86_64));
        for other in [&b""[..], b"MZ", b"\x7fELF", b"#!/bin/sh\n"] {
            assert_eq!(Platform::of(other), None);
        }
    }
}
