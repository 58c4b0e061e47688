//! Storage and loss modulus from a sinusoidal shear test over three decades of frequency, through the element.
//!
//! Source: G' = G_inf + sum G_k w^2 t_k^2 / (1 + w^2 t_k^2), G'' = sum G_k w t_k / (1 + w^2 t_k^2), and the energy
//! dissipated per cycle pi G'' a^2, e.g. Ferry, Viscoelastic Properties of Polymers (1980).

use softanvil_verification::problems::harmonic::{SERIES, measured};
use softanvil_verification::tolerance::{HARMONIC, relative_error};

#[test]
fn storage_and_loss_modulus_over_three_decades() {
    for series in SERIES {
        for m in measured(series) {
            let error = relative_error(m.value, m.reference);
            let (what, omega, value, reference) = (m.what, m.omega, m.value, m.reference);
            assert!(error < HARMONIC, "{series} at {omega} 1/s: {what} {value} against {reference}, {error:e}");
        }
    }
}
