//! [`FIELDS`]: the single table of what a simulation tells about every node, surface node and triangle.

use crate::contact::surface;
use crate::mesh::TETRAHEDRA;
use crate::model::Model;
use crate::number::real::Real;
use crate::result::solid_stress::SolidStress;
use crate::result::stress::{Stress, cauchy_stress, principal_stretch};
use crate::state::StateView;

/// Where the values of a field live.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Location {
    /// At the nodes: rows from the core to the surface, columns from the first edge of the section to the last. Of a solid, a row
    /// for each slice of a row of nodes, slice by slice.
    Node,
    /// At the nodes of the surface: one row, or one for each slice of a solid.
    Surface,
    /// In the triangles: rows from the core to the surface, two columns per cell. In the tetrahedra of a solid: a row for each slice
    /// of a row of cells, six columns per cell.
    Element,
}

/// Numbers of one component of a field that lie in memory: the one at (row, column) is `data[row * row_stride + column]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strided<'a> {
    /// The numbers, with padding between rows.
    pub data: &'a [Real],
    /// Numbers from one row to the next.
    pub row_stride: usize,
}

/// Where the numbers of a field come from.
#[derive(Clone, Copy)]
pub enum Source {
    /// They lie in memory, an array per component.
    Stored(for<'a> fn(&Model<'a>, &StateView<'a>) -> [&'a [Real]; 2]),
    /// They are computed from row, column and component.
    Computed(fn(&Model, &StateView, usize, usize, usize) -> Option<Real>),
}

/// One row of the table.
///
/// ```
/// use softanvil_kernel::{Field, Simulation, StepInput, preset};
///
/// let mut anvil = Simulation::new(&preset::study())?;
/// anvil.run(4e-3, &StepInput::default())?;
/// let pressure = Field::find("surface.contact_pressure").unwrap();
/// let along_surface: Vec<f64> = anvil.with(|model, state| {
///     let [_, columns] = pressure.shape(model);
///     let state = state.as_view();
///     (0..columns).filter_map(|column| pressure.value(model, &state, 0, column, 0)).collect()
/// })?;
/// // The face presses the top of the round anvil, and not its side.
/// assert!(along_surface[0] > 0.0);
/// assert_eq!(along_surface.last(), Some(&0.0));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
pub struct Field {
    /// Its number, for ever: no other field gets it, even when this one is no more.
    pub id: u32,
    /// Name, such as "node.displacement".
    pub name: &'static str,
    /// SI unit.
    pub unit: &'static str,
    /// Meaning, one line.
    pub description: &'static str,
    /// Where the values live.
    pub location: Location,
    /// Numbers per value.
    pub components: usize,
    /// Where the numbers come from.
    pub source: Source,
}

const fn stored(
    id: u32,
    name: &'static str,
    unit: &'static str,
    location: Location,
    source: for<'a> fn(&Model<'a>, &StateView<'a>) -> [&'a [Real]; 2],
    description: &'static str,
) -> Field {
    Field { id, name, unit, description, location, components: 2, source: Source::Stored(source) }
}

const fn computed(
    id: u32,
    name: &'static str,
    unit: &'static str,
    location: Location,
    components: usize,
    source: fn(&Model, &StateView, usize, usize, usize) -> Option<Real>,
    description: &'static str,
) -> Field {
    Field { id, name, unit, description, location, components, source: Source::Computed(source) }
}

/// Ids of fields that are no more, which no other field gets.
pub const RETIRED_FIELDS: &[u32] = &[];

