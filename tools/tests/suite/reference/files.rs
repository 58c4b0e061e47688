//! docs/reference/files.md: the keys of problem and sweep files, by what a wrong one is answered, and the keys and columns of what
//! the commands write.

use std::path::Path;

use softanvil_tools::measurement::quantity::QUANTITIES;
use softanvil_tools::output::trace;
use tempfile::{TempDir, tempdir};

use super::json_keys::{COMMON, json_table};
use super::{code, compare, table};
use crate::common::{fail, json, read_table, succeed};

/// A table of a file: what it is called, a file with a key in it that nobody knows, and what its keys mean, with what a key that is
/// left out stands for.
struct Keys {
    title: &'static str,
    about: &'static str,
    command: &'static str,
    file: &'static str,
    meanings: &'static [(&'static str, &'static str)],
}

const PROBLEM: [Keys; 9] = [
    Keys {
        title: "The file",
        about: "",
        command: "calibrate",
        file: "zzz = 1\n",
        meanings: &[
            ("preset", "preset to start from; `study` if left out"),
            ("scenario", "scenario file beside the problem file, over the preset"),
            ("fixed", "table of parameters and their values, over the scenario: numbers, or labels of choices"),
            ("search", "table: how to search"),
            ("objective", "table: what the score is made of"),
            ("prior", "table: what quasi-static tests say; none if left out"),
            ("uncertainty", "table: what is known of the errors of the measured numbers, for `--uncertainty`"),
            ("parameters", "table of what is searched for: names with their ranges"),
            ("impact", "a table `[[impact]]` for each impact that was measured"),
            ("impacts", "CSV file beside the problem file with further impacts, a line each"),
            ("material_test", "a table `[[material_test]]` for each test of a material by itself"),
        ],
    },
    Keys {
        title: "`[search]`",
        about: "",
        command: "calibrate",
        file: "[search]\nzzz = 1\n[parameters]\n",
        meanings: &[
            ("seed", "seed of the random numbers; 1"),
            ("evaluations", "evaluations to spend"),
            ("population", "evaluations in a generation; 0, or left out, takes 4 + 3 ln n of n parameters"),
            ("step", "first standard deviation as a part of every range, above 0 and at most 1; 0.2"),
        ],
    },
    Keys {
        title: "`[parameters]`",
        about: "The name is that of a quantity of the scenario, or `overstress_1` and so on of a layer: g over g_inf of a Prony \
                term. Searching that instead of `prony_g_1` leaves the long-term law and the other terms as they are. A best \
                value on a bound of its range is marked in the results.",
        command: "calibrate",
        file: "[search]\nevaluations = 1\n[parameters]\n\"silicone.c10\" = { min = 1e4, max = 1e6, zzz = 1 }\n",
        meanings: &[
            ("min", "smallest value, in the unit of the parameter"),
            ("max", "largest value"),
            ("scale", "`linear` for equal steps, `log` for equal factors; `linear`"),
            ("start", "where the search starts; the value of the scenario"),
        ],
    },
    Keys {
        title: "`[objective]`",
        about: "The score is the weighted mean of the absolute errors in %, plus what exceeds the limits, plus the material \
                tests, plus the prior. The \
                keys of numbers are `peak_force`, `max_deformation`, `impact_duration` and `impulse`.",
        command: "calibrate",
        file: "[search]\nevaluations = 1\n[parameters]\n[objective]\nzzz = 1\n",
        meanings: &[
            (
                "root_mean_square",
                "share of the root mean square of the errors in the score, 0 to 1; the rest is the mean of their absolute values; 0",
            ),
            ("weights", "table of weights by key of a number, or `trace` for the difference of a trace; 1 each"),
            (
                "limits",
                "table of errors in %, by key of a number: what an error is more than its limit counts once more in full; none",
            ),
            ("force", "`contact` or `core`: which force is compared with the measured one; `contact`"),
            ("cfc", "channel frequency class in Hz of the filter on the simulated force and on traces; none"),
            ("steps_per_sample", "most steps in 50 us: stiffer materials are refused; 0 allows all; 0"),
            (
                "poissons_ratio_at_once",
                "smallest Poisson's ratio that a layer may have before anything has relaxed; none",
            ),
            (
                "rounding",
                "`true` lets an error count only as far as it is outside what the printed number may have been rounded from; `false`",
            ),
            (
                "material_weight",
                "points of score for a mean square distance of one standard deviation from the material tests; 1",
            ),
        ],
    },
    Keys {
        title: "`[prior]`",
        about: "Impacts alone do not tell the long-term law from the fast overstress. The prior compares a simple compression of the \
                layer next to the core, taken as incompressible, with measured moduli. The mean square of the logarithms of model over \
                measurement, times the weight, is added to the score: a factor e costs one weight. A modulus that is left out \
                demands nothing.",
        command: "calibrate",
        file: "[search]\nevaluations = 1\n[parameters]\n[prior]\nzzz = 1\n",
        meanings: &[
            ("weight", "points of score for a factor e, above 0"),
            ("youngs_modulus", "initial Young's modulus in a slow compression, Pa"),
            ("time", "duration of that compression, s: overstress that relaxes faster hardly counts; 1"),
            ("relaxation_strain", "strain at which the relaxation was measured, between 0 and 1; 0.5"),
            ("relaxed_shear_modulus", "a third of nominal stress over strain at that strain, fully relaxed, Pa"),
            ("initial_shear_modulus", "the same at the start of the relaxation, after a ramp of `time`, Pa"),
        ],
    },
    Keys {
        title: "`[[material_test]]`",
        about: "A test of the material by itself, a ramp of nominal strain and a hold, of which one value was read. The specimen is \
                taken as incompressible and free at its sides. The distance of the model is ln(model / value) in standard \
                deviations, which are relative ones then; the score grows by `material_weight` times the mean of its squares.",
        command: "calibrate",
        file: "[search]\nevaluations = 1\n[parameters]\n[[material_test]]\nzzz = 1\n",
        meanings: &[
            ("name", "what the test is called in the results"),
            ("layer", "name of the layer that the material is of; the layer next to the core"),
            ("load", "`compression` or `tension`; `compression`"),
            (
                "quantity",
                "what `value` is: `youngs_modulus` (nominal stress over strain), `shear_modulus` (a third of that) or `stress`",
            ),
            ("strain", "nominal strain at the end of the ramp, above 0, in compression below 1"),
            ("rate", "rate of nominal strain, 1/s; left out, the ramp is so slow that all overstress has relaxed"),
            ("hold", "time for which the strain has been held when the value was read, s; 0"),
            ("value", "what was measured, Pa"),
            ("standard_deviation", "its standard deviation, Pa"),
            ("predict", "`true` where the test is reported and does not count; `false`"),
        ],
    },
    Keys {
        title: "`[uncertainty]`",
        about: "What `--uncertainty` takes for the errors of the measured numbers ([uncertainty.md](../uncertainty.md)). The tables have \
                the keys of numbers.",
        command: "calibrate",
        file: "[search]\nevaluations = 1\n[parameters]\n[uncertainty]\nzzz = 1\n",
        meanings: &[
            ("samples", "samples that the posterior file keeps, 50 to 2000; 200"),
            ("noise", "table of relative standard deviations of a measurement, up to 1; 0.01 each"),
            (
                "discrepancy",
                "table of scales of the half-normal priors of what the model misses, relative, up to 1; 0 for nothing; 0.1 each",
            ),
            (
                "rounding",
                "table of steps to which the numbers are rounded, in SI; 0 each, those of `table_1` have its digits",
            ),
            (
                "prior_deviation",
                "standard deviation of the logarithm of a modulus of `[prior]`, model over measurement; 0.3",
            ),
        ],
    },
    Keys {
        title: "`[[impact]]`",
        about: "Numbers are in SI units. An impact has at least one of them, a trace, or `table_1`.",
        command: "calibrate",
        file: "[search]\nevaluations = 1\n[parameters]\n[[impact]]\nzzz = 1\n",
        meanings: &[
            ("energy", "impact energy, J"),
            ("table_1", "`true` takes the four numbers from the table of the paper, for 14.7, 9.8 or 4.9 J"),
            ("peak_force", "peak force, N"),
            ("max_deformation", "largest deformation, m"),
            ("impact_duration", "impact duration, s"),
            ("impulse", "impulse of the contact force, N s"),
            ("trace", "file with a force or an acceleration over time, beside the problem file; or a table, see below"),
            (
                "filtered",
                "`true` where the trace has been filtered already: `cfc` is for the simulated force alone then",
            ),
            (
                "half_unit",
                "table of half a unit of the last printed digit, by key of a number, in SI, for `rounding`; that of the table for its \
                 numbers, else 0",
            ),
            ("ignore", "list of keys of numbers that are reported and do not count"),
            ("predict", "`true` where nothing of the impact counts: it is simulated and reported as a prediction"),
        ],
    },
    Keys {
        title: "The file of `impacts`",
        about: "A CSV file with these titles, those that it needs, and a line for each impact. Cells may be empty.",
        command: "calibrate",
        file: "impacts = \"impacts.csv\"\n[search]\nevaluations = 1\n[parameters]\n\"silicone.c10\" = { min = 1e4, max = 1e6 }\n",
        meanings: &[
            ("energy", "as above"),
            ("peak_force", "as above"),
            ("max_deformation", "as above"),
            ("impact_duration", "as above"),
            ("impulse", "as above"),
            ("trace", "name of a file"),
            ("predict", "`true` or `false`"),
        ],
    },
];

