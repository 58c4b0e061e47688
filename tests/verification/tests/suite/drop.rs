//! The study's drops: conservation of energy and momentum, impenetrability, convergence, repeatability.

use softanvil_kernel::cfc::{Coefficients, Filter};
use softanvil_kernel::state::{restore, save, snapshot_size};
use softanvil_kernel::{Output, SAMPLING_INTERVAL, Simulation, SnapshotError, StepInput, preset, step};
use softanvil_verification::scenes::{ENERGIES, study_drop};
use softanvil_verification::tolerance::{ENERGY_RESIDUAL, MESH, MOMENTUM, PENETRATION, ROW_MOMENTUM, relative_error};

/// Source: conservation of energy; elastic energy from its potential against the work of the nodal forces.
#[test]
fn energy_is_accounted_for_at_every_step() {
    for energy in ENERGIES {
        let mut scenario = preset::study();
        scenario.impactor = scenario.impactor.with_energy(energy);
        // The preset has no slider.
        (scenario.layers[0].material.slider_stiffness, scenario.layers[0].material.slider_yield_stress) = (1e6, 10e3);
        let mut simulation = Simulation::new(&scenario).expect("a legal scenario");
        let steps = simulation.constants().steps_in(scenario.time.duration);
        let mut largest = 0.0_f64;
        for _ in 0..steps {
            simulation.step(1, &StepInput::default()).expect("a stable run");
            largest = largest.max(simulation.scalars().energy.residual().abs());
        }
        assert!(largest < ENERGY_RESIDUAL * energy, "{energy} J: residual {largest} J");
        let ledger = simulation.scalars().energy;
        for (name, value) in [
            ("elastic", ledger.elastic),
            ("viscous", ledger.viscous),
            ("slider", ledger.slider_dissipation),
            ("friction", ledger.friction),
            ("contact", ledger.contact),
        ] {
            assert!(value > 0.0, "{energy} J: {name} energy {value} J");
        }
    }
}

/// Source: conservation of momentum, impulse = m (v0 + v1) + m g T over the time of contact.
#[test]
fn impulse_balances_momentum() {
    for energy in ENERGIES {
        let simulation = study_drop(energy, 3e-3);
        let impactor = simulation.constants().scenario.impactor;
        let metrics = simulation.scalars().metrics;
        let momentum = impactor.mass * (metrics.impact_speed + metrics.rebound_speed)
            + impactor.mass * impactor.gravity * metrics.contact_time;
        let error = relative_error(metrics.impulse, momentum);
        assert!(error < MOMENTUM, "{energy} J: impulse {} N s against {momentum} N s", metrics.impulse);
    }
}

/// Source: conservation of momentum, m v = m v0 + impulse - m g t, and the definition of kinetic energy. All outputs of a
/// row belong to one time, at every step.
#[test]
fn the_outputs_of_a_row_belong_to_one_time() {
    let mut simulation = Simulation::new(&preset::study()).expect("a legal scenario");
    let impactor = simulation.constants().scenario.impactor;
    let start = impactor.mass * impactor.start_speed();
    for _ in 0..simulation.constants().steps_in(15e-3) {
        simulation.step(1, &StepInput::default()).expect("a stable run");
        let read = |name| (Output::find(name).expect("an output").read)(simulation.constants(), simulation.scalars());
        let (velocity, time) = (read("impactor.velocity"), simulation.time());
        let momentum = read("result.impulse") - start - impactor.mass * impactor.gravity * time;
        assert!((impactor.mass * velocity - momentum).abs() < ROW_MOMENTUM * start, "{time} s");
        assert_eq!(read("energy.impactor_kinetic"), 0.5 * impactor.mass * velocity * velocity);
    }
}

/// Nothing passes the face, at any step, up to five times the energy of the highest drop.
#[test]
fn nodes_do_not_pass_the_face() {
    for energy in [4.9, 14.7, 5.0 * 14.7] {
        let mut scenario = preset::study();
        scenario.impactor = scenario.impactor.with_energy(energy);
        let mut simulation = Simulation::new(&scenario).expect("a legal scenario");
        let steps = simulation.constants().steps_in(scenario.time.duration);
        let deepest = simulation
            .with(|model, state| {
                let grid = model.constants.grid;
                let top = grid.n_v * grid.stride();
                let mut deepest = 0.0_f64;
                for _ in 0..steps {
                    step(model, state, &StepInput::default()).expect("a stable run");
                    let face = model.constants.top_height + state.scalars.impactor.position;
                    for node in top..=top + grid.n_u {
                        let height = model.reference_position()[1][node] + state.displacement()[1][node];
                        deepest = deepest.max(height - face);
                    }
                }
                deepest
            })
            .expect("memory of the right size");
        let limit = PENETRATION * scenario.mesh.element_size;
        assert!(deepest <= limit, "{energy} J: {deepest} m above the face");
    }
}

/// Peak force and deformation are numbers of the problem, not of the mesh.
#[test]
fn default_mesh_agrees_with_one_twice_as_fine() {
    for energy in ENERGIES {
        let coarse = study_drop(energy, 3e-3).scalars().metrics;
        let fine = study_drop(energy, 1.5e-3).scalars().metrics;
        for (name, a, b) in [
            ("peak force", coarse.peak_force, fine.peak_force),
            ("deformation", coarse.max_deformation, fine.max_deformation),
        ] {
            assert!(relative_error(a, b) < MESH, "{energy} J: {name} {a} against {b}");
        }
    }
}

