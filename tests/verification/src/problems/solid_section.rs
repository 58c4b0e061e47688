//! Solids that a section describes: a slice between held ends, a dome, a disc, and loose pads on them; pressed by a face without friction, quasi-static.

use softanvil_kernel::scenario::{Body, Ends, Formulation, Interface, Layer, LayerInterface, Motion, Shape};
use softanvil_kernel::{Scenario, Simulation, preset};

use crate::memo::Memo;
use crate::relaxation::press_slowly;
use crate::row::Row;
use crate::scenes::elastic;

/// A body that both formulations have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Twin {
    /// A round layer between held ends, in plane strain.
    Slice,
    /// Half a ball on half a ball, axisymmetric.
    Dome,
    /// A flat cylinder, axisymmetric.
    Disc,
    /// The slice with a pad on it that covers a part and may slide and lift.
    PaddedSlice,
    /// The dome with such a pad.
    PaddedDome,
}

impl Twin {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Slice, Self::Dome, Self::Disc, Self::PaddedSlice, Self::PaddedDome];

    /// Poisson's ratios that are tried.
    pub fn poissons_ratios(self) -> &'static [f64] {
        match self {
            Self::Disc => &[0.3, 0.48, 0.49],
            Self::Slice | Self::Dome => &[0.3, 0.48],
            Self::PaddedSlice | Self::PaddedDome => &[0.45],
        }
    }

    /// Side of an element, m.
    fn size(self) -> f64 {
        if self.is_dome() { 4e-3 } else { 2.5e-3 }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Slice => "slice",
            Self::Dome => "dome",
            Self::Disc => "disc",
            Self::PaddedSlice => "slice with a loose pad",
            Self::PaddedDome => "dome with a loose pad",
        }
    }

    fn is_dome(self) -> bool {
        matches!(self, Self::Dome | Self::PaddedDome)
    }

    fn is_slice(self) -> bool {
        matches!(self, Self::Slice | Self::PaddedSlice)
    }

    /// Its section.
    fn section(self, poissons_ratio: f64) -> Scenario {
        let mut scenario = anvil(poissons_ratio, self.size());
        if !self.is_slice() {
            scenario.geometry.formulation = Formulation::Axisymmetric;
        }
        if matches!(self, Self::PaddedSlice | Self::PaddedDome) {
            let material = scenario.layers[0].material;
            let interface = LayerInterface::Frictional;
            let pad = Layer { interface, friction_coefficient: 0.3, width: 60e-3, ..Layer::new("pad", 8e-3, material) };
            scenario.add_layer(pad).expect("room for a pad");
        }
        if self == Self::Disc {
            (scenario.geometry.shape, scenario.geometry.block_width) = (Shape::Block, 40e-3);
        }
        scenario
    }

    /// Its solid, and how much of the section's force it bears.
    fn solid(self, section: &Scenario) -> (Scenario, f64) {
        let mut solid = section.clone();
        solid.geometry.formulation = Formulation::Solid;
        if !self.is_slice() {
            solid.geometry.body = Body::Revolved;
            return (solid, 1.0);
        }
        (solid.geometry.ends, solid.geometry.length) = (Ends::Held, 5e-3);
        let part = solid.geometry.length / section.geometry.length;
        (solid, part)
    }
}

/// A bonded anvil of a plain rubber under a large smooth face.
fn anvil(poissons_ratio: f64, element_size: f64) -> Scenario {
    let bulk_modulus = 0.6e6 * (1.0 + poissons_ratio) / (3.0 * (1.0 - 2.0 * poissons_ratio));
    let mut scenario = preset::study();
    scenario.layers[0].material = elastic(0.15e6, 0.0, bulk_modulus);
    (scenario.core.interface, scenario.face.friction_coefficient) = (Interface::Bonded, 0.0);
    (scenario.impactor.motion, scenario.impactor.gap, scenario.impactor.face_diameter) = (Motion::Driven, 0.0, 0.5);
    (scenario.geometry.length, scenario.mesh.element_size) = (15e-3, element_size);
    scenario
}

/// Force at 3 mm of depth, N.
fn force(scenario: &Scenario) -> f64 {
    press_slowly(&mut Simulation::new(scenario).expect("a legal anvil"), 3e-3, 20e-3, 4e-3)
}

/// By how much the force on the solid differs from that on the section, relative.
pub fn error(twin: Twin, poissons_ratio: f64) -> f64 {
    static KNOWN: Memo<(Twin, u64), f64> = Memo::new();
    KNOWN.get((twin, poissons_ratio.to_bits()), || {
        let section = twin.section(poissons_ratio);
        let (solid, part) = twin.solid(&section);
        force(&solid) / (part * force(&section)) - 1.0
    })
}

/// Rows of the table.
pub fn rows() -> Vec<Row> {
    let row = |twin: Twin, nu: f64| Row {
        problem: "solid_section",
        quantity: format!("force to 3 mm, {}, nu = {nu}", twin.name()),
        reference: "the section, same mesh".into(),
        meshes: vec![format!("{} mm", 1e3 * twin.size())],
        errors: vec![error(twin, nu)],
        order: None,
    };
    let rows_of = |twin: Twin| twin.poissons_ratios().iter().map(move |nu| row(twin, *nu));
    Twin::ALL.into_iter().flat_map(rows_of).collect()
}
