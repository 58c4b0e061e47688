//! The cells of the section: two linear triangles each, total Lagrangian, with the pressure of their mean dilatation.
//!
//! For each triangle F = I + sum (u_a - u_0) (x) dN_a/dX, and the polar decomposition F = R U of the section is closed:
//! R is the rotation by the angle of (F11 + F22, F21 - F12). All deviatoric stresses live in the unrotated frame. The
//! two triangles of a cell share p = U'(J-bar) with J-bar their volume-weighted mean Jacobian (a mean-dilatation patch,
//! Nagtegaal, Parks and Rice 1974), which removes volumetric locking and derives from an energy. The first
//! Piola-Kirchhoff stress is P = R T U^-1 with T = dev + p J I, and the nodal force V P dN/dX.

use crate::lanes::{Deviator, LANES, Lane, ZERO};
use crate::material::Laws;
use crate::material::relaxation::Overstress;
use crate::material::tear::Tear;
use crate::math;
use crate::mesh::out_of_plane;
use crate::real::Real;
use crate::scenario::Scenario;
use crate::stretch::IsochoricStretch;

/// Constants of the triangles of a block of cells; all zero in padding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CellConstants {
    /// 1 where the diagonal runs from corner 0 to corner 2, 0 where it runs from corner 1 to corner 3.
    pub rising: Lane,
    /// First and second triangle of each cell: the first has the bottom edge, the second the top edge.
    pub triangle: [TriangleConstants; 2],
}

/// Constants of one triangle of each cell of a block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangleConstants {
    /// dN/dX_j for the two edges that the triangle shares with its cell, shape (2 x 2), 1/m: the one along the row, then
    /// the one across. F = I + sum (difference of u along the edge, as x and y grow) (x) gradient.
    pub shape_gradient: [[Lane; 2]; 2],
    /// V0, m3.
    pub reference_volume: Lane,
    /// Part of the cell's volume.
    pub patch_weight: Lane,
}

/// Derivative of the hoop stretch with respect to the radial displacement of each corner, shape (2 x 4), 1/m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HoopConstants {
    /// 1/(3 R) for the corners of each triangle, R its centroid's radius.
    pub weight: [[Lane; 4]; 2],
}

/// What the triangles of a block of cells remember.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CellHistory {
    /// First and second triangle of each cell.
    pub triangle: [TriangleHistory; 2],
}

/// What one triangle of each cell of a block remembers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangleHistory {
    /// Right stretch U11, U22, U12, U33 of the last step.
    pub stretch_prev: [Lane; 4],
    /// Long-term isochoric stress of the last step, Pa, before any tear.
    pub elastic_prev: Deviator,
    /// Stress of the damping spring, Pa, before any tear.
    pub slider_stress: Deviator,
    /// Largest principal stretch so far, where the material can tear; 1 otherwise.
    pub largest_stretch: Lane,
    /// Isochoric and spring energy of the last step before any tear, J/m3, where the material can tear; 0 otherwise.
    pub stored_prev: Lane,
}

impl CellConstants {
    /// Padding: no volume.
    pub const ZERO: Self = Self {
        rising: ZERO,
        triangle: [TriangleConstants { shape_gradient: [[ZERO; 2]; 2], reference_volume: ZERO, patch_weight: ZERO }; 2],
    };
}

impl HoopConstants {
    /// Padding.
    pub const ZERO: Self = Self { weight: [[ZERO; 4]; 2] };
}

impl CellHistory {
    /// At rest: unit stretch, no stress.
    pub const REST: Self = Self {
        triangle: [TriangleHistory {
            stretch_prev: [ONE, ONE, ZERO, ONE],
            elastic_prev: Deviator::ZERO,
            slider_stress: Deviator::ZERO,
            largest_stretch: ONE,
            stored_prev: ZERO,
        }; 2],
    };
}

const ONE: Lane = [1.0; LANES];

