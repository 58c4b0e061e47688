//! Deterministic samples of deformations and rotations.

/// A deformation gradient of the section: F11, F12, F21, F22, with the hoop stretch equal to F11 when axisymmetric.
pub type Gradient = [[f64; 2]; 2];

/// Numbers from -1 to 1 from a multiplicative congruential generator (Park and Miller 1988).
pub struct Samples(u64);

impl Samples {
    /// A sequence of its own for every seed above 0.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// The next number.
    pub fn number(&mut self) -> f64 {
        self.0 = self.0 * 16_807 % 2_147_483_647;
        2.0 * self.0 as f64 / 2_147_483_647.0 - 1.0
    }

    /// A deformation gradient with stretches within about `size` of 1 and any rotation.
    pub fn gradient(&mut self, size: f64) -> Gradient {
        let (a, b, c) = (1.0 + size * self.number(), 1.0 + size * self.number(), size * self.number());
        let turn = std::f64::consts::PI * self.number();
        product(rotation(turn), [[a, c], [c, b]])
    }
}

/// Rotation of the section by `angle`.
pub fn rotation(angle: f64) -> Gradient {
    let (s, c) = angle.sin_cos();
    [[c, -s], [s, c]]
}

/// The product a b.
pub fn product(a: Gradient, b: Gradient) -> Gradient {
    core::array::from_fn(|i| core::array::from_fn(|j| a[i][0] * b[0][j] + a[i][1] * b[1][j]))
}
