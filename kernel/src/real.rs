//! The kernel's number: binary64, or binary32 in the crate `softanvil-kernel-f32`.
//!
//! Both crates are these same sources, for targets with and without a double-precision unit. What differs between them
//! stands in this file: the type, the functions of `libm` for it, and the constants that hang on its digits.

pub use chosen::*;

#[cfg(not(feature = "single"))]
mod chosen {
    pub use core::f64::consts;
    pub use libm::{asinh, ceil, cos, exp, expm1, log as ln, log1p as ln_1p, round, sin, sinh, sqrt};

    /// A floating-point number.
    pub type Real = f64;
    /// Its bits.
    pub type Bits = u64;

    /// Relative difference that rounding may leave between two quotients that should be equal.
    pub const SAME: Real = 1e-9;
    /// Guess of x^(-1/2): this minus half the bits of x.
    pub const INVERSE_SQRT_MAGIC: Bits = 0x5fe6_eb50_c7b5_37a9;
    /// Guess of x^(-1/3): this minus a third of the bits of x; its error is smallest around x = 1.
    pub const INVERSE_CBRT_MAGIC: Bits = 0x553e_e000_0000_0000;
    /// Newton steps from either guess to the last bit.
    pub const NEWTON_STEPS: usize = 4;
    /// Significant digits in messages, of which the scaling spoils none.
    pub const SHOWN_DIGITS: i32 = 12;
    /// Powers of ten whose exponents add up to any that a number has.
    pub const POWERS_OF_TEN: &[(i32, Real)] =
        &[(256, 1e256), (128, 1e128), (64, 1e64), (32, 1e32), (16, 1e16), (8, 1e8), (4, 1e4), (2, 1e2), (1, 1e1)];

    /// 2^32 / 3: this times the upper half of the bits is a third of them.
    pub const THIRD_OF_UPPER_HALF: Bits = 0x5555_5555;

    /// A third of `bits`, to about 32 digits.
    #[inline(always)]
    pub fn third(bits: Bits) -> Bits {
        (bits >> 32) * THIRD_OF_UPPER_HALF
    }

    /// The bits of `number` as the word that digests and snapshots hold.
    pub fn to_word(number: Real) -> u64 {
        number.to_bits()
    }

    /// The number with the bits of `word`.
    pub fn from_word(word: u64) -> Real {
        Real::from_bits(word)
    }
}

#[cfg(feature = "single")]
mod chosen {
    pub use core::f32::consts;
    pub use libm::{
        asinhf as asinh, ceilf as ceil, cosf as cos, expf as exp, expm1f as expm1, log1pf as ln_1p, logf as ln,
        roundf as round, sinf as sin, sinhf as sinh, sqrtf as sqrt,
    };

    /// A floating-point number.
    pub type Real = f32;
    /// Its bits.
    pub type Bits = u32;

    /// Relative difference that rounding may leave between two quotients that should be equal.
    pub const SAME: Real = 1e-6;
    /// Guess of x^(-1/2): this minus half the bits of x.
    pub const INVERSE_SQRT_MAGIC: Bits = 0x5f37_5a86;
    /// Guess of x^(-1/3): this minus a third of the bits of x; its error is smallest around x = 1.
    pub const INVERSE_CBRT_MAGIC: Bits = 0x54a2_4000;
    /// Newton steps from either guess to the last bit.
    pub const NEWTON_STEPS: usize = 3;
    /// Significant digits in messages, of which the scaling spoils none.
    pub const SHOWN_DIGITS: i32 = 6;
    /// Powers of ten whose exponents add up to any that a number has.
    pub const POWERS_OF_TEN: &[(i32, Real)] = &[(32, 1e32), (16, 1e16), (8, 1e8), (4, 1e4), (2, 1e2), (1, 1e1)];

    /// A third of `bits`.
    #[inline(always)]
    pub fn third(bits: Bits) -> Bits {
        bits / 3
    }

    /// The bits of `number` as the word that digests and snapshots hold.
    pub fn to_word(number: Real) -> u64 {
        u64::from(number.to_bits())
    }

    /// The number with the bits of `word`, whose upper half is left alone.
    pub fn from_word(word: u64) -> Real {
        Real::from_bits(word as Bits)
    }
}