/// Displacements of the four corners of a block of cells, shape (4 x 2), m.
pub type Corners = [[Lane; 2]; 4];

/// Deformation of one triangle of each cell of a block.
pub struct Kinematics {
    /// Cosine and sine of the rotation R.
    pub cos: Lane,
    /// See `cos`.
    pub sin: Lane,
    /// Right stretch U.
    pub u11: Lane,
    /// Right stretch U.
    pub u22: Lane,
    /// Right stretch U.
    pub u12: Lane,
    /// Hoop stretch; 1 in plane strain.
    pub u33: Lane,
    /// J = det F.
    pub jacobian: Lane,
    /// J^(-1/3).
    pub inverse_cbrt_j: Lane,
}

impl Kinematics {
    /// Deformation of a triangle from the differences of displacement along its two edges and, in rings, those of its
    /// corners.
    #[inline(always)]
    pub fn new(constants: &TriangleConstants, edges: &[[Lane; 2]; 2], hoop: Option<(&[Lane; 4], &Corners)>) -> Self {
        let mut k =
            Self { cos: ZERO, sin: ZERO, u11: ONE, u22: ONE, u12: ZERO, u33: ONE, jacobian: ONE, inverse_cbrt_j: ONE };
        if let Some((weight, corners)) = hoop {
            for l in 0..LANES {
                k.u33[l] = 1.0
                    + weight[0][l] * corners[0][0][l]
                    + weight[1][l] * corners[1][0][l]
                    + weight[2][l] * corners[2][0][l]
                    + weight[3][l] * corners[3][0][l];
            }
        }
        let rings = hoop.is_some();
        let [g, h] = &constants.shape_gradient;
        let [[ax, ay], [bx, by]] = edges;
        for l in 0..LANES {
            let f11 = 1.0 + (ax[l] * g[0][l] + bx[l] * h[0][l]);
            let f12 = ax[l] * g[1][l] + bx[l] * h[1][l];
            let f21 = ay[l] * g[0][l] + by[l] * h[0][l];
            let f22 = 1.0 + (ay[l] * g[1][l] + by[l] * h[1][l]);
            // R maximises tr(R^T F), so its angle is that of (F11 + F22, F21 - F12).
            let (a, b) = (f11 + f22, f21 - f12);
            let inverse_length = math::inverse_sqrt(a * a + b * b);
            let (cos, sin) = (a * inverse_length, b * inverse_length);
            k.cos[l] = cos;
            k.sin[l] = sin;
            k.u11[l] = cos * f11 + sin * f21;
            k.u22[l] = cos * f22 - sin * f12;
            k.u12[l] = cos * f12 + sin * f22;
            let section = f11 * f22 - f12 * f21;
            let jacobian = if rings { section * k.u33[l] } else { section };
            k.jacobian[l] = jacobian;
            k.inverse_cbrt_j[l] = math::inverse_cbrt(jacobian);
        }
        k
    }

    /// U-bar = J^(-1/3) U of lane `l`.
    #[inline(always)]
    pub fn isochoric_stretch(&self, l: usize) -> IsochoricStretch {
        let scale = self.inverse_cbrt_j[l];
        IsochoricStretch {
            u11: scale * self.u11[l],
            u22: scale * self.u22[l],
            u12: scale * self.u12[l],
            u33: scale * self.u33[l],
        }
    }

    /// C-bar = U-bar^2 of lane `l`: components 11, 22, 12, 33.
    #[inline(always)]
    pub fn isochoric_cauchy_green(&self, l: usize) -> [Real; 4] {
        let IsochoricStretch { u11, u22, u12, u33 } = self.isochoric_stretch(l);
        [u11 * u11 + u12 * u12, u22 * u22 + u12 * u12, u12 * (u11 + u22), u33 * u33]
    }

    /// First lane whose Jacobian is not positive, or not a number.
    #[inline(always)]
    pub fn inverted_lane(&self) -> Option<usize> {
        self.jacobian.iter().position(|j| j.is_nan() || *j <= 0.0)
    }

