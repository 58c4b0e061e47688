//! The examples of docs/measured-data.md: each is written as it stands there, and its command run.

use std::path::Path;

use crate::common::json;

/// An example: its title, the name of its file, what is in it, and the arguments of its command.
struct Example {
    title: String,
    file: String,
    content: String,
    arguments: Vec<String>,
}

fn examples() -> Vec<Example> {
    let page = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/measured-data.md")).unwrap();
    let sections = page.split("\n### ").skip(1).map(|section| {
        let (title, rest) = section.split_once('\n').unwrap();
        let (_, block) = rest.split_once("```text ").unwrap_or_else(|| panic!("{title}"));
        let (file, block) = block.split_once('\n').unwrap();
        let (content, rest) = block.split_once("\n```\n```sh\n").unwrap();
        let (command, _) = rest.split_once("\n```").unwrap();
        Example {
            title: title.into(),
            file: file.into(),
            content: content.to_string() + "\n",
            arguments: words(command.strip_prefix("softanvil ").unwrap()),
        }
    });
    sections.collect()
}

/// The words of a command, with quotation marks around those that hold blanks.
fn words(command: &str) -> Vec<String> {
    let parts = command.split('"').enumerate();
    parts
        .flat_map(|(index, part)| match index % 2 {
            0 => part.split_whitespace().map(String::from).collect(),
            _ => vec![part.to_string()],
        })
        .collect()
}

#[test]
fn every_example_gives_the_numbers_that_it_was_made_of() {
    let folder = tempfile::tempdir().unwrap();
    let examples = examples();
    assert!(examples.len() >= 15, "{}", examples.len());
    for example in &examples {
        std::fs::write(folder.path().join(&example.file), &example.content).unwrap();
        let mut arguments: Vec<&str> = example.arguments.iter().map(String::as_str).collect();
        arguments.push("--json");
        let close = |found: &serde_json::Value, expected: f64, part: f64| {
            let found = found.as_f64().unwrap_or_else(|| panic!("{}: {found}", example.title));
            assert!((found / expected - 1.0).abs() < part, "{}: {found} for {expected}", example.title);
        };
        if arguments[0] == "measure" {
            // The simulation is no part of this.
            arguments.extend(["--duration", "0.002", "--set", "mesh.element_size=7.5e-3"]);
            let result = json(folder.path(), &arguments);
            close(&result["comparison"]["numbers"]["peak_force"]["measured"], 4e3, 1e-6);
            close(&result["comparison"]["numbers"]["impulse"]["measured"], 20.109, 1e-4);
            assert_eq!(result["trace"]["warnings"].as_array().unwrap().len(), 0, "{}", example.title);
        } else {
            let result = json(folder.path(), &arguments);
            let laws = result["laws"].as_array().unwrap();
            let law = laws.iter().find(|law| law["law"] == "neo_hookean").unwrap();
            // The median of two specimens is one of straight lines between their points.
            close(&law["parameters"]["c10"], 1e5, 2e-3);
        }
    }
}

#[test]
fn a_calibration_says_how_it_read_its_traces() {
    let folder = tempfile::tempdir().unwrap();
    let rows: String = (-40..200)
        .map(|i| f64::from(i) * 0.1)
        .map(|t| {
            format!(
                "{t:.1};{:.4}\n",
                if (0.0..8.0).contains(&t) { 4.0 * (std::f64::consts::PI * t / 8.0).sin() } else { 0.0 }
            )
        })
        .collect();
    std::fs::write(folder.path().join("drop.csv"), format!("t;Fz\n{}", rows.replace('.', ","))).unwrap();
    let problem = |trace: &str| {
        let text = format!(
            "[search]\nevaluations = 2\n[fixed]\n\"mesh.element_size\" = 7.5e-3\n[parameters]\n\"silicone.c10\" = {{ min = 1e5, \
             max = 1e6 }}\n[[impact]]\nenergy = 14.7\ntrace = {trace}\n"
        );
        std::fs::write(folder.path().join("problem.toml"), text).unwrap();
    };
    problem("\"drop.csv\"");
    let error = crate::common::fail(folder.path(), &["calibrate", "problem.toml"], 2);
    assert!(error.contains("column \"Fz\" has no unit of force: state it, as in trace.force = \"Fz [N]\""), "{error}");
    problem("{ file = \"drop.csv\", time = \"t [ms]\", force = \"Fz [kN]\" }");
    let text = crate::common::succeed(folder.path(), &["calibrate", "problem.toml", "--out", "out"]);
    assert!(text.contains("column 2 \"Fz\", in kN (1000 N)"), "{text}");
    // There is no mean of no numbers.
    let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words.contains("1 parameter searched, no numbers were measured, traces alone."), "{text}");
    assert!(!text.contains("mean |error|"), "{text}");
    let best = std::fs::read_to_string(folder.path().join("out/best.toml")).unwrap();
    assert!(best.contains("# No numbers were measured, traces alone.\n"), "{best}");
    let summary = std::fs::read_to_string(folder.path().join("out/summary.json")).unwrap();
    let summary: serde_json::Value = serde_json::from_str(&summary).unwrap();
    assert_eq!(summary["impacts"][0]["trace"]["force"]["unit"], "kN");
    assert!(summary["mean_error_percent"].is_null(), "{summary}");
    // The log is read again.
    crate::common::succeed(folder.path(), &["calibrate", "problem.toml", "--out", "out"]);
}
