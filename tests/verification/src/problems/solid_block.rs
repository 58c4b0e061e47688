//! Square block and disc of rubber bonded between rigid plates, as solids, in the linear limit: apparent modulus against the shape factor.
//!
//! Reference: quadratic displacements and linear pressures (Taylor and Hood), `tests/verification/reference/bonded_block.py`; and the
//! approximate closed forms.

use std::f64::consts::{FRAC_PI_4, PI};

use crate::memo::Memo;
use crate::order::{extrapolate, over_cells};
use crate::row::Row;
use crate::scenes::neo_hookean;
use crate::solid_body::{SolidBody, SolidField};
use crate::solid_statics::{SolidSupports, linear};

const SHEAR_MODULUS: f64 = 1e5;
/// Half of the thickness, m: the plane between the halves is one of symmetry.
const HALF_THICKNESS: f64 = 5e-3;
/// Mean strain.
const STRAIN: f64 = 1e-6;

/// How the plates are cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outline {
    /// Square.
    Square,
    /// Round.
    Round,
}

/// A block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block {
    /// How it is cut.
    pub outline: Outline,
    /// Loaded area over free area: half of the side or the radius over two thicknesses.
    pub shape_factor: f64,
    /// Bulk modulus over shear modulus: 10,000 is close to the incompressible limit; what is left is in the references.
    pub bulk_over_shear: f64,
}

/// The blocks of the study, and their apparent moduli over three shear moduli by elements of another kind: of the squares by
/// `bonded_block.py` with five elements through half of the thickness, of the disc with sixteen. With four they are 0.03 % above.
pub const BLOCKS: [(Block, f64); 5] = [
    (Block { outline: Outline::Square, shape_factor: 0.5, bulk_over_shear: 1e4 }, 1.672),
    (Block { outline: Outline::Square, shape_factor: 1.0, bulk_over_shear: 1e4 }, 3.344),
    (Block { outline: Outline::Square, shape_factor: 2.0, bulk_over_shear: 1e4 }, 9.925),
    (Block { outline: Outline::Square, shape_factor: 2.0, bulk_over_shear: 50.0 }, 6.020),
    (Block { outline: Outline::Round, shape_factor: 1.0, bulk_over_shear: 1e4 }, 2.953),
];

/// Cells through half of the thickness.
pub const CELLS: [usize; 3] = [2, 4, 6];

impl Block {
    /// Gent and Lindley's apparent modulus of a disc, Gent and Meinecke's of a square, over three shear moduli, with the bulk modulus in
    /// series: a homogeneous compression and the pressure of a parabolic outflow, whose mean over the plate is that of its torsion
    /// function.
    pub fn closed_form(&self) -> f64 {
        let odd = (0..10).map(|i| f64::from(2 * i + 1));
        let sum: f64 = odd.map(|n| (0.5 * n * PI).tanh() / n.powi(5)).sum();
        let outflow = match self.outline {
            Outline::Square => 64.0 * (1.0 / 12.0 - 16.0 / PI.powi(5) * sum),
            Outline::Round => 2.0,
        };
        1.0 / (1.0 / (1.0 + outflow * self.shape_factor.powi(2)) + 3.0 / self.bulk_over_shear)
    }

    /// Half of the side, or the radius, m.
    fn half(&self) -> f64 {
        4.0 * self.shape_factor * HALF_THICKNESS
    }

    /// A quarter of the loaded area, m2.
    fn area(&self) -> f64 {
        let part = if self.outline == Outline::Square { 1.0 } else { FRAC_PI_4 };
        part * self.half().powi(2)
    }

    /// Where the point (`x`, `z`) of the unit square lies, m: on a disc the squares about the centre become circles.
    fn place(&self, [x, z]: [f64; 2]) -> [f64; 2] {
        let radius = x.max(z);
        if self.outline == Outline::Square || radius == 0.0 {
            return [x, z].map(|part| self.half() * part);
        }
        let (sin, cos) = (FRAC_PI_4 * x.min(z) / radius).sin_cos();
        (if x >= z { [cos, sin] } else { [sin, cos] }).map(|part| self.half() * radius * part)
    }