/// What a table of a trace may have: what is said of it is tried, because a wrong key is answered without the others.
const TRACE: [(&str, &str, &str); 11] = [
    ("file", "\"tr.csv\"", "name of the file"),
    ("time", "\"t [s]\"", "column of the time"),
    ("force", "\"F [N]\"", "column of the force"),
    ("acceleration", "\"a [g]\"", "column of the acceleration"),
    ("mass", "\"5kg\"", "mass that falls"),
    ("rate", "\"20kHz\"", "samples in a second, instead of a column of time"),
    ("offset", "-60.0", "force in N that the file shows without contact"),
    ("sign", "\"+\"", "side of a push, `+` or `-`"),
    ("impact", "1", "which impact of the record, from 1"),
    ("sheet", "\"Sheet 1\"", "sheet of a workbook"),
    ("decimal", "\"point\"", "decimal sign, `point` or `comma`"),
];

const SWEEP: [Keys; 3] = [
    Keys {
        title: "The file",
        about: "",
        command: "sweep",
        file: "zzz = 1\n",
        meanings: &[
            ("title", "title of the page"),
            ("about", "a sentence below it"),
            ("axis", "a table `[[axis]]` for each thing that is changed"),
            ("convergence", "list of factors by which the mesh is refined; none"),
            (
                "contrast",
                "a table `[[contrast]]` for each change that the page is to show first; not beside `convergence`",
            ),
        ],
    },
    Keys {
        title: "`[[axis]]`",
        about: "",
        command: "sweep",
        file: "title = \"a\"\n[[axis]]\nzzz = 1\n",
        meanings: &[
            ("name", "name of the axis; that of its parameter"),
            ("parameters", "list of parameters that have the same value"),
            ("values", "list of their values: numbers, or labels of choices"),
            ("levels", "instead of these two: a list of tables, each with a `name` and settings of several parameters"),
        ],
    },
    Keys {
        title: "`[[contrast]]`",
        about: "",
        command: "sweep",
        file: "title = \"a\"\n[[axis]]\nparameters = [\"silicone.c10\"]\nvalues = [1e5]\n[[contrast]]\nzzz = 1\n",
        meanings: &[
            ("what", "what is changed, in words"),
            ("from", "list of a level of each axis"),
            ("to", "the same of the other combination"),
            ("paper", "what the paper says of it, if it does"),
        ],
    },
];

