//! Virtual material tests: a cylinder between two plates, compressed at a constant rate of nominal strain and then held,
//! gives the curve of nominal stress that a laboratory would measure on a material.
//!
//! The kernel is explicit, and a test of a minute has many millions of its steps. What a slow test depends on is not its
//! time, though, but the ratio of its time to the times of the material: so the test is run in a short simulated time,
//! with every relaxation time of the material shortened in the same proportion ([`timescale`]). What remains is the
//! inertia of the shortened test. It is kept small by a travel of many periods of the specimen's slowest vibration,
//! [`Compression::periods`]; the error that this leaves is measured in the verification suite, and is seen by doubling
//! the number. A slider has no time of its own and needs no scaling.
//!
//! ```
//! use softanvil_specimen::{Compression, compress};
//!
//! let material = softanvil_kernel::preset::study().layers[0].material;
//! let curve = compress(&material, &Compression { strain: 0.1, ..Compression::study(0.67) })?;
//! let end = curve.last().unwrap();
//! println!("{:.3} at {:.0} Pa after {:.3} s", end.strain, end.stress, end.time);
//! assert!((end.strain - 0.1).abs() < 1e-4 && end.stress > 0.0);
//! # Ok::<(), softanvil_specimen::Error>(())
//! ```

mod rig;
pub mod timescale;

use softanvil_kernel::material::Material;
use softanvil_kernel::scenario::{DropBy, Formulation, Interface, Motion, Scenario, Section, Shape, StepBy};
use softanvil_kernel::{ModelError, SAMPLING_INTERVAL, StepError, preset};

use crate::rig::Rig;

/// Rates of nominal strain of the study's quasi-static tests, 1/s: 5, 50 and 500 mm/min on 12.5 mm.
pub const STUDY_RATES: [f64; 3] = [0.0067, 0.067, 0.67];

/// How the ends of the specimen are held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ends {
    /// They slide without friction: the strain is the same everywhere.
    Frictionless,
    /// They stick to the plates, and the specimen bulges.
    Bonded,
}

/// Compression of a cylinder along its axis, and what follows.
///
/// ```
/// use softanvil_kernel::preset;
/// use softanvil_specimen::{Compression, Ends, compress};
///
/// let test = Compression { strain: 0.05, ..Compression::study(0.67) };
/// let free = compress(&preset::elastic().layers[0].material, &test)?;
/// let bonded = compress(&preset::elastic().layers[0].material, &Compression { ends: Ends::Bonded, cells: 8, ..test })?;
/// // Ends that stick make the specimen bulge, which makes it stiffer.
/// assert!(bonded.last().unwrap().stress > 1.1 * free.last().unwrap().stress);
/// # Ok::<(), softanvil_specimen::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Compression {
    /// Diameter at rest, m.
    pub diameter: f64,
    /// Height at rest, m.
    pub height: f64,
    /// How the ends are held.
    pub ends: Ends,
    /// Rate of nominal strain, 1/s.
    pub strain_rate: f64,
    /// Nominal strain at the end, compression positive, below 1.
    pub strain: f64,
    /// Time for which the strain is then held, s; 0 ends the test at the end of the compression.
    pub hold: f64,
    /// Cells over the height. Frictionless ends need few, since the strain is the same everywhere, and a fine mesh can
    /// buckle at the free corner as the law itself would; bonded ones need eight or more.
    pub cells: u32,
    /// Periods of the slowest axial vibration of the specimen, with its long-term modulus, in the time of the travel.
    pub periods: f64,
}

impl Compression {
    /// The study's compression: 29 mm by 12.5 mm to 50 % at `strain_rate`, 1/s, between frictionless plates.
    pub fn study(strain_rate: f64) -> Self {
        Self {
            diameter: 29e-3,
            height: 12.5e-3,
            ends: Ends::Frictionless,
            strain_rate,
            strain: 0.5,
            hold: 0.0,
            cells: 4,
            periods: 40.0,
        }
    }

    /// The study's relaxation: the same at its highest rate, then held for `hold` s.
    pub fn study_relaxation(hold: f64) -> Self {
        Self { hold, ..Self::study(STUDY_RATES[2]) }
    }

    /// Area of an end at rest, m2.
    pub fn area(&self) -> f64 {
        0.25 * std::f64::consts::PI * self.diameter * self.diameter
    }

    /// Time of the travel, s, without the smooth start and stop.
    pub fn travel_time(&self) -> f64 {
        self.strain / self.strain_rate
    }

    fn check(&self) -> Result<(), Error> {
        let refuse = |name, value, legal| Err(Error::Test { name, value, legal });
        for (name, value) in [("diameter", self.diameter), ("height", self.height), ("strain_rate", self.strain_rate)] {
            let positive = value.is_finite() && value > 0.0;
            if !positive {
                return refuse(name, value, "a number above 0");
            }
        }
        let strain = self.strain > 0.0 && self.strain < 1.0;
        if !strain {
            return refuse("strain", self.strain, "above 0 and below 1");
        }
        let hold = self.hold.is_finite() && self.hold >= 0.0;
        if !hold {
            return refuse("hold", self.hold, "0 s or more");
        }
        let periods = self.periods >= 1.0 && self.periods <= 1e4;
        if !periods {
            return refuse("periods", self.periods, "1 to 10000");
        }
        match self.cells {
            1..=64 => Ok(()),
            cells => refuse("cells", f64::from(cells), "1 to 64"),
        }
    }
}

