//! What this program is: version, kernel digest, target.

use std::env::consts::{ARCH, OS};
use std::sync::LazyLock;

use softanvil_kernel::{InstructionSet, KERNEL_DIGEST};

/// The kernel digest as packages state it: 16 hexadecimal digits.
pub fn kernel_digest() -> String {
    format!("{KERNEL_DIGEST:016x}")
}

/// What this program was compiled for: processor, system and C library.
pub fn target() -> String {
    let library = if cfg!(target_env = "musl") {
        "-musl"
    } else if cfg!(target_env = "gnu") {
        "-gnu"
    } else {
        ""
    };
    format!("{ARCH}-{OS}{library}")
}

/// What `--version` prints behind the name of the program.
pub fn long_version() -> &'static str {
    static TEXT: LazyLock<String> = LazyLock::new(|| {
        format!(
            "{}\nkernel digest {} (`softanvil golden check` computes it on this machine)\ntarget {}, steps with {}",
            env!("CARGO_PKG_VERSION"),
            kernel_digest(),
            target(),
            instructions(InstructionSet::best())
        )
    });
    &TEXT
}

/// The name of an instruction set.
fn instructions(set: InstructionSet) -> &'static str {
    match set {
        InstructionSet::Baseline => "what every processor of the target has",
        InstructionSet::Neon => "NEON",
        InstructionSet::Simd128 => "simd128",
        InstructionSet::Avx2 => "AVX2",
        InstructionSet::Avx512 => "AVX-512",
    }
}
