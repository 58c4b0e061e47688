use softanvil_kernel::error::Says;

use super::*;

const NAN: f64 = f64::NAN;

fn number(name: &str) -> u32 {
    Parameter::find(name).unwrap().number()
}

/// Same numbers, those that are none included.
fn same(a: [f64; 3], b: [f64; 3]) -> bool {
    a.into_iter().zip(b).all(|(a, b)| a == b || a.is_nan() && b.is_nan())
}

/// A failure, and what C learns of it: status; value, smallest and largest; parameter to blame; first words of the text.
type Row = (Failure, Status, [f64; 3], Option<&'static str>, &'static str);

fn check(rows: &[Row]) {
    for (failure, status, numbers, parameter, text) in rows {
        assert_eq!(failure.status(), *status, "{failure}");
        assert!(same(failure.numbers(), *numbers), "{failure}: {:?}", failure.numbers());
        assert_eq!(failure.parameter(), parameter.map_or(u32::MAX, number), "{failure}");
        assert!(failure.to_string().starts_with(text), "{failure}");
    }
}

#[test]
fn arguments_are_told_with_what_is_legal() {
    let argument = "size";
    check(&[
        (Failure::Null { argument }, Status::NullPointer, [NAN; 3], None, "size is a null pointer"),
        (
            Failure::Misaligned { argument, alignment: 64 },
            Status::Misaligned,
            [NAN; 3],
            None,
            "size is misaligned: expected a multiple of 64 bytes",
        ),
        (
            Failure::Short { argument, given: 3, needed: 4 },
            Status::ShortBuffer,
            [3.0, 4.0, NAN],
            None,
            "size has 3 bytes: expected at least 4 bytes",
        ),
        (
            Failure::Long { argument, given: usize::MAX },
            Status::ShortBuffer,
            [usize::MAX as f64, NAN, isize::MAX as f64],
            None,
            "size has 18446744073709551615 bytes: expected at most 9223372036854775807 bytes",
        ),
        (
            Failure::Uninitialised { argument },
            Status::Uninitialised,
            [NAN; 3],
            None,
            "size was not initialised by this library",
        ),
        (
            Failure::UnknownId { argument: "output", id: 9, largest: 7 },
            Status::UnknownId,
            [9.0, 0.0, 7.0],
            None,
            "output 9 is unknown: expected one of the table, up to 7",
        ),
        (
            Failure::RetiredId { argument: "output", id: 9 },
            Status::UnknownId,
            [9.0, NAN, NAN],
            None,
            "output 9 is retired",
        ),
        (Failure::UnknownName { argument: "name" }, Status::UnknownName, [NAN; 3], None, "name is not in the table"),
        (
            Failure::ReservedSlot { array: "layer", slot: 99, value: 2.5 },
            Status::ReservedSlot,
            [2.5, 0.0, 0.0],
            None,
            "layer[99] = 2.5 is refused",
        ),
        (
            Failure::Time { time: 3.0, min: 1.0, max: 2.0 },
            Status::IllegalTime,
            [3.0, 1.0, 2.0],
            None,
            "time 3 s is refused: expected 1 s, half a step before the present, to 2 s",
        ),
    ]);
}

#[test]
fn scenarios_are_told_with_the_parameter_to_blame() {
    let name = Parameter::find("layers[1].c10").unwrap().name();
    let (value, unit) = (2.5, "Pa");
    let no_effect = NoEffect { name, value, unit, by: "layers.count".into(), says: Says::Number(1.0) };
    let parameter = ParameterError { name, value, unit, min: 3.0, max: 4.0 };
    let names = ["impactor.drop_height".into(), "impactor.drop_energy".into()];
    let of = Failure::Scenario;
    check(&[
        (
            parameter.into(),
            Status::IllegalValue,
            [2.5, 3.0, 4.0],
            Some("layers[1].c10"),
            "layers[1].c10 = 2.5 Pa is refused: expected 3 to 4 Pa",
        ),
        (
            of(ScenarioError::NoEffect(no_effect)),
            Status::NoEffect,
            [2.5, NAN, NAN],
            Some("layers[1].c10"),
            "layers[1].c10 = 2.5 Pa has no effect: layers.count is 1",
        ),
        (
            of(ScenarioError::Contradiction { names }),
            Status::Contradiction,
            [NAN; 3],
            Some("impactor.drop_energy"),
            "impactor.drop_height and impactor.drop_energy state the same thing",
        ),
        (
            of(ScenarioError::LayerThickness { layer: 2, thickness: 1.0, minimum: 2.0 }),
            Status::LayerThickness,
            [1.0, 2.0, NAN],
            Some("layers[2].thickness"),
            "layers[2].thickness = 1 m is refused: expected at least 2 m",
        ),
        (
            of(ScenarioError::PronySum { layer: 0, sum: 1.25 }),
            Status::PronySum,
            [1.25, 0.0, 1.0],
            None,
            "layers[0].prony_g_1 to _5 sum to 1.25",
        ),
        (
            of(ScenarioError::ShearModulus { layer: 0, coefficients: "c10 gives", modulus: -2.0 }),
            Status::ShearModulus,
            [-2.0, 0.0, NAN],
            None,
            "layers[0].c10 gives a shear modulus of -2 Pa",
        ),
        (
            of(ScenarioError::FaceTooSmall { name: "impactor.face_diameter", width: 1.0, minimum: 2.0 }),
            Status::FaceTooSmall,
            [1.0, 2.0, NAN],
            Some("impactor.face_diameter"),
            "impactor.face_diameter = 1 m is refused: expected at least 2 m",
        ),
        (
            of(ScenarioError::FullAxisymmetric),
            Status::FullAxisymmetric,
            [NAN; 3],
            Some("geometry.section"),
            "geometry.section = full is refused",
        ),
        (
            of(ScenarioError::OffsetOfHalf { offset: 0.5 }),
            Status::OffsetOfHalf,
            [0.5, 0.0, 0.0],
            Some("impactor.offset"),
            "impactor.offset = 0.5 m is refused",
        ),
        (
            of(ScenarioError::TearStretch { layer: 3, stretch: 0.5 }),
            Status::TearStretch,
            [0.5, 1.0, NAN],
            Some("layers[3].tear_stretch"),
            "layers[3].tear_stretch = 0.5 is refused",
        ),
        (
            of(ScenarioError::LayerWidth { layer: 1, width: 0.5, maximum: 0.25 }),
            Status::LayerWidth,
            [0.5, 0.0, 0.25],
            Some("layers[1].width"),
            "layers[1].width = 0.5 m is refused: expected at most 0.25 m",
        ),
        (
            of(ScenarioError::WithoutPads { name: Name::of_layer(1, "law") }),
            Status::WithoutPads,
            [NAN; 3],
            Some("layers[1].law"),
            "layers[1].law is refused: expected a kernel that was built with its feature pads",
        ),
        (
            of(ScenarioError::NotInSolid { name: "impactor.shape".into(), expected: "round or rectangular" }),
            Status::NotInSolid,
            [NAN; 3],
            Some("impactor.shape"),
            "impactor.shape is refused: expected round or rectangular with geometry.formulation = solid",
        ),
    ]);
    // A scenario that the model refuses is told as a scenario.
    assert_eq!(Failure::from(ModelError::Scenario(parameter.into())), parameter.into());
}