/// The keys of a table, as the answer to a wrong one lists them.
fn keys(folder: &TempDir, keys: &Keys) -> String {
    std::fs::write(folder.path().join("file.toml"), keys.file).unwrap();
    let error = fail(folder.path(), &[keys.command, "file.toml"], 2);
    let (_, expected) = error.split_once("unknown field `zzz`, expected one of ").unwrap_or_else(|| panic!("{error}"));
    let found: Vec<&str> = expected.split('`').skip(1).step_by(2).collect();
    let mut rows = Vec::new();
    for key in &found {
        let (_, meaning) = keys.meanings.iter().find(|(known, _)| known == key).unwrap_or_else(|| panic!("{key}"));
        rows.push(vec![code(key), (*meaning).into()]);
    }
    assert_eq!(found.len(), keys.meanings.len(), "{}", keys.title);
    let about = if keys.about.is_empty() { String::new() } else { format!("{}\n\n", keys.about) };
    format!("### {}\n{about}{}", keys.title, table(&["key", "meaning, and what it is if left out"], rows))
}

/// The keys of the table of a trace, each of which is taken for what it is.
fn keys_of_trace(folder: &TempDir) -> String {
    let refused = |table: &str| {
        let text = format!(
            "[search]\nevaluations = 1\n[parameters]\n\"silicone.c10\" = {{ min = 1e4, max = 1e6 }}\n[[impact]]\nenergy = 14.7\n\
             trace = {{ {table} }}\n"
        );
        std::fs::write(folder.path().join("file.toml"), text).unwrap();
        fail(folder.path(), &["calibrate", "file.toml"], 2)
    };
    assert!(refused("file = \"none.csv\", zzz = 1").contains("trace.zzz is unknown"));
    let rows = TRACE.map(|(key, value, meaning)| {
        let value = if key == "file" { String::new() } else { format!(", {key} = {value}") };
        let error = refused(&format!("file = \"none.csv\"{value}"));
        assert!(error.contains("none.csv"), "{key}: {error}");
        vec![code(key), meaning.into()]
    });
    format!(
        "### `trace` as a table\nWhat the file leaves open, as options of `softanvil measure` say it \
         ([measured-data.md](../measured-data.md#options)).\n\n{}",
        table(&["key", "meaning"], rows)
    )
}

