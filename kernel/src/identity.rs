//! What tells one kernel from another.

/// The kernel digest: that of the last states of all golden traces, which `softanvil golden check` computes anew. Kernels with
/// the same digest give the same bits; packages state it beside their version. It changes with the results, and with nothing else.
#[cfg(not(feature = "single"))]
pub const KERNEL_DIGEST: u64 = 0xf11c_4d32_531d_e9be;
/// The kernel digest of single precision, likewise.
#[cfg(feature = "single")]
pub const KERNEL_DIGEST: u64 = 0xc72e_f220_dbf7_1ee8;
