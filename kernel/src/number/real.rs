//! The kernel's number: binary64, or binary32 in the crate `softanvil-kernel-f32`.
//!
//! Both crates are these same sources, for targets with and without a double-precision unit. What differs between them
//! stands in this file: the type, the functions of `libm` for it, and the constants that hang on its digits.

pub use chosen::*;

#[cfg(not(feature = "single"))]
mod chosen {
    pub use core::f64::consts;
    pub use libm::{asin, ceil, cos, exp, expm1 as exp_m1, log as ln, round, sin, sqrt};

    /// A floating-point number.
    pub type Real = f64;
    /// Its bits.
    pub type Bits = u64;
    /// The same, with a sign.
    pub type SignedBits = i64;

    /// Relative difference that rounding may leave between two quotients that should be equal.
    pub const SAME: Real = 1e-9;
    /// The same between a duration and a whole number of sampling intervals.
    pub const SAME_DURATION: Real = 1e-9;
    /// Guess of x^(-1/3): this and a third of the bits from x to [`CBRT_END`]; its error is smallest around x = 1.
    pub const INVERSE_CBRT_MAGIC: Bits = 0x2a99_8aaa_bfd0_0000;
    /// The bits after those of the largest number.
    pub const CBRT_END: Bits = Real::INFINITY.to_bits();
    /// Bits of the fraction of a number, below those of its exponent.
    pub const FRACTION_BITS: u32 = 52;
    /// Largest exponent of a power of two that [`crate::number::power`] forms: room is left to multiply it.
    pub const LARGEST_EXPONENT: Real = 1000.0;
    /// 2 atanh(t) / (t ln 2) for |t| < 0.2004 in powers of t^2, relative error 7e-17.
    pub const LOG2: [Real; 8] = [
        2.0 * consts::LOG2_E,
        0.961_796_693_925_979_6,
        0.577_078_016_345_927_7,
        0.412_198_586_952_651_94,
        0.320_598_326_032_484_67,
        0.262_348_623_361_121_8,
        0.220_493_500_732_877_32,
        0.218_147_544_563_494_58,
    ];
    /// sinh(f ln 2) / f for |f| <= 1/2 in powers of f^2, relative error 4e-17.
    pub const SINH: [Real; 6] = [
        consts::LN_2,
        0.055_504_108_664_821_58,
        0.001_333_355_814_642_321_3,
        1.525_273_382_079_580_3e-5,
        1.017_806_726_744_942_7e-7,
        4.454_103_410_587_04e-10,
    ];
    /// (cosh(f ln 2) - 1) / f^2, likewise, relative error 3e-16.
    pub const COSH: [Real; 5] = [
        0.240_226_506_959_100_75,
        0.009_618_129_107_618_665,
        0.000_154_035_304_247_765_29,
        1.321_545_166_322_143_4e-6,
        7.070_977_866_508_138e-9,
    ];
    /// The polynomial of [`crate::number::erf`], relative error 3e-17.
    pub const ERF: [Real; 17] = [
        1.726_001_084_749_877_2,
        -1.207_864_987_229_535_5,
        0.770_425_629_393_001,
        -0.441_909_995_998_038_7,
        0.223_983_641_201_490_6,
        -0.097_768_009_943_195_37,
        0.035_169_896_791_842_126,
        -0.009_482_004_379_664_248,
        0.001_361_480_737_422_472_2,
        0.000_236_777_846_607_676,
        -0.000_193_283_996_423_541_92,
        3.518_231_925_768_726e-05,
        9.721_549_340_690_386e-06,
        -5.895_136_286_259_321e-06,
        6.062_223_808_554_277e-07,
        1.276_191_516_157_747_3e-06,
        2.354_037_805_452_105_2e-07,
    ];
    /// A square next to nothing: far below any strain's that matters, far above the smallest number.
    pub const TINY_SQUARE: Real = 1e-280;
    /// Significant digits in messages, of which the scaling spoils none.
    pub const SHOWN_DIGITS: i32 = 12;
    /// Powers of ten whose exponents add up to any that a number has.
    pub const POWERS_OF_TEN: &[(i32, Real)] =
        &[(256, 1e256), (128, 1e128), (64, 1e64), (32, 1e32), (16, 1e16), (8, 1e8), (4, 1e4), (2, 1e2), (1, 1e1)];

    /// 2^32 / 3: this times the upper half of the bits is a third of them.
    const THIRD_OF_UPPER_HALF: Bits = 0x5555_5555;

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
        asinf as asin, ceilf as ceil, cosf as cos, expf as exp, expm1f as exp_m1, logf as ln, roundf as round,
        sinf as sin, sqrtf as sqrt,
    };

    /// A floating-point number.
    pub type Real = f32;
    /// Its bits.
    pub type Bits = u32;
    /// The same, with a sign.
    pub type SignedBits = i32;

    /// Relative difference that rounding may leave between two quotients that should be equal.
    pub const SAME: Real = 1e-6;
    /// The same between a duration and a whole number of sampling intervals, of which a minute has a million: the last digit
    /// of the duration and that of a product, and no more, or a sample would be lost.
    pub const SAME_DURATION: Real = 1.5 * Real::EPSILON;
    /// Guess of x^(-1/3): this and a third of the bits from x to [`CBRT_END`]; its error is smallest around x = 1.
    pub const INVERSE_CBRT_MAGIC: Bits = 0x29f7_9556;
    /// Bits after those of every finite number.
    pub const CBRT_END: Bits = 0x8000_0000;
    /// Bits of the fraction of a number, below those of its exponent.
    pub const FRACTION_BITS: u32 = 23;
    /// Largest exponent of a power of two that [`crate::number::power`] forms: room is left to multiply it.
    pub const LARGEST_EXPONENT: Real = 120.0;
    /// 2 atanh(t) / (t ln 2) for |t| < 0.2004 in powers of t^2, relative error 3e-8.
    pub const LOG2: [Real; 4] =
        [2.0 * consts::LOG2_E, 0.961_797_356_605_529_8, 0.576_772_987_842_559_8, 0.432_245_165_109_634_4];
    /// sinh(f ln 2) / f for |f| <= 1/2 in powers of f^2, relative error 4e-9.
    pub const SINH: [Real; 4] =
        [consts::LN_2, 0.055_504_109_710_454_94, 0.001_333_352_178_335_189_8, 1.529_094_879_515_469e-5];
    /// (cosh(f ln 2) - 1) / f^2, likewise, relative error 5e-9.
    pub const COSH: [Real; 3] = [0.240_226_507_186_889_65, 0.009_618_083_015_084_267, 0.000_154_531_633_597_798_65];
    /// The polynomial of [`crate::number::erf`], relative error 3e-8.
    #[allow(clippy::excessive_precision, reason = "the digits that were found")]
    pub const ERF: [Real; 9] = [
        1.726_001_074_037_366_1,
        -1.207_865_722_883_011_6,
        0.770_427_194_542_001_8,
        -0.441_858_192_061_992_2,
        0.224_058_340_400_994_18,
        -0.098_486_047_206_032_39,
        0.032_279_833_125_972_13,
        -0.013_712_289_922_403_547,
        -0.001_171_982_962_139_200_1,
    ];
    /// A square next to nothing: far below any strain's that matters, far above the smallest number.
    pub const TINY_SQUARE: Real = 1e-30;
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