    /// dev sym(delta U U^-1) against the stretch of the last step, at the mean stretch; then remembers this stretch.
    #[inline(always)]
    fn strain_increment(&self, stretch_prev: &mut [Lane; 4], rings: bool) -> Deviator {
        let mut increment = Deviator::ZERO;
        let [p11, p22, p12, p33] = stretch_prev;
        for l in 0..LANES {
            let (u11, u22, u12) = (self.u11[l], self.u22[l], self.u12[l]);
            let (d11, d22, d12) = (u11 - p11[l], u22 - p22[l], u12 - p12[l]);
            // Twice the mean stretch, whose inverse is twice its adjugate over its determinant.
            let (s11, s22, s12) = (u11 + p11[l], u22 + p22[l], u12 + p12[l]);
            let double_inverse = 2.0 / (s11 * s22 - s12 * s12);
            let shear = d12 * s12;
            let xx = (d11 * s22 - shear) * double_inverse;
            let yy = (d22 * s11 - shear) * double_inverse;
            let zz = if rings { 2.0 * (self.u33[l] - p33[l]) / (self.u33[l] + p33[l]) } else { 0.0 };
            let mean = (if rings { xx + yy + zz } else { xx + yy }) * (1.0 / 3.0);
            increment.xx[l] = xx - mean;
            increment.yy[l] = yy - mean;
            increment.xy[l] = (d12 * (s11 + s22) - s12 * (d11 + d22)) * (0.5 * double_inverse);
            p11[l] = u11;
            p22[l] = u22;
            p12[l] = u12;
        }
        if rings {
            *p33 = self.u33;
        }
        increment
    }
}

/// Energy of the elements: section sums per lane, J, or densities, J/m3.
#[derive(Clone, Copy, Debug)]
pub struct ElementEnergy {
    /// Long-term elastic energy, isochoric and volumetric.
    pub elastic: Lane,
    /// Energy stored in the damping springs.
    pub slider_stored: Lane,
    /// Work done on the viscous overstress in this step.
    pub viscous_increment: Lane,
    /// Power dissipated by the dashpots after this step, W.
    pub viscous_power: Lane,
    /// Energy dissipated by the sliders in this step.
    pub slider_increment: Lane,
    /// Energy dissipated by tearing in this step.
    pub tear_increment: Lane,
}

impl ElementEnergy {
    /// Nothing yet.
    pub const ZERO: Self = Self {
        elastic: ZERO,
        slider_stored: ZERO,
        viscous_increment: ZERO,
        viscous_power: ZERO,
        slider_increment: ZERO,
        tear_increment: ZERO,
    };

    /// Adds the energy densities, but for tearing, of triangles of the reference volumes `volume`.
    #[inline(always)]
    fn add(&mut self, volume: &Lane, density: &Self) {
        for l in 0..LANES {
            self.elastic[l] += volume[l] * density.elastic[l];
            self.slider_stored[l] += volume[l] * density.slider_stored[l];
            self.viscous_increment[l] += volume[l] * density.viscous_increment[l];
            self.viscous_power[l] += volume[l] * density.viscous_power[l];
            self.slider_increment[l] += volume[l] * density.slider_increment[l];
        }
    }
}

