//! The highest frequency of single cells of a solid.
//!
//! As in the section ([`crate::element::cell_bound`]): with a majorant G of the shear tangent of each tetrahedron and kappa of the
//! cell's mean dilatation, the stiffness is the sum of 2 G V dev(e) : dev(e) over the tetrahedra and kappa V b b', with the current
//! gradients but for the rotation of one tetrahedron against the other. With an eighth of the mass rho V at each corner, a step dt is
//! stable where rho V - 2 dt^2 K is positive definite, where Gauss' elimination meets positive pivots alone.

use crate::element::cell_bound::HALVINGS;
use crate::element::solid_cell::{INVERSE_VOLUME, SolidBlock, TETRAHEDRON_PACKS, VOLUME, path_corners};
use crate::element::solid_force::edge_gradient;
use crate::mesh::{PATHS, TETRAHEDRA};
use crate::number::math::THIRD;
use crate::number::pack::{Pack, ZERO};
use crate::number::real::Real;
use crate::number::vector::{Simd, Vector};
use crate::tensor::symmetric::Symmetric;

/// Displacements of a cell: of each corner, three directions.
const N: usize = 24;

/// K over rho V / 2 of neighbouring cells, 1/s2, and what it is made of. Large, so that one is filled again and again.
pub(crate) struct SolidMatrix<V> {
    /// The lower triangle; nothing above the diagonal is read.
    matrix: [[V; N]; N],
    /// Place for the elimination.
    rows: [[V; N]; N],
    /// Derivative of the mean dilatation with respect to the displacements, 1/m.
    dilatation: [V; N],
    /// Largest bulk tangent of the tetrahedra, Pa.
    bulk: V,
}

impl<V: Vector> SolidMatrix<V> {
    /// Without stiffness.
    #[inline(always)]
    pub fn none<S: Simd<Vector = V>>(simd: S) -> Self {
        let zero = simd.splat(0.0);
        Self { matrix: [[zero; N]; N], rows: [[zero; N]; N], dilatation: [zero; N], bulk: zero }
    }

    /// Fills it with that of the cells at the stretches that the last internal forces have left in the `history`; at rest where there
    /// is none.
    #[inline(always)]
    pub fn fill<S: Simd<Vector = V>>(&mut self, simd: S, chunk: usize, block: &SolidBlock, history: &[Pack]) {
        let zero = simd.splat(0.0);
        (self.dilatation, self.bulk) = ([zero; N], zero);
        for i in 0..N {
            for j in 0..i + 1 {
                self.matrix[i][j] = zero;
            }
        }
        let share = (history.len() / TETRAHEDRA).max(1);
        let inverse_volume = simd.load(&block.constants[INVERSE_VOLUME], chunk);
        let tetrahedra = block.constants.as_chunks::<TETRAHEDRON_PACKS>().0;
        for (t, (packs, path)) in tetrahedra.iter().zip(PATHS).enumerate() {
            let mut stretch = Symmetric::unit(simd.splat(1.0), zero);
            if let Some(packs) = history.get(t * share..).and_then(|history| history.first_chunk()) {
                stretch = stretch.plus(&Symmetric::load(simd, packs, chunk));
            }
            let fraction = simd.load(&packs[VOLUME], chunk) * inverse_volume;
            let gradients = node_gradients(simd, chunk, packs, &stretch);
            self.add(simd, block, path, &stretch, &gradients, fraction);
        }
        self.complete(simd, block);
    }

    /// 1 where the step of this square is too large, 0 elsewhere and where the state is not a number.
    #[inline(always)]
    fn unstable<S: Simd<Vector = V>>(&mut self, simd: S, step_squared: V) -> V {
        let (zero, one) = (simd.splat(0.0), simd.splat(1.0));
        let Self { matrix, rows, .. } = self;
        for i in 0..N {
            for j in 0..i + 1 {
                rows[i][j] = zero - step_squared * matrix[i][j];
            }
            rows[i][i] = rows[i][i].add_scalar(1.0);
        }
        let mut unstable = zero;
        for k in 0..N {
            let pivot = rows[k][k];
            unstable = simd.splat(Real::MIN_POSITIVE).select_greater(pivot, one, unstable);
            let inverse = one / pivot;
            for i in k + 1..N {
                let factor = rows[i][k] * inverse;
                for j in k + 1..i + 1 {
                    rows[i][j] = rows[i][j] - factor * rows[j][k];
                }
            }
        }
        unstable
    }

