//! Traces as instruments and people write them: each gives the numbers of the first, or is refused with the reason.

use serde_json::json;
use softanvil_records::channel::Filter;
use softanvil_records::trace::{self, Options};

use crate::common::{EXPECTED, assert_impact, half_sine, impact, read, refusal, rows};

fn ok() -> String {
    "time [s],force [N]\n".to_string() + &rows(|_, t, f| format!("{t:.5},{f:.3}"))
}

fn comma(text: String) -> String {
    text.replace('.', ",")
}

#[test]
fn the_same_impact_in_many_layouts() {
    let g = |force: f64| force / 5.0 / 9.80665;
    let kn = |_, t: f64, f: f64| format!("{:.3},{:.6}", 1e3 * t, f / 1e3);
    let layouts = [
        ("plain", ok()),
        ("a byte order mark", format!("\u{feff}{}", ok())),
        ("a comment", format!("# drop 3, 5 kg\n{}", ok())),
        ("a footer", format!("{}Max,4000\n", ok())),
        ("a footer of several lines", format!("{}\nMaximum,4000\nMean,1.0,2.0\nend of test\n", ok())),
        ("ms and kN", "Time (ms),Force (kN)\n".to_string() + &rows(kn)),
        ("a row of units", "Time,Force\n(ms),(kN)\n".to_string() + &rows(kn)),
        (
            "Fortran's exponents",
            "time [s],force [N]\n".to_string() + &rows(|_, t, f| format!("{:.2}D-03,{:.6}D+03", 1e3 * t, f / 1e3)),
        ),
        (
            "semicolons and decimal commas",
            "Zeit [s];Kraft [N]\n".to_string() + &rows(|_, t, f| comma(format!("{t:.5};{f:.3}"))),
        ),
        ("tabs", "Temps [s]\tForce [N]\n".to_string() + &rows(|_, t, f| format!("{t:.5}\t{f:.3}"))),
        ("fixed width", "    Tiempo [s]     Fuerza [N]\n".to_string() + &rows(|_, t, f| format!("{t:14.5} {f:14.3}"))),
        (
            "quotation marks",
            "\"time [s]\",\"force [N]\"\n".to_string() + &rows(|_, t, f| format!("\"{t:.5}\",\"{f:.3}\"")),
        ),
        (
            "thousands",
            "time [s];force [N]\n".to_string()
                + &rows(|_, t, f| {
                    if f < 1e3 {
                        format!("{t:.5};{f:.3}")
                    } else {
                        format!("{t:.5};{},{:07.3}", (f / 1e3).floor(), f % 1e3)
                    }
                }),
        ),
        ("a clock", "Time,Force [N]\n".to_string() + &rows(|_, t, f| format!("00:00:{t:08.5},{f:.3}"))),
        (
            "a clock with a date",
            "Zeit [s];Kraft [N]\n".to_string()
                + &rows(|_, t, f| {
                    format!("02.05.2024 00:00:{};{}", comma(format!("{t:08.5}")), comma(format!("{f:.3}")))
                }),
        ),
        ("metadata", format!("Operator,me\nDate,2024-05-02 10:11:12\nMass,5.0,kg\nSample rate,20,kHz\n\n{}", ok())),
        ("an index", ",time [s],force [N]\n".to_string() + &rows(|i, t, f| format!("{i},{t:.5},{f:.3}"))),
        (
            "other columns",
            "time [s],temperature [°C],force [N],remarks\n".to_string()
                + &rows(|_, t, f| format!("{t:.5},23.1,{f:.3},ok")),
        ),
        ("blank lines", "time [s],force [N]\n\n".to_string() + &rows(|_, t, f| format!("{t:.5},{f:.3}\n"))),
        ("Windows line ends", ok().replace('\n', "\r\n")),
        ("old Macintosh line ends", ok().replace('\n', "\r")),
        ("an offset", "time [s],force [N]\n".to_string() + &rows(|_, t, f| format!("{t:.5},{:.3}", f - 60.0))),
        ("a negative push", "time [s],force [N]\n".to_string() + &rows(|_, t, f| format!("{t:.5},{:.3}", 12.0 - f))),
        (
            "pounds",
            "t [us],load [lbf]\n".to_string() + &rows(|_, t, f| format!("{:.1},{:.8}", 1e6 * t, f / 4.4482216152605)),
        ),
        (
            "accelerations in g",
            "Fallmasse: 5 kg\ntime [s],acceleration [g]\n".to_string() + &rows(|_, t, f| format!("{t:.5},{:.9}", g(f))),
        ),
        (
            "accelerations in m/s2",
            "mass [kg],5\ntime [s],a [m/s^2]\n".to_string() + &rows(|_, t, f| format!("{t:.5},{:.9}", -f / 5.0)),
        ),
        ("a rate alone", "Sampling rate: 20 kHz\nForce [N]\n".to_string() + &rows(|_, _, f| format!("{f:.3}"))),
        (
            "an unfiltered channel beside a filtered one",
            "time [s],force CFC600 [N],force unfiltered [N]\n".to_string()
                + &rows(|_, t, f| format!("{t:.5},{:.3},{f:.3}", 0.9 * f)),
        ),
        (
            "a count of samples and a rate",
            "Rate: 20000 Hz\nSample,Force [N]\n".to_string() + &rows(|i, _, f| format!("{i},{f:.3}")),
        ),
        (
            "a comment in the first row",
            "time [s]\tforce [N]\tComment\n".to_string()
                + &rows(|i, t, f| format!("{t:.5}\t{f:.3}{}", if i == 0 { "\tdrop 3" } else { "" })),
        ),
        ("statistics below", format!("{}\nStatistics\nMax,Min\n4000,0\n", ok())),
        (
            "a description between titles and units",
            "Time,Force\nrelative,anvil\ns,N\n".to_string() + &rows(|_, t, f| format!("{t:.5},{f:.3}")),
        ),
        ("a table of results above", format!("Drop,Peak\n1,4000\n2,3900\n\n{}", ok())),
    ];
    for (name, text) in layouts {
        let trace = read(&text, &Options::default()).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_impact(&trace, 1e-3, name);
        assert_eq!(trace.understood.warnings, Vec::<String>::new(), "{name}");
    }
}

