//! One cell of two triangles, driven through a history of deformation gradients, as the kernel's step drives it.

use softanvil_kernel::element::{Block, CellHistory, Corners, ElementEnergy, internal_force};
use softanvil_kernel::material::{Material, MaterialModel};
use softanvil_kernel::number::pack::{ZERO, sum};
use softanvil_kernel::number::vector::Scalar;
use softanvil_kernel::sampling::SMALLEST_STEP;
use softanvil_kernel::scenario::{Formulation, StepBy};
use softanvil_kernel::tensor::deviator::Deviator;
use softanvil_kernel::{Model, ModelMemory, Scalars, Scenario, Size, StateMemory};

use crate::deformation::Gradient;
use crate::scenes;

/// A cell at rest in lane 0 of a block, the first one beside the centre line.
pub struct Cell {
    memory: (Vec<f64>, Vec<softanvil_kernel::element::CellConstants>, Vec<softanvil_kernel::element::HoopConstants>),
    corners: [[f64; 2]; 4],
    laws: MaterialModel,
    history: CellHistory,
    viscous: Vec<Deviator>,
    /// Viscous work so far, J/m3.
    pub viscous_work: f64,
    /// Slider dissipation so far, J/m3.
    pub slider_dissipation: f64,
    /// Dissipation by tearing so far, J/m3.
    pub tear: f64,
    /// Dissipation by softening so far, J/m3.
    pub softening: f64,
    /// Energy in the damping spring, J/m3.
    pub slider_stored: f64,
    /// Elastic energy, J/m3.
    pub elastic_energy: f64,
}

impl Cell {
    /// The cell of a block of `material`, for steps of `dt` s.
    pub fn new(material: Material, formulation: Formulation, dt: f64) -> Self {
        let mut scenario: Scenario = scenes::block(12e-3, 3e-3, material);
        scenario.geometry.formulation = formulation;
        let size = Size::of(&scenario).expect("a legal block");
        let mut memory = (
            vec![0.0; size.model_nodes],
            vec![softanvil_kernel::element::CellConstants::ZERO; size.model_cells],
            vec![softanvil_kernel::element::HoopConstants::ZERO; size.model_hoops],
        );
        // A given step needs no trial, and so no state.
        (scenario.time.step_by, scenario.time.step) = (StepBy::Given, SMALLEST_STEP);
        let mut state =
            StateMemory { scalars: &mut Scalars::BLANK.clone(), nodes: &mut [], cells: &mut [], viscous: &mut [] };
        let mut constants = None;
        let (nodes, cells, hoops) = (&mut memory.0, &mut memory.1, &mut memory.2);
        let model = Model::new(&scenario, ModelMemory { constants: &mut constants, nodes, cells, hoops }, &mut state)
            .expect("a legal model");
        let [x, y] = model.reference_position();
        let stride = model.constants.grid.stride();
        let corners = [0, 1, stride + 1, stride].map(|node| [x[node], y[node]]);
        Self {
            corners,
            laws: MaterialModel::new(&material, dt),
            history: CellHistory::REST,
            viscous: vec![Deviator::ZERO; size.state_viscous],
            memory,
            viscous_work: 0.0,
            slider_dissipation: 0.0,
            tear: 0.0,
            softening: 0.0,
            slider_stored: 0.0,
            elastic_energy: 0.0,
        }
    }

    /// Deforms the cell homogeneously; returns the mean first Piola-Kirchhoff stress from the nodal forces, Pa:
    /// sum_a f_a (x) X_a = V P. In an axisymmetric cell the xx entry is P11 + P33.
    pub fn deform(&mut self, gradient: Gradient) -> Gradient {
        let mut displacement: Corners<f64> = [[0.0; 2]; 4];
        for (corner, reference) in displacement.iter_mut().zip(&self.corners) {
            for i in 0..2 {
                let deformed = gradient[i][0] * reference[0] + gradient[i][1] * reference[1];
                corner[i] = deformed - reference[i];
            }
        }
        let constants = self.lane_zero();
        let mut energy = ElementEnergy::ZERO;
        let hoop = self.memory.2.first();
        let force = internal_force(
            Scalar,
            0,
            &Block { laws: &self.laws, constants: &constants, hoop },
            &displacement,
            &mut self.history,
            &mut self.viscous,
            &mut energy,
        );
        assert_eq!(energy.inverted, ZERO, "a positive Jacobian");
        let volume: f64 = constants.triangle.iter().map(|t| t.reference_volume[0]).sum();
        self.viscous_work += sum(&energy.viscous_increment) / volume;
        self.slider_dissipation += sum(&energy.slider_increment) / volume;
        self.tear += sum(&energy.tear_increment) / volume;
        self.softening += sum(&energy.softening_increment) / volume;
        self.slider_stored = sum(&energy.slider_stored) / volume;
        self.elastic_energy = sum(&energy.elastic) / volume;
        let mut stress = [[0.0; 2]; 2];
        for (nodal, reference) in force.iter().zip(&self.corners) {
            for i in 0..2 {
                for j in 0..2 {
                    stress[i][j] += nodal[i] * reference[j] / volume;
                }
            }
        }
        stress
    }

    /// The constants with every lane but the first emptied, so that lane 0 is alone.
    fn lane_zero(&self) -> softanvil_kernel::element::CellConstants {
        let mut constants = self.memory.1[0];
        for triangle in &mut constants.triangle {
            for lane in triangle.shape_gradient.iter_mut().flatten() {
                lane[1..].fill(0.0);
            }
            triangle.reference_volume[1..].fill(0.0);
            triangle.volume_fraction[1..].fill(0.0);
        }
        constants
    }
}
