//! Every tolerance of the verification problems, with its reason.

/// Closed forms evaluated by the element at prescribed corner positions: round-off of some hundred operations.
pub const CLOSED_FORM: f64 = 1e-11;

/// The same in a solid, whose strains are sums of products of three components, over the shear modulus.
pub const SOLID_CLOSED_FORM: f64 = 1e-10;

/// A solid between held ends against its section in plane strain, on meshes of 2.5 mm.
pub const SOLID_PLANE_STRAIN: f64 = 5e-3;

/// A solid of revolution against its axisymmetric section, on meshes of 2.5 to 4 mm: its squares about the centre are not the
/// section's rings.
pub const SOLID_REVOLVED: f64 = 1e-2;

/// Tetrahedra of 2.5 mm against hexahedra between the same nodes, six cells through the layer: 1.2 % apart, with 2.0 to 2.2 %
/// four cells through it.
pub const SOLID_HEXAHEDRA: f64 = 1.5e-2;

/// Factor by which the two come closer when the cells are two thirds as large: of first order it were 1.5, of second 2.25.
pub const SOLID_HEXAHEDRA_GAIN: f64 = 1.5;

/// What the force may lose as a face gets wider by an eighth of a cell: 0.2 % where its edge reaches a node. Nodes alone lost
/// 1.4 % in a quarter.
pub const EDGE_FALL: f64 = 3e-3;
/// What it may gain, over its gain in a whole cell: 0.32. Nodes alone gained 0.5 in a quarter.
pub const EDGE_RISE: f64 = 0.4;

/// Cook's membrane as a solid, linear, on 32 by 32 by 2 cells: as [`COOK_LINEAR`], with more ways for a cell to bend.
pub const SOLID_COOK: f64 = 8e-3;

/// Bonded solid blocks with twelve cells through their thickness: the edges of the bonds are singular, as are those of the section's.
pub const SOLID_BLOCK: f64 = 0.035;

/// Their limit, extrapolated from meshes of four to twelve cells: 0.6 % at most when measured.
pub const SOLID_BLOCK_LIMIT: f64 = 8e-3;

/// Least order of their apparent modulus: at an incompressible edge between bond and free side the displacement goes with the power 0.595
/// of the distance, and the energy, in the limit, with twice as much of the size of the cells.
pub const SOLID_BLOCK_ORDER: f64 = 1.1;

/// Gent and Meinecke's modulus of a square at a shape factor of 0.5, as [`GENT_LINDLEY_SLENDER`]: it lacks what the corners hold too.
pub const GENT_MEINECKE_SLENDER: f64 = 0.08;

/// Displacement of Lame's problems as solids on the finest meshes, 12 and 32 cells through the wall, root mean square.
pub const SOLID_LAME_DISPLACEMENT: f64 = 1e-3;

/// Largest error of a displacement there: at a corner of the sphere's part, whose only cell is sheared.
pub const SOLID_LAME_LARGEST: f64 = 1e-2;

/// Least order of the largest error in a cylinder, and in a sphere, where that corner is not yet in the limit with 12 cells.
pub const SOLID_LAME_LARGEST_ORDER: [f64; 2] = [1.85, 1.2];

/// Pressure of the cells there over the pressure inside.
pub const SOLID_LAME_PRESSURE: f64 = 2e-3;

/// Least order of the pressure: one is what a constant in each cell promises.
pub const SOLID_LAME_PRESSURE_ORDER: f64 = 1.3;

/// Displacement of the swinging cube on 16 by 16 by 16 cells.
pub const SOLID_SWING: f64 = 2e-3;

/// Largest alternating part of the pressure of a solid with eight cells through the thickness, at any Poisson's ratio of the study.
pub const SOLID_CHECKERBOARD: f64 = 6e-3;

/// Least order of that part at Poisson's ratios of 0.48, 0.499 and 0.4999: as the volume stiffens, so do the alternating pressures, which
/// a finer mesh feels less.
pub const SOLID_CHECKERBOARD_ORDER: [f64; 3] = [2.0, 0.5, 0.2];

/// Least square of an inf-sup value of a cube with a free side, times the square of the number of cells along a side: 1.03 or more when
/// measured. The constant pressure of linear cells is known to lose as much.
pub const SOLID_INF_SUP: f64 = 1.0;

/// Zero inf-sup values: as [`ZERO_ENERGY`].
pub const ZERO_INF_SUP: f64 = 1e-9;