    /// Square of the largest stable step of each cell, s2, to one part in 10^8 from below; at most `bound`.
    #[inline(always)]
    pub fn limit_squared<S: Simd<Vector = V>>(&mut self, simd: S, bound: V) -> V {
        let zero = simd.splat(0.0);
        let mut trace = zero;
        for i in 0..N {
            trace = trace + self.matrix[i][i];
        }
        // The largest eigenvalue lies between the mean of all and their sum.
        let mut stable = simd.splat(1.0) / trace.max(simd.splat(Real::MIN_POSITIVE));
        stable = stable.select_greater(bound, bound, stable);
        let (mut beyond, mut probe) = (bound, bound);
        for _ in 0..=HALVINGS {
            let lost = self.unstable(simd, probe);
            (stable, beyond) = (lost.select_greater(zero, stable, probe), lost.select_greater(zero, probe, beyond));
            let most = stable.mul_scalar(N as Real);
            beyond = beyond.select_greater(most, most, beyond);
            probe = (stable + beyond).mul_scalar(0.5);
            let mut open = ZERO;
            simd.store(beyond - stable, &mut open, 0);
            if open == ZERO {
                break;
            }
        }
        stable
    }

    /// Adds a tetrahedron of each cell along a `path`, whose corners have these gradients, with the part `fraction` of its volume.
    #[inline(always)]
    fn add<S: Simd<Vector = V>>(
        &mut self,
        simd: S,
        block: &SolidBlock,
        path: [usize; 3],
        stretch: &Symmetric<V>,
        gradients: &[[V; 3]; 4],
        fraction: V,
    ) {
        let stretches = stretch.principal(simd).values;
        let [shear, own_bulk] = block.laws.solid_tangent(simd, stretches);
        let (shear_part, bulk_part) = (fraction * shear, fraction * own_bulk);
        let trace_part = bulk_part - shear_part.mul_scalar(2.0 * THIRD);
        let corners = path_corners(path);
        for a in 0..4 {
            for b in 0..4 {
                let (row, column) = (3 * (corners[a] % 8), 3 * (corners[b] % 8));
                if row < column {
                    continue;
                }
                let (g, h) = (&gradients[a], &gradients[b]);
                let dot = shear_part * (g[0] * h[0] + g[1] * h[1] + g[2] * h[2]);
                for i in 0..3 {
                    for j in 0..3 {
                        let mut entry = trace_part * (g[i] * h[j]) + shear_part * (g[j] * h[i]);
                        if i == j {
                            entry = entry + dot;
                        }
                        let place = &mut self.matrix[(row + i) % N][(column + j) % N];
                        *place = *place + entry;
                    }
                }
            }
            for i in 0..3 {
                let place = &mut self.dilatation[(3 * corners[a] + i) % N];
                *place = *place + fraction * gradients[a][i];
            }
        }
        if !block.laws.elastic.is_compressible() {
            // Stresses stiffen a change of volume, too: by about what they add to the shear.
            let jacobian = stretches[0] * stretches[1] * stretches[2];
            let added = shear.add_scalar(-block.laws.shear_modulus_0).max(simd.splat(0.0));
            self.bulk = self.bulk.max(block.laws.volumetric.tangent(simd, jacobian) + added);
        }
    }

    /// Adds the pressure of the mean dilatation and divides by the mass.
    #[inline(always)]
    fn complete<S: Simd<Vector = V>>(&mut self, simd: S, block: &SolidBlock) {
        let scale = simd.splat(2.0 / block.laws.density);
        for i in 0..N {
            let own = self.bulk * self.dilatation[i];
            for j in 0..i + 1 {
                self.matrix[i][j] = scale * (self.matrix[i][j] + own * self.dilatation[j]);
            }
        }
    }
}

/// U^-1 times the gradients of the corners along a path: the spatial ones but for a rotation.
#[inline(always)]
fn node_gradients<S: Simd>(
    simd: S,
    chunk: usize,
    packs: &[Pack; TETRAHEDRON_PACKS],
    stretch: &Symmetric<S::Vector>,
) -> [[S::Vector; 3]; 4] {
    let (zero, adjugate) = (simd.splat(0.0), stretch.adjugate());
    let inverse = adjugate.scaled(simd.splat(1.0) / stretch.determinant(&adjugate));
    let mut nodes = [[zero; 3]; 4];
    for edge in 0..3 {
        let gradient = inverse.times(edge_gradient(simd, chunk, packs, edge));
        for i in 0..3 {
            nodes[edge][i] = nodes[edge][i] - gradient[i];
            nodes[edge + 1][i] = nodes[edge + 1][i] + gradient[i];
        }
    }
    nodes
}