/// Nodal internal forces of a block, N, from the displacements of its corners; advances the history of its triangles.
///
/// `viscous` holds the overstress of the first triangle's terms, then of the second's.
///
/// # Errors
/// The first inverted (lane, triangle). The history of the block is not to be used then.
#[inline(always)]
pub fn internal_force(
    laws: &Laws,
    constants: &CellConstants,
    hoop: Option<&HoopConstants>,
    corners: &Corners,
    history: &mut CellHistory,
    viscous: &mut [Deviator],
    energy: &mut ElementEnergy,
) -> Result<Corners, (usize, usize)> {
    let rings = hoop.is_some();
    let kinematics = cell_kinematics(constants, hoop, corners);
    for (t, k) in kinematics.iter().enumerate() {
        if let Some(l) = k.inverted_lane() {
            return Err((l, t));
        }
    }
    let pressure = patch_pressure(laws, constants, &kinematics, energy);
    let mut edge_force = [[[ZERO; 2]; 2]; 2];
    let mut hoop_stress = [ZERO; 2];
    let (first, second) = viscous.split_at_mut_checked(laws.n_term()).unwrap_or_default();
    for (t, terms) in [first, second].into_iter().enumerate() {
        let (k, triangle) = (&kinematics[t], &constants.triangle[t]);
        let volume = &triangle.reference_volume;
        let stress = deviatoric_stress(laws, k, rings, volume, &mut history.triangle[t], terms, energy);
        edge_forces(k, &stress, &pressure, triangle, rings, &mut edge_force[t], &mut hoop_stress[t]);
    }
    let mut force = corner_forces(&constants.rising, &edge_force);
    if let Some(hoop) = hoop {
        for t in 0..2 {
            add_hoop_force(&kinematics[t].u33, &hoop_stress[t], &hoop.weight[t], &mut force);
        }
    }
    Ok(force)
}

/// Deformation of the two triangles of each cell.
#[inline(always)]
pub(crate) fn cell_kinematics(
    constants: &CellConstants,
    hoop: Option<&HoopConstants>,
    corners: &Corners,
) -> [Kinematics; 2] {
    let [first, second] = triangle_edges(&constants.rising, corners);
    let [a, b] = &constants.triangle;
    match hoop {
        Some(HoopConstants { weight: [v, w] }) => {
            [Kinematics::new(a, &first, Some((v, corners))), Kinematics::new(b, &second, Some((w, corners)))]
        }
        None => [Kinematics::new(a, &first, None), Kinematics::new(b, &second, None)],
    }
}

/// Differences of displacement along the edges of the two triangles of each cell: along the row, then across.
#[inline(always)]
fn triangle_edges(rising: &Lane, [c0, c1, c2, c3]: &Corners) -> [[[Lane; 2]; 2]; 2] {
    let mut edges = [[[ZERO; 2]; 2]; 2];
    for i in 0..2 {
        for l in 0..LANES {
            let (left, right) = (c3[i][l] - c0[i][l], c2[i][l] - c1[i][l]);
            let first_has_right = rising[l] > 0.0;
            edges[0][0][i][l] = c1[i][l] - c0[i][l];
            edges[0][1][i][l] = if first_has_right { right } else { left };
            edges[1][0][i][l] = c2[i][l] - c3[i][l];
            edges[1][1][i][l] = if first_has_right { left } else { right };
        }
    }
    edges
}

/// Forces on the corners from those on the edges of the two triangles, which pull an edge's end and push its start.
#[inline(always)]
fn corner_forces(rising: &Lane, [first, second]: &[[[Lane; 2]; 2]; 2]) -> Corners {
    let mut force = [[ZERO; 2]; 4];
    for i in 0..2 {
        for l in 0..LANES {
            let (bottom, top) = (first[0][i][l], second[0][i][l]);
            let first_has_right = rising[l] > 0.0;
            let right = if first_has_right { first[1][i][l] } else { second[1][i][l] };
            let left = if first_has_right { second[1][i][l] } else { first[1][i][l] };
            force[0][i][l] = -(bottom + left);
            force[1][i][l] = bottom - right;
            force[2][i][l] = top + right;
            force[3][i][l] = left - top;
        }
    }
    force
}

/// Pressure of each cell from the volume-weighted mean Jacobian of its two triangles.
#[inline(always)]
fn patch_pressure(
    laws: &Laws,
    constants: &CellConstants,
    kinematics: &[Kinematics; 2],
    energy: &mut ElementEnergy,
) -> Lane {
    let [a, b] = &constants.triangle;
    let mut mean = ONE;
    for l in 0..LANES {
        mean[l] = 1.0
            + (a.patch_weight[l] * (kinematics[0].jacobian[l] - 1.0)
                + b.patch_weight[l] * (kinematics[1].jacobian[l] - 1.0));
    }
    let density = laws.volumetric.strain_energy_density(&mean);
    for l in 0..LANES {
        energy.elastic[l] += (a.reference_volume[l] + b.reference_volume[l]) * density[l];
    }
    laws.volumetric.stress(&mean)
}

