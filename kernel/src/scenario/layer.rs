//! A soft layer: how thick it is, what it is made of, how it is meshed, and how it sits on the one below.

use heapless::String;

use crate::material::Material;
use crate::number::real::Real;

/// Most layers.
pub const MAX_LAYERS: usize = 4;

/// Most bytes of the name of a layer.
pub const MAX_LAYER_NAME: usize = 23;

/// A soft layer of the anvil.
#[derive(Clone, Debug, PartialEq)]
pub struct Layer {
    /// What people call it, such as "silicone"; may be empty. Nothing follows from it.
    pub name: String<MAX_LAYER_NAME, u8>,
    /// Thickness at rest, m.
    pub thickness: Real,
    /// Rows of cells through its thickness; 0 takes as many as come nearest to [`crate::scenario::Mesh::element_size`].
    pub rows: usize,
    /// What it is made of.
    pub material: Material,
}

impl Layer {
    /// A layer of `thickness` m, meshed by the element size. A name that is longer than [`MAX_LAYER_NAME`] bytes is left out.
    pub fn new(name: &str, thickness: Real, material: Material) -> Self {
        Self { name: String::try_from(name).unwrap_or_default(), thickness, rows: 0, material }
    }
}

/// How two neighbouring layers hold together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LayerInterface {
    /// Glued: both share the nodes between them.
    Bonded,
}
