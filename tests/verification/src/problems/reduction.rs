//! What the section costs: a bonded round layer under a round face without friction, quasi-static, as a section and as a solid.

use softanvil_kernel::mesh::{Grid, solid_position};
use softanvil_kernel::scenario::{Formulation, Interface, Motion, StepBy};
use softanvil_kernel::{Scenario, Simulation, preset};

use crate::relaxation::{Stage, press_on};
use crate::scenes::neo_hookean;

/// Depths of the face, m.
pub const DEPTHS: [f64; 5] = [1e-3, 2e-3, 3e-3, 4e-3, 5e-3];

/// Shear modulus, Pa.
pub const SHEAR_MODULUS: f64 = 0.3e6;

/// Bulk moduli, Pa: of Poisson's ratios of 0.227, 0.480 and 0.490.
pub const BULK_MODULI: [f64; 3] = [0.45e6, 7.4e6, 14.9e6];

/// Poisson's ratio of a bulk modulus, Pa.
pub fn poissons_ratio(bulk_modulus: f64) -> f64 {
    (3.0 * bulk_modulus - 2.0 * SHEAR_MODULUS) / (2.0 * (3.0 * bulk_modulus + SHEAR_MODULUS))
}

/// The study's anvil in elements of `size` m, of a plain rubber with this bulk modulus, Pa.
pub fn scenario(formulation: Formulation, bulk_modulus: f64, size: f64) -> Scenario {
    let mut scenario = preset::study();
    scenario.geometry.formulation = formulation;
    scenario.layers[0].material = neo_hookean(SHEAR_MODULUS, bulk_modulus);
    (scenario.core.interface, scenario.face.friction_coefficient) = (Interface::Bonded, 0.0);
    (scenario.impactor.motion, scenario.impactor.gap) = (Motion::Driven, 0.0);
    // Under the edges of the face the solid is pressed harder than the layer as a whole.
    (scenario.mesh.element_size, scenario.time.design_compression) = (size, 0.6);
    scenario
}

/// Time for a millimetre of depth, s.
const TRAVEL: f64 = 5e-3;
/// About that of critical damping of the layer's slowest shear waves, s.
const DECAY: f64 = 0.5e-3;
/// Kinetic over elastic energy at which the layer counts as at rest: the force is then off by its square root.
const AT_REST: f64 = 1e-8;

/// Contact forces at rest at each of `depths`, N.
///
/// # Panics
/// If a step fails.
pub fn forces(simulation: &mut Simulation, depths: &[f64]) -> Vec<f64> {
    let mut from = 0.0;
    let mut stage = |to: f64| {
        let travel = TRAVEL * (to - from) / 1e-3;
        let stage = Stage { from, to, travel, decay: DECAY, at_rest: AT_REST };
        from = to;
        simulation.with(|model, state| press_on(model, state, &stage)).expect("memory of the right size")
    };
    depths.iter().map(|to| stage(*to)).collect()
}

/// The same of the kernel's own mesh.
///
/// # Panics
/// If the scenario is illegal or a step fails.
pub fn pressed(scenario: &Scenario, depths: &[f64]) -> Vec<f64> {
    forces(&mut Simulation::new(scenario).expect("a legal anvil"), depths)
}

/// Half of the width of the belt of fine slices about the edge, m.
const BELT: f64 = 4.5e-3;

/// Where the slices of a solid stand whose cells are narrower about the edge of the face.
struct Slices {
    /// Half of the length of the anvil and radius of the face, m.
    end: f64,
    radius: f64,
    /// Slices of cells inside the belt, in it and outside.
    inside: usize,
    belt: usize,
    outside: usize,
}

impl Slices {
    fn new(solid: &Scenario, fine: f64) -> Self {
        let (end, radius) = (0.5 * solid.geometry.length, 0.5 * solid.impactor.face_diameter);
        let of = |width: f64, size: f64| (width / size).round().max(1.0) as usize;
        let size = solid.mesh.element_size;
        Self {
            end,
            radius,
            inside: of(radius - BELT, size),
            belt: of(2.0 * BELT, fine),
            outside: of(end - radius - BELT, size),
        }
    }

