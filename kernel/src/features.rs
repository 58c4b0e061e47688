//! What the kernel was built with.

/// Whether it was built with the feature `pads`. What depends on it is left out by the compiler where it is false.
pub(crate) const PADS: bool = cfg!(feature = "pads");

/// Whether it was built with the feature `solid`, likewise.
pub(crate) const SOLID: bool = cfg!(feature = "solid");
