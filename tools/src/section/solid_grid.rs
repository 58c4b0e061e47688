//! A solid as a grid of VTK: its tetrahedra, with all fields of the kernel as vectors and tensors in space.

use softanvil_kernel::mesh::{TETRAHEDRA, tetrahedra};
use softanvil_kernel::{Field, result::Location};

use super::vtk_fields::{all_fields, in_space, short};
use super::vtu::{Array, Cell, Grid};
use super::{Frame, Mesh};

/// The solid of `mesh` at the time of a `frame` of the whole.
pub(super) fn solid_grid(mesh: &Mesh, frame: &Frame) -> Grid {
    let grid = &mesh.constants.grid;
    let (columns, slices) = (grid.n_u + 1, grid.node_slices());
    let number = |[u, v, w]: [usize; 3]| (v * slices + w) * columns + u;
    let (mut cells, mut there) = (Vec::with_capacity(grid.n_elem()), Vec::with_capacity(grid.n_elem()));
    for (v, w) in (0..grid.n_v).flat_map(|v| (0..grid.n_w).map(move |w| (v, w))) {
        for u in 0..grid.n_u {
            let has_cell = grid.has_cell(u, v, w);
            there.extend([has_cell; TETRAHEDRA]);
            if has_cell {
                cells.extend(tetrahedra(grid, [u, v, w]).map(|corners| corners.map(number).to_vec()));
            }
        }
    }
    let nodes = grid.node_rows() * slices * columns;
    let (mut point_data, mut cell_data) = (Vec::new(), Vec::new());
    for field in all_fields().into_iter().filter(|field| !field.name.ends_with("_z")) {
        let (mut values, components) = in_space(field, frame.values(field.name));
        add_along_z(field, frame, &mut values);
        if field.location == Location::Surface {
            // Inside the layers there is no contact.
            let mut all = vec![0.0; nodes * components];
            for (place, of_node) in values.chunks_exact(components).enumerate() {
                let (w, u) = (place / columns, place % columns);
                let first = components * number([u, grid.surface_row(u, w), w]);
                all[first..first + components].copy_from_slice(of_node);
            }
            values = all;
        }
        if field.location == Location::Element {
            let of_cells = values.chunks_exact(components).zip(&there).filter(|(_, there)| **there);
            values = of_cells.flat_map(|(values, _)| values).copied().collect();
        }
        let data = if field.location == Location::Element { &mut cell_data } else { &mut point_data };
        data.push(Array { name: short(field), components, values });
    }
    let [rest, moved] = ["reference_position", "displacement"]
        .map(|name| point_data.iter().find(|array| array.name == name).map_or(&[][..], |array| &array.values));
    let points = rest.iter().zip(moved).map(|(rest, moved)| rest + moved).collect();
    Grid { points, kind: Cell::Tetrahedron, cells, point_data, cell_data }
}

/// Puts what a field has along z, which is another one, into its vectors and tensors.
fn add_along_z(field: &Field, frame: &Frame, values: &mut [f64]) {
    let along = match field.name {
        "node.reference_position" => "node.reference_z",
        "node.displacement" => "node.displacement_z",
        "node.velocity" => "node.velocity_z",
        "node.force" => "node.force_z",
        "surface.contact_force" => "surface.friction_z",
        "element.cauchy_stress" => {
            for (tensor, shear) in
                values.chunks_exact_mut(6).zip(frame.values("element.shear_stress_z").chunks_exact(2))
            {
                tensor[4..].copy_from_slice(shear);
            }
            return;
        }
        _ => return,
    };
    for (vector, z) in values.chunks_exact_mut(3).zip(frame.values(along)) {
        vector[2] = *z;
    }
}