#[test]
fn encodings_are_told_apart() {
    let text = "Zeit [s],Kraft [N] Prüfung\n".to_string() + &rows(|_, t, f| format!("{t:.5},{f:.3}"));
    let latin: Vec<u8> = text.chars().map(|c| c as u8).collect();
    let little: Vec<u8> = [0xfeff_u16].into_iter().chain(text.encode_utf16()).flat_map(u16::to_le_bytes).collect();
    let big: Vec<u8> = text.encode_utf16().flat_map(u16::to_be_bytes).collect();
    for (bytes, encoding) in [(latin, "Latin-1 (Windows-1252)"), (little, "UTF-16LE"), (big, "UTF-16BE")] {
        let trace = trace::read("x", &bytes, &Options::default(), Some(&EXPECTED)).unwrap();
        assert_impact(&trace, 1e-3, encoding);
        assert_eq!(trace.understood.get("file").unwrap()["encoding"], encoding);
    }
}

#[test]
fn what_the_file_leaves_open_is_refused_with_the_option_that_decides() {
    let data = |head: &str| format!("{head}\n{}", rows(|_, t, f| format!("{t:.5},{f:.3}")));
    for (text, message) in [
        (data("t,force [N]"), "column \"t\" has no unit of time: state it, as in --time \"t [ms]\""),
        (data("time [s],force"), "column \"force\" has no unit of force: state it, as in --force-column \"force [N]\""),
        (data("time [s],a [g]"), "is an acceleration: give the mass that falls, as in --mass \"5 kg\""),
        (data("time [s],CH1 [V]"), "no column of force or acceleration understood among \"time [s]\", \"CH1 [V]\""),
        (data("time,force [kN]\ns,N"), "column \"force [kN] [N]\" has two units, kN and N: expected one"),
        (data("x,y"), "no column of force or acceleration understood among \"x\", \"y\""),
        (rows(|_, t, f| format!("{t:.5},{f:.3}")), "the 2 columns have no titles: name them by number"),
        ("force [N],count\n".to_string() + &rows(|i, _, f| format!("{f:.3},{i}")), "give --rate \"20 kHz\""),
        (
            "time [s],Fx [N],Fz [N]\n".to_string() + &rows(|_, t, f| format!("{t:.5},{f:.3},{f:.3}")),
            "2 columns of force: \"Fx [N]\", \"Fz [N]\"; name one",
        ),
        // The unit is wrong: 50 us as 50 s, 4000 kN.
        (
            "time [s],force [N]\n".to_string() + &rows(|_, t, f| format!("{:.1},{f:.3}", 1e6 * t)),
            "--time \"time [ms]\"",
        ),
        (data("time [s],force [kN]"), "a rebound gives 1 to 2. State the units that are true"),
        (data("time [s],force [N]").replace("0.00500,", "0.00500,x"), "= \"x2828.427\" is refused: expected a number"),
        (
            "time [s],force [N]\n".to_string() + &rows(|_, t, f| format!("{t:.4},{f:.3}")),
            "is not after that of the line before",
        ),
        (
            "time [s],force [N]\n".to_string()
                + &rows(|i, t, f| if (63..142).contains(&i) { String::new() } else { format!("{t:.5},{f:.3}") }),
            "4.000 ms without a sample before this one, within the impact",
        ),
        (
            "time [s],force [N]\n".to_string()
                + &rows(
                    |i, t, f| if (63..142).contains(&i) { format!("{t:.5},NaN") } else { format!("{t:.5},{f:.3}") },
                ),
            "4.000 ms without a sample before this one, within the impact",
        ),
        ("time [s],force [N]\n".to_string() + &rows(|_, t, _| format!("{t:.5},1.0")), "nothing hits"),
        (ok().replace("0.00700,", "TRIGGER,start\n0.00700,"), "line 142: \"TRIGGER,start\" is refused"),
        (ok().replace("0.00700,", "pause\n0.00700,"), "line 142: \"pause\" is refused"),
        (format!("Sample rate,2000,kHz\n{}", ok()), "states 0.500 us"),
    ] {
        let found = refusal(&text, &Options::default());
        assert!(found.contains(message), "{message}\n{found}");
    }
}

