//! A run as a series for ParaView: a VTU file of the section and one of the impactor's face for each time, and a PVD file
//! that lists them. Everything is in SI, the points at their current positions.

use std::fs;
use std::path::{Path, PathBuf};

use quick_xml::Writer;
use quick_xml::events::{BytesDecl, BytesText, Event};
use softanvil_kernel::{Field, ModelError, Simulation, result};
use tempfile::TempDir;

use super::solid_grid::solid_grid;
use super::vtk_fields::{all_fields, in_space, short};
use super::vtu::{Array, Cell, Grid};
use super::{Frame, Mesh, SLAB};
use crate::failure::Failure;
use crate::files::own_folder::{Kind, Listed, OwnFolder};
use crate::files::staging;

/// The file that lists the others, and by which a series is known.
const COLLECTION: &str = "impact.pvd";

/// A folder with a series.
pub const KIND: Kind = Kind { option: "--vtu", what: "a series for ParaView", listed_files };

/// A series that is being written.
pub struct Series {
    place: OwnFolder,
    staged: TempDir,
    /// Samples from one frame to the next.
    stride: usize,
    samples: usize,
    mesh: Option<Mesh>,
    times: Vec<f64>,
}

impl Series {
    /// A series at `place` with a frame every `stride` samples.
    ///
    /// # Errors
    /// A folder that cannot be written.
    pub fn new(place: OwnFolder, stride: usize) -> Result<Self, Failure> {
        let staged = staging::stage_folder(place.path()).map_err(|error| Failure::writing(place.path(), error))?;
        Ok(Self { place, staged, stride, samples: 0, mesh: None, times: Vec::new() })
    }

    /// Takes the present of `simulation`, at its start or after a sample.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn take(&mut self, simulation: &mut Simulation) -> Result<(), Failure> {
        let due = self.samples.is_multiple_of(self.stride);
        self.samples += 1;
        if due {
            self.write(simulation).map_err(|error| Failure::writing(self.place.path(), error))?;
        }
        Ok(())
    }

    fn write(&mut self, simulation: &mut Simulation) -> Result<(), SeriesError> {
        let solid = simulation.constants().grid.is_solid();
        let frame = if solid { Frame::whole(simulation, &all_fields())? } else { Frame::take(simulation, &fields())? };
        let mesh = match &mut self.mesh {
            Some(mesh) => mesh,
            none => none.insert(Mesh::of(simulation)?),
        };
        for (name, text) in names(self.times.len()).iter().zip(files(mesh, &frame)?) {
            fs::write(self.staged.path().join(name), text)?;
        }
        self.times.push(frame.time);
        Ok(())
    }

    /// Puts the series in place, complete; returns its first file and the number of frames.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn finish(self) -> Result<(PathBuf, usize), Failure> {
        let failed = |error: SeriesError| Failure::writing(self.place.path(), error);
        let text = collection(&self.times).map_err(failed)?;
        let put = |text: &[u8]| fs::write(self.staged.path().join(COLLECTION), text);
        put(&text).map_err(|error| failed(error.into()))?;
        staging::replace_folder(self.staged, self.place.path())
            .map_err(|error| Failure::writing(self.place.path(), error))?;
        Ok((self.place.path().join(COLLECTION), self.times.len()))
    }
}