/// Deviatoric Kirchhoff stress of one triangle of each cell in the unrotated frame, Pa.
#[inline(always)]
fn deviatoric_stress(
    laws: &Laws,
    kinematics: &Kinematics,
    rings: bool,
    volume: &Lane,
    history: &mut TriangleHistory,
    viscous: &mut [Deviator],
    energy: &mut ElementEnergy,
) -> Deviator {
    let strain_increment = kinematics.strain_increment(&mut history.stretch_prev, rings);
    let (elastic, stored_elastic) = laws.elastic.stress(kinematics);
    let mut overstress = Overstress::beside(&elastic);
    let (quasi_linear, additive) = viscous.split_at_mut_checked(laws.prony.n_term()).unwrap_or_default();
    laws.prony.update(&elastic, &history.elastic_prev, quasi_linear, &mut overstress);
    laws.maxwell.update(&strain_increment, additive, &mut overstress);
    history.elastic_prev = elastic;
    let mut density = ElementEnergy { elastic: stored_elastic, viscous_power: overstress.power, ..ElementEnergy::ZERO };
    for l in 0..LANES {
        density.viscous_increment[l] = 0.5 * overstress.double_mean.contract(&strain_increment, l);
    }
    let mut total = overstress.total;
    if laws.slider.active() {
        let spring = laws.slider.update(&strain_increment, &mut history.slider_stress);
        density.slider_increment = spring.dissipation;
        density.slider_stored = spring.stored;
        total.add(&history.slider_stress);
    }
    if laws.tear.active() {
        // Copies, so that the address of the numbers that all materials need is not taken, which would cost them time.
        let (mut torn, mut rest) = (total, density);
        tear(&laws.tear, kinematics, history, &mut torn, &mut rest);
        energy.add(volume, &rest);
        for l in 0..LANES {
            energy.tear_increment[l] += volume[l] * rest.tear_increment[l];
        }
        return torn;
    }
    energy.add(volume, &density);
    total
}

/// Takes from a block of triangles the stress and the energies that it has lost by tearing.
fn tear(
    law: &Tear,
    kinematics: &Kinematics,
    history: &mut TriangleHistory,
    stress: &mut Deviator,
    energy: &mut ElementEnergy,
) {
    let [before, after] = law.update(kinematics, &mut history.largest_stretch);
    for l in 0..LANES {
        let (factor, mean) = (after[l], 0.5 * (before[l] + after[l]));
        let stored = energy.elastic[l] + energy.slider_stored[l];
        energy.tear_increment[l] = (before[l] - after[l]) * 0.5 * (history.stored_prev[l] + stored);
        history.stored_prev[l] = stored;
        energy.elastic[l] *= factor;
        energy.slider_stored[l] *= factor;
        energy.viscous_increment[l] *= mean;
        energy.viscous_power[l] *= factor;
        energy.slider_increment[l] *= mean;
        for component in [&mut stress.xx, &mut stress.yy, &mut stress.xy] {
            component[l] *= factor;
        }
    }
}

