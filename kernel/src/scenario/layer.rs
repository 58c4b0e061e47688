//! A soft layer: how thick it is, what it is made of, how it is meshed, and how it sits on the one below.

use heapless::String;
use strum::{FromRepr, VariantNames};

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
    /// Width along its lower side, m, full or, of a dome, the diameter; 0 is as wide as what is below it.
    pub width: Real,
    /// How it sits on the layer below; the lowest one sits on the core as [`crate::scenario::CoreInterface`] says.
    pub interface: LayerInterface,
    /// Coulomb coefficient of a frictional interface with the layer below.
    pub friction_coefficient: Real,
    /// Distance to the layer below at rest, m, where they are not bonded.
    pub gap: Real,
    /// What it is made of.
    pub material: Material,
}

impl Layer {
    /// A layer of `thickness` m, meshed by the element size, as wide as what is below it and bonded to that. A name that is longer than [`MAX_LAYER_NAME`] bytes is left out.
    pub fn new(name: &str, thickness: Real, material: Material) -> Self {
        let (name, interface) = (String::try_from(name).unwrap_or_default(), LayerInterface::Bonded);
        Self { name, thickness, rows: 0, width: 0.0, interface, friction_coefficient: 0.3, gap: 0.0, material }
    }

    /// Coulomb coefficient of sliding on the layer below; 0 without friction.
    pub(crate) fn sliding_coefficient(&self) -> Real {
        match self.interface {
            LayerInterface::Frictional => self.friction_coefficient,
            LayerInterface::Separating | LayerInterface::Bonded => 0.0,
        }
    }
}

/// How a layer sits on the one below.
#[derive(Clone, Copy, Debug, FromRepr, PartialEq, Eq, VariantNames)]
#[strum(serialize_all = "snake_case")]
pub enum LayerInterface {
    /// Glued: both share the nodes between them.
    Bonded,
    /// They touch where they meet, lift and slide, with Coulomb friction.
    Frictional,
    /// The same without friction.
    Separating,
}
