//! Interfaces between layers: a stack as springs in series, waves that meet another impedance, a gap that closes, a layer that
//! slides on another one until friction stops it.
//!
//! Sources: springs in series, 1 / E = sum h_i / E_i over the height; Kolsky, Stress Waves in Solids (1953): of a stress wave
//! 2 Z_2 / (Z_1 + Z_2) goes on and (Z_2 - Z_1) / (Z_1 + Z_2) comes back, Z = rho c.

use softanvil_kernel::material::Material;
use softanvil_kernel::scenario::{Formulation, Interface, Layer, LayerInterface, Section, Symmetry};
use softanvil_kernel::{Model, Scenario, Simulation, State, StepInput, step};

use crate::order::over_cells;
use crate::relaxation::{damp, press_slowly};
use crate::row::Row;
use crate::scenes::{block, neo_hookean};
use crate::solid::nodes;

/// A block of two layers under a face that nothing moves.
fn stack(width: f64, [below, above]: [(f64, Material); 2], interface: LayerInterface) -> Scenario {
    let mut scenario = block(width, below.0, below.1);
    let layer = Layer { interface, friction_coefficient: 0.0, ..Layer::new("", above.0, above.1) };
    scenario.add_layer(layer).expect("room for two");
    scenario.impactor.gap = 0.0;
    scenario
}

/// Force of a stack pressed by a hundredth of a per cent, over that of springs in series. The layers have the same width.
/// Bonded ones have a Poisson's ratio of 0, so that neither hinders the other.
pub fn series_springs(formulation: Formulation, interface: LayerInterface) -> f64 {
    let bulk = if interface == LayerInterface::Bonded { 2.0 / 3.0 } else { 2.0 };
    let (soft, hard) = (neo_hookean(1e6, bulk * 1e6), neo_hookean(4e6, bulk * 4e6));
    let heights = [8e-3, 5e-3];
    // Young's modulus, and that of plane strain, of a shear and a bulk modulus.
    let modulus = |g: f64, k: f64| match formulation {
        Formulation::Axisymmetric | Formulation::Solid => 9.0 * k * g / (3.0 * k + g),
        Formulation::PlaneStrain => 4.0 * g * (g + 3.0 * k) / (3.0 * k + 4.0 * g),
    };
    let mut scenario = stack(20e-3, [(heights[0], soft), (heights[1], hard)], interface);
    scenario.geometry.formulation = formulation;
    if formulation.is_solid() {
        scenario.geometry.length = 20e-3;
    }
    let area = match formulation {
        Formulation::Axisymmetric => std::f64::consts::PI * 10e-3 * 10e-3,
        Formulation::PlaneStrain | Formulation::Solid => 20e-3 * scenario.geometry.length,
    };
    let depth = 1e-4 * (heights[0] + heights[1]);
    let compliance = (heights[0] / modulus(1e6, bulk * 1e6) + heights[1] / modulus(4e6, bulk * 4e6)) / area;
    let mut simulation = Simulation::new(&scenario).expect("a legal scenario");
    press_slowly(&mut simulation, depth, 10e-3, 1e-3) * compliance / depth
}

const LENGTH: f64 = 0.1;
const DENSITY: f64 = 1000.0;
const SPEED: f64 = 1e-3;

/// Stress on the core behind the first wave through a bar of two materials, over that of the closed form; its upper half is a
/// quarter as stiff. The sides do not move.
pub fn transmitted(interface: LayerInterface, n: usize) -> f64 {
    wave(interface, n)[0] - 1.0
}

/// Stress on the face after the first wave has come back from the other material, over that of the closed form.
pub fn reflected(interface: LayerInterface, n: usize) -> f64 {
    wave(interface, n)[1] - 1.0
}