/// A point of the curve of a test.
///
/// ```
/// use softanvil_kernel::preset;
/// use softanvil_specimen::{Compression, Point, compress};
///
/// let silicone = preset::elastic().layers[0].material;
/// let curve = compress(&silicone, &Compression { strain: 0.05, ..Compression::study(0.67) })?;
/// let Point { time, strain, stress } = *curve.last().unwrap();
/// assert!((time / (0.05 / 0.67) - 1.0).abs() < 0.1 && (strain - 0.05).abs() < 1e-4);
/// // Of a small strain in a material that hardly changes its volume: E = 3 G.
/// assert!((stress / (3.0 * silicone.shear_modulus_inf() * strain) - 1.0).abs() < 0.1);
/// # Ok::<(), softanvil_specimen::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Time since the start, s, of the real test.
    pub time: f64,
    /// Nominal strain, compression positive.
    pub strain: f64,
    /// Nominal stress, Pa, compression positive: force over area at rest.
    pub stress: f64,
}

/// Why a test gave no curve.
///
/// ```
/// use softanvil_kernel::preset;
/// use softanvil_specimen::{Compression, compress};
///
/// let flat = Compression { strain: 1.0, ..Compression::study(0.67) };
/// let refused = compress(&preset::elastic().layers[0].material, &flat).unwrap_err();
/// assert_eq!(refused.to_string(), "strain = 1 is refused: expected above 0 and below 1");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum Error {
    /// A number of the test is not legal.
    #[error("{name} = {value} is refused: expected {legal}")]
    Test {
        /// The number.
        name: &'static str,
        /// Its value.
        value: f64,
        /// What is legal.
        legal: &'static str,
    },
    /// The material or the mesh is refused.
    #[error("{0}")]
    Model(#[from] ModelError),
    /// A step failed.
    #[error("the simulation failed: {0}")]
    Step(#[from] StepError),
}

/// Compresses a cylinder of `material`; returns the curve, a point for every force sample of the kernel.
///
/// # Errors
/// A test or material that is refused, or a step that fails: more strain than the material bears.
pub fn compress(material: &Material, test: &Compression) -> Result<Vec<Point>, Error> {
    test.check()?;
    let travel = simulated_travel(material, test);
    let scenario = scenario(material, test, travel);
    let mut rig = Rig::new(&scenario)?;
    let mut curve = Vec::new();
    // Simulated seconds of a real second.
    let scale = travel / test.travel_time();
    let mut record = Recorder { test, curve: &mut curve, time: 0.0, scale };
    rig.run(&timescale::scaled(&scenario, scale), (1.0 + RISE) * travel, &mut record)?;
    // Slower and slower: the stress changes on the scale of the time since the compression.
    let end = record.time + test.hold;
    let mut real = test.travel_time() / PARTS;
    while record.time < end {
        let simulated = travel / PARTS;
        record.scale = simulated / real;
        rig.run(&timescale::scaled(&scenario, record.scale), simulated, &mut record)?;
        real *= GROWTH;
    }
    curve.retain(|point| point.time <= end * (1.0 + f64::EPSILON));
    Ok(curve)
}

/// Part of the travel's time in which the speed rises at the start, and falls at the end.
const RISE: f64 = 0.05;

/// Parts of the travel's simulated time that one part of the hold takes.
const PARTS: f64 = 4.0;

/// Real time of a part of the hold over that of the part before.
const GROWTH: f64 = 1.5;

/// Fewest force samples of the travel.
const SAMPLES: f64 = 200.0;

/// Simulated time of the travel, s.
fn simulated_travel(material: &Material, test: &Compression) -> f64 {
    let wave_speed = (3.0 * material.shear_modulus_inf() / material.density).sqrt();
    let period = 4.0 * test.height / wave_speed;
    (test.periods * period).max(SAMPLES * SAMPLING_INTERVAL)
}

/// The kernel's scenario of a test whose travel takes `travel` s.
fn scenario(material: &Material, test: &Compression, travel: f64) -> Scenario {
    let mut scenario = preset::study();
    let geometry = &mut scenario.geometry;
    (geometry.shape, geometry.formulation) = (Shape::Block, Formulation::Axisymmetric);
    geometry.section = Section::Half;
    geometry.block_width = test.diameter;
    let impactor = &mut scenario.impactor;
    (impactor.motion, impactor.drop_by) = (Motion::Prescribed, DropBy::Speed);
    (impactor.gap, impactor.drop_speed) = (0.0, 0.0);
    // Wider than any bulge.
    impactor.face_diameter = 10.0 * test.diameter;
    impactor.prescribed_depth = test.strain * test.height;
    impactor.prescribed_speed = impactor.prescribed_depth / travel;
    impactor.prescribed_rise = RISE * travel;
    let (core, friction) = match test.ends {
        Ends::Frictionless => (Interface::Sliding, 0.0),
        // The largest legal coefficient: nothing slides.
        Ends::Bonded => (Interface::Bonded, 10.0),
    };
    (scenario.core.interface, scenario.face.friction_coefficient) = (core, friction);
    scenario.mesh.element_size = test.height / f64::from(test.cells);
    scenario.time.step_by = StepBy::SafetyFactor;
    let specimen = &mut scenario.layers[0];
    (specimen.thickness, specimen.material) = (test.height, *material);
    scenario
}

/// Turns force samples into points of the curve.
struct Recorder<'a> {
    test: &'a Compression,
    curve: &'a mut Vec<Point>,
    /// Real time of the last sample's end, s.
    time: f64,
    /// Simulated seconds of a real second.
    scale: f64,
}

impl Recorder<'_> {
    /// Takes the mean force over a sampling interval, N, with the depths of the face at its start and end, m.
    fn take(&mut self, force: f64, depth: [f64; 2]) {
        let interval = SAMPLING_INTERVAL / self.scale;
        // A mean belongs to the middle.
        let strain = 0.5 * (depth[0] + depth[1]) / self.test.height;
        self.curve.push(Point { time: self.time + 0.5 * interval, strain, stress: force / self.test.area() });
        self.time += interval;
    }
}