/// P against central differences of W with a step of 10^-5: the next order is its square times a third derivative of
/// some ten moduli, the round-off of W over the step about the same.
pub const ENERGY_GRADIENT: f64 = 1e-8;

/// A law at almost equal stretches against its closed form, relative to each stress component by itself.
pub const COINCIDENCE: f64 = 1e-13;

/// Shear modulus from a shear of 10^-4: the next order is its square.
pub const SMALL_SHEAR: f64 = 1e-7;

/// Patch test: residual force of an interior node relative to the largest internal force of a node, round-off.
pub const PATCH: f64 = 1e-11;

/// Ramp of a Prony series, relative to the peak: the recurrence is exact for the linear ramp of the elastic stress, which
/// a strain of 10^-4 leaves nonlinear to the order of the strain.
pub const PRONY_RAMP: f64 = 1e-3;

/// Work on a Prony series under a ramp to a strain of 10^-4: the strain makes the law nonlinear to its own order, and the
/// trapezoidal rule takes (dt / tau)^2 / 12 = 2 10^-6 off.
pub const PRONY_WORK: f64 = 5e-4;

/// A ring of 1 mm in a radius of 1 m: the hoop stretch differs by a thousandth of the growth from one side to the other.
pub const THIN_RING: f64 = 2e-3;

/// Width of a block under a strain of 10^-3: the linear closed form is off by the strain.
pub const FLAT_WIDTH: f64 = 1e-4;

/// Pressure at a node under a flat face against the mean: what is left of the motion, and the rounding of the last step's catch.
pub const FLAT_PRESSURE: f64 = 1e-4;

/// Ramp of additive terms at a constant true strain rate: the increment at the mean stretch is off by the square of its
/// size over 12, and each term is exact for it.
pub const MAXWELL_RAMP: f64 = 1e-6;

/// Work of that ramp: the trapezoidal rule takes (beta dt)^2 / 12 = 3 10^-5 off the bent part of the work, which is below a
/// tenth of it.
pub const MAXWELL_WORK: f64 = 3e-6;

/// Storage and loss modulus at 400 steps a cycle: the steps are straight, which takes (omega dt)^2 / 12 = 2 10^-5 off an
/// amplitude, and a transient of e^-12 is left.
pub const HARMONIC: f64 = 1e-4;

/// Shear tangent from second differences of W over a strain of 10^-3: the next order is its square times the ratio of the
/// fourth derivative to the second, of the order of ten.
pub const SHEAR_TANGENT: f64 = 1e-5;

/// Largest stable step of a cell: the halvings of an interval seven times as long, and the half of the squares' error. The
/// central differences of the reference leave a hundredth of it.
pub const STABLE_STEP: f64 = 1e-8;

/// The least that the limit of a deformed cell may be of the true one of the same cell: its tangents are majorants, but steps
/// are not to be wasted.
pub const NAMED_LIMIT_LEAST: f64 = 0.7;

/// The stability limit of single cells over that of the whole mesh: their tangents are majorants but for what turning a cell
/// under its stress adds. In none of 15,000 random states of all laws was it above.
pub const NAMED_LIMIT_RELAXED: f64 = 0.02;

/// The same where all of an overstress of nine times the long-term stress is there, in which the tangents have no more part
/// than before, but the stress ten times: 9.1 % at most in 5,000 states. The default safety factor is as far below.
pub const NAMED_LIMIT_UNRELAXED: f64 = 0.1;

/// Residual of the energy of a drop over what was brought in, whatever the material.
pub const PLAUSIBLE_RESIDUAL: f64 = 5e-3;

/// Steps of the median plausible drop over those that it needed in hindsight.
pub const STEPS_OVER_HINDSIGHT: f64 = 1.5;

/// The same of a drop on a layer that softens: up to four times as many for an impact that follows it, and the margins.
pub const STEPS_FOR_THE_NEXT_IMPACT: f64 = 7.0;

/// Slider loop at a shear of 1 %: the closed form is that of small strain, the next order is the square of the shear.
pub const SLIDER_LOOP: f64 = 1e-3;

/// Stress left by ten turns, relative to the spring stiffness: round-off of the stretch in each step.
pub const ROTATION_DRIFT: f64 = 1e-10;

/// Free fall: the impactor follows the exact parabola, contact is found to within one step.
pub const FREE_FALL: f64 = 1e-12;

