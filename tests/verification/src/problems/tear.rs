//! Tearing in planar extension of neo-Hooke: the fall of the stress, and the energy it takes.

use softanvil_kernel::material::Material;
use softanvil_kernel::scenario::Formulation;

use crate::deformation::Gradient;
use crate::element::Cell;
use crate::row::Check;
use crate::scenes::elastic;

/// Stretch at which tearing begins.
pub const LIMIT: f64 = 1.3;
const WIDTH: f64 = 0.2;
/// Part of the stress that is left.
pub const RESIDUAL: f64 = 0.1;
/// Modulus of neo-Hooke, Pa.
pub const C10: f64 = 0.1e6;

/// A material made to tear.
pub fn tearing(material: Material) -> Material {
    Material { tear_stretch: LIMIT, tear_width: WIDTH, tear_residual: RESIDUAL, ..material }
}

/// An element in plane strain.
pub fn cell(material: Material) -> Cell {
    Cell::new(material, Formulation::PlaneStrain, 1e-5)
}

/// Planar extension.
pub fn planar(l: f64) -> Gradient {
    [[1.0 / l, 0.0], [0.0, l]]
}

/// Part of the stress after the largest stretch `m`.
pub fn factor(m: f64) -> f64 {
    let x = ((m - LIMIT) / WIDTH).clamp(0.0, 1.0);
    1.0 - (1.0 - RESIDUAL) * x * x * (3.0 - 2.0 * x)
}

/// Largest error of the stress, there and back over the limit, against that of the material that does not tear, over C10.
pub fn stress_error() -> f64 {
    let (mut torn, mut whole) = (cell(tearing(elastic(C10, 0.0, 1e6))), cell(elastic(C10, 0.0, 1e6)));
    let (mut stretch, mut error) = (1.0_f64, 0.0_f64);
    for l in [1.1, 1.3, 1.2, 1.35, 1.1, 1.0, 1.35, 1.42, 0.8, 1.42, 1.5, 1.7, 1.05, 1.2] {
        // Compression across is a stretch along the other direction.
        stretch = stretch.max(l).max(1.0 / l);
        let (stress, expected) = (torn.deform(planar(l)), whole.deform(planar(l)));
        for i in 0..2 {
            error = error.max((stress[i][i] - factor(stretch) * expected[i][i]).abs() / C10);
        }
    }
    error
}

/// Work of the nodal forces along a path of planar stretches, J/m3.
pub fn work(cell: &mut Cell, path: impl Iterator<Item = f64>) -> f64 {
    let mut work = 0.0;
    let mut before = (planar(1.0), cell.deform(planar(1.0)));
    for l in path {
        let gradient = planar(l);
        let stress = cell.deform(gradient);
        for i in 0..2 {
            work += 0.5 * (stress[i][i] + before.1[i][i]) * (gradient[i][i] - before.0[i][i]);
        }
        before = (gradient, stress);
    }
    work
}

/// Extension through the tear, J/m3.
pub struct Extension {
    /// Work of the nodal forces.
    pub work: f64,
    /// Elastic energy at its end.
    pub elastic: f64,
    /// Dissipation in the ledger.
    pub tear: f64,
    /// Dissipation by the closed form.
    pub closed_form: f64,
}

/// Extension to a stretch of 1.7.
pub fn extension() -> Extension {
    let mut torn = cell(tearing(elastic(C10, 0.0, 1e6)));
    let work = work(&mut torn, (0..=4000).map(|n| 1.0 + 0.7 * f64::from(n) / 4000.0));
    // Simpson's rule over -phi' W from the limit to the end of the width.
    let integrand = |x: f64| {
        let l = LIMIT + WIDTH * x;
        (1.0 - RESIDUAL) * 6.0 * x * (1.0 - x) * C10 * (l - 1.0 / l) * (l - 1.0 / l)
    };
    let closed_form = (0..1000)
        .map(|n| {
            let (a, h) = (f64::from(n) / 1000.0, 1e-3);
            h / 6.0 * (integrand(a) + 4.0 * integrand(a + 0.5 * h) + integrand(a + h))
        })
        .sum();
    Extension { work, elastic: torn.elastic_energy, tear: torn.tear, closed_form }
}

/// Lines of the table.
pub fn checks() -> Vec<Check> {
    let Extension { work, elastic, tear, closed_form } = extension();
    let check =
        |quantity: &str, reference, error| Check { problem: "tear", quantity: quantity.into(), reference, error };
    vec![
        check("stress, there and back over the limit", "smooth fall, no return", stress_error()),
        check("dissipation of an extension", "integral of the closed form", (tear / closed_form - 1.0).abs()),
        check("dissipation and elastic energy", "work of the forces", ((tear + elastic) / work - 1.0).abs()),
    ]
}
