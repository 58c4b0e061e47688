//! Which drop a command simulates: where its numbers come from, what it is, and what speaks against it.

use std::path::PathBuf;

use serde_json::{Value, json};
use softanvil_kernel::mesh::Grid;
use softanvil_kernel::preset::Preset;
use softanvil_kernel::scenario::{Body, DropBy, Ends, Formulation, Geometry, Motion, Section, Shape, Symmetry};
use softanvil_kernel::state::{EnergyBalance, Scalars};
use softanvil_kernel::{Constants, ModelError, Scenario};

use crate::output::material_summary;
use crate::run::Until;
use crate::text::number::{four_digits, short};
use crate::text::wrap::filled;

/// The drop that a command simulates.
#[derive(Clone, Debug)]
pub struct Subject {
    /// The scenario.
    pub scenario: Scenario,
    /// When its runs end.
    pub until: Until,
    /// The preset that it starts from.
    pub preset: &'static Preset,
    /// The scenario file upon it.
    pub scenario_file: Option<PathBuf>,
    /// The material file upon that.
    pub material_file: Option<PathBuf>,
    /// The parameters set on the command line, as they were given.
    pub set: Vec<String>,
}

/// Rows of cells through the layer below which a warning is due: fewer do not show how a layer bulges that is held on both
/// sides, and at two the paper's peak is off by more than its experiment scatters.
const FEWEST_ROWS: usize = 3;
/// The same of columns along it.
const FEWEST_COLUMNS: usize = 3;

impl Subject {
    /// The scenario of `preset` as it is.
    pub fn of_preset(preset: &'static Preset) -> Self {
        let scenario = (preset.scenario)();
        Self { scenario, until: Until::Over, preset, scenario_file: None, material_file: None, set: Vec::new() }
    }

    /// What is simulated, in lines.
    pub fn text(&self) -> String {
        let mut source = vec![format!("preset {}", self.preset.name)];
        source.extend(self.scenario_file.iter().map(|path| path.display().to_string()));
        source.extend(self.material_file.iter().map(|path| path.display().to_string()));
        source.extend(self.set.iter().cloned());
        let head = format!("Scenario: {}.\n{}\n{}\n", source.join(", "), drop(&self.scenario), anvil(&self.scenario));
        filled(&head) + &material_summary::text(&self.scenario)
    }

    /// The same for programs, in SI.
    pub fn json(&self) -> Value {
        let impactor = &self.scenario.impactor;
        let path = |path: &Option<PathBuf>| path.as_ref().map(|path| path.display().to_string());
        let motion = match impactor.motion {
            Motion::Prescribed => json!({
                "motion": "prescribed", "speed": impactor.prescribed_speed, "depth": impactor.prescribed_depth,
            }),
            _ => json!({
                "motion": "drop", "mass": impactor.mass, "energy": energy(&self.scenario), "speed": impactor.start_speed(),
                "height": height(&self.scenario),
            }),
        };
        json!({
            "preset": self.preset.name,
            "scenario_file": path(&self.scenario_file),
            "material_file": path(&self.material_file),
            "set": self.set,
            "impactor": motion,
            "layer_thickness": self.scenario.thickness(),
            "layers": material_summary::json(&self.scenario),
        })
    }
}

/// Kinetic energy at the start, J.
fn energy(scenario: &Scenario) -> f64 {
    match scenario.impactor.drop_by {
        DropBy::Energy => scenario.impactor.drop_energy,
        DropBy::Height | DropBy::Speed => 0.5 * scenario.impactor.mass * scenario.impactor.start_speed().powi(2),
    }
}

/// Height from which a fall gives the speed at the start, m; none without gravity.
fn height(scenario: &Scenario) -> Option<f64> {
    if scenario.impactor.drop_by == DropBy::Height {
        return Some(scenario.impactor.drop_height);
    }
    let (speed, gravity) = (scenario.impactor.start_speed(), scenario.impactor.gravity);
    (gravity > 0.0).then(|| speed * speed / (2.0 * gravity))
}