/// A drop on a coarse mesh, whose numbers nobody reads.
const COARSE: [&str; 4] = ["--set", "mesh.element_size=7.5e-3", "--set", "geometry.length=0.1"];

/// The columns of the CSV files.
fn columns(folder: &TempDir) -> String {
    let trace = trace::columns()
        .map(|output| vec![code(format!("{} [{}]", output.name, output.unit)), output.description.to_string()]);
    let time = vec![code("time [s]"), "end of the sample, from the start".to_string()];
    let trace = table(&["column", "meaning"], [time].into_iter().chain(trace));
    let named = |path: &str, meaning: &dyn Fn(&str) -> String| {
        let (header, _) = read_table(&folder.path().join(path));
        table(&["column", "meaning"], header.iter().map(|title| vec![code(title), meaning(title)]))
    };
    let sweep = named("sweep/silicone.c10.csv", &|title| match title.split(' ').next().unwrap() {
        "case" => "number of the combination, from 0".into(),
        "silicone.c10" => "the parameters of the axes, a column each".into(),
        "failure" => "why the simulation failed; empty where it did not".into(),
        key => json_meaning(key),
    });
    let log = named("search/evaluations.csv", &|title| {
        let (of_impact, key) = title.split_once(": ").map_or(("", title), |(energy, key)| (energy, key));
        match (of_impact, key.split(' ').next().unwrap()) {
            ("", "evaluation") => "number, from 0".into(),
            ("", "restart") => "how often the search has started anew".into(),
            ("", "score") => "what the search makes small".into(),
            ("", "mean_error") => "mean of the absolute errors of all measured numbers".into(),
            ("", "silicone.c10") => "the parameters that are searched for, a column each".into(),
            ("", "refusal") => "why the values could not be simulated; empty where they were".into(),
            ("", "problem") => "digest of the problem".into(),
            (_, key) => format!("of each impact: {}", json_meaning(key)),
        }
    });
    format!(
        "## CSV files\nNumbers are in SI units, with as many digits as give back the same bits.\n\n\
         ### Trace: `run --csv`, and in the report\nA line for each force sample, every 50 us.\n\n{trace}\
         ### Sweep: `sweep --out`\nA line for each simulation.\n\n{sweep}\
         ### Log of a search: `evaluations.csv`\nA line for each evaluation.\n\n{log}"
    )
}

fn json_meaning(key: &str) -> String {
    let (_, meaning) = COMMON.iter().find(|(known, _)| *known == key).unwrap_or_else(|| panic!("{key}"));
    (*meaning).into()
}

