//! What edited files make of every reader of the command line: refused in words, or understood; never a panic. Used by the
//! fuzzer (`tools/fuzz`) and by a test that tries some thousands of them (`tools/tests/suite/fuzz.rs`).

mod archive;
mod edits;
mod seeds;

use arbitrary::{Result, Unstructured};
use softanvil_identify::data::curve::{self, Direction};
use softanvil_identify::data::cycles::{self, Selection};
use softanvil_identify::data::specimen::Specimen;
use softanvil_identify::export::{Layer, abaqus, c_source, ls_dyna, ssv};
use softanvil_identify::relaxation::prony::Relaxation;
use softanvil_identify::relaxation::read as relaxation;
use softanvil_kernel::parameter::{Kind, Values};
use softanvil_kernel::{Parameter, Scenario, preset};
use softanvil_records::series::Table;
use softanvil_records::sheet::{self, Layout};
use softanvil_records::trace::{self, Options};
use softanvil_tools::calibration::problem::Problem;
use softanvil_tools::calibration::uncertainty::posterior::Posterior;
use softanvil_tools::measurement::measured::Measured;
use softanvil_tools::{scenario_file, sweep};

use edits::{edited, edited_text};

/// A target: its name, and what it does with its input.
pub type Target = (&'static str, fn(&[u8]));

/// Every target.
pub const TARGETS: [Target; 8] = [
    ("scenario_file", scenario_file),
    ("scenario_values", scenario_values),
    ("problem_file", problem_file),
    ("sweep_file", sweep_file),
    ("posterior_file", posterior_file),
    ("trace", trace),
    ("material_test", material_test),
    ("material_card", material_card),
];

/// Does what `target` asks for; choices that run out end it.
fn with(data: &[u8], target: impl FnOnce(&mut Unstructured) -> Result<()>) {
    let _ = target(&mut Unstructured::new(data));
}

/// An error is one message that says something.
fn told<T, E: std::fmt::Display>(result: std::result::Result<T, E>) -> Option<T> {
    result.map_err(|error| assert!(!error.to_string().trim().is_empty(), "an error without a message")).ok()
}

/// A scenario that was read is legal, and written and read again it is the same.
fn assert_whole(scenario: &Scenario) {
    assert_eq!(scenario.validate(), Ok(()));
    let text = scenario_file::to_toml(scenario);
    let again = scenario_file::parse(&text, &preset::study()).unwrap_or_else(|error| panic!("{error}\n{text}"));
    for parameter in Parameter::of(scenario).filter(|parameter| parameter.without_effect(scenario).is_none()) {
        let [first, second] = [scenario, &again].map(|scenario| parameter.get(scenario));
        assert_eq!(first.to_bits(), second.to_bits(), "{}: {first} and {second}\n{text}", parameter.name());
    }
}

/// A scenario file, and a material file.
pub fn scenario_file(data: &[u8]) {
    with(data, |choices| {
        let bases = [preset::study(), preset::natural_rubber()];
        let base = choices.choose(&bases)?;
        let text = edited_text(seeds::scenarios(), choices)?;
        if let Some(scenario) = told(scenario_file::parse(&text, base)) {
            assert_whole(&scenario);
        }
        told(scenario_file::parse_material(&text, base));
        Ok(())
    });
}

/// A scenario file whose keys are right and whose values are anything.
pub fn scenario_values(data: &[u8]) {
    with(data, |choices| {
        let mut values = Values::of(&preset::study());
        for _ in 0..choices.int_in_range(1..=12)? {
            let parameter = Parameter::all().nth(choices.int_in_range(0..=Parameter::COUNT - 1)?).unwrap();
            let _ = values.set(parameter, value(&parameter, choices)?);
        }
        let scenario = values.scenario();
        let text = scenario_file::to_toml(&scenario);
        match scenario.validate() {
            Ok(()) => assert_whole(&scenario),
            Err(error) => {
                let refused = scenario_file::parse(&text, &preset::study());
                assert!(refused.is_err(), "{error}, and yet the file is read:\n{text}");
            }
        }
        Ok(())
    });
}

/// A value of a parameter: in its range or a little outside, at an end, or any number.
fn value(parameter: &Parameter, choices: &mut Unstructured) -> Result<f64> {
    let (min, max) = parameter.range();
    let part = f64::from(choices.arbitrary::<u16>()?) / f64::from(u16::MAX);
    Ok(match (choices.int_in_range(0..=7)?, parameter.kind()) {
        (0, _) => f64::from_bits(choices.arbitrary()?),
        (1, _) => [min, max, min.next_down(), max.next_up()][choices.int_in_range(0..=3)?],
        (_, Kind::Choice { labels }) => (part * labels.len() as f64).floor(),
        (_, Kind::Count) => (min + part * (max.min(100.0) - min)).round(),
        (2, _) => min + part * (max - min),
        _ => parameter.get(&preset::study()) * (0.2 + 2.0 * part),
    })
}

/// A problem file of `calibrate`; the files that it names stand in the folder of the project's own.
pub fn problem_file(data: &[u8]) {
    with(data, |choices| {
        let folder = seeds::root().join("calibration");
        if let Some(problem) = told(Problem::parse(&edited_text(seeds::problems(), choices)?, &folder)) {
            assert!(!problem.variables.is_empty() && problem.scenario.validate().is_ok());
            assert_eq!(problem.digest().len(), 16);
        }
        Ok(())
    });
}

/// A file of `sweep`.
pub fn sweep_file(data: &[u8]) {
    with(data, |choices| {
        let read = sweep::file::parse(&edited_text(seeds::sweeps(), choices)?, &preset::study());
        if let Some(sweep) = told(read) {
            for level in sweep.axes.iter().flat_map(|axis| &axis.levels) {
                if let Some(scenario) = told(sweep::axis::combined(&preset::study(), &[level])) {
                    assert_eq!(scenario.validate(), Ok(()));
                }
            }
        }
        Ok(())
    });
}

/// A posterior.
pub fn posterior_file(data: &[u8]) {
    with(data, |choices| {
        if let Some(posterior) = told(Posterior::parse(&edited_text(seeds::posteriors(), choices)?)) {
            told(posterior.check_belongs(&preset::study()));
            for count in [1, posterior.count(), 7] {
                assert!(!posterior.samples(count).is_empty());
            }
        }
        Ok(())
    });
}

/// A table of measured data: text, or a sheet of a workbook.
fn table(seeds: &[Vec<u8>], choices: &mut Unstructured) -> Result<Vec<u8>> {
    match choices.int_in_range(0..=7)? {
        0 => Ok(archive::workbook(&edited_text(seeds::sheets(), choices)?)),
        _ => edited(seeds, choices),
    }
}

/// A trace of an impact, from what instruments write.
pub fn trace(data: &[u8]) {
    with(data, |choices| {
        let mut options = Options::default();
        let open: u8 = choices.arbitrary()?;
        if open & 1 != 0 {
            options.rate = Some(1e4);
        }
        if open & 2 != 0 {
            options.force = "2 [N]".parse().ok();
        }
        if open & 4 != 0 {
            options.mass = Some(5.0);
        }
        if open & 8 != 0 {
            options.impact = Some(usize::from(open >> 4));
        }
        let bytes = table(seeds::traces(), choices)?;
        if let Some(trace) = told(trace::read("x", &bytes, &options, None)) {
            assert!(trace.times.len() == trace.forces.len() && trace.times.is_sorted());
            assert!(trace.times.iter().chain(&trace.forces).all(|value| value.is_finite()));
        }
        told(Measured::of("x", &bytes, &options, &preset::study().impactor));
        if let Some(sheet) = told(sheet::parse(&bytes, &Layout::default())) {
            told(Table::new(sheet, None));
        }
        Ok(())
    });
}

/// Files of `fit`: a curve and a relaxation.
pub fn material_test(data: &[u8]) {
    with(data, |choices| {
        let open: u8 = choices.arbitrary()?;
        let length = (open & 1 != 0).then_some(10e-3);
        let specimen = Specimen { height: length, area: length.map(|_| 1e-4) };
        let direction = [None, Some(Direction::Tension), Some(Direction::Compression)][usize::from(open >> 1) % 3];
        let options = curve::Options { specimen, direction, shear: open & 64 != 0, ..curve::Options::default() };
        let bytes = table(seeds::material_tests(), choices)?;
        if let Some(curve) = told(curve::read("x", &bytes, &options)) {
            for repeat in &curve.repeats {
                let points = &repeat.points;
                assert!(points.iter().all(|point| point.stretch.is_finite() && point.stress.is_finite()));
                told(cycles::select(points, Selection::default(), &mut Vec::new()));
            }
        }
        let options = relaxation::Options { specimen, strain: length.map(|_| -0.1), ..relaxation::Options::default() };
        if let Some(test) = told(relaxation::read(&bytes, &options, None)) {
            let Relaxation { times, loads, .. } = &test.relaxation;
            assert!(times.len() == loads.len() && times.iter().chain(loads).all(|value| value.is_finite()));
        }
        Ok(())
    });
}

/// A material in the words of other programs, read back.
pub fn material_card(data: &[u8]) {
    with(data, |choices| {
        let text = edited_text(seeds::cards(), choices)?;
        let layer = Layer { place: 0, name: "silicone".into() };
        told(abaqus::read(&text));
        told(ls_dyna::read(&text));
        told(ssv::read(&text, &layer));
        told(c_source::read(&text, &layer));
        Ok(())
    });
}
