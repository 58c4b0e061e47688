//! The instruction set that steps are made with. It changes the speed and no bit: see [`crate::number::pack`].
//!
//! With the feature `dispatch` the crate `pulp` has the vectors: on x86-64 those that the processor is found to have at run
//! time, on aarch64 and wasm32 those of the target. Without it, elsewhere and in single precision there is only scalar code.

/// Vector instructions.
///
/// ```
/// use softanvil_kernel::{InstructionSet, Simulation, StepInput, preset, step_with};
///
/// let mut anvil = Simulation::new(&preset::study())?;
/// anvil.run(4e-3, &StepInput::default())?;
/// let next = |set| {
///     let mut anvil = anvil.clone();
///     anvil.with(|model, state| step_with(set, model, state, &StepInput::default()))??;
///     Ok::<_, Box<dyn core::error::Error>>(*anvil.scalars())
/// };
/// assert!(InstructionSet::best().available());
/// for set in InstructionSet::ALL.into_iter().filter(|set| set.available()) {
///     assert_eq!(next(set)?, next(InstructionSet::Baseline)?);
/// }
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InstructionSet {
    /// SSE2, vectors of two numbers, which every x86-64 has; scalar code elsewhere.
    Baseline,
    /// NEON of aarch64: vectors of two numbers.
    Neon,
    /// Vectors of two numbers of wasm32, in a program that is compiled for them (`-C target-feature=+simd128`).
    Simd128,
    /// AVX2: vectors of four numbers.
    Avx2,
    /// AVX-512: vectors of eight numbers.
    Avx512,
}

impl InstructionSet {
    /// Every set, widest last.
    pub const ALL: [Self; 5] = [Self::Baseline, Self::Neon, Self::Simd128, Self::Avx2, Self::Avx512];
}
