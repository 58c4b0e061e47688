//! Line contact: a^2 = 4 F' R / (pi E*), p0 = 2 F' / (pi a), p = p0 sqrt(1 - x^2/a^2), for the contact force found.
//!
//! Source: Johnson, Contact Mechanics (1985). The half width is known to a cell; the pressure at a node is a
//! mean over a cell.

use softanvil_verification::problems::hertz::{CELLS, contact};
use softanvil_verification::tolerance::HERTZ_PEAK;

#[test]
fn half_width_and_pressure() {
    let mut profile = f64::MAX;
    for n in CELLS {
        let contact = contact(n);
        assert!((contact.half_width - 1.0).abs() * (contact.nodes as f64) < 1.0, "{n}: {contact:?}");
        assert!((contact.peak_pressure - 1.0).abs() < HERTZ_PEAK, "{n}: {contact:?}");
        // At least first order.
        assert!(contact.profile < 0.6 * profile, "{n}: {contact:?} after a profile error of {profile}");
        profile = contact.profile;
    }
}