/// Mass on a linear spring: waves in the layer are of the order sqrt(layer mass / mass) = 0.3 %, the strain of 0.3 %
/// makes the law nonlinear to the same order.
pub const SPRING: f64 = 0.01;

/// Energy of a tear against its integral and against the work of the forces, in some thousand steps: the trapezoidal rule
/// over a slope that changes within a thousand of them.
pub const TEAR_ENERGY: f64 = 1e-5;

/// Energy of random histories over the work done on the way, in steps of up to 1.4 thousandths of strain: the trapezoidal
/// rule.
pub const HISTORY_ENERGY: f64 = 1e-3;

/// Loss of a dissipated energy in one step over its size: round-off of a product that is zero at its least.
pub const NO_GAIN: f64 = 1e-12;

/// Energy residual over impact energy (0.1 % is the requirement).
pub const ENERGY_RESIDUAL: f64 = 1e-3;

/// A stack pressed by a thousandth against springs in series: what the law is not linear by, and what still swings.
pub const SERIES: f64 = 5e-3;

/// Two layers of one material against one layer: the round-off of the positions of the rows, grown in some thousand steps
/// in which nodes touch and leave the face.
pub const LAYERS: f64 = 1e-9;

/// Momentum balance over the impulse: round-off of some thousand steps.
pub const MOMENTUM: f64 = 1e-9;

/// Peak force and deformation between the default mesh and one twice as fine.
pub const MESH: f64 = 0.03;

/// Penetration of the face over the element size: contact is a constraint, what is left is round-off.
pub const PENETRATION: f64 = 1e-9;

/// Mirror images and two halves against the whole: round-off, grown over some thousand steps of contact.
pub const SYMMETRY: f64 = 1e-8;

/// The value `measured` against `reference`, relative.
pub fn relative_error(measured: f64, reference: f64) -> f64 {
    (measured - reference).abs() / reference.abs()
}

/// Least order of the contact force of the bonded layer: the requirement.
pub const CONTACT_ORDER: f64 = 1.5;

/// Contact force at the default element size against the finest mesh: the requirement.
pub const CONTACT_DEFAULT: f64 = 0.02;

/// The force at which the kernel's steps settle against the equilibrium of the same mesh: the square root of the kinetic
/// energy that is left.
pub const SETTLED: f64 = 1e-5;

/// Patch test with free inner nodes: round-off, grown by the condition of the stiffness.
pub const PATCH_DISTORTED: f64 = 1e-10;

/// Least order where theory says 2, measured over four meshes of which the coarsest is not yet in the limit.
pub const SECOND_ORDER: f64 = 1.9;

/// Largest error of the swinging plate on 32 by 32 cells.
pub const SWINGING_PLATE: f64 = 1e-3;

/// Cook's membrane, linear, on 32 by 32 cells: linear triangles bend stiffly, the corner of the clamp is singular.
pub const COOK_LINEAR: f64 = 0.012;

/// Limit of Cook's linear deflection, extrapolated from the three finest regular meshes.
pub const COOK_LIMIT: f64 = 3e-3;

/// Limit of Cook's deflection at finite strain, extrapolated likewise.
pub const COOK_FINITE_LIMIT: f64 = 5e-3;

/// Stress of a frictionless virtual cylinder over its largest: inertia of 40 periods, 1.6e-4 when measured.
pub const CYLINDER: f64 = 3e-4;

/// The same with the study's silicone, fifty times as stiff at once as in the end, whose tangent rises at half the height.
pub const CYLINDER_STUDY: f64 = 2e-3;

/// Stress of a bonded virtual cylinder against the equilibrium of its mesh: vibration, averaged over the hold.
pub const CYLINDER_BONDED: f64 = 1e-6;

/// Period of free vibration on the finest bar; lateral inertia of the free bar adds (nu' k b)^2 / 6 = 2e-5.
pub const BAR_PERIOD: f64 = 1e-4;

/// Speed of a front on the finest bar: the width of a step's front is a few cells of 128, and its delay is known to 1e-3.
pub const BAR_SPEED: f64 = 1e-3;

/// Stress behind a front: ringing of the face's nodes, averaged.
pub const BAR_STRESS: f64 = 1e-4;

/// Gent and Lindley's moduli are sums of two mechanisms, good to this at shape factors from 1 to 5...
pub const GENT_LINDLEY: f64 = 0.04;

/// ...and to this at 0.5, where the shear near the bonded edges is not parabolic.
pub const GENT_LINDLEY_SLENDER: f64 = 0.07;

