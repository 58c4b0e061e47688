//! The fields of the kernel as ParaView knows them.

use softanvil_kernel::{FIELDS, Field};

/// The fields of a series of a solid.
pub(super) fn all_fields() -> Vec<&'static Field> {
    FIELDS.iter().filter(|field| field.name != "node.position").collect()
}

/// The name of a field without its place.
pub(super) fn short(field: &Field) -> &'static str {
    field.name.split_once('.').map_or(field.name, |(_, name)| name)
}

/// Values as ParaView knows them, and their components: vectors in space, symmetric tensors as xx, yy, zz, xy, yz, xz.
pub(super) fn in_space(field: &Field, values: &[f64]) -> (Vec<f64>, usize) {
    let components = field.components;
    let places = values.chunks_exact(components);
    match components {
        2 => (places.flat_map(|v| [v[0], v[1], 0.0]).collect(), 3),
        4 => (places.flat_map(|v| [v[0], v[1], v[3], v[2], 0.0, 0.0]).collect(), 6),
        _ => (values.to_vec(), components),
    }
}
