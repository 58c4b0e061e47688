//! The volume of a specimen in a test, and the isochoric test that is in it.
//!
//! The laws are of the isochoric part of the deformation, J^(-1/3) l for each stretch l, as the kernel has them: their
//! difference of Kirchhoff stresses in the loaded and the free direction is P l, whatever the volume does. So the stress P at
//! the stretch l of a specimen that changes its volume by J is P J^(1/3) at the stretch J^(-1/3) l of one that does not. That
//! needs both free directions, or both loaded ones, to be alike, which they are not in a planar test.

use super::Mode;

/// How the volume of a specimen behaves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Volume {
    /// Nothing is known: it is taken as constant.
    Assumed,
    /// Lateral logarithmic strain over the loaded one, with the sign changed, as the user states it.
    Stated(f64),
    /// The law of a foam says it, with this Poisson's ratio of every term where it is known.
    OfLaw(Option<f64>),
    /// The same, as the files have it: lateral strains or the change of volume.
    Measured {
        /// By least squares over all states.
        poissons_ratio: f64,
        /// Smallest and largest of a state.
        range: (f64, f64),
    },
}

/// Poisson's ratio from which on laws are fitted as to a constant volume: at half the length the stress then differs by less
/// than 3 %.
pub const NEARLY_INCOMPRESSIBLE: f64 = 0.45;
/// Logarithmic strain below which a state tells no ratio.
const SMALLEST_STRAIN: f64 = 0.01;

impl Volume {
    /// What `states` (stretch of the loaded direction, volume over that at rest) of uniaxial tests say; none if they are all
    /// at rest.
    pub fn measured(states: &[(f64, f64)]) -> Option<Self> {
        let logarithms = states.iter().map(|(stretch, volume)| (stretch.ln(), volume.ln()));
        let states: Vec<(f64, f64)> = logarithms.filter(|state| state.0.abs() >= SMALLEST_STRAIN).collect();
        let ratio = |(strain, volume): (f64, f64)| 0.5 * (1.0 - volume / strain);
        let sum = |of: fn(&(f64, f64)) -> f64| states.iter().map(of).sum::<f64>();
        let poissons_ratio = ratio((sum(|state| state.0 * state.0), sum(|state| state.0 * state.1)));
        let ends = states.iter().map(|state| ratio(*state));
        let range = ends.fold((f64::MAX, f64::MIN), |(low, high), ratio| (low.min(ratio), high.max(ratio)));
        poissons_ratio.is_finite().then_some(Self::Measured { poissons_ratio, range })
    }

    /// Poisson's ratio, where it is known.
    pub fn poissons_ratio(self) -> Option<f64> {
        match self {
            Self::Assumed => None,
            Self::OfLaw(poissons_ratio) => poissons_ratio,
            Self::Stated(poissons_ratio) | Self::Measured { poissons_ratio, .. } => Some(poissons_ratio),
        }
    }

    /// Poisson's ratio of a volume that the laws are fitted with beside their own; none of one that counts as constant.
    pub fn compressible(self) -> Option<f64> {
        self.poissons_ratio().filter(|_| !matches!(self, Self::OfLaw(_))).filter(|ratio| *ratio < NEARLY_INCOMPRESSIBLE)
    }

    /// The state of a specimen of constant volume that has the isochoric part of the state `point` (stretch, nominal stress).
    pub fn isochoric(self, mode: Mode, point: (f64, f64)) -> (f64, f64) {
        let scale = self.ratio(mode, point.0).cbrt();
        (point.0 / scale, point.1 * scale)
    }

    /// The state that a specimen has where one of constant volume has the stretch and stress `point`.
    pub fn real(self, mode: Mode, point: (f64, f64)) -> (f64, f64) {
        // J is a power of the stretch, and the isochoric stretch one with the exponent 1 less a third of that.
        let stretch = point.0.powf(1.0 / (1.0 - self.exponent(mode) / 3.0));
        (stretch, point.1 / self.ratio(mode, stretch).cbrt())
    }

    /// Volume over that at rest at the stretch `l`.
    fn ratio(self, mode: Mode, l: f64) -> f64 {
        l.powf(self.exponent(mode))
    }

    /// The power of the loaded stretch that the volume is: logarithmic strains add up.
    fn exponent(self, mode: Mode) -> f64 {
        let Some(ratio) = self.compressible() else { return 0.0 };
        match mode {
            Mode::SimpleShear => 0.0,
            Mode::Uniaxial => 1.0 - 2.0 * ratio,
            Mode::Planar => (1.0 - 2.0 * ratio) / (1.0 - ratio),
            Mode::Equibiaxial => 2.0 * (1.0 - 2.0 * ratio) / (1.0 - ratio),
        }
    }
}

/// Words for a porous solid, which is compressible, in the languages of the files' titles.
const POROUS: [&str; 8] = ["foam", "sponge", "schaum", "schwamm", "mousse", "espuma", "schiuma", "cellular"];

/// The word for a porous solid that stands in `words`, if one does.
pub fn porous(words: &str) -> Option<&'static str> {
    let words = words.to_lowercase();
    POROUS.into_iter().find(|word| words.contains(word))
}

