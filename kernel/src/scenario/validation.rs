//! What a scenario has to be: each value in its range, and all of them together.

use crate::error::{Name, ScenarioError};
use crate::features::PADS;
use crate::number::real::consts::PI;
use crate::number::real::{Real, SAME};
use crate::scenario::parameter::Parameter;
use crate::scenario::{FaceShape, Formulation, Impactor, Layer, LayerInterface, Scenario, Section, Symmetry};

impl Scenario {
    /// Checks every parameter against its legal range, then what several parameters say together.
    ///
    /// # Errors
    /// The first refused value, by name, with its unit and legal range.
    pub fn validate(&self) -> Result<(), ScenarioError> {
        for parameter in Parameter::of(self) {
            parameter.check(parameter.get(self))?;
        }
        self.layers.iter().enumerate().try_for_each(|(place, layer)| layer.validate(place))?;
        self.validate_widths()?;
        self.validate_geometry()?;
        self.validate_build()
    }

    /// A kernel without pads has nothing for what only they need; it has no parameters for most of it either.
    fn validate_build(&self) -> Result<(), ScenarioError> {
        if PADS {
            return Ok(());
        }
        let of_layer = |(layer, of): (usize, &Layer)| {
            let needs = [
                ("softening_r", of.material.softening_r > 0.0),
                ("interface", of.interface != LayerInterface::Bonded),
                ("width", of.width > 0.0),
            ];
            needs.into_iter().find(|(_, needs)| *needs).map(|(field, _)| Name::of_layer(layer, field))
        };
        let face = || if self.face_covers() { None } else { Some("impactor.face_diameter".into()) };
        let Impactor { rail_friction, rail_damping, .. } = self.impactor;
        let rails = || (rail_friction > 0.0 || rail_damping > 0.0).then(|| "impactor.rail_friction".into());
        match self.layers.iter().enumerate().find_map(of_layer).or_else(face).or_else(rails) {
            Some(name) => Err(ScenarioError::WithoutPads { name }),
            None => Ok(()),
        }
    }

    /// Each layer lies on the one below, so it is at most as wide.
    fn validate_widths(&self) -> Result<(), ScenarioError> {
        for (layer, of) in self.layers.iter().enumerate().filter(|_| PADS) {
            let maximum = self.width_below(layer);
            if of.width > maximum * (1.0 + SAME) {
                return Err(ScenarioError::LayerWidth { layer, width: of.width, maximum });
            }
        }
        Ok(())
    }

    fn validate_geometry(&self) -> Result<(), ScenarioError> {
        let geometry = &self.geometry;
        if geometry.formulation.is_solid() {
            return self.validate_solid();
        }
        if geometry.section == Section::Full && geometry.formulation == Formulation::Axisymmetric {
            return Err(ScenarioError::FullAxisymmetric);
        }
        if geometry.section == Section::Half && self.impactor.offset != 0.0 {
            return Err(ScenarioError::OffsetOfHalf { offset: self.impactor.offset });
        }
        self.validate_face()
    }

    fn validate_solid(&self) -> Result<(), ScenarioError> {
        let impactor = &self.impactor;
        if self.geometry.symmetry == Symmetry::Quarter && impactor.offset != 0.0 {
            let (name, expected) = ("impactor.offset".into(), "0 m with geometry.symmetry = quarter");
            return Err(ScenarioError::NotInSolid { name, expected });
        }
        self.validate_face()
    }

    fn validate_face(&self) -> Result<(), ScenarioError> {
        let (impactor, size) = (&self.impactor, self.mesh.element_size);
        let refused =
            |shape, expected, formulation| Err(ScenarioError::FaceOfFormulation { shape, expected, formulation });
        match (self.geometry.formulation, impactor.shape) {
            (Formulation::PlaneStrain, FaceShape::Sphere) => {
                return refused("sphere", "round, rectangular or bar", "plane_strain");
            }
            (Formulation::Axisymmetric, FaceShape::Bar) => {
                return refused("bar", "round, rectangular or sphere", "axisymmetric");
            }
            _ => {}
        }
        if self.face_half_width() >= size {
            return Ok(());
        }
        let (name, width, minimum) = match (impactor.shape, self.geometry.formulation) {
            (FaceShape::Rectangular, Formulation::Axisymmetric) => {
                ("impactor.face_width", impactor.face_width, PI * size * size / impactor.face_length)
            }
            (FaceShape::Rectangular, _) => ("impactor.face_width", impactor.face_width, 2.0 * size),
            _ => ("impactor.face_diameter", impactor.face_diameter, 2.0 * size),
        };
        Err(ScenarioError::FaceTooSmall { name, width, minimum })
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
        if material.law.is_compressible() && bulk_modulus <= 0.0 {
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

#[cfg(all(test, not(feature = "pads")))]
mod tests {
    use super::*;
    use crate::scenario::preset;

    #[test]
    fn a_kernel_without_pads_refuses_what_needs_one() {
        let refused = |change: fn(&mut Scenario)| {
            let mut scenario = preset::study();
            scenario.add_layer(preset::chamois()).unwrap();
            assert_eq!(scenario.validate(), Ok(()));
            change(&mut scenario);
            match scenario.validate() {
                Err(ScenarioError::WithoutPads { name }) => name,
                other => panic!("{other:?}"),
            }
        };
        assert_eq!(refused(|of| of.layers[0].material.softening_r = 2.0), Name::of_layer(0, "softening_r"));
        assert_eq!(refused(|of| of.layers[1].interface = LayerInterface::Separating), Name::of_layer(1, "interface"));
        assert_eq!(refused(|of| of.layers[1].width = 50e-3), Name::of_layer(1, "width"));
        assert_eq!(refused(|of| of.impactor.face_diameter = 50e-3), "impactor.face_diameter".into());
        assert_eq!(refused(|of| of.impactor.shape = FaceShape::Bar), "impactor.face_diameter".into());
        assert_eq!(refused(|of| of.impactor.rail_damping = 1.0), "impactor.rail_friction".into());
    }
}