/// Force under a face that sticks by friction against a bonded one: nodes stick where they are caught.
pub const STICKING: f64 = 1e-4;

/// Hertz's peak pressure: the body is forty contact half widths wide and deep, not infinite.
pub const HERTZ_PEAK: f64 = 0.015;

/// Force on a flat punch with sixteen cells under its radius: half a hundredth, of which rounded edges and the extent of the
/// block are a part.
pub const PUNCH: f64 = 5e-3;

/// Force on a ball, extrapolated over the mesh: the block is sixty contact half widths wide and deep, not infinite.
pub const BALL: f64 = 0.02;

/// Largest pressure under a bar: as [`HERTZ_PEAK`].
pub const BAR_PRESSURE: f64 = 0.01;

/// Radius of the contact of a flat punch.
pub const INDENTATION_WIDTH: f64 = 2e-3;

/// Stiffness of a stack against springs in series at a strain of 1e-4, the size of what is not linear.
pub const SERIES_SPRINGS: f64 = 3e-4;

/// Waves at a change of impedance, with 64 cells along each part: the start of the wave is sixteen cells long.
pub const IMPEDANCE: f64 = 2e-3;

/// Stopping distance of a slab on a layer: both vibrate.
pub const STOPPING_DISTANCE_ON_LAYER: f64 = 6e-3;

/// What a slab that friction holds still moves in the time that it slid, over the way that it slid.
pub const CREEP: f64 = 1e-5;

/// The deepest that a node may be inside another layer, over the element size: the requirement.
pub const LAYER_PENETRATION: f64 = 0.01;

/// Motion on rails against its closed form: the friction of a step works over all of it, also in the half step that the start
/// is behind.
pub const RAILS: f64 = 1e-4;

/// Stopping distance of a rigid block: the elastic one vibrates in shear while it slides.
pub const STOPPING_DISTANCE: f64 = 2e-3;

/// Displacement of Lame's problems with 32 cells through the wall.
pub const LAME_DISPLACEMENT: f64 = 2e-3;

/// Stress of Lame's problems with 32 cells through the wall, over the pressure.
pub const LAME_STRESS: f64 = 1e-3;

/// Least order of the stress of the sphere: on the axis the hoop stretch of a linear triangle is of first order, in a
/// part of the body that shrinks with the element size.
pub const LAME_SPHERE_STRESS_ORDER: f64 = 1.4;

/// Largest alternating part of the pressure with eight cells through the thickness.
pub const CHECKERBOARD: f64 = 0.05;

/// Zero eigenvalues over the largest: round-off of the difference quotients.
pub const ZERO_ENERGY: f64 = 1e-9;

/// Smallest eigenvalue of a real deformation of one cell over the largest: the ratio of the moduli, not less.
pub const SMALLEST_STIFFNESS: f64 = 1e-3;

/// Forces from the Cauchy stresses against those of the element, relative to the largest: the positions at the time of the
/// stresses come from those after the step less the velocity's share, which leaves round-off of a displacement in a
/// difference of neighbours.
pub const FIELD_FORCE: f64 = 1e-10;

/// The four numbers in single precision against double, and the closure of its energy ledger over the impact energy. Round-off
/// of 6e-8 in each of 5,000 steps grows with their square root at best, in proportion at worst.
pub const SINGLE_PRECISION: f64 = 1e-3;

/// Kinetic energy and work of gravity in free fall, over the energy at contact: round-off of up to twenty thousand sums.
pub const FREE_FALL_ENERGY: f64 = 1e-12;

/// A row's momentum against its impulse, over the momentum at the start: round-off of some thousand steps.
pub const ROW_MOMENTUM: f64 = 1e-11;

/// The way of a driven face against its closed form: round-off of a position over that of a step.
pub const PATH: f64 = 1e-9;

/// Peak force of a drop with the mass outside against that with the mass inside, by sampling intervals between exchanges: the
/// requirement.
pub const COUPLED_PEAK: [(u64, f64); 2] = [(1, 0.005), (4, 0.02)];

/// A branch's part of the peak force in single precision against double, whatever its time: as [`SINGLE_PRECISION`], of which
/// contact takes the most.
pub const SINGLE_BRANCH: f64 = 2e-3;

/// A bonded cylinder of foam against an independent solution: triangles of a sixteenth of the height, a point of the curve that
/// is up to a sample from the strain, and what is left of the motion.
pub const INDEPENDENT_FOAM: f64 = 1e-2;