    fn count(&self) -> usize {
        self.inside + self.belt + self.outside
    }

    /// Place along z of slice `w` of nodes at `x`, m: the belt follows the edge of the face.
    fn place(&self, w: usize, x: f64) -> f64 {
        let edge = (self.radius * self.radius - x * x).sqrt();
        let between = |from: f64, to: f64, i: usize, n: usize| from + (to - from) * i as f64 / n as f64;
        let (inner, outer) = (self.inside, self.inside + self.belt);
        match w {
            w if w <= inner => between(0.0, edge - BELT, w, inner),
            w if w <= outer => between(edge - BELT, edge + BELT, w - inner, self.belt),
            w => between(edge + BELT, self.end, w - outer, self.outside),
        }
    }
}

/// A solid with cells that are `fine` m wide along z about the edge of the face, in steps of `step` s.
///
/// # Panics
/// If the scenario is illegal.
pub fn with_fine_edge(solid: &Scenario, fine: f64, step: f64) -> Simulation {
    let slices = Slices::new(solid, fine);
    let mut long = solid.clone();
    (long.time.step_by, long.time.step) = (StepBy::Given, step);
    // A longer anvil has as many slices as this one is given.
    while Grid::new(&long).expect("a legal mesh").slices.half < slices.count() {
        long.geometry.length += 0.5 * solid.mesh.element_size;
    }
    let grid = Grid::new(&long).expect("a legal mesh");
    assert_eq!(grid.slices.half, slices.count(), "slices of the longer anvil");
    let position = |node: [usize; 3]| {
        let [x, y, _] = solid_position(&long, &grid, node);
        [x, y, slices.place(node[2], x)]
    };
    Simulation::with_node_positions(&long, &position).expect("a legal anvil")
}

/// Sides of the elements of the first table, m: the second is the default.
pub const SIZES: [f64; 2] = [4e-3, 3e-3];

/// Widths of the cells about the edge of the face, m, and steps that are stable with them, s, of the second.
pub const EDGES: [(f64, f64); 3] = [(1.5e-3, 4e-6), (0.75e-3, 2e-6), (0.375e-3, 1e-6)];

/// Forces on the solid over those on the section at `depths`, m.
pub fn ratios(bulk_modulus: f64, size: f64, depths: &[f64]) -> Vec<f64> {
    let solid = pressed(&scenario(Formulation::Solid, bulk_modulus, size), depths);
    over_section(solid, bulk_modulus, size, depths)
}

/// The same with cells of the default size that are `fine` m wide about the edge of the face, in steps of `step` s.
pub fn ratios_with_fine_edge(bulk_modulus: f64, (fine, step): (f64, f64), depths: &[f64]) -> Vec<f64> {
    let solid = scenario(Formulation::Solid, bulk_modulus, SIZES[1]);
    over_section(forces(&mut with_fine_edge(&solid, fine, step), depths), bulk_modulus, SIZES[1], depths)
}

fn over_section(solid: Vec<f64>, bulk_modulus: f64, size: f64, depths: &[f64]) -> Vec<f64> {
    let section = pressed(&scenario(Formulation::PlaneStrain, bulk_modulus, size), depths);
    solid.iter().zip(section).map(|(solid, section)| solid / section).collect()
}

/// The start of a line of the first table.
pub fn label(bulk_modulus: f64, size: f64) -> String {
    format!("| {:.3} | {} | {}", poissons_ratio(bulk_modulus), bulk_modulus / 1e6, 1e3 * size)
}

/// A line of a table in Markdown: three decimals, far above what compilers and mathematics libraries change.
pub fn line(label: &str, ratios: &[f64]) -> String {
    ratios.iter().fold(label.to_string(), |text, ratio| format!("{text} | {ratio:.3}")) + " |"
}