/// A word that is a part of another, or the name of a sensor, leaves no column out.
#[test]
fn a_second_force_is_never_passed_over_by_a_word_in_its_title() {
    let two = |first: &str, second: &str| {
        format!("time [s],{first},{second}\n{}", rows(|_, t, f| format!("{t:.5},{f:.3},{f:.3}")))
    };
    for (first, second) in [
        ("Load cell force [N]", "Calibrated force [N]"),
        ("Load cell force [N]", "Workpiece force [N]"),
        ("Force [N]", "Temperature corrected force [N]"),
        ("Force Fe [N]", "Force Fi [N]"),
        ("Force CI [N]", "Kraft 2 [N]"),
        ("Force model 9301B [N]", "Force model 9305A [N]"),
    ] {
        let found = refusal(&two(first, second), &Options::default());
        assert!(found.contains(&format!("2 columns of force: \"{first}\", \"{second}\"; name one")), "{found}");
    }
    for computed in ["Force model [N]", "Force CI [N]", "Force fit [N]", "Force rate [N/s]"] {
        assert_impact(&read(&two("Force [N]", computed), &Options::default()).unwrap(), 5e-4, computed);
    }
    let text = format!("time [s],Force fit [N]\n{}", rows(|_, t, f| format!("{t:.5},{f:.3}")));
    let found = refusal(&text, &Options::default());
    assert!(found.contains("\"Force fit [N]\" is passed over, as a fit, a model or a scatter"), "{found}");
}

