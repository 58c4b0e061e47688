//! The rows and lines that a problem adds to the table.

use softanvil_kernel::scenario::Formulation;

/// One row: the errors of a quantity over meshes.
pub struct Row {
    /// File of the problem.
    pub problem: &'static str,
    /// What is compared, and for which case.
    pub quantity: String,
    /// What it is compared with.
    pub reference: String,
    /// Mesh of each error, coarsest first.
    pub meshes: Vec<String>,
    /// Relative errors.
    pub errors: Vec<f64>,
    /// Order of convergence, where one is measured.
    pub order: Option<f64>,
}

/// One line: the largest error of a quantity that has no mesh.
pub struct Check {
    /// File of the problem.
    pub problem: &'static str,
    /// What is compared, and for which case.
    pub quantity: String,
    /// What it is compared with.
    pub reference: &'static str,
    /// Relative error.
    pub error: f64,
}

/// A formulation in words.
pub fn name(formulation: Formulation) -> &'static str {
    match formulation {
        Formulation::PlaneStrain => "plane strain",
        Formulation::Axisymmetric => "axisymmetric",
        Formulation::Solid => "solid",
    }
}