fn wave(interface: LayerInterface, n: usize) -> [f64; 2] {
    // The impedance of the lower part is twice that of the upper one.
    let of = |factor: f64| Material { density: DENSITY, ..neo_hookean(factor * 3e6, factor * 5e6) };
    let (upper, lower) = ((3e6_f64 * 4.0 / 3.0 + 5e6) / DENSITY, 4.0 * (3e6 * 4.0 / 3.0 + 5e6) / DENSITY);
    let (c_1, c_2) = (upper.sqrt(), lower.sqrt());
    let (z_1, z_2) = (DENSITY * c_1, DENSITY * c_2);
    let mut scenario = stack(LENGTH / 8.0, [(LENGTH, of(4.0)), (LENGTH, of(1.0))], interface);
    scenario.mesh.element_size = LENGTH / n as f64;
    let mut simulation = Simulation::new(&scenario).expect("a legal scenario");
    let area = LENGTH / 8.0 * scenario.geometry.length;
    let (to_interface, to_core) = (LENGTH / c_1, LENGTH / c_2);
    let start = 0.25 * to_interface;
    let incident = z_1 * SPEED;
    let found = simulation.with(|model, state| {
        let (mut sums, mut times) = ([0.0; 2], [0.0; 2]);
        let dt = model.constants.dt;
        while state.time(model) < 2.95 * to_interface {
            let time = state.time(model) + dt;
            let travel = if time < start { 0.5 * time * time / start } else { time - 0.5 * start };
            advance(model, state, -SPEED * travel);
            // Behind the wave at the core, where it has doubled, before the next one arrives; likewise at the face.
            let windows = [
                [to_interface + to_core + 1.2 * start, to_interface + to_core + 3.0 * start],
                [2.0 * to_interface + 1.2 * start, 2.0 * to_interface + 3.0 * start],
            ];
            let forces = [state.scalars.force.core_reaction, state.scalars.force.contact];
            for (([from, to], force), (sum, time_in)) in windows.iter().zip(forces).zip(sums.iter_mut().zip(&mut times))
            {
                if time > *from && time < *to {
                    *sum += dt * force;
                    *time_in += dt;
                }
            }
        }
        [0, 1].map(|i| sums[i] / times[i] / area)
    });
    let [core, face] = found.expect("memory of the right size");
    let (on, back) = (2.0 * z_2 / (z_1 + z_2), (z_2 - z_1) / (z_1 + z_2));
    // A fixed end doubles a wave.
    [core / (2.0 * on * incident), face / ((1.0 + 2.0 * back) * incident)]
}

fn advance(model: &Model, state: &mut State, driven_position: f64) {
    step(model, state, &StepInput { driven_position: Some(driven_position), ..StepInput::default() }).expect("a step");
    state.displacement_mut()[0].fill(0.0);
    state.velocity_mut()[0].fill(0.0);
}

const GRAVITY: f64 = 20.0;
const SLIDING: f64 = 0.2;

/// Way over which a slab slides on a bonded layer until friction stops it, over v^2 / (2 mu g), and how far it then still moves
/// in as long again, over the same.
pub fn sliding_slab(friction: f64, element_size: f64) -> [f64; 2] {
    let material = neo_hookean(4e6, 1e7);
    let mut scenario = stack(60e-3, [(4e-3, material), (6e-3, material)], LayerInterface::Frictional);
    scenario.geometry.section = Section::Full;
    scenario.core.interface = Interface::Bonded;
    (scenario.layers[1].width, scenario.layers[1].friction_coefficient) = (20e-3, friction);
    scenario.impactor.gap = 0.5;
    scenario.mesh.element_size = element_size;
    let mut simulation = Simulation::new(&scenario).expect("a legal scenario");
    let dt = simulation.constants().dt;
    let found = simulation.with(|model, state| {
        let input = StepInput { driven_position: Some(0.5), ..StepInput::default() };
        let [_, above] = model.constants.grid.interface_rows(1).expect("an interface");
        let first = above * model.constants.grid.stride();
        let accelerate = |state: &mut State, i: usize, change: f64| {
            state.velocity_mut()[i].iter_mut().skip(first).for_each(|velocity| *velocity += change);
        };
        let advance = |state: &mut State| {
            accelerate(state, 1, -GRAVITY * dt);
            step(model, state, &input).expect("a step");
        };
        for _ in 0..(5e-3 / dt) as usize {
            damp(model, state, 1.0 - dt / 0.5e-3);
            advance(state);
        }
        let start = slab(model, state);
        accelerate(state, 0, SLIDING);
        let stopping = (1.2 * SLIDING / (friction * GRAVITY) / dt) as usize;
        for _ in 0..stopping {
            advance(state);
        }
        let stopped = slab(model, state);
        // The slab still trembles: what it does in the mean is a creep.
        for _ in 0..stopping {
            advance(state);
        }
        [stopped - start, slab(model, state) - stopped]
    });
    let reference = SLIDING * SLIDING / (2.0 * friction * GRAVITY);
    found.expect("memory of the right size").map(|way| way / reference)
}