/// Every field.
pub static FIELDS: [Field; 18] = [
    stored(
        0,
        "node.reference_position",
        "m",
        Location::Node,
        |model, _| [model.nodes.reference_x, model.nodes.reference_y],
        "position at rest, x outwards from the centre line and y upwards from the centre of the core",
    ),
    computed(1, "node.position", "m", Location::Node, 2, position, "current position, x and y"),
    stored(
        2,
        "node.displacement",
        "m",
        Location::Node,
        |_, state| state.displacement(),
        "displacement from rest, x and y",
    ),
    stored(
        3,
        "node.velocity",
        "m/s",
        Location::Node,
        |_, state| state.velocity(),
        "velocity half a step back, x and y",
    ),
    stored(
        4,
        "node.force",
        "N",
        Location::Node,
        |_, state| state.force(),
        "force in the last step on the meshed section, contact and friction included, x and y",
    ),
    stored(
        5,
        "surface.contact_force",
        "N",
        Location::Surface,
        |_, state| state.contact_force(),
        "force of the face in the last step on the meshed section, pressing and, outwards, by friction",
    ),
    computed(
        6,
        "surface.contact_pressure",
        "Pa",
        Location::Surface,
        1,
        contact_pressure,
        "contact pressure in the last step, over the area halfway to the neighbouring nodes",
    ),
    computed(
        7,
        "element.pressure",
        "Pa",
        Location::Element,
        1,
        pressure,
        "hydrostatic pressure of the last step, positive in compression",
    ),
    computed(
        8,
        "element.von_mises_stress",
        "Pa",
        Location::Element,
        1,
        von_mises,
        "von Mises stress of the last step, viscous and damping parts included",
    ),
    computed(
        9,
        "element.principal_stress",
        "Pa",
        Location::Element,
        3,
        principal_stresses,
        "principal Cauchy stresses of the last step: larger and smaller in the section, then out of its plane; of a solid from the \
         largest to the smallest",
    ),
    computed(
        10,
        "element.cauchy_stress",
        "Pa",
        Location::Element,
        4,
        cauchy_components,
        "Cauchy stress of the last step, positive in tension: xx, yy, xy, and zz out of the section",
    ),
    computed(
        11,
        "element.principal_stretch",
        "1",
        Location::Element,
        3,
        principal_stretches,
        "principal stretches of the last step: larger and smaller in the section, then out of its plane; of a solid from the largest \
         to the smallest",
    ),
    computed(
        12,
        "node.reference_z",
        "m",
        Location::Node,
        1,
        |model, _, row, column, _| at(model, model.reference_z(), row, column),
        "position at rest along z, of a solid; 0 in a section",
    ),
    computed(13, "node.displacement_z", "m", Location::Node, 1, displacement_z, "displacement along z, of a solid"),
    computed(
        14,
        "node.velocity_z",
        "m/s",
        Location::Node,
        1,
        |model, state, row, column, _| at(model, state.along_z(model)[1], row, column),
        "velocity half a step back along z, of a solid",
    ),
    computed(
        17,
        "node.force_z",
        "N",
        Location::Node,
        1,
        |model, state, row, column, _| at(model, state.along_z(model)[2], row, column),
        "force along z in the last step on the meshed solid, contact and friction included",
    ),
    computed(
        15,
        "surface.friction_z",
        "N",
        Location::Surface,
        1,
        |model, state, row, column, _| at(model, state.along_z(model)[3], row, column),
        "friction force of the face along z in the last step, on the meshed solid",
    ),
    computed(
        16,
        "element.shear_stress_z",
        "Pa",
        Location::Element,
        2,
        shear_stress_z,
        "Cauchy stress of the last step of a solid: yz and zx",
    ),
];

impl Field {
    /// Rows and columns of the field in `model`.
    pub fn shape(&self, model: &Model) -> [usize; 2] {
        let grid = &model.constants.grid;
        match self.location {
            Location::Node => [grid.node_rows() * grid.node_slices(), grid.n_u + 1],
            Location::Surface => [grid.node_slices(), grid.n_u + 1],
            Location::Element if grid.is_solid() => [grid.n_v * grid.n_w, TETRAHEDRA * grid.n_u],
            Location::Element => [grid.n_v, 2 * grid.n_u],
        }
    }