/// What the impactor does.
pub fn drop(scenario: &Scenario) -> String {
    let impactor = &scenario.impactor;
    if impactor.motion == Motion::Prescribed {
        let (speed, depth) = (four_digits(impactor.prescribed_speed), short(1e3 * impactor.prescribed_depth));
        return format!("Press: at {speed} m/s to a depth of {depth} mm, then held.");
    }
    let height = height(scenario).map_or(String::new(), |height| format!(", as from a height of {height:.3} m"));
    format!(
        "Drop: {} kg with {} J, at {} m/s{height}.",
        short(impactor.mass),
        short(energy(scenario)),
        four_digits(impactor.start_speed())
    )
}

/// What it falls on.
fn anvil(scenario: &Scenario) -> String {
    let geometry = &scenario.geometry;
    let in_mm = |length: f64| short(1e3 * length);
    let parts = scenario.layers.iter().enumerate();
    let parts =
        parts.map(|(k, layer)| format!("{} mm of {}", in_mm(layer.thickness), material_summary::name(k, layer)));
    let layer = match scenario.layers.len() {
        1 => format!("a layer of {} mm", in_mm(scenario.thickness())),
        _ => format!("{}, from the core to the surface,", parts.collect::<Vec<_>>().join(", ")),
    };
    let on = match (geometry.shape, is_revolved(geometry)) {
        (Shape::Round, false) => format!("a core of {} mm diameter", in_mm(2.0 * geometry.core_radius)),
        (Shape::Round, true) => format!("a ball of {} mm diameter", in_mm(2.0 * geometry.core_radius)),
        (Shape::Block, false) => format!("a flat core, {} mm wide", in_mm(geometry.block_width)),
        (Shape::Block, true) => format!("a flat core, {} mm in diameter", in_mm(geometry.block_width)),
    };
    format!("Anvil: {layer} on {on}; {}.", formulation(geometry))
}

fn is_revolved(geometry: &Geometry) -> bool {
    geometry.formulation == Formulation::Axisymmetric
        || geometry.formulation.is_solid() && geometry.body == Body::Revolved
}

/// In how many dimensions it is simulated, and how much of it.
fn formulation(geometry: &Geometry) -> String {
    if !geometry.formulation.is_solid() {
        let kind = if is_revolved(geometry) { "axisymmetric" } else { "plane strain" };
        let section = if geometry.section == Section::Full { "whole" } else { "half" };
        return format!("{kind}, {section} section");
    }
    let part = match geometry.symmetry {
        Symmetry::Quarter => "a quarter",
        Symmetry::Half => "a half",
        Symmetry::Full => "the whole",
    };
    let ends = if geometry.ends == Ends::Held { "held" } else { "free" };
    let long = format!("{} mm long with {ends} ends, ", short(1e3 * geometry.length));
    let long = if is_revolved(geometry) { "" } else { &long };
    format!("in three dimensions, {long}{part} of it meshed")
}

/// What makes the numbers of a run doubtful, of which `end` is the last step, in lines without a break.
pub fn warnings(constants: &Constants, end: &Scalars) -> Vec<String> {
    let size = 1e3 * constants.scenario.mesh.element_size;
    let way = end.metrics.max_deformation;
    [coarse(&constants.grid, size), flat(way, constants.scenario.thickness()), unbalanced(&end.energy)]
        .into_iter()
        .flatten()
        .collect()
}

/// Part of the layers' thickness beyond which no test of a material goes.
const FLAT: f64 = 0.95;

fn flat(deformation: f64, thickness: f64) -> Option<String> {
    (deformation > FLAT * thickness).then(|| {
        format!(
            "the layers are pressed by {} mm of {} mm, further than any test of a material goes: the force is what the law happens to \
             make of it, and small steps take long; less energy, or a thicker or stiffer layer, is what the law is for",
            four_digits(1e3 * deformation),
            short(1e3 * thickness)
        )
    })
}

/// Part of the external energy that a sound simulation leaves unexplained at most.
const LARGEST_RESIDUAL: f64 = 0.01;

fn unbalanced(energy: &EnergyBalance) -> Option<String> {
    let (residual, external) = (energy.residual().abs(), energy.external.abs());
    (residual > LARGEST_RESIDUAL * external).then(|| {
        format!(
            "the balance of energy leaves {} J of {} J unexplained ({:.1} %): a part of a layer folds or is pressed flat, and what \
             comes after that means little; less energy, damping, a thicker or stiffer layer, or a smaller time.safety_factor may do",
            four_digits(residual),
            four_digits(external),
            1e2 * residual / external
        )
    })
}