/// Why a file could not be made.
#[derive(Debug, thiserror::Error)]
pub enum SeriesError {
    /// XML, or the file system.
    #[error("{0}")]
    Io(#[from] std::io::Error),
    /// The simulation's memory.
    #[error("{0}")]
    Model(#[from] ModelError),
}

/// The fields of a series: every one of the kernel, but for the position, which the points have, and those along z.
fn fields() -> Vec<&'static Field> {
    all_fields().into_iter().filter(|field| !field.name.ends_with("_z")).collect()
}

/// Names of the two files of the frame with this number.
fn names(number: usize) -> [String; 2] {
    ["section", "impactor"].map(|part| format!("{part}-{number:05}.vtu"))
}

/// The files of one frame, which holds [`fields`].
///
/// # Errors
/// What the XML library refuses.
fn files(mesh: &Mesh, frame: &Frame) -> Result<[Vec<u8>; 2], SeriesError> {
    let body = if mesh.constants.grid.is_solid() { solid_grid(mesh, frame) } else { section(mesh, frame) };
    Ok([body.file()?, impactor(mesh, frame).file()?])
}

/// The PVD file of frames at these times, s.
///
/// # Errors
/// What the XML library refuses.
fn collection(times: &[f64]) -> Result<Vec<u8>, SeriesError> {
    let mut xml = Writer::new_with_indent(Vec::new(), b' ', 2);
    xml.write_event(Event::Decl(BytesDecl::new("1.0", None, None)))?;
    let attributes = [("type", "Collection"), ("version", "0.1"), ("byte_order", "LittleEndian")];
    xml.create_element("VTKFile").with_attributes(attributes).write_inner_content(|xml| {
        xml.write_event(Event::Comment(BytesText::new(" Softanvil. SI: m, s, N, Pa; part 0 section, 1 impactor. ")))?;
        xml.create_element("Collection").write_inner_content(|xml| {
            for (number, time) in times.iter().enumerate() {
                for (part, name) in names(number).iter().enumerate() {
                    let attributes =
                        [("timestep", time.to_string()), ("part", part.to_string()), ("file", name.into())];
                    let attributes = attributes.each_ref().map(|(key, value)| (*key, value.as_str()));
                    xml.create_element("DataSet").with_attributes(attributes).write_empty()?;
                }
            }
            Ok(())
        })?;
        Ok(())
    })?;
    let mut text = xml.into_inner();
    text.push(b'\n');
    Ok(text)
}

/// The files of the series in `folder`; none if it is not ours.
fn listed_files(folder: &Path) -> Vec<Listed> {
    let collection = fs::read_to_string(folder.join(COLLECTION)).unwrap_or_default();
    let names = collection.split(" file=\"").skip(1).filter_map(|rest| rest.split('"').next());
    if collection.contains("<!-- Softanvil.") {
        names.chain([COLLECTION]).map(|name| Listed { name: name.into(), digest: None }).collect()
    } else {
        Vec::new()
    }
}

/// The section, and of a series of fields those of it.
fn section(mesh: &Mesh, frame: &Frame) -> Grid {
    let displacement = frame.values("node.displacement").chunks_exact(2);
    let points = mesh.reference.iter().zip(displacement).flat_map(|(rest, u)| [rest[0] + u[0], rest[1] + u[1], 0.0]);
    let (mut point_data, mut cell_data) = (Vec::new(), Vec::new());
    for field in fields() {
        let (mut values, components) = in_space(field, frame.values(field.name));
        match field.location {
            // Inside the layers there is no contact.
            result::Location::Surface => values = on_surface(mesh, &values, components),
            result::Location::Element => values = mesh.of_triangles(&values, components),
            result::Location::Node => {}
        }
        let data = if field.location == result::Location::Element { &mut cell_data } else { &mut point_data };
        data.push(Array { name: short(field), components, values });
    }
    Grid {
        points: points.collect(),
        kind: Cell::Triangle,
        cells: mesh.triangles.iter().map(|triangle| triangle.to_vec()).collect(),
        point_data,
        cell_data,
    }
}

/// Values of the surface, and zeros everywhere else.
fn on_surface(mesh: &Mesh, values: &[f64], components: usize) -> Vec<f64> {
    let mut all = vec![0.0; mesh.reference.len() * components];
    for (column, value) in values.chunks_exact(components).enumerate() {
        let start = mesh.surface(column) * components;
        all[start..start + components].copy_from_slice(value);
    }
    all
}

/// The face as a line of pieces, each with the force on all of it.
fn impactor(mesh: &Mesh, frame: &Frame) -> Grid {
    let (offset, height) = (mesh.constants.scenario.impactor.offset, mesh.constants.top_height + frame.face());
    let mut face = mesh.impactor();
    // Without its upper side, and of a half what is to the right.
    face.retain(|[_, y]| *y < SLAB || mesh.constants.outline.radius >= SLAB);
    if mesh.is_half() {
        face.retain(|[x, _]| *x > 0.0);
        face.insert(0, [0.0, 0.0]);
    }
    let pieces = face.len().saturating_sub(1);
    let motion = [
        ("contact_force", frame.scalars.sampler.last.contact_force),
        ("velocity", frame.scalars.impactor.velocity),
        ("position", frame.face()),
    ];
    Grid {
        points: face.iter().flat_map(|[x, y]| [offset + x, height + y, 0.0]).collect(),
        kind: Cell::Line,
        cells: (0..pieces).map(|piece| vec![piece, piece + 1]).collect(),
        point_data: Vec::new(),
        cell_data: motion.map(|(name, value)| Array { name, components: 1, values: vec![value; pieces] }).into(),
    }
}