/// Logarithmic strains of compression between which the reduced stress is looked at.
const SMALL: (f64, f64) = (0.02, 0.15);
/// A strain of compression from which on a constant volume stiffens a solid.
const LARGE: f64 = 0.5;
/// Part of its value at small strains to which the reduced stress of a solid of constant volume does not fall: filled rubbers
/// come down to about 0.7.
const SOFTENED: f64 = 0.6;

/// The reduced stress P / (l - l^-2) in uniaxial compression beyond half a logarithmic strain over that at small strains, if it
/// is so small that the specimen can hardly have kept its volume: a constant one makes the cross-section grow.
pub fn collapse(points: &[(f64, f64)]) -> Option<f64> {
    let mean = |from: f64, to: f64| {
        let within = points.iter().filter(|(l, _)| (from..to).contains(&-l.ln()));
        let reduced: Vec<f64> = within.map(|(l, stress)| stress / (l - l.powi(-2))).collect();
        (!reduced.is_empty()).then(|| reduced.iter().sum::<f64>() / reduced.len() as f64)
    };
    let (large, small) = (mean(LARGE, f64::INFINITY)?, mean(SMALL.0, SMALL.1)?);
    // A specimen that bears nothing at small strains has no stiffness to fall from.
    let part = large / small;
    (small > 0.0 && (0.0..SOFTENED).contains(&part)).then_some(part)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::{Law, MODES, stress};
    use softanvil_kernel::material::Elastic;

    #[test]
    fn states_come_back_from_the_isochoric_test() {
        for volume in [Volume::Assumed, Volume::Stated(0.1), Volume::Stated(0.44), Volume::Stated(0.48)] {
            for mode in MODES {
                let back = volume.real(mode, volume.isochoric(mode, (0.6, -2e5)));
                assert!((back.0 - 0.6).abs() < 1e-12 && (back.1 + 2e5).abs() < 1e-6, "{volume:?} {mode:?}: {back:?}");
            }
        }
        assert_eq!(Volume::Stated(0.48).isochoric(Mode::Uniaxial, (0.6, 1.0)), (0.6, 1.0));
    }

    /// Source: uniaxial stress of a compressible neo-Hookean solid, tau_1 - tau_2 = 2 C10 J^(-2/3) (l_1^2 - l_2^2) and P l_1
    /// = tau_1 with tau_2 = 0 (e.g. Bonet and Wood, Nonlinear Continuum Mechanics), with l_2 = l_1^-nu.
    #[test]
    fn the_isochoric_test_is_the_one_of_the_law() {
        let law = Law::find("neo_hookean").unwrap();
        for (nu, l) in [(0.0_f64, 0.5_f64), (0.3, 0.6), (0.3, 1.7)] {
            let lateral = l.powf(-nu);
            let jacobian = l * lateral * lateral;
            let stress = 2e5 * jacobian.powf(-2.0 / 3.0) * (l * l - lateral * lateral) / l;
            let (stretch, nominal) = Volume::Stated(nu).isochoric(Mode::Uniaxial, (l, stress));
            let found = stress::nominal(&Elastic::new(&law.material(&[1e5])), Mode::Uniaxial, &[stretch])[0];
            assert!((found / nominal - 1.0).abs() < 1e-12, "{nu} {l}: {found} {nominal}");
        }
    }

    #[test]
    fn lateral_strains_tell_the_ratio() {
        let states: Vec<(f64, f64)> =
            (0..20).map(|k| 0.5 + 0.05 * f64::from(k)).map(|l: f64| (l, l.powf(0.4))).collect();
        let Some(Volume::Measured { poissons_ratio, range }) = Volume::measured(&states) else { panic!("{states:?}") };
        assert!((poissons_ratio - 0.3).abs() < 1e-12 && range.1 - range.0 < 1e-9);
        assert_eq!(Volume::measured(&[(1.0, 1.0), (1.001, 1.0)]), None);
    }

    /// A plateau of a foam, and a solid that softens by a third.
    #[test]
    fn a_foam_is_told_from_a_solid_by_its_plateau() {
        let points =
            |stress: fn(f64) -> f64| (1..14).map(|k| 1.0 - 0.05 * f64::from(k)).map(|l| (l, stress(l))).collect();
        let foam: Vec<(f64, f64)> = points(|l| -0.4e5 * (1.0 - (-(1.0 - l) / 0.08).exp()));
        let solid: Vec<(f64, f64)> = points(|l| 1e5 * (l - l.powi(-2)) * (0.7 + 0.3 * (-(1.0 - l) / 0.2).exp()));
        assert!(collapse(&foam).is_some_and(|part| part < 0.3), "{:?}", collapse(&foam));
        assert_eq!(collapse(&solid), None);
        // A gap before the touch, and a load that is a little below zero there.
        for rest in [0.0, 1.0] {
            let late: Vec<(f64, f64)> = points(|l| if l > 0.8 { 0.0 } else { 1e5 * (l - l.powi(-2) + 0.76) });
            let late: Vec<(f64, f64)> = late.into_iter().map(|(l, stress)| (l, stress + rest)).collect();
            assert_eq!(collapse(&late), None, "{rest}");
        }
        assert_eq!(porous("EVA-Schaum, 12 mm"), Some("schaum"));
    }
}