/// What makes the numbers of a scenario doubtful before it runs.
///
/// # Errors
/// A mesh that is refused.
pub fn warnings_of(scenario: &Scenario) -> Result<Vec<String>, ModelError> {
    Ok(coarse(&Grid::new(scenario)?, 1e3 * scenario.mesh.element_size).into_iter().collect())
}

fn coarse(grid: &Grid, size: f64) -> Option<String> {
    let (rows, columns) = (grid.n_v, grid.n_u);
    let cells = |count: usize, one: &str| format!("{count} {one}{}", if count == 1 { "" } else { "s" });
    (rows < FEWEST_ROWS || columns < FEWEST_COLUMNS).then(|| {
        format!(
            "the mesh is too coarse for numbers to mean much: {} of cells through the layer and {} along it, \
             with mesh.element_size = {} mm; at least {FEWEST_ROWS} and {FEWEST_COLUMNS} are advised, and `softanvil sweep \
             --convergence` tells the error",
            cells(rows, "row"),
            cells(columns, "column"),
            short(size)
        )
    })
}

/// Warnings as lines of text.
pub fn warning_lines(warnings: &[String]) -> String {
    warnings.iter().map(|warning| filled(&format!("! Warning: {warning}.\n"))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use softanvil_kernel::preset;

    #[test]
    fn a_mesh_of_few_cells_is_warned_of_and_the_preset_is_not() {
        let mut scenario = preset::study();
        assert!(warnings_of(&scenario).unwrap().is_empty());
        scenario.mesh.element_size = 7.5e-3;
        let warnings = warnings_of(&scenario).unwrap();
        assert!(warnings.len() == 1 && warnings[0].contains("2 rows of cells"), "{warnings:?}");
        assert!(warnings[0].contains("mesh.element_size = 7.5 mm"), "{warnings:?}");
    }

    #[test]
    fn layers_that_are_pressed_flat_are_warned_of() {
        assert_eq!(flat(14.0e-3, 15e-3), None);
        let text = flat(14.48e-3, 15e-3).unwrap();
        assert!(text.starts_with("the layers are pressed by 14.48 mm of 15 mm, further"), "{text}");
    }

    #[test]
    fn energy_that_is_not_explained_is_warned_of() {
        let mut energy = softanvil_kernel::Simulation::new(&preset::study()).unwrap().scalars().energy;
        let mut told = |kinetic: f64, external: f64| {
            (energy.impactor_kinetic, energy.external) = (kinetic, external);
            unbalanced(&energy)
        };
        assert_eq!(
            [(14.7, 14.7), (14.6, 14.7), (0.0, 0.0)].map(|(kinetic, external)| told(kinetic, external)),
            [None, None, None]
        );
        let text = told(12.7, 14.7).unwrap();
        assert!(text.contains("leaves 2.000 J of 14.70 J unexplained (13.6 %)"), "{text}");
    }

    #[test]
    fn a_drop_is_told_by_mass_energy_speed_and_height_and_a_press_by_speed_and_depth() {
        let mut scenario = preset::study();
        assert_eq!(drop(&scenario), "Drop: 5 kg with 14.7 J, at 2.425 m/s, as from a height of 0.300 m.");
        scenario.impactor.motion = Motion::Prescribed;
        assert_eq!(drop(&scenario), "Press: at 0.1000 m/s to a depth of 5 mm, then held.");
    }

    #[test]
    fn a_solid_is_told_as_one() {
        let mut scenario = preset::study();
        let on = "Anvil: a layer of 15 mm on a core of 75 mm diameter;";
        assert_eq!(anvil(&scenario), format!("{on} plane strain, half section."));
        let geometry = &mut scenario.geometry;
        geometry.formulation = Formulation::Solid;
        let length = short(1e3 * geometry.length);
        assert_eq!(
            anvil(&scenario),
            format!("{on} in three dimensions, {length} mm long with free ends, a quarter of it meshed.")
        );
        scenario.geometry.body = Body::Revolved;
        let dome = "Anvil: a layer of 15 mm on a ball of 75 mm diameter; in three dimensions, a quarter of it meshed.";
        assert_eq!(anvil(&scenario), dome);
    }
}
