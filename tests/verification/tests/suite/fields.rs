//! Fields of the section against each other and against the forces that moved the nodes.

use softanvil_kernel::mesh::{out_of_plane, triangles};
use softanvil_kernel::scenario::{Formulation, Section};
use softanvil_kernel::{Field, Model, Simulation, StateView, StepInput, preset};
use softanvil_verification::tolerance::FIELD_FORCE;

const CORNERS: [(usize, usize); 4] = [(0, 0), (1, 0), (1, 1), (0, 1)];

/// Component `component` of the field `name` at a place that exists.
fn value(model: &Model, state: &StateView, name: &str, row: usize, column: usize, component: usize) -> f64 {
    let field = Field::find(name).unwrap_or_else(|| panic!("{name}"));
    field.value(model, state, row, column, component).unwrap_or_else(|| panic!("{name} {row} {column} {component}"))
}

/// Force on each node of the grid from the Cauchy stresses: minus the sum of sigma grad N times the current volume, all of
/// it from fields and at the time of the stresses, half of a step's motion behind the velocities.
///
/// Source: the principle of virtual work.
fn forces_of_stresses(model: &Model, state: &StateView) -> Vec<[f64; 2]> {
    let grid = &model.constants.grid;
    let node = |row, column, c| {
        value(model, state, "node.position", row, column, c)
            - model.constants.dt * value(model, state, "node.velocity", row, column, c)
    };
    let rest = |row, column, c| value(model, state, "node.reference_position", row, column, c);
    let mut forces = vec![[0.0; 2]; (grid.n_v + 1) * (grid.n_u + 1)];
    for (v, column) in (0..grid.n_v).flat_map(|v| (0..2 * grid.n_u).map(move |column| (v, column))) {
        let u = column / 2;
        let corners = triangles(grid, u, v)[column % 2].map(|corner| (v + CORNERS[corner].1, u + CORNERS[corner].0));
        let at = |p: &dyn Fn(usize, usize, usize) -> f64| corners.map(|(r, c)| [p(r, c, 0), p(r, c, 1)]);
        let (now, before) = (at(&node), at(&rest));
        let stress: [f64; 4] = std::array::from_fn(|c| value(model, state, "element.cauchy_stress", v, column, c));
        let stretch: [f64; 3] = std::array::from_fn(|c| value(model, state, "element.principal_stretch", v, column, c));
        let centre = before.iter().map(|p| p[0]).sum::<f64>() / 3.0;
        let volume = double_area(&before) / 2.0
            * out_of_plane(&model.constants.scenario, centre)
            * stretch.iter().product::<f64>();
        for (a, (r, c)) in corners.into_iter().enumerate() {
            let (next, last) = (now[(a + 1) % 3], now[(a + 2) % 3]);
            let gradient = [(next[1] - last[1]) / double_area(&now), (last[0] - next[0]) / double_area(&now)];
            let [xx, yy, xy, around] = stress;
            let force = &mut forces[r * (grid.n_u + 1) + c];
            force[0] -= volume * (xx * gradient[0] + xy * gradient[1]);
            // A radial displacement of a corner widens the ring by a third of it.
            if grid.axisymmetric {
                force[0] -= volume * around / now.iter().map(|p| p[0]).sum::<f64>();
            }
            force[1] -= volume * (xy * gradient[0] + yy * gradient[1]);
        }
    }
    forces
}

fn double_area(corners: &[[f64; 2]; 3]) -> f64 {
    let [a, b, c] = corners;
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// In the middle of a drop the layer turns, shears and is compressed by a third: a component in a wrong frame or with a
/// wrong sign shows as a force.
#[test]
fn cauchy_stresses_give_the_forces_of_the_nodes() {
    use Formulation::{Axisymmetric, PlaneStrain};
    for (formulation, section, tears) in [
        (PlaneStrain, Section::Half, false),
        (PlaneStrain, Section::Full, false),
        (PlaneStrain, Section::Half, true),
        (Axisymmetric, Section::Half, false),
        (Axisymmetric, Section::Half, true),
    ] {
        let mut scenario = preset::study();
        scenario.geometry.formulation = formulation;
        scenario.geometry.section = section;
        if tears {
            let silicone = &mut scenario.layers[0].material;
            (silicone.tear_stretch, silicone.tear_width, silicone.tear_residual) = (1.02, 0.1, 0.5);
        }
        let mut simulation = Simulation::new(&scenario).expect("a legal scenario");
        let steps = simulation.constants().steps_in(2.5e-3);
        simulation.step(steps, &StepInput::default()).expect("a stable run");
        let (largest, off) = simulation
            .with(|model, state| {
                let state = &state.as_view();
                let forces = forces_of_stresses(model, state);
                let grid = &model.constants.grid;
                let (mut largest, mut off) = (0.0_f64, 0.0_f64);
                // Rows between core and face, and no node of the centre line: nothing but stresses acts on them.
                for (v, u) in (1..grid.n_v).flat_map(|v| (1..=grid.n_u).map(move |u| (v, u))) {
                    for (c, force) in forces[v * (grid.n_u + 1) + u].iter().enumerate() {
                        let found = value(model, state, "node.force", v, u, c);
                        largest = largest.max(found.abs());
                        off = off.max((found - force).abs());
                    }
                }
                (largest, off)
            })
            .expect("memory that fits");
        assert!(
            largest > 1.0 && off < FIELD_FORCE * largest,
            "{formulation:?}, {section:?}, {tears}: {off} N of {largest} N"
        );
    }
}

/// The components, the principal stresses, the von Mises stress and the pressure say the same.
#[test]
fn stresses_agree_with_each_other() {
    for formulation in [Formulation::PlaneStrain, Formulation::Axisymmetric] {
        let mut scenario = preset::study();
        scenario.geometry.formulation = formulation;
        let mut simulation = Simulation::new(&scenario).expect("a legal scenario");
        let steps = simulation.constants().steps_in(2.5e-3);
        simulation.step(steps, &StepInput::default()).expect("a stable run");
        simulation.with(|model, state| check_stresses(model, &state.as_view())).expect("memory that fits");
    }
}

fn check_stresses(model: &Model, state: &StateView) {
    let grid = &model.constants.grid;
    for (row, column) in (0..grid.n_v).flat_map(|v| (0..2 * grid.n_u).map(move |column| (v, column))) {
        let get = |name: &str, c| value(model, state, name, row, column, c);
        let [xx, yy, xy, zz] = std::array::from_fn(|c| get("element.cauchy_stress", c));
        let [p1, p2, p3] = std::array::from_fn(|c| get("element.principal_stress", c));
        let mises = get("element.von_mises_stress", 0);
        let scale = mises + p1.abs() + p2.abs() + p3.abs();
        for (a, b) in [
            (xx + yy, p1 + p2),
            (zz, p3),
            ((0.25 * (xx - yy) * (xx - yy) + xy * xy).sqrt(), 0.5 * (p1 - p2)),
            (-(xx + yy + zz) / 3.0, get("element.pressure", 0)),
            ((0.5 * ((xx - yy).powi(2) + (yy - zz).powi(2) + (zz - xx).powi(2)) + 3.0 * xy * xy).sqrt(), mises),
        ] {
            assert!((a - b).abs() <= FIELD_FORCE * scale, "{row} {column}: {a} {b}");
        }
    }
}