/// The same of a slab on a layer in three dimensions, 16 mm square, that slides along x and, by `SIDEWAYS` of it, along z; then how much
/// more of its way is along z, over `SIDEWAYS`, less 1.
pub fn sliding_solid_slab(friction: f64, element_size: f64) -> [f64; 3] {
    let material = neo_hookean(4e6, 1e7);
    let mut scenario = stack(48e-3, [(4e-3, material), (6e-3, material)], LayerInterface::Frictional);
    (scenario.geometry.formulation, scenario.geometry.symmetry) = (Formulation::Solid, Symmetry::Full);
    scenario.geometry.length = 16e-3;
    scenario.core.interface = Interface::Bonded;
    (scenario.layers[1].width, scenario.layers[1].friction_coefficient) = (16e-3, friction);
    scenario.impactor.gap = 0.5;
    scenario.mesh.element_size = element_size;
    let speed = SLIDING * (1.0 + SIDEWAYS * SIDEWAYS).sqrt();
    let mut simulation = Simulation::new(&scenario).expect("a legal scenario");
    let dt = simulation.constants().dt;
    let found = simulation.with(|model, state| {
        let input = StepInput { driven_position: Some(0.5), ..StepInput::default() };
        let [_, above] = model.constants.grid.interface_rows(1).expect("an interface");
        let slab: Vec<(usize, f64)> = nodes(model)
            .filter(|[_, v, _]| *v >= above)
            .map(|[u, v, w]| (model.constants.grid.node(u, v, w), model.nodal_mass(u, v, w)))
            .filter(|(_, mass)| *mass > 0.0)
            .collect();
        let mean = |state: &State| {
            let ([x, _], [z, ..]) = (state.displacement(), state.as_view().along_z(model));
            let mass: f64 = slab.iter().map(|(_, mass)| mass).sum();
            [x, z].map(|along| slab.iter().map(|(node, mass)| mass * along[*node]).sum::<f64>() / mass)
        };
        let advance = |state: &mut State| {
            slab.iter().for_each(|(node, _)| state.velocity_mut()[1][*node] -= GRAVITY * dt);
            step(model, state, &input).expect("a step");
        };
        for _ in 0..(5e-3 / dt) as usize {
            damp(model, state, 1.0 - dt / 0.5e-3);
            advance(state);
        }
        let start = mean(state);
        for (node, _) in &slab {
            state.velocity_mut()[0][*node] += SLIDING;
            state.along_z_mut(model)[1][*node] += SIDEWAYS * SLIDING;
        }
        let stopping = (1.2 * speed / (friction * GRAVITY) / dt) as usize;
        for _ in 0..stopping {
            advance(state);
        }
        let stopped = mean(state);
        for _ in 0..stopping {
            advance(state);
        }
        let way = |to: [f64; 2], from: [f64; 2]| [to[0] - from[0], to[1] - from[1]];
        (way(stopped, start), way(mean(state), stopped))
    });
    let (way, creep) = found.expect("memory of the right size");
    let reference = speed * speed / (2.0 * friction * GRAVITY);
    [way[0].hypot(way[1]) / reference, creep[0].hypot(creep[1]) / reference, way[1] / way[0] / SIDEWAYS - 1.0]
}

/// Speed along z over that along x.
const SIDEWAYS: f64 = 0.3;

/// Mean displacement of the upper layer along x, m, by mass.
fn slab(model: &Model, state: &State) -> f64 {
    let grid = &model.constants.grid;
    let [_, above] = grid.interface_rows(1).expect("an interface");
    let columns = grid.columns_of(1);
    let last = grid.node_rows() - 1;
    let (mut sum, mut total) = (0.0, 0.0);
    for v in above..=last {
        for u in columns.start..=columns.end {
            let edge = |at_edge: bool| if at_edge { 0.5 } else { 1.0 };
            let weight = edge(v == above || v == last) * edge(u == columns.start || u == columns.end);
            sum += weight * state.displacement()[0][v * grid.stride() + u];
            total += weight;
        }
    }
    sum / total
}

