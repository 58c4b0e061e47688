//! The SI units of the variables, in base units, and the units that people read them in.

/// A unit that a variable can have.
pub struct Unit {
    /// Name, as in the kernel's tables.
    pub name: &'static str,
    /// Exponents of kg, m and s.
    pub base: [i32; 3],
    /// Unit for display and how many of it make one of this unit.
    pub display: Option<(&'static str, f64)>,
    /// Size of an ordinary value in this application, in this unit.
    pub nominal: f64,
}

/// The unit called `name`.
pub fn find(name: &str) -> Option<&'static Unit> {
    UNITS.iter().find(|unit| unit.name == name)
}

const fn unit(name: &'static str, base: [i32; 3], display: Option<(&'static str, f64)>, nominal: f64) -> Unit {
    Unit { name, base, display, nominal }
}

/// Every unit of the kernel's tables.
pub static UNITS: &[Unit] = &[
    unit("1", [0, 0, 0], None, 1.0),
    unit("kg", [1, 0, 0], None, 1.0),
    unit("kg/m3", [1, -3, 0], None, 1e3),
    unit("m", [0, 1, 0], Some(("mm", 1e3)), 1e-3),
    unit("m/s", [0, 1, -1], None, 1.0),
    unit("m/s2", [0, 1, -2], None, 1e3),
    unit("Hz", [0, 0, -1], None, 1e3),
    unit("1/s", [0, 0, -1], None, 1e3),
    unit("s", [0, 0, 1], Some(("ms", 1e3)), 1e-3),
    unit("N", [1, 1, -2], Some(("kN", 1e-3)), 1e3),
    unit("N.s", [1, 1, -1], None, 10.0),
    unit("N.s/m", [1, 0, -1], None, 10.0),
    unit("J", [1, 2, -2], None, 10.0),
    unit("Pa", [1, -1, -2], Some(("MPa", 1e-6)), 1e6),
];
