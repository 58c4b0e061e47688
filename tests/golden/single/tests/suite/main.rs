//! The golden traces in single precision: reproduced, near those in double precision, and apart from them.

use softanvil_golden::run as double;
use softanvil_golden_f32::{Checker, Header, Memory, Run, SCENES, Scene, run::Failure};

/// Most by which the force of a record may differ from that in double precision, over the largest of the scene. It is that
/// of one step, and a driven face jolts: the last digit of its position (2e-10 m) over a step is 1e-4 m/s, which some ten
/// grams of layer answer with some newtons of a thousand.
const FORCE: f64 = 1e-2;
/// The same of the position: gravity adds the same to the velocity in every step and is rounded in the same direction. At
/// 2 m/s that is up to 1.2e-7 m/s a step, so up to 3e-4 m/s after 2400 steps, over 15 ms half a thousandth of a layer's
/// depth and more.
const POSITION: f64 = 1e-3;

#[test]
fn the_kernel_states_the_digest_of_the_traces() {
    let digest = softanvil_golden_f32::scenes::digest(SCENES.iter().filter_map(Scene::last_state));
    assert_eq!(softanvil_kernel::KERNEL_DIGEST, digest, "kernel/src/identity.rs: {digest:#018x}");
}

#[test]
fn every_scene_gives_the_bits_of_its_trace() {
    let mut memory = Box::new(Memory::new());
    for scene in SCENES {
        let mut run = Run::new(scene, &mut memory).unwrap();
        assert!(scene.trace.starts_with(&Header::new(scene, &run.model).to_string()), "{}", scene.name);
        let mut golden = Checker::new(scene.trace);
        assert_eq!(golden.check(&run.record()), Ok(()), "{}", scene.name);
        while let Some(record) = run.advance().unwrap() {
            assert_eq!(golden.check(&record), Ok(()), "{}", scene.name);
        }
        assert!(!golden.has_more(), "{}", scene.name);
    }
}

#[test]
fn every_scene_follows_double_precision() {
    for scene in SCENES {
        let double = softanvil_golden::Scene::find(scene.name).unwrap();
        let [double, single] = [double.trace, scene.trace].map(columns);
        assert_eq!(double.len(), single.len(), "{}", scene.name);
        let largest = |column: usize| double.iter().map(|line| line[column].abs()).fold(0.0, f64::max);
        let scale = [largest(1), largest(2)];
        let mut most = [0.0_f64; 2];
        for (double, single) in double.iter().zip(&single) {
            assert_eq!(double[0], single[0], "{}", scene.name);
            for i in 0..2 {
                most[i] = most[i].max((single[1 + i] - double[1 + i]).abs() / scale[i]);
            }
        }
        println!("{:16} force {:.1e}, position {:.1e}", scene.name, most[0], most[1]);
        assert!(most[0] > 0.0 && most[0] <= FORCE && most[1] <= POSITION, "{}: {most:?}", scene.name);
    }
}

/// Step, force and position of a trace's lines.
fn columns(trace: &str) -> Vec<[f64; 3]> {
    let lines = trace.lines().filter(|line| !line.starts_with('#'));
    lines
        .map(|line| {
            let mut numbers = line.split_whitespace().map(|word| word.parse().unwrap());
            std::array::from_fn(|_| numbers.next().unwrap())
        })
        .collect()
}

/// A state saved in one precision is refused in the other.
#[test]
fn snapshots_do_not_cross_precisions() {
    let mut bytes = vec![0; softanvil_golden::memory::SNAPSHOT];
    let (mut memory, mut memory_double) = (Box::new(Memory::new()), Box::new(softanvil_golden::Memory::new()));
    let mut single = Run::new(Scene::find("yeoh").unwrap(), &mut memory).unwrap();
    let scene = softanvil_golden::Scene::find("yeoh").unwrap();
    let mut double = double::Run::new(scene, &mut memory_double).unwrap();
    let refused = single.restore(double.save(&mut bytes).unwrap()).unwrap_err();
    assert!(matches!(refused, Failure::Snapshot(_)) && refused.to_string().contains("different model"), "{refused}");
    let refused = double.restore(single.save(&mut bytes).unwrap()).unwrap_err();
    assert!(matches!(refused, double::Failure::Snapshot(_)), "{refused}");
    assert!(refused.to_string().contains("different model"), "{refused}");
}