/// A trace, a relaxation and an impact to read.
fn write_inputs(folder: &Path) {
    let half_sine = |i: i32| if (40..200).contains(&i) { 5e3 * (f64::from(i - 40) * 0.0196).sin() } else { 0.0 };
    let rows: String = (0..400).map(|i| format!("{},{}\n", 5e-5 * f64::from(i), half_sine(i))).collect();
    std::fs::write(folder.join("tr.csv"), format!("t [s],F [N]\n{rows}")).unwrap();
    let times = (0..60).map(|i| 0.01 * 1.15_f64.powi(i));
    let rows: String = times.map(|t| format!("{t},{}\n", 0.33 + 0.27 * (-t / 0.4).exp())).collect();
    std::fs::write(folder.join("rel.csv"), format!("time [s],shear modulus [MPa]\n{rows}")).unwrap();
    std::fs::write(folder.join("impacts.csv"), "energy,zzz\n14.7,1\n").unwrap();
    let problem = "[search]\nevaluations = 4\npopulation = 4\n[fixed]\n\"mesh.element_size\" = 7.5e-3\n[parameters]\n\"silicone.c10\" = \
                   { min = 1e4, max = 1e6, scale = \"log\" }\n[[impact]]\nenergy = 14.7\ntrace = \"tr.csv\"\npeak_force = 5499\n[[material_test]]\n\
                   name = \"a\"\nquantity = \"shear_modulus\"\nstrain = 0.5\nvalue = 3e5\nstandard_deviation = 3e4\n";
    std::fs::write(folder.join("problem.toml"), problem).unwrap();
}

#[test]
fn the_page_of_the_files_is_that_of_what_is_read_and_written() {
    let folder = tempdir().unwrap();
    write_inputs(folder.path());
    let data = |name: &str| format!("{}/../data/treloar/{name}.csv", env!("CARGO_MANIFEST_DIR"));
    let run = |arguments: &[&str]| json(folder.path(), &[arguments, &["--json"]].concat());
    let coarse = |arguments: &[&str]| run(&[arguments, &COARSE].concat());
    let problem: String = PROBLEM.iter().map(|of| keys(&folder, of)).collect();
    let trace = keys_of_trace(&folder);
    let sweep: String = SWEEP.iter().map(|of| keys(&folder, of)).collect();
    succeed(folder.path(), &["calibrate", "problem.toml", "--out", "search"]);
    succeed(folder.path(), &[&["sweep", "silicone.c10=1e5", "--out", "sweep"][..], &COARSE].concat());
    let summary = std::fs::read_to_string(folder.path().join("search/summary.json")).unwrap();
    let (uniaxial, planar) = (data("uniaxial"), data("planar"));
    let fit = ["fit", "--uniaxial", &uniaxial, "--planar", &planar, "--relaxation", "rel.csv", "--ramp-time", "0"];
    let tables = [
        (
            "`run`",
            "With `--impacts`, `impacts` has those before the last one, too.",
            coarse(&["run", "--impacts", "2"]),
        ),
        ("`measure`", "`comparison` and `trace` are there with `--trace`.", coarse(&["measure", "--trace", "tr.csv"])),
        ("`validate`", "", run(&["validate"])),
        ("`protect`", "", run(&["protect", "--preset", "en1621-1"])),
        ("`sweep`", "", coarse(&["sweep", "silicone.c10=1e5"])),
        ("`reduction`", "", coarse(&["reduction", "impactor.drop_energy=12"])),
        ("`summary.json` of `calibrate`", "", serde_json::from_str(&summary).unwrap()),
        ("`fit`", "It is also the file `fit.json` that `--out` writes.", run(&fit)),
    ];
    let mut text = format!(
        "## Problem files of `calibrate`\n[calibration.md](../calibration.md) tells how the search goes, and `calibration/` has \
         examples.\n\n{problem}{trace}## Files of `sweep`\n[sweeps.md](../sweeps.md) has an example.\n\n{sweep}{}## JSON\nNumbers \
         are in SI units unless the key says otherwise. `[]` stands for each element of a list, a name in angle brackets for any \
         name.\n\n",
        columns(&folder)
    );
    text += &json_table(&tables);
    compare("files.md", "Files and results", &text);
}

/// Numbers have the same keys wherever they stand.
#[test]
fn the_numbers_of_the_table_have_a_meaning() {
    for quantity in &QUANTITIES {
        json_meaning(quantity.key);
    }
}