    /// Cells along half of a side for one through half of the thickness: cubes in the thickest block, wider ones in thinner blocks, in
    /// which less changes along the side.
    fn aspect(&self) -> usize {
        (2.0 * (2.0 * self.shape_factor).sqrt()).round() as usize
    }
}

/// A quarter of the upper half of a block with `n` cells through it, under compression.
pub struct Compression {
    /// The block.
    pub body: SolidBody,
    /// Its displacements, m.
    pub displacement: SolidField,
    /// Force on the plate, N.
    pub force: f64,
}

/// The compression of a block with `n` cells through half of its thickness and `along` cells along half of its sides.
pub fn compressed(block: &Block, along: usize, n: usize) -> Compression {
    let position = |[u, v, w]: [usize; 3]| {
        let [x, z] = block.place([u, w].map(|i| i as f64 / along as f64));
        [x, HALF_THICKNESS * v as f64 / n as f64, z]
    };
    let material = neo_hookean(SHEAR_MODULUS, block.bulk_over_shear * SHEAR_MODULUS);
    let mut body = SolidBody::new([along, n, along], material, &position);
    let mut supports = SolidSupports::none(&body);
    for [u, v, w] in body.nodes() {
        let held = &mut supports.prescribed[body.node([u, v, w])];
        *held = [u == 0, v == 0, w == 0].map(|on_plane| on_plane.then_some(0.0));
        if v == n {
            *held = [Some(0.0), Some(-STRAIN * HALF_THICKNESS), Some(0.0)];
        }
    }
    let found = linear(&mut body, &supports);
    let plate = body.nodes().filter(|[_, v, _]| *v == n).map(|node| -found.force[body.node(node)][1]);
    let force = plate.sum();
    Compression { body, displacement: found.displacement, force }
}

/// Apparent modulus over three shear moduli with `n` cells through half of the thickness.
pub fn apparent_modulus(block: &Block, n: usize) -> f64 {
    static KNOWN: Memo<(Block, usize), f64> = Memo::new();
    KNOWN.get((*block, n), || {
        let force = compressed(block, block.aspect() * n, n).force;
        force / (block.area() * STRAIN * 3.0 * SHEAR_MODULUS)
    })
}

/// Apparent moduli over [`CELLS`], with their limit and order.
pub fn converged(block: &Block) -> ([f64; 3], f64, f64) {
    let moduli = CELLS.map(|n| apparent_modulus(block, n));
    let (limit, order) = extrapolate(CELLS.map(|n| 1.0 / n as f64), moduli);
    (moduli, limit, order)
}

/// Rows of the table.
pub fn rows() -> Vec<Row> {
    let of = |(block, reference): &(Block, f64)| {
        let Block { outline, shape_factor, bulk_over_shear } = block;
        let moduli = CELLS.map(|n| apparent_modulus(block, n));
        let row = |name: &str, value: f64, ordered: bool| {
            let errors: Vec<f64> = moduli.iter().map(|modulus| modulus / value - 1.0).collect();
            Row {
                problem: "solid_block",
                quantity: format!("apparent modulus, {outline:?}, S = {shape_factor}, K = {bulk_over_shear} G")
                    .replace("Square", "square")
                    .replace("Round", "round"),
                reference: name.into(),
                meshes: CELLS.map(|n| format!("{} cells", 2 * n)).into(),
                order: ordered.then(|| over_cells(&CELLS, &errors)),
                errors,
            }
        };
        let approximate = match outline {
            Outline::Square => "Gent-Meinecke (approximate)",
            Outline::Round => "Gent-Lindley (approximate)",
        };
        [row("Taylor-Hood elements", *reference, true), row(approximate, block.closed_form(), false)]
    };
    BLOCKS.iter().flat_map(of).collect()
}
