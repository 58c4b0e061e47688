//! Hertz's line contact: a flat rigid face on a round elastic solid, large against the contact.

use softanvil_kernel::contact::surface;
use softanvil_kernel::{StepInput, step};

use crate::body::{Body, Pressure};
use crate::row::Row;
use crate::scenes::{grid, neo_hookean};
use crate::statics::{Face, Supports, press};

const SHEAR_MODULUS: f64 = 1e6;
const POISSONS_RATIO: f64 = 0.3;
/// Radius of the solid's crest, half width and depth of what is meshed, m.
const RADIUS: f64 = 100e-3;
const EXTENT: f64 = 40e-3;
/// Travel of the face, m, for a contact half width of a fortieth of the extent.
const TRAVEL: f64 = 20e-6;
/// The mesh is graded by x = sinh(GRADING xi), finest at the contact.
const GRADING: f64 = 4.5;

/// Cells along the surface, twice those in depth, of the regular study.
pub const CELLS: [usize; 3] = [24, 48, 96];

/// What the kernel's contact shows against Hertz's solution for the same force.
#[derive(Clone, Copy, Debug)]
pub struct Contact {
    /// Half width over the reference.
    pub half_width: f64,
    /// Pressure at the crest over the reference.
    pub peak_pressure: f64,
    /// Root mean square difference of the pressures from the elliptic profile over its peak.
    pub profile: f64,
    /// Nodes in contact beside the one on the centre line.
    pub nodes: usize,
}

/// The contact on `n` by `n` / 2 cells.
pub fn contact(n: usize) -> Contact {
    let bulk = 2.0 * SHEAR_MODULUS * (1.0 + POISSONS_RATIO) / (3.0 * (1.0 - 2.0 * POISSONS_RATIO));
    let n_v = n / 2;
    let graded = |part: f64| EXTENT * (GRADING * part).sinh() / GRADING.sinh();
    let position = |u: usize, v: usize| {
        let (x, depth) = (graded(u as f64 / n as f64), graded((n_v - v) as f64 / n_v as f64));
        [x, EXTENT - depth - (1.0 - depth / EXTENT) * x * x / (2.0 * RADIUS)]
    };
    let mut body = Body::new(&grid(n, n_v, neo_hookean(SHEAR_MODULUS, bulk)), &position, Pressure::Patch);
    let mut supports = Supports::none(&body);
    for v in 0..=n_v {
        supports.prescribed[body.node(0, v)][0] = Some(0.0);
    }
    for u in 0..=n {
        supports.prescribed[body.node(u, 0)] = [Some(0.0); 2];
    }
    let equilibrium = press(&mut body, &supports, &Face { height: EXTENT - TRAVEL }, 4).pop().expect("an increment");
    let input = StepInput { driven_position: Some(-TRAVEL), ..StepInput::default() };
    body.at(&equilibrium.displacement, |model, state| {
        step(model, state, &input).expect("a step");
        let modulus = 2.0 * SHEAR_MODULUS / (1.0 - POISSONS_RATIO);
        let load = state.scalars.force.contact / model.constants.scenario.geometry.length;
        let half_width = (4.0 * load * RADIUS / (std::f64::consts::PI * modulus)).sqrt();
        let peak = 2.0 * load / (std::f64::consts::PI * half_width);
        let view = state.as_view();
        let pressure = |u: usize| surface::contact_pressure(model, &view, u).expect("a column");
        let x = |u: usize| surface::surface_position(model, &view, u).expect("a column")[0];
        let (mut sum, mut nodes) = (0.0, 0);
        while pressure(nodes) > 0.0 {
            let ellipse = (1.0 - (x(nodes) / half_width).powi(2)).max(0.0).sqrt();
            sum += (pressure(nodes) / peak - ellipse).powi(2);
            nodes += 1;
        }
        Contact {
            half_width: surface::contact_half_width(model, &view) / half_width,
            peak_pressure: pressure(0) / peak,
            profile: (sum / nodes as f64).sqrt(),
            nodes: nodes - 1,
        }
    })
}

/// Rows of the table over `cells` along the surface.
pub fn rows(cells: &[usize]) -> Vec<Row> {
    let all: Vec<Contact> = cells.iter().map(|n| contact(*n)).collect();
    let row = |quantity: &str, error: &dyn Fn(&Contact) -> f64| Row {
        problem: "hertz",
        quantity: quantity.into(),
        reference: "closed form for the half space".into(),
        meshes: all.iter().map(|contact| format!("{} cells in contact", contact.nodes)).collect(),
        errors: all.iter().map(error).collect(),
        order: None,
    };
    vec![
        row("half width", &|contact| contact.half_width - 1.0),
        row("peak pressure", &|contact| contact.peak_pressure - 1.0),
        row("pressure profile", &|contact| contact.profile),
    ]
}