#[test]
fn models_are_told_with_their_limits() {
    let memory = MemoryError { what: "nodes", given: 10, needed: 20 };
    check(&[
        (
            ModelError::TooManyCells { cells: 1e9, max: 1000 }.into(),
            Status::TooManyCells,
            [1e9, 1.0, 1000.0],
            Some("mesh.element_size"),
            "mesh.element_size asks for 1000000000 cells",
        ),
        (
            ModelError::StepTooSmall { step: 1.0, smallest: 2.0, stretch: 0.0213 }.into(),
            Status::StepTooSmall,
            [1.0, 2.0, NAN],
            None,
            "the stable time step is 1 s with a cell pressed to 2.2 % of its size (less energy or depth, or a thicker or stiffer layer, allows more): expected at least 2 s",
        ),
        (
            ModelError::StepTooLarge { step: 2.0, limit: 1.0 }.into(),
            Status::StepTooLarge,
            [2.0, 0.0, 1.0],
            Some("time.step"),
            "time.step = 2 s is refused",
        ),
        (ModelError::NoArea { element: 3 }.into(), Status::NoArea, [NAN; 3], None, "element 3 has no area"),
        (memory.into(), Status::ShortBuffer, [10.0, 20.0, NAN], None, ""),
    ]);
}

#[test]
fn steps_are_told_with_their_place_and_time() {
    let name = Parameter::find("impactor.gap").unwrap().name();
    let error = ParameterError { name, value: 9.0, unit: "m", min: 3.0, max: 4.0 };
    let inverted = StepError::Inverted { element: 5, time: 0.25 };
    let unstable = StepError::Unstable { element: 6, time: 0.5, limit: 1e-6, step: 2e-6 };
    let input = StepError::Input { error, time: 0.75 };
    let memory = StepError::Memory(MemoryError { what: "nodes", given: 10, needed: 20 });
    check(&[
        (inverted.into(), Status::Inverted, [NAN; 3], None, "element 5 is inverted or not finite at 0.25 s"),
        (unstable.into(), Status::Unstable, [2e-6, 0.0, 1e-6], None, "the time step of 0.000002 s is above"),
        (input.into(), Status::IllegalInput, [9.0, 3.0, 4.0], None, "impactor.gap = 9 m is refused"),
        (memory.into(), Status::ShortBuffer, [10.0, 20.0, NAN], None, ""),
    ]);
    let place = |error: StepError| Failure::from(error).place();
    assert_eq!([place(inverted), place(unstable), place(input)], [(5, 0.25), (6, 0.5), (u32::MAX, 0.75)]);
    let (element, time) = place(memory);
    assert!(element == u32::MAX && time.is_nan());
}

#[test]
fn snapshots_are_told_apart() {
    check(&[
        (
            SnapshotError::Length { given: 8, needed: 16 }.into(),
            Status::ShortBuffer,
            [8.0, 16.0, NAN],
            None,
            "bytes has 8 bytes: expected at least 16 bytes",
        ),
        (SnapshotError::Format.into(), Status::SnapshotFormat, [NAN; 3], None, "the bytes are not a snapshot"),
        (
            SnapshotError::Version { given: 5, expected: 6 }.into(),
            Status::SnapshotFormat,
            [5.0, 6.0, 6.0],
            None,
            "the snapshot has format version 5: expected 6",
        ),
        (SnapshotError::Foreign.into(), Status::SnapshotForeign, [NAN; 3], None, "the snapshot belongs to"),
        (SnapshotError::Corrupt.into(), Status::SnapshotCorrupt, [NAN; 3], None, "the snapshot's checksum"),
        (SnapshotError::Failed.into(), Status::SnapshotFailed, [NAN; 3], None, "the state has failed"),
    ]);
}
