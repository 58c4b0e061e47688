//! Pressure checkerboards and hourglass modes of a solid.

use nalgebra::{DMatrix, SymmetricEigen};

use crate::memo::Memo;
use crate::order::over_cells;
use crate::problems::solid_block::{Block, Compression, Outline, compressed};
use crate::row::Row;
use crate::scenes::neo_hookean;
use crate::solid_body::SolidBody;
use crate::solid_statics::dense_stiffness;

/// Poisson's ratios of the block.
pub const POISSONS_RATIOS: [f64; 3] = [0.48, 0.499, 0.4999];

/// Shear modulus of the cubes, Pa.
const SHEAR_MODULUS: f64 = 1e6;

/// Cells through half of the thickness.
pub const CELLS: [usize; 3] = [4, 6, 8];

/// The ways in which a pressure may alternate from cell to cell, along which of the three directions.
const MODES: [[bool; 3]; 4] = [[true, true, false], [true, false, true], [false, true, true], [true, true, true]];

/// Alternating part of the pressure in a cube compressed between bonded plates, `n` cells through half of its thickness: root mean
/// square of the strongest of `MODES` in every two by two by two cells over that of the pressure.
///
/// The half thickness next to the free sides is left out, as in [`crate::problems::checkerboard`].
pub fn alternating_part(nu: f64, n: usize) -> f64 {
    static KNOWN: Memo<(u64, usize), f64> = Memo::new();
    KNOWN.get((nu.to_bits(), n), || {
        let bulk_over_shear = 2.0 * (1.0 + nu) / (3.0 * (1.0 - 2.0 * nu));
        // Twice as wide as thick, in cubes.
        let block = Block { outline: Outline::Square, shape_factor: 0.5, bulk_over_shear };
        let Compression { body, displacement, .. } = compressed(&block, 2 * n, n);
        let pressure = body.cell_pressures(&displacement);
        let total: f64 = pressure.iter().map(|p| p * p).sum();
        let at = |[u, v, w]: [usize; 3]| pressure[(w * n + v) * 2 * n + u];
        let places: Vec<_> = body.cell_list().filter(|[u, v, w]| u + 1 < n && v + 1 < n && w + 1 < n).collect();
        let part = |mode: &[bool; 3]| places.iter().map(|place| amplitude(&at, *place, mode).powi(2)).sum::<f64>();
        (MODES.iter().map(part).fold(0.0, f64::max) / total).sqrt()
    })
}

/// Amplitude of `mode` in the two by two by two cells from `place`.
fn amplitude(at: &dyn Fn([usize; 3]) -> f64, place: [usize; 3], mode: &[bool; 3]) -> f64 {
    let corners = (0..8).map(|corner| [corner & 1, corner >> 1 & 1, corner >> 2]);
    let signed = corners.map(|corner: [usize; 3]| {
        let flips = (0..3).filter(|i| mode[*i] && corner[*i] == 1).count();
        let value = at(core::array::from_fn(|i| place[i] + corner[i]));
        if flips % 2 == 0 { value } else { -value }
    });
    signed.sum::<f64>() / 8.0
}

/// Side of the cubes, m.
const SIDE: f64 = 0.1;

/// Bulk modulus over shear modulus without a resistance to changes of volume but that of the shears.
const SOFT: f64 = 2.0 / 3.0;

/// A cube of `n` by `n` by `n` cells.
fn cube(n: usize, bulk_over_shear: f64) -> SolidBody {
    SolidBody::new([n, n, n], neo_hookean(SHEAR_MODULUS, bulk_over_shear * SHEAR_MODULUS), &|node| {
        node.map(|i| SIDE * i as f64 / n as f64)
    })
}

/// Eigenvalues of the stiffness of a free cube of `n` by `n` by `n` cells, over the largest, in rising order.
pub fn eigenvalues(n: usize) -> Vec<f64> {
    let stiffness = dense_stiffness(&mut cube(n, 50.0));
    let mut values: Vec<f64> = SymmetricEigen::new(stiffness).eigenvalues.iter().copied().collect();
    values.sort_by(f64::total_cmp);
    let largest = values[values.len() - 1];
    values.iter().map(|value| value / largest).collect()
}

/// What holds a cube.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Hold {
    /// Its base: as a bonded layer.
    Base,
    /// Base and top: as a bonded block.
    Plates,
    /// All of its surface.
    All,
}

/// Squares of the inf-sup values of the pressures of a cube of `n` by `n` by `n` cells, in rising order.
pub fn inf_sup(hold: Hold, n: usize) -> Vec<f64> {
    let mut body = cube(n, SOFT);
    let free: Vec<usize> = body
        .nodes()
        .filter(|[u, v, w]| match hold {
            Hold::Base => *v > 0,
            Hold::Plates => *v > 0 && *v < n,
            Hold::All => [u, v, w].into_iter().all(|i| *i > 0 && *i < n),
        })
        .flat_map(|node| [0, 1, 2].map(|i| 3 * body.node(node) + i))
        .collect();
    // Without a resistance to changes of volume: 2 G eps : eps.
    let stiffness = dense_stiffness(&mut body).select_rows(&free).select_columns(&free);
    // Growth of the cells by a displacement, from pressures of -K times its part of their volume.
    let (edge, bulk_modulus) = (SIDE / n as f64, SOFT * SHEAR_MODULUS);
    let cell = edge.powi(3);
    let mut growth = DMatrix::zeros(free.len(), n * n * n);
    for (row, freedom) in free.iter().enumerate() {
        let mut displacement = vec![[0.0; 3]; body.n_node()];
        displacement[freedom / 3][freedom % 3] = edge;
        for (column, pressure) in body.cell_pressures(&displacement).into_iter().enumerate() {
            growth[(row, column)] = -pressure / bulk_modulus * cell / edge;
        }
    }
    let solved = stiffness.cholesky().expect("a cube that is held").solve(&growth);
    let schur = 2.0 * SHEAR_MODULUS / cell * growth.transpose() * solved;
    let mut values: Vec<f64> =
        SymmetricEigen::new(0.5 * (&schur + schur.transpose())).eigenvalues.iter().copied().collect();
    values.sort_by(f64::total_cmp);
    values
}

/// Rows of the table.
pub fn rows() -> Vec<Row> {
    let row = |nu: f64| {
        let errors: Vec<f64> = CELLS.iter().map(|n| alternating_part(nu, *n)).collect();
        Row {
            problem: "solid_checkerboard",
            quantity: format!("alternating part of the pressure, bonded square, nu = {nu}"),
            reference: "none in the limit".into(),
            meshes: CELLS.iter().map(|n| format!("{} cells", 2 * n)).collect(),
            order: Some(over_cells(&CELLS, &errors)),
            errors,
        }
    };
    POISSONS_RATIOS.map(row).into()
}
