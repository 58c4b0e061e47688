//! All frames of one run.

use softanvil_kernel::{Field, ModelError, SAMPLING_INTERVAL, Simulation};

use super::{Frame, Mesh, nodal_means};

/// Field of the displacements.
pub const DISPLACEMENT: &str = "node.displacement";

/// A quantity that is shown in colours.
#[derive(Debug)]
pub struct Shade {
    /// Field of the triangles.
    pub field: &'static str,
    /// Name for people.
    pub label: &'static str,
    /// Name for files.
    pub key: &'static str,
}

/// The stresses that are shown.
pub static SHADES: [Shade; 2] = [
    Shade { field: "element.von_mises_stress", label: "von Mises stress", key: "von-mises" },
    Shade { field: "element.pressure", label: "pressure", key: "pressure" },
];

/// Frames of a run at every sample.
#[derive(Debug, Default)]
pub struct Animation {
    mesh: Option<Mesh>,
    frames: Vec<Frame>,
}

/// A time worth looking at.
#[derive(Clone, Debug)]
pub struct Instant {
    /// What it is.
    pub label: String,
    /// Number of its frame.
    pub frame: usize,
}

/// Time after the contact of the first instant, s.
const EARLY: f64 = 0.5e-3;
/// Part of the peak force at the last instant.
const FAINT: f64 = 0.1;

impl Animation {
    /// Takes the present of `simulation`.
    ///
    /// # Errors
    /// Never in practice, as [`Simulation::with`].
    pub fn take(&mut self, simulation: &mut Simulation) -> Result<(), ModelError> {
        let names = SHADES.iter().map(|shade| shade.field).chain([DISPLACEMENT]);
        let fields: Vec<&'static Field> = names.filter_map(Field::find).collect();
        if self.mesh.is_none() {
            self.mesh = Some(Mesh::of(simulation)?);
        }
        self.frames.push(Frame::take(simulation, &fields)?);
        Ok(())
    }

    /// The mesh; none before the first frame.
    pub fn mesh(&self) -> Option<&Mesh> {
        self.mesh.as_ref()
    }

    /// The frames.
    pub fn frames(&self) -> &[Frame] {
        &self.frames
    }

    /// Nodal values of `shade` at a frame, Pa.
    pub fn shaded(&self, frame: &Frame, shade: &Shade) -> Vec<f64> {
        self.mesh
            .as_ref()
            .map(|mesh| nodal_means(mesh, &mesh.of_triangles(frame.values(shade.field), 1)))
            .unwrap_or_default()
    }

    /// Smallest and largest nodal value of `shade`, Pa.
    pub fn range(&self, shade: &Shade) -> [f64; 2] {
        let values = self.frames.iter().flat_map(|frame| self.shaded(frame, shade));
        values.fold([0.0, 0.0], |[low, high], value| [f64::min(low, value), f64::max(high, value)])
    }

    /// Number of the last frame before contact.
    pub fn contact(&self) -> usize {
        let touching = |frame: &Frame| frame.scalars.sampler.last.contact_force > 0.0;
        self.frames.iter().position(touching).unwrap_or(0).saturating_sub(1)
    }

    /// Time of `frame` since contact, s. Forces are drawn at the middle of their interval, the first one just before contact.
    pub fn since_contact(&self, frame: &Frame) -> f64 {
        let contact = self.frames.get(self.contact()).map_or(0.0, |frame| frame.time);
        frame.time - contact + 0.5 * SAMPLING_INTERVAL
    }

    /// Times worth looking at, in their order.
    pub fn instants(&self) -> Vec<Instant> {
        let depth = |frame: &Frame| frame.scalars.impactor.deformation();
        let largest = |value: &dyn Fn(&Frame) -> f64| {
            let numbered = self.frames.iter().enumerate();
            numbered.max_by(|a, b| value(a.1).total_cmp(&value(b.1))).map_or(0, |(number, _)| number)
        };
        let start = self.frames.get(self.contact()).map_or(0.0, |frame| frame.time);
        let early = self.frames.iter().position(|frame| frame.time >= start + EARLY).unwrap_or(0);
        let deepest = largest(&depth);
        let force = |frame: &Frame| frame.scalars.sampler.last.contact_force;
        let hardest = largest(&force);
        let faint = FAINT * self.frames.get(hardest).map_or(0.0, force);
        let released = self.frames.iter().skip(deepest).position(|frame| force(frame) <= faint);
        let mut instants = vec![
            (early, format!("{} ms after contact", EARLY * 1e3)),
            (hardest, "peak force".into()),
            (deepest, "maximum compression".into()),
        ];
        instants.extend(released.map(|after| (deepest + after, "force down to a tenth".into())));
        instants.sort_by_key(|(frame, _)| *frame);
        instants.into_iter().map(|(frame, label)| Instant { label, frame }).collect()
    }

    /// The frame of largest deformation; none if there is none.
    pub fn deepest(&self) -> Option<&Frame> {
        self.frames.iter().max_by(|a, b| a.scalars.impactor.deformation().total_cmp(&b.scalars.impactor.deformation()))
    }
}
