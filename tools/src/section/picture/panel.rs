//! One view of the section: layer, core and impactor, mirrored to the whole section.

use svg::node::element::{Group, Text};

use super::canvas::{INK, STEEL, closed, open};
use crate::section::animation::DISPLACEMENT;
use crate::section::contour::region;
use crate::section::{Frame, Levels, Mesh, SLAB};

/// Width and height of a panel, px.
pub const PANEL: [f64; 2] = [520.0, 268.0];
/// Height of its caption, px.
const CAPTION: f64 = 26.0;
/// Room beside what is drawn, in its widths.
const ROOM: f64 = 0.03;

/// A view that is ready to be placed.
pub struct Panel {
    group: Group,
}

/// From metres in the section to pixels.
struct View<'a> {
    mesh: &'a Mesh,
    frame: &'a Frame,
    scale: f64,
}

/// Height of the ground above the lower edge, px.
const GROUND: f64 = 2.0;

/// Pixels per metre at which the section fits, and the impactor on it stays below the caption.
fn scale(mesh: &Mesh) -> f64 {
    let across = PANEL[0] / (2.0 * mesh.reach() * (1.0 + 2.0 * ROOM));
    let upwards = (PANEL[1] - GROUND - CAPTION) / (mesh.constants.top_height + SLAB);
    across.min(upwards)
}

impl View<'_> {
    fn new<'a>(mesh: &'a Mesh, frame: &'a Frame) -> View<'a> {
        View { mesh, frame, scale: scale(mesh) }
    }

    fn pixel(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [0.5 * PANEL[0] + self.scale * x, PANEL[1] - GROUND - self.scale * y]
    }

    /// Current position of a node.
    fn now(&self, node: usize) -> [f64; 2] {
        let ([x, y], u) = (self.mesh.reference[node], self.frame.values(DISPLACEMENT));
        [x + u[2 * node], y + u[2 * node + 1]]
    }

    /// The same polygons, and their mirror images if the mesh is one half.
    fn whole(&self, polygons: Vec<Vec<[f64; 2]>>) -> Vec<Vec<[f64; 2]>> {
        let mirrored = if self.mesh.is_half() { polygons.clone() } else { Vec::new() };
        let mirrored = mirrored.into_iter().map(|polygon| polygon.into_iter().map(|[x, y]| [-x, y]).rev().collect());
        let all = polygons.into_iter().chain(mirrored);
        all.map(|polygon: Vec<_>| polygon.into_iter().map(|point| self.pixel(point)).collect()).collect()
    }

    fn core(&self) -> Group {
        let parts = self.whole(vec![self.mesh.core()]);
        Group::new().add(closed(parts.iter().map(Vec::as_slice)).set("fill", STEEL))
    }

    fn impactor(&self) -> Group {
        let impactor = &self.mesh.constants.scenario.impactor;
        let face = self.mesh.constants.top_height + self.frame.face();
        let corners: Vec<_> =
            self.mesh.impactor().into_iter().map(|[x, y]| self.pixel([impactor.offset + x, face + y])).collect();
        Group::new().add(closed([corners.as_slice()].into_iter()).set("fill", STEEL).set("stroke", INK))
    }

    /// Regions of each band, one over the other.
    fn bands(&self, values: &[f64], levels: &Levels) -> Group {
        let mut group = Group::new();
        for band in 0..levels.bands() {
            let level = if band == 0 { f64::NEG_INFINITY } else { levels.bounds[band] };
            let corners = |nodes: &[usize; 3]| nodes.map(|node| (self.now(node), values[node]));
            let regions = self.mesh.triangles.iter().map(|nodes| region(corners(nodes), level));
            let regions = self.whole(regions.filter(|polygon| polygon.len() > 2).collect());
            group = group.add(closed(regions.iter().map(Vec::as_slice)).set("fill", levels.colour(band)));
        }
        group
    }

    fn triangles(&self) -> Group {
        let triangles = self.mesh.triangles.iter().map(|nodes| nodes.map(|node| self.now(node)).to_vec());
        let triangles = self.whole(triangles.collect());
        let path = closed(triangles.iter().map(Vec::as_slice)).set("fill", "#cfe3f1").set("stroke", "#0072b2");
        Group::new().add(path.set("stroke-width", 0.8).set("stroke-linejoin", "round"))
    }

    fn edge(&self, at: impl Fn(usize) -> [f64; 2]) -> Group {
        let lines =
            self.whole(self.mesh.outlines().iter().map(|nodes| nodes.iter().map(|node| at(*node)).collect()).collect());
        lines.iter().fold(Group::new(), |group, line| group.add(open(line).set("stroke", INK).set("stroke-width", 1)))
    }
}

impl Panel {
    /// Contours of nodal `values`.
    pub fn contours(mesh: &Mesh, frame: &Frame, values: &[f64], levels: &Levels) -> Self {
        let view = View::new(mesh, frame);
        let group = Group::new().add(view.core()).add(view.bands(values, levels));
        Self { group: group.add(view.edge(|node| view.now(node))).add(view.impactor()) }
    }

    /// The mesh, with its outline at rest.
    pub fn mesh(mesh: &Mesh, frame: &Frame) -> Self {
        let view = View::new(mesh, frame);
        let rest = view.edge(|node| mesh.reference[node]).set("stroke-dasharray", "5 4");
        Self { group: Group::new().add(view.core()).add(view.triangles()).add(view.impactor()).add(rest) }
    }

    /// With this caption.
    pub fn titled(self, caption: String) -> Self {
        let text = Text::new(caption).set("x", 0).set("y", CAPTION - 8.0).set("font-size", 15);
        Self { group: self.group.add(text) }
    }

    /// The panel, its upper left corner at the origin.
    pub fn draw(self) -> Group {
        self.group
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use softanvil_kernel::scenario::Layer;
    use softanvil_kernel::{Simulation, preset};

    /// A stack on the anvil is higher than the layer that the panel was drawn for.
    #[test]
    fn the_impactor_stays_below_the_caption_on_any_stack() {
        for pad in [0.0, 10e-3, 40e-3] {
            let mut scenario = preset::study();
            if pad > 0.0 {
                let layer = Layer { thickness: pad, ..preset::spare_layer() };
                scenario.add_layer(layer).unwrap();
            }
            // Small, which makes the scale across large.
            scenario.impactor.face_diameter = 2.05 * (scenario.geometry.core_radius + scenario.thickness());
            let mesh = Mesh::of(&Simulation::new(&scenario).unwrap()).unwrap();
            let top = PANEL[1] - GROUND - scale(&mesh) * (mesh.constants.top_height + SLAB);
            assert!(top >= CAPTION - 1e-9, "{pad} m: the impactor ends {top} px below the edge");
        }
    }
}