    /// The numbers of a component in memory; none for a computed field.
    pub fn strided<'a>(&self, model: &Model<'a>, state: &StateView<'a>, component: usize) -> Option<Strided<'a>> {
        let Source::Stored(source) = self.source else { return None };
        let data = source(model, state).get(component).copied()?;
        Some(Strided { data, row_stride: model.constants.grid.stride() })
    }

    /// One number; none outside the shape.
    pub fn value(&self, model: &Model, state: &StateView, row: usize, column: usize, component: usize) -> Option<Real> {
        let [rows, columns] = self.shape(model);
        if row >= rows || column >= columns || component >= self.components {
            return None;
        }
        match self.source {
            Source::Stored(source) => {
                let index = row * model.constants.grid.stride() + column;
                source(model, state).get(component)?.get(index).copied()
            }
            Source::Computed(source) => source(model, state, row, column, component),
        }
    }

    /// The field of this name.
    pub fn find(name: &str) -> Option<&'static Self> {
        FIELDS.iter().find(|field| field.name == name)
    }
}

fn position(model: &Model, state: &StateView, row: usize, column: usize, component: usize) -> Option<Real> {
    let node = row * model.constants.grid.stride() + column;
    let (rest, displacement) = (model.reference_position(), state.displacement());
    Some(rest.get(component)?.get(node)? + displacement.get(component)?.get(node)?)
}

/// A number at (row, column); 0 where there are none.
fn at(model: &Model, numbers: &[Real], row: usize, column: usize) -> Option<Real> {
    Some(numbers.get(row * model.constants.grid.stride() + column).copied().unwrap_or_default())
}

fn contact_pressure(model: &Model, state: &StateView, row: usize, column: usize, _: usize) -> Option<Real> {
    if model.constants.grid.is_solid() {
        return surface::solid_contact_pressure(model, state, row, column);
    }
    surface::contact_pressure(model, state, column)
}

fn displacement_z(model: &Model, state: &StateView, row: usize, column: usize, _: usize) -> Option<Real> {
    at(model, state.along_z(model)[0], row, column)
}

fn pressure(model: &Model, state: &StateView, row: usize, column: usize, _: usize) -> Option<Real> {
    if model.constants.grid.is_solid() {
        return Some(-SolidStress::of(model, state, row, column)?.mean);
    }
    Stress::of(model, state, row, column).map(|stress| -stress.mean)
}

fn von_mises(model: &Model, state: &StateView, row: usize, column: usize, _: usize) -> Option<Real> {
    if model.constants.grid.is_solid() {
        return Some(SolidStress::of(model, state, row, column)?.von_mises());
    }
    Stress::of(model, state, row, column).map(|stress| stress.von_mises())
}

fn principal_stresses(model: &Model, state: &StateView, row: usize, column: usize, c: usize) -> Option<Real> {
    if model.constants.grid.is_solid() {
        return SolidStress::of(model, state, row, column)?.principal().get(c).copied();
    }
    Stress::of(model, state, row, column)?.principal().get(c).copied()
}

fn cauchy_components(model: &Model, state: &StateView, row: usize, column: usize, c: usize) -> Option<Real> {
    if model.constants.grid.is_solid() {
        let stress = SolidStress::of(model, state, row, column)?.cauchy(model, state)?;
        return [stress.m11, stress.m22, stress.m12, stress.m33].get(c).copied();
    }
    cauchy_stress(model, state, row, column)?.get(c).copied()
}

fn shear_stress_z(model: &Model, state: &StateView, row: usize, column: usize, c: usize) -> Option<Real> {
    if !model.constants.grid.is_solid() {
        return Some(0.0);
    }
    let stress = SolidStress::of(model, state, row, column)?.cauchy(model, state)?;
    [stress.m23, stress.m13].get(c).copied()
}

fn principal_stretches(model: &Model, state: &StateView, row: usize, column: usize, c: usize) -> Option<Real> {
    if model.constants.grid.is_solid() {
        return SolidStress::of(model, state, row, column)?.stretches().get(c).copied();
    }
    principal_stretch(model, state, row, column)?.get(c).copied()
}