/// V P dN/dX of one triangle of each cell for its two edges, and in rings the hoop stress times V and the hoop stretch.
#[inline(always)]
fn edge_forces(
    k: &Kinematics,
    stress: &Deviator,
    pressure: &Lane,
    constants: &TriangleConstants,
    rings: bool,
    force: &mut [[Lane; 2]; 2],
    hoop_stress: &mut Lane,
) {
    let [g, h] = &constants.shape_gradient;
    for l in 0..LANES {
        let volume = constants.reference_volume[l];
        let spherical = pressure[l] * k.jacobian[l];
        let (t11, t22, t12) = (stress.xx[l] + spherical, stress.yy[l] + spherical, stress.xy[l]);
        // U^-1 of the section is the adjugate over J / U33, and 1/J is the cube of J^(-1/3). The volume joins it here.
        let root = k.inverse_cbrt_j[l];
        let cube = volume * (root * root * root);
        let inverse = if rings { k.u33[l] * cube } else { cube };
        let (i11, i22, i12) = (k.u22[l] * inverse, k.u11[l] * inverse, k.u12[l] * inverse);
        let (b11, b12) = (t11 * i11 - t12 * i12, t12 * i22 - t11 * i12);
        let (b21, b22) = (t12 * i11 - t22 * i12, t22 * i22 - t12 * i12);
        let (cos, sin) = (k.cos[l], k.sin[l]);
        let (p11, p12) = (cos * b11 - sin * b21, cos * b12 - sin * b22);
        let (p21, p22) = (sin * b11 + cos * b21, sin * b12 + cos * b22);
        force[0][0][l] = p11 * g[0][l] + p12 * g[1][l];
        force[0][1][l] = p21 * g[0][l] + p22 * g[1][l];
        force[1][0][l] = p11 * h[0][l] + p12 * h[1][l];
        force[1][1][l] = p21 * h[0][l] + p22 * h[1][l];
        if rings {
            hoop_stress[l] = volume * (spherical - (stress.xx[l] + stress.yy[l]));
        }
    }
}

/// Adds the radial forces of the hoop stress to the corners.
#[inline(always)]
fn add_hoop_force(u33: &Lane, hoop_stress: &Lane, weight: &[Lane; 4], force: &mut Corners) {
    for l in 0..LANES {
        let p33 = hoop_stress[l] / u33[l];
        for a in 0..4 {
            force[a][0][l] += p33 * weight[a][l];
        }
    }
}

/// Constants of one triangle of one cell, before they are put into lanes.
pub(crate) struct Triangle {
    /// dN_a/dX of the four corners, 1/m.
    pub gradient: [[Real; 2]; 4],
    /// V0, m3.
    pub volume: Real,
    /// 1/(3 R) for the triangle's corners, 1/m.
    pub hoop: [Real; 4],
}

impl Triangle {
    /// The triangle of three of a cell's four `corners`, m.
    pub fn new(scenario: &Scenario, corners: &[[Real; 2]; 4], nodes: [usize; 3]) -> Self {
        // Corners are numbered 0 to 3; the remainder changes nothing and leaves no bound to check.
        let [a, b, c] = nodes.map(|node| corners[node % 4]);
        // The corners run counter-clockwise, so this is positive.
        let double_area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
        let radius = (a[0] + b[0] + c[0]) / 3.0;
        let mut triangle = Self {
            gradient: [[0.0; 2]; 4],
            volume: 0.5 * double_area * out_of_plane(scenario, radius),
            hoop: [0.0; 4],
        };
        for (node, (p, q)) in nodes.into_iter().zip([(b, c), (c, a), (a, b)]) {
            triangle.gradient[node % 4] = [(p[1] - q[1]) / double_area, (q[0] - p[0]) / double_area];
            triangle.hoop[node % 4] = 1.0 / (3.0 * radius);
        }
        triangle
    }

    /// Writes the triangle into lane `l`.
    pub fn store(&self, l: usize, constants: &mut TriangleConstants, patch_volume: Real) {
        // Moving the end of an edge moves the corners beyond it, too: those on the right, those on top.
        for j in 0..2 {
            constants.shape_gradient[0][j][l] = self.gradient[1][j] + self.gradient[2][j];
            constants.shape_gradient[1][j][l] = self.gradient[2][j] + self.gradient[3][j];
        }
        constants.reference_volume[l] = self.volume;
        constants.patch_weight[l] = self.volume / patch_volume;
    }
}
