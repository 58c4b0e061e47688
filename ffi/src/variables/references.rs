//! Value references: fixed numbers, so that a system model that names them survives a new version of the FMU.
//!
//! | range        | variables                                     |
//! |--------------|-----------------------------------------------|
//! | 0            | time                                          |
//! | 1000 to 1999 | parameters                                    |
//! | 2000 to 2999 | inputs                                        |
//! | 3000 to 3999 | scalar outputs                                |
//! | 4000 to 4999 | calculated parameters                         |
//! | 5000 to 5999 | outputs that are no quantity (states, texts)  |
//! | 6000 to 6999 | arrays                                        |
//!
//! Within a range a group of names starts at a multiple of 100. A number is never given away twice: what leaves the
//! kernel's tables leaves a gap here.

/// Numbers that a group has.
pub const GROUP: u32 = 100;

/// The independent variable.
pub const TIME: u32 = 0;

/// Inputs.
pub const EXTERNAL_FORCE: u32 = 2000;
/// Height of a driven impactor.
pub const DRIVEN_POSITION: u32 = 2001;
/// Velocity of a driven impactor.
pub const DRIVEN_VELOCITY: u32 = 2002;

/// The kernel's time.
pub const KERNEL_TIME: u32 = 3500;

/// The kernel's time step.
pub const TIME_STEP: u32 = 4000;
/// Number of elements of the mesh.
pub const ELEMENTS: u32 = 4001;
/// Number of nodes along the surface.
pub const SURFACE_NODES: u32 = 4002;

/// Whether the impactor touches the layer.
pub const CONTACT_ACTIVE: u32 = 5000;
/// Digest of the force samples.
pub const TRACE_HASH: u32 = 5001;

/// Number of points of the profiles.
pub const SURFACE_POINTS: u32 = 1900;
/// Distance of the surface from the centre line.
pub const SURFACE_X: u32 = 6000;
/// Height of the surface.
pub const SURFACE_HEIGHT: u32 = 6001;
/// Contact pressure along the surface.
pub const SURFACE_CONTACT_PRESSURE: u32 = 6002;