#[test]
fn options_settle_what_is_open() {
    let choice = |text: &str| Some(text.parse::<trace::Choice>().unwrap());
    let plain = |head: &str| format!("{head}\n{}", rows(|_, t, f| format!("{:.3},{:.6}", 1e3 * t, f / 1e3)));
    let settled = Options { time: choice("t [ms]"), force: choice("F [kN]"), ..Options::default() };
    assert_impact(&read(&plain("t,F"), &settled).unwrap(), 1e-3, "units");
    let numbered = Options { time: choice("1 [ms]"), force: choice("2 [kN]"), ..Options::default() };
    assert_impact(&read(&plain("x,y"), &numbered).unwrap(), 1e-3, "numbers");
    assert_impact(
        &read(&rows(|_, t, f| format!("{:.3},{:.6}", 1e3 * t, f / 1e3)), &numbered).unwrap(),
        1e-3,
        "untitled",
    );
    let unit = Options { time: choice("[ms]"), force: choice("[kN]"), ..Options::default() };
    assert_impact(&read(&plain("time,force"), &unit).unwrap(), 1e-3, "units alone");
    let sensor = Options { force: choice("CH1 [250 N/V]"), ..Options::default() };
    let volts = "time [s],CH1 [V]\n".to_string() + &rows(|_, t, f| format!("{t:.5},{:.9}", f / 250.0));
    assert_impact(&read(&volts, &sensor).unwrap(), 1e-3, "a sensor");
    let wrong = Options { force: choice("CH1 [250 N/mV]"), ..Options::default() };
    assert!(refusal(&volts, &wrong).contains("the column is in v"));
    let twice = Options { force: choice("Kraft [2 kN/V]"), ..Options::default() };
    assert!(refusal(&plain("time [s],Kraft [kN]"), &twice).contains("the column is in kN: expected one in V or mV"));
    let rated = Options { rate: Some(2e4), ..Options::default() };
    let rounded = "time [s],force [N]\n".to_string() + &rows(|_, t, f| format!("{t:.3},{f:.3}"));
    assert_impact(&read(&rounded, &rated).unwrap(), 1e-3, "a rate");
    let mass = Options { mass: Some(5.0), ..Options::default() };
    let g = "time [s],a [g]\n".to_string() + &rows(|_, t, f| format!("{t:.5},{:.9}", f / 5.0 / 9.80665));
    assert_impact(&read(&g, &mass).unwrap(), 1e-3, "a mass");
    let three = "time [s],Fx [N],Fz [N]\n".to_string() + &rows(|_, t, f| format!("{t:.5},1.0,{f:.3}"));
    assert_impact(&read(&three, &Options { force: choice("fz"), ..Options::default() }).unwrap(), 1e-3, "a name");
    for (text, message) in [
        ("none [N]", "expected one of \"time [s]\", \"Fx [N]\", \"Fz [N]\", or a number from 1 to 3"),
        ("Fz [mm]", "[mm] is no unit of force"),
        ("4 [N]", "or a number from 1 to 3"),
    ] {
        let found = refusal(&three, &Options { force: choice(text), ..Options::default() });
        assert!(found.contains(message), "{found}");
    }
    // Told so, an unlikely unit is read, with a warning.
    let stated = Options { force: choice("force [N]"), ..Options::default() };
    let small = "time [s],force [N]\n".to_string() + &rows(|_, t, f| format!("{t:.5},{:.6}", f / 1e3));
    let trace = read(&small, &stated).unwrap();
    assert!(trace.understood.warnings[0].contains("a rebound gives 1 to 2"), "{:?}", trace.understood);
}

#[test]
fn the_first_of_several_impacts_is_read_and_another_on_request() {
    let bounce = |time: f64| half_sine(time - 3e-3) + 0.45 * half_sine(time - 0.45);
    let text: String = (0..12_000).map(|i| 5e-5 * f64::from(i)).map(|t| format!("{t:.5},{:.3}\n", bounce(t))).collect();
    let text = "time [s],force [N]\n".to_string() + &text;
    let first = read(&text, &Options::default()).unwrap();
    let cut = first.times.len();
    assert!((0.2..0.26).contains(&first.times[cut - 1]));
    let peak = |trace: &trace::Trace| trace.forces.iter().copied().fold(0.0, f64::max);
    assert!((peak(&first) - 4e3).abs() < 1e-3);
    let impacts = first.understood.get("impact").unwrap();
    assert_eq!((&impacts["chosen"], impacts["impacts"].as_array().unwrap().len()), (&json!(1), 2));
    let second = read(&text, &Options { impact: Some(2), ..Options::default() }).unwrap();
    assert!((peak(&second) - 1800.0).abs() < 1e-3);
    for wanted in [0, 3] {
        let options = Options { impact: Some(wanted), ..Options::default() };
        assert!(refusal(&text, &options).contains(&format!("--impact {wanted} is refused: expected 1 to 2")));
    }
    let noise: String = (2..30).map(|i| format!("{:.3},{}\n", 1e-3 * f64::from(i), i % 7)).collect();
    let none = refusal(&("time [s],force [N]\n".to_string() + &noise), &Options::default());
    assert!(none.contains("no impact is found in the record"), "{none}");
    // Two drops, one below the other.
    let two = ok() + &ok().replace("4000.000", "3999.000");
    assert!((peak(&read(&two, &Options { impact: Some(2), ..Options::default() }).unwrap()) - 4e3).abs() < 5.0);
}

