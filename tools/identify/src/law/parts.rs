//! The tests that data sets hold, each of which has residuals of its own: uniaxial compression and tension apart.

use super::{DataSet, Mode};

/// A test.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// Name for people.
    pub name: &'static str,
    /// Places of its points among those of all data sets.
    pub places: Vec<usize>,
}

/// How well a law describes a test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Misfit {
    /// Root mean square of the residuals, Pa.
    pub rms: f64,
    /// Largest measured stress, Pa.
    pub largest: f64,
}

impl Misfit {
    /// The root mean square as a part of the largest stress.
    pub fn relative(self) -> f64 {
        self.rms / self.largest
    }
}

impl Part {
    /// Every test of `data`.
    pub fn list(data: &[DataSet]) -> Vec<Self> {
        let (mut parts, mut first): (Vec<Self>, usize) = (Vec::new(), 0);
        for set in data {
            // A state at rest belongs to a tension, if there is one.
            let stretched = set.points.iter().any(|point| point.0 > 1.0);
            for (index, (x, _)) in set.points.iter().enumerate() {
                let name = name(set.mode, *x < 1.0 || *x == 1.0 && !stretched);
                match parts.iter_mut().find(|part| part.name == name) {
                    Some(part) => part.places.push(first + index),
                    None => parts.push(Self { name, places: vec![first + index] }),
                }
            }
            first += set.points.len();
        }
        parts
    }

    /// Of what a law says (`stresses`, Pa, of all points) beside what was `measured`.
    pub fn misfit(&self, stresses: &[f64], measured: &[f64]) -> Misfit {
        let squares = self.places.iter().map(|place| (stresses[*place] - measured[*place]).powi(2)).sum::<f64>();
        Misfit { rms: (squares / self.places.len() as f64).sqrt(), largest: self.largest(measured) }
    }

    /// Largest measured stress, Pa.
    pub fn largest(&self, measured: &[f64]) -> f64 {
        self.places.iter().fold(0.0, |largest, place| f64::max(largest, measured[*place].abs()))
    }
}

fn name(mode: Mode, compressed: bool) -> &'static str {
    match (mode, compressed) {
        (Mode::Uniaxial, true) => "uniaxial compression",
        (Mode::Uniaxial, false) => "uniaxial tension",
        (Mode::Planar, true) => "planar compression",
        (Mode::Planar, false) => "planar tension",
        (Mode::Equibiaxial, true) => "equibiaxial compression",
        (Mode::Equibiaxial, false) => "equibiaxial tension",
        (Mode::SimpleShear, _) => "simple shear",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn compression_and_tension_are_tests_of_their_own() {
        let uniaxial = DataSet { mode: Mode::Uniaxial, points: vec![(0.8, -2.0), (1.0, 0.0), (1.2, 3.0), (1.4, 5.0)] };
        let shear = DataSet { mode: Mode::SimpleShear, points: vec![(-0.1, -1.0), (0.2, 2.0)] };
        let parts = Part::list(&[uniaxial, shear]);
        let places: Vec<_> = parts.iter().map(|part| (part.name, part.places.clone())).collect();
        let expected =
            [("uniaxial compression", vec![0]), ("uniaxial tension", vec![1, 2, 3]), ("simple shear", vec![4, 5])];
        assert_eq!(places, expected);
        let misfit = parts[1].misfit(&[0.0, 0.0, 4.0, 5.0, 0.0, 0.0], &[-2.0, 0.0, 3.0, 5.0, -1.0, 2.0]);
        assert!((misfit.rms - (1.0_f64 / 3.0).sqrt()).abs() < 1e-15 && misfit.largest == 5.0);
    }
}