/// A run from a restored snapshot gives the bits of the run that was not interrupted.
#[test]
fn snapshots_continue_with_the_same_bits() {
    let scenario = preset::study();
    let whole = study_drop(14.7, scenario.mesh.element_size);
    for part in [0, 1, 997, 2000] {
        let mut first = Simulation::new(&scenario).expect("a legal scenario");
        let steps = first.constants().steps_in(scenario.time.duration);
        first.step(part, &StepInput::default()).expect("a stable run");
        let mut bytes = vec![0; snapshot_size(first.constants())];
        first.with(|model, state| save(model, state, &mut bytes)).expect("memory").expect("a snapshot");

        let mut second = Simulation::new(&scenario).expect("a legal scenario");
        second.step(321, &StepInput::default()).expect("a stable run");
        second.with(|model, state| restore(model, state, &bytes)).expect("memory").expect("a snapshot of this model");
        assert_eq!(second.scalars(), first.scalars());
        second.step(steps - part, &StepInput::default()).expect("a stable run");
        assert_eq!(second.scalars(), whole.scalars(), "restored after {part} steps");
    }
}

/// Damaged, truncated and foreign snapshots are refused and change nothing.
#[test]
fn snapshots_are_checked() {
    let scenario = preset::study();
    let mut simulation = Simulation::new(&scenario).expect("a legal scenario");
    simulation.step(100, &StepInput::default()).expect("a stable run");
    let before = *simulation.scalars();
    let mut bytes = vec![0; snapshot_size(simulation.constants())];
    simulation.with(|model, state| save(model, state, &mut bytes)).expect("memory").expect("a snapshot");

    let mut other = scenario;
    other.impactor.mass = 4.0;
    let mut foreign = Simulation::new(&other).expect("a legal scenario");
    assert!(foreign.with(|model, state| restore(model, state, &bytes)).expect("memory").is_err());

    for flip in [0, 8, 16, 24, 40, bytes.len() / 2, bytes.len() - 1] {
        let mut damaged = bytes.clone();
        damaged[flip] ^= 1;
        let result = simulation.with(|model, state| restore(model, state, &damaged)).expect("memory");
        assert!(result.is_err(), "byte {flip} flipped");
    }
    let truncated = &bytes[..bytes.len() - 8];
    assert!(simulation.with(|model, state| restore(model, state, truncated)).expect("memory").is_err());
    assert_eq!(*simulation.scalars(), before);
}

/// A snapshot belongs to a model with the same nodes, not only with the same parameters.
#[test]
fn a_snapshot_of_other_nodes_is_foreign() {
    let mut scenario = preset::study();
    scenario.mesh.element_size = 5e-3;
    let mut simulation = Simulation::new(&scenario).expect("a legal scenario");
    let (rest, stride) = simulation
        .with(|model, _| (model.reference_position().map(<[f64]>::to_vec), model.constants.grid.stride()))
        .expect("memory of the right size");
    let moved = |by: [f64; 2]| {
        let rest = rest.clone();
        Simulation::with_positions(&scenario, &move |u, v| {
            let node = v * stride + u;
            // One node in the middle of the layer.
            let at = if (u, v) == (2, 1) { by } else { [0.0; 2] };
            [rest[0][node] + at[0], rest[1][node] + at[1]]
        })
        .expect("a legal mesh")
    };
    let mut bytes = vec![0; snapshot_size(simulation.constants())];
    simulation.step(10, &StepInput::default()).expect("a stable run");
    simulation.with(|model, state| save(model, state, &mut bytes)).expect("memory").expect("a snapshot");
    let restored = |by| moved(by).with(|model, state| restore(model, state, &bytes)).expect("memory");
    assert_eq!(restored([0.0; 2]), Ok(()));
    for by in [[1e-12, 0.0], [0.0, -1e-12], [1e-4, 1e-4]] {
        assert_eq!(restored(by), Err(SnapshotError::Foreign), "{by:?}");
    }
}

/// Durations are rounded up to whole samples, of which none is lost or added to rounding, in a minute and more.
#[test]
fn a_duration_has_as_many_samples_as_it_is_long() {
    let simulation = Simulation::new(&preset::study()).expect("a legal scenario");
    let per_sample = u64::from(simulation.constants().steps_per_sample);
    let samples = |duration| simulation.constants().steps_in(duration) / per_sample;
    for whole in (0..3000).chain((3000..2_000_000).step_by(997)) {
        let duration = whole as f64 / 20e3;
        assert_eq!((samples(duration), samples(50e-6 * whole as f64)), (whole, whole), "{duration} s");
        assert_eq!(samples(duration + 1e-6), whole + 1, "{duration} s and a little");
    }
}

/// Reset gives the bits of a new simulation.
#[test]
fn reset_starts_anew() {
    let mut simulation = study_drop(14.7, 3e-3);
    let first = *simulation.scalars();
    simulation.reset().expect("memory of the right size");
    let steps = first.step_index;
    simulation.step(steps, &StepInput::default()).expect("a stable run");
    assert_eq!(*simulation.scalars(), first);
}

/// Source: the definition; the filter itself is checked beside it, against SciPy and the standard's corridor.
#[test]
fn the_filtered_force_is_the_forward_pass_over_the_samples() {
    let mut scenario = preset::study();
    scenario.measurement.channel_class = 180.0;
    let mut simulation = Simulation::new(&scenario).expect("a legal scenario");
    let per_sample = u64::from(simulation.constants().steps_per_sample);
    let coefficients = Coefficients::new(180.0, SAMPLING_INTERVAL).expect("a legal class");
    let mut filter = Filter::settled(0.0);
    for _ in 0..300 {
        simulation.step(per_sample, &StepInput::default()).expect("a stable run");
        let expected = filter.take(&coefficients, simulation.scalars().sampler.last.contact_force);
        let output = Output::find("contact.force_filtered").expect("an output");
        assert_eq!((output.read)(simulation.constants(), simulation.scalars()).to_bits(), expected.to_bits());
    }
    assert!(filter.value() != simulation.scalars().sampler.last.contact_force);
}