/// Reference of every row of the kernel's table of parameters.
pub static PARAMETERS: &[(&str, u32)] = &[
    ("geometry.shape", 1000),
    ("geometry.formulation", 1001),
    ("geometry.core_radius", 1002),
    ("geometry.silicone_thickness", 1003),
    ("geometry.skin_thickness", 1004),
    ("geometry.length", 1005),
    ("geometry.block_width", 1006),
    ("geometry.layers", 1007),
    ("geometry.section", 1008),
    ("impactor.motion", 1100),
    ("impactor.mass", 1101),
    ("impactor.face_diameter", 1102),
    ("impactor.gap", 1103),
    ("impactor.gravity", 1104),
    ("impactor.drop_by", 1105),
    ("impactor.drop_height", 1106),
    ("impactor.drop_energy", 1107),
    ("impactor.drop_speed", 1108),
    ("impactor.offset", 1109),
    ("impactor.prescribed_speed", 1110),
    ("impactor.prescribed_depth", 1111),
    ("impactor.prescribed_rise", 1112),
    ("silicone.density", 1200),
    ("silicone.moduli", 1201),
    ("silicone.c10", 1202),
    ("silicone.c01", 1203),
    ("silicone.c11", 1204),
    ("silicone.c20", 1205),
    ("silicone.c02", 1206),
    ("silicone.volumetric_by", 1207),
    ("silicone.bulk_modulus", 1208),
    ("silicone.poissons_ratio", 1209),
    ("silicone.prony_g_1", 1210),
    ("silicone.prony_tau_1", 1211),
    ("silicone.prony_g_2", 1212),
    ("silicone.prony_tau_2", 1213),
    ("silicone.prony_g_3", 1214),
    ("silicone.prony_tau_3", 1215),
    ("silicone.prony_g_4", 1216),
    ("silicone.prony_tau_4", 1217),
    ("silicone.prony_g_5", 1218),
    ("silicone.prony_tau_5", 1219),
    ("silicone.slider_stiffness", 1220),
    ("silicone.slider_yield_stress", 1221),
    ("silicone.law", 1222),
    ("silicone.c30", 1223),
    ("silicone.ogden_mu_1", 1224),
    ("silicone.ogden_alpha_1", 1225),
    ("silicone.ogden_mu_2", 1226),
    ("silicone.ogden_alpha_2", 1227),
    ("silicone.ogden_mu_3", 1228),
    ("silicone.ogden_alpha_3", 1229),
    ("silicone.volumetric_law", 1230),
    ("silicone.maxwell_g_1", 1231),
    ("silicone.maxwell_beta_1", 1232),
    ("silicone.maxwell_g_2", 1233),
    ("silicone.maxwell_beta_2", 1234),
    ("silicone.maxwell_g_3", 1235),
    ("silicone.maxwell_beta_3", 1236),
    ("silicone.maxwell_g_4", 1237),
    ("silicone.maxwell_beta_4", 1238),
    ("silicone.maxwell_g_5", 1239),
    ("silicone.maxwell_beta_5", 1240),
    ("silicone.tear_stretch", 1241),
    ("silicone.tear_width", 1242),
    ("silicone.tear_residual", 1243),
    ("silicone.gent_mu", 1244),
    ("silicone.gent_jm", 1245),
    ("silicone.arruda_boyce_mu", 1246),
    ("silicone.arruda_boyce_lambda_m", 1247),
    ("core.interface", 1300),
    ("core.friction_coefficient", 1301),
    ("face.friction_coefficient", 1400),
    ("mesh.element_size", 1500),
    ("time.step_by", 1600),
    ("time.safety_factor", 1601),
    ("time.step", 1602),
    ("time.duration", 1603),
    ("time.design_compression", 1604),
    ("measurement.force_threshold", 1700),
    ("measurement.channel_class", 1701),
    ("skin.density", 1800),
    ("skin.law", 1801),
    ("skin.moduli", 1802),
    ("skin.c10", 1803),
    ("skin.c01", 1804),
    ("skin.c11", 1805),
    ("skin.c20", 1806),
    ("skin.c02", 1807),
    ("skin.c30", 1808),
    ("skin.ogden_mu_1", 1809),
    ("skin.ogden_alpha_1", 1810),
    ("skin.ogden_mu_2", 1811),
    ("skin.ogden_alpha_2", 1812),
    ("skin.ogden_mu_3", 1813),
    ("skin.ogden_alpha_3", 1814),
    ("skin.volumetric_law", 1815),
    ("skin.volumetric_by", 1816),
    ("skin.bulk_modulus", 1817),
    ("skin.poissons_ratio", 1818),
    ("skin.prony_g_1", 1819),
    ("skin.prony_tau_1", 1820),
    ("skin.prony_g_2", 1821),
    ("skin.prony_tau_2", 1822),
    ("skin.prony_g_3", 1823),
    ("skin.prony_tau_3", 1824),
    ("skin.prony_g_4", 1825),
    ("skin.prony_tau_4", 1826),
    ("skin.prony_g_5", 1827),
    ("skin.prony_tau_5", 1828),
    ("skin.maxwell_g_1", 1829),
    ("skin.maxwell_beta_1", 1830),
    ("skin.maxwell_g_2", 1831),
    ("skin.maxwell_beta_2", 1832),
    ("skin.maxwell_g_3", 1833),
    ("skin.maxwell_beta_3", 1834),
    ("skin.maxwell_g_4", 1835),
    ("skin.maxwell_beta_4", 1836),
    ("skin.maxwell_g_5", 1837),
    ("skin.maxwell_beta_5", 1838),
    ("skin.slider_stiffness", 1839),
    ("skin.slider_yield_stress", 1840),
    ("skin.tear_stretch", 1841),
    ("skin.tear_width", 1842),
    ("skin.tear_residual", 1843),
    ("skin.gent_mu", 1844),
    ("skin.gent_jm", 1845),
    ("skin.arruda_boyce_mu", 1846),
    ("skin.arruda_boyce_lambda_m", 1847),
];

/// Reference of every row of the kernel's table of outputs.
pub static OUTPUTS: &[(&str, u32)] = &[
    ("contact.force", 3000),
    ("contact.force_step", 3001),
    ("contact.half_width", 3002),
    ("contact.force_filtered", 3003),
    ("core.reaction", 3100),
    ("impactor.position", 3200),
    ("impactor.velocity", 3201),
    ("impactor.acceleration", 3202),
    ("impactor.deformation", 3203),
    ("result.peak_force", 3300),
    ("result.max_deformation", 3301),
    ("result.impact_duration", 3302),
    ("result.impulse", 3303),
    ("result.impact_speed", 3304),
    ("result.rebound_speed", 3305),
    ("result.restitution", 3306),
    ("result.contact_time", 3307),
    ("result.complete", 3308),
    ("energy.impactor_kinetic", 3400),
    ("energy.layer_kinetic", 3401),
    ("energy.elastic", 3402),
    ("energy.viscous", 3403),
    ("energy.slider_stored", 3404),
    ("energy.slider_dissipation", 3405),
    ("energy.friction", 3406),
    ("energy.contact", 3407),
    ("energy.external", 3408),
    ("energy.residual", 3409),
    ("energy.tear", 3411),
    ("model.design_stretch", 3501),
];

/// The number that `list` has for `name`.
pub(super) fn reference_of(list: &[(&str, u32)], name: &str) -> Option<u32> {
    list.iter().find(|(listed, _)| *listed == name).map(|(_, reference)| *reference)
}