#[test]
fn an_offset_is_taken_off_or_warned_of() {
    let text = |from: usize| {
        let rows = rows(|i, t, f| if i < from { String::new() } else { format!("{t:.5},{:.3}", f - 60.0) });
        format!("time [s],force [N]\n{rows}")
    };
    let given = Options { offset: Some(-60.0), ..Options::default() };
    for (from, options) in [(0, Options::default()), (30, Options::default()), (57, given.clone()), (60, given)] {
        let trace = read(&text(from), &options).unwrap();
        assert!((trace.forces.iter().copied().fold(0.0, f64::max) - 4e3).abs() < 1e-3, "{}", trace.understood);
    }
    let few = read(&text(55), &Options::default()).unwrap();
    assert!(few.understood.warnings[0].contains("--offset -60.000 does"), "{}", few.understood);
}

/// Noise of 1.5 % of the peak reaches 5 % in a record of half a second, long before and behind the impact.
#[test]
fn noise_makes_no_impact_of_half_a_second() {
    let mut state = 1_u64;
    let mut uniform = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 33) as f64 / 2_f64.powi(31) - 0.5
    };
    // The sum of twelve is nearly normal, with a standard deviation of one.
    let mut row = |i: i32| {
        let noise = 60.0 * (0..12).map(|_| uniform()).sum::<f64>();
        let time = 5e-5 * f64::from(i);
        format!("{time:.5},{:.3}\n", half_sine(time - 0.05) + noise)
    };
    let text = "time [s],force [N]\n".to_string() + &(0..10_000).map(&mut row).collect::<String>();
    let trace = read(&text, &Options::default()).unwrap();
    let beyond = trace.times.iter().zip(&trace.forces).filter(|(time, force)| **time > 0.06 && **force > 200.0);
    assert!(beyond.count() > 0 && trace.understood.warnings.is_empty(), "{}", trace.understood);
}

#[test]
fn a_force_that_is_cut_off_is_warned_of() {
    let text = "time [s],force [N]\n".to_string() + &rows(|_, t, f| format!("{t:.5},{:.3}", f.min(3e3)));
    let trace = read(&text, &Options::default()).unwrap();
    assert!(trace.understood.warnings[0].contains("may be cut off by the amplifier"), "{}", trace.understood);
}

#[test]
fn filters_and_displacements_are_understood() {
    let text = "time [s],force CFC 600 [N],x [mm]\n".to_string()
        + &rows(|_, t, f| format!("{t:.5},{f:.3},{:.6}", 7.0 - f / 1e3));
    let trace = read(&text, &Options::default()).unwrap();
    assert_eq!(trace.filter, Some(Filter::Class(600)));
    assert!((trace.deformation.unwrap() - 4e-3).abs() < 1e-7, "{:?}", trace.deformation);
}

#[test]
fn what_was_understood_is_told_to_programs() {
    let trace = read(&(ok() + "Max,4000\n"), &Options::default()).unwrap();
    let json = trace.understood.json();
    assert_eq!(json["force"], json!({"column": 2, "title": "force [N]", "unit": "N", "factor": 1.0}));
    assert_eq!(json["sign"], 1.0);
    assert_eq!(json["offset"]["force"], 0.0);
    assert!(
        json["file"]["notes"][0].as_str().unwrap().contains("1 lines below passed over from line 603, \"Max,4000\"")
    );
    assert_eq!(json["warnings"], json!([]));
    assert_eq!(impact().len(), 601);
}