/// When a slab that moves down at a speed through a gap first touches the layer below, over gap / speed: from the start of the step
/// in which the force begins.
pub fn closing_gap(gap: f64) -> [f64; 2] {
    let material = neo_hookean(1e6, 4e6);
    let mut scenario = stack(20e-3, [(8e-3, material), (6e-3, material)], LayerInterface::Separating);
    (scenario.layers[1].gap, scenario.impactor.gap) = (gap, 0.5);
    let speed = 1.0;
    let mut simulation = Simulation::new(&scenario).expect("a legal scenario");
    let dt = simulation.constants().dt;
    let time = simulation.with(|model, state| {
        let [_, above] = model.constants.grid.interface_rows(1).expect("an interface");
        let first = above * model.constants.grid.stride();
        state.velocity_mut()[1].iter_mut().skip(first).for_each(|velocity| *velocity = -speed);
        let input = StepInput { driven_position: Some(0.5), ..StepInput::default() };
        let mut time = 0.0;
        loop {
            time = state.time(model).max(time);
            step(model, state, &input).expect("a step");
            if state.velocity()[1][0..first].iter().any(|velocity| velocity.abs() > 1e-6) {
                return time;
            }
        }
    });
    [time.expect("memory of the right size"), dt].map(|time| time * speed / gap)
}

/// Cells along each part of the bar.
pub const CELLS: [usize; 3] = [16, 32, 64];

/// Coefficients of friction.
pub const FRICTION: [f64; 2] = [0.1, 0.3];

/// Element size of the slab, m.
pub const ELEMENT_SIZE: f64 = 2e-3;

/// Rows of the table over `cells` along each part of a bar.
pub fn rows(cells: &[usize]) -> Vec<Row> {
    let mut rows = Vec::new();
    for (interface, name) in [(LayerInterface::Bonded, "bonded"), (LayerInterface::Separating, "separating")] {
        for (formulation, kind) in [
            (Formulation::PlaneStrain, "plane strain"),
            (Formulation::Axisymmetric, "axisymmetric"),
            (Formulation::Solid, "solid"),
        ] {
            rows.push(row(
                format!("stiffness of two layers, {name}, {kind}"),
                "springs in series",
                &["3 mm".into()],
                vec![series_springs(formulation, interface) - 1.0],
                None,
            ));
        }
        let meshes: Vec<String> = cells.iter().map(|n| format!("{n} cells")).collect();
        for (what, reference, of) in [
            ("wave into twice the impedance", "2 Z_2 / (Z_1 + Z_2)", transmitted as fn(LayerInterface, usize) -> f64),
            ("wave back from twice the impedance", "(Z_2 - Z_1) / (Z_1 + Z_2)", reflected),
        ] {
            let errors: Vec<f64> = cells.iter().map(|n| of(interface, *n)).collect();
            let order = over_cells(cells, &errors);
            rows.push(row(format!("{what}, {name}"), reference, &meshes, errors, Some(order)));
        }
    }
    for friction in FRICTION {
        let error = sliding_slab(friction, ELEMENT_SIZE)[0] - 1.0;
        let quantity = format!("stopping distance of a slab, friction {friction}");
        rows.push(row(quantity, "v^2 / (2 mu g), rigid", &["2 mm".into()], vec![error], None));
    }
    let [way, _, aside] = sliding_solid_slab(FRICTION[1], ELEMENT_SIZE);
    for (of, reference, error) in [
        ("stopping distance of", "v^2 / (2 mu g), rigid", way - 1.0),
        ("direction of the way of", "that of its velocity", aside),
    ] {
        let quantity = format!("{of} a solid slab that slides aslant, friction {}", FRICTION[1]);
        rows.push(row(quantity, reference, &["2 mm".into()], vec![error], None));
    }
    rows
}

fn row(quantity: String, reference: &str, meshes: &[String], errors: Vec<f64>, order: Option<f64>) -> Row {
    Row { problem: "interface", quantity, reference: reference.into(), meshes: meshes.into(), errors, order }
}
