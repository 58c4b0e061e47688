//! What a scenario has to be: each value in its range, and all of them together.

use crate::error::ScenarioError;
use crate::number::math;
use crate::number::real::Real;
use crate::scenario::parameter::Parameter;
use crate::scenario::{Formulation, Layer, Scenario, Section, Shape};

impl Scenario {
    /// Checks every parameter against its legal range, then what several parameters say together.
    ///
    /// # Errors
    /// The first refused value, by name, with its unit and legal range.
    pub fn validate(&self) -> Result<(), ScenarioError> {
        for parameter in Parameter::of(self) {
            parameter.check(parameter.get(self))?;
        }
        let (layers, interfaces) = (self.layers.len(), self.interfaces.len());
        if interfaces + 1 != layers {
            return Err(ScenarioError::Interfaces { layers, interfaces });
        }
        self.layers.iter().enumerate().try_for_each(|(place, layer)| layer.validate(place))?;
        self.validate_geometry()
    }

    fn validate_geometry(&self) -> Result<(), ScenarioError> {
        let geometry = &self.geometry;
        let outer = geometry.core_radius + self.thickness();
        let chord_ends = geometry.shape == Shape::Round && geometry.formulation == Formulation::PlaneStrain;
        let reach = FACE_MARGIN * outer + math::abs(self.impactor.offset);
        if geometry.section == Section::Full && geometry.formulation == Formulation::Axisymmetric {
            return Err(ScenarioError::FullAxisymmetric);
        }
        if geometry.section == Section::Half && self.impactor.offset != 0.0 {
            return Err(ScenarioError::OffsetOfHalf { offset: self.impactor.offset });
        }
        if chord_ends && 0.5 * self.impactor.face_diameter < reach {
            let minimum = 2.0 * reach;
            return Err(ScenarioError::FaceTooSmall { diameter: self.impactor.face_diameter, minimum });
        }
        Ok(())
    }
}

impl Layer {
    fn validate(&self, layer: usize) -> Result<(), ScenarioError> {
        let (thickness, material) = (self.thickness, &self.material);
        if thickness < MIN_THICKNESS {
            return Err(ScenarioError::LayerThickness { layer, thickness, minimum: MIN_THICKNESS });
        }
        if material.prony_g_inf() <= 0.0 {
            return Err(ScenarioError::PronySum { layer, sum: 1.0 - material.prony_g_inf() });
        }
        let modulus = material.shear_modulus_inf();
        if modulus <= 0.0 {
            return Err(ScenarioError::ShearModulus { layer, coefficients: material.law.modulus_at_rest(), modulus });
        }
        let bulk_modulus = material.effective_bulk_modulus();
        if material.law.description().compressible && bulk_modulus <= 0.0 {
            return Err(ScenarioError::BulkModulus { layer, modulus: bulk_modulus });
        }
        let r = material.softening_r;
        if r > 0.0 && r < 1.0 {
            return Err(ScenarioError::Softening { layer, r });
        }
        let stretch = material.tear_stretch;
        if stretch > 0.0 && stretch < 1.0 {
            return Err(ScenarioError::TearStretch { layer, stretch });
        }
        Ok(())
    }
}

/// Thinnest layer, m: as thin as the smallest element.
const MIN_THICKNESS: Real = 1e-5;

/// The face's chord is the thickness of the section, so the face must reach past the anvil's side by this factor.
const FACE_MARGIN: Real = 1.02;
