//! `softanvil fit` as its users meet it.

use tempfile::tempdir;

use crate::common::{entries, fail, json, succeed};

const CURVE: &str = "Compressive strain (%);Compressive stress (kPa)\n5;-9,4\n10;19,6\n20;43\n30;75\n40;120\n50;190\n";

fn folder() -> tempfile::TempDir {
    let folder = tempdir().unwrap();
    std::fs::write(folder.path().join("curve.csv"), CURVE.replace('-', "")).unwrap();
    folder
}

#[test]
fn a_curve_becomes_a_material_that_runs() {
    let folder = folder();
    let text = succeed(folder.path(), &["fit", "--uniaxial", "curve.csv", "--stable", "--out", "out"]);
    assert!(text.contains("read as compression") && text.contains("written: out/material.toml"), "{text}");
    let files = entries(&folder.path().join("out"));
    for name in
        ["material.toml", "material.h", "material.ssv", "material-lsdyna.k", "material-abaqus.inp", "uniaxial.svg"]
    {
        assert!(files.iter().any(|file| file == name), "{name} in {files:?}");
    }
    let run = ["run", "--material", "out/material.toml", "--energy", "0.1", "--json"];
    assert!(json(folder.path(), &run)["peak_force"].as_f64().unwrap() > 0.0);
}

/// A soft material is pressed thinner than the study's step is chosen for: the scenario file has a step that holds.
#[test]
fn a_soft_material_comes_with_a_scenario_that_goes_through() {
    let folder = folder();
    let row = |k: u32| (1.0 - 0.05 * f64::from(k), 0.1e6);
    let line = |(l, c): (f64, f64)| format!("{l:.2},{:.3}\n", c * (l - l.powi(-2)));
    let rows: String = (1..13).map(row).map(line).collect();
    std::fs::write(folder.path().join("soft.csv"), format!("stretch,stress [Pa]\n{rows}")).unwrap();
    let text = succeed(folder.path(), &["fit", "--uniaxial", "soft.csv", "--law", "neo_hookean", "--out", "out"]);
    assert!(text.contains("softanvil run --scenario out/scenario.toml"), "{text}");
    let run = json(folder.path(), &["run", "--scenario", "out/scenario.toml", "--json"]);
    assert!(run["peak_force"].as_f64().unwrap() > 0.0);
}

/// The table of the documentation is that of the last comparison with other programs.
#[test]
fn json_names_the_chosen_law_and_its_errors() {
    let folder = folder();
    let fit = json(folder.path(), &["fit", "--uniaxial", "curve.csv", "--law", "yeoh_2", "--json"]);
    assert_eq!(fit["chosen"], "yeoh_2");
    let laws = fit["laws"].as_array().unwrap();
    let law = laws.iter().find(|law| law["law"] == "yeoh_2").unwrap();
    assert!(law["standard_errors"]["c10"].as_f64().unwrap() > 0.0);
}

#[test]
fn wrong_input_is_refused_in_one_line() {
    let folder = folder();
    assert!(fail(folder.path(), &["fit"], 2).contains("nothing to fit"));
    assert!(fail(folder.path(), &["fit", "--uniaxial", "none.csv"], 2).starts_with("none.csv: "));
    std::fs::write(folder.path().join("bare.csv"), "0.1 0.2\n0.2 0.3\n0.3 0.5\n").unwrap();
    assert!(fail(folder.path(), &["fit", "--uniaxial", "bare.csv"], 2).contains("--columns"));
    std::fs::write(folder.path().join("no.toml"), "[impactor]\nmass = 4\n").unwrap();
    assert!(fail(folder.path(), &["run", "--material", "no.toml"], 2).contains("line 1: impactor is refused"));
}

#[test]
fn the_study_gives_a_start_with_its_contradictions() {
    let folder = folder();
    assert!(succeed(folder.path(), &["fit", "--paper"]).contains("contradict"));
}

#[test]
fn files_of_others_are_left_alone_and_own_ones_replaced() {
    let folder = folder();
    let path = |name: &str| folder.path().join(name);
    let fit = ["fit", "--uniaxial", "curve.csv", "--law", "neo_hookean", "--out", "."];
    std::fs::write(path("scenario.toml"), "mine").unwrap();
    let line = fail(folder.path(), &fit, 2);
    assert!(line.contains("scenario.toml is there and not as this program left it; --overwrite replaces it"), "{line}");
    assert_eq!(std::fs::read_to_string(path("scenario.toml")).unwrap(), "mine");
    assert_eq!(entries(folder.path()), ["curve.csv", "scenario.toml"]);
    std::fs::remove_file(path("scenario.toml")).unwrap();
    succeed(folder.path(), &fit);
    succeed(folder.path(), &fit);
    // Changed by hand, a file is no longer the program's.
    let mut material = std::fs::read_to_string(path("material.toml")).unwrap();
    material += "# mine";
    std::fs::write(path("material.toml"), &material).unwrap();
    assert!(fail(folder.path(), &fit, 2).contains("material.toml is there"));
    assert_eq!(std::fs::read_to_string(path("material.toml")).unwrap(), material);
    succeed(folder.path(), &[&fit[..], &["--overwrite"]].concat());
    assert_ne!(std::fs::read_to_string(path("material.toml")).unwrap(), material);
}

#[test]
fn poissons_ratio_is_the_preset_s_unless_given() {
    let folder = folder();
    let fit = ["fit", "--uniaxial", "curve.csv", "--law", "neo_hookean", "--out", "out"];
    succeed(folder.path(), &fit);
    let text = std::fs::read_to_string(folder.path().join("out/material.toml")).unwrap();
    let own = softanvil_kernel::preset::study().layers[0].material.poissons_ratio;
    assert!(text.contains(&format!("\npoissons_ratio = {own} ")), "{text}");
}

/// A term of Ogden's law, and the derivative of another by its exponent, which two terms approach as they cancel.
fn cancelling() -> String {
    let stress = |l: f64| 40.0 * (l * l - l.powf(-2.5)) + 100.0 * (l + 0.5 * l.powi(-2)) * l.ln();
    let rows = (1..40).map(|k| 1.0 + 0.05 * f64::from(k)).map(|l| format!("{l:.2},{:.8}\n", stress(l)));
    format!("stretch,stress [kPa]\n{}", rows.collect::<String>())
}

#[test]
fn a_card_that_would_not_give_the_stresses_back_is_not_written() {
    let folder = folder();
    std::fs::write(folder.path().join("cancelling.csv"), cancelling()).unwrap();
    let fit = ["fit", "--uniaxial", "cancelling.csv", "--stable-range", "0.9:3", "--out", "out"];
    let chosen = succeed(folder.path(), &fit).replace("\n  ", " ");
    assert!(chosen.contains("Ogden 3 is not chosen: its terms cancel"), "{chosen}");
    assert!(!chosen.contains("not written"), "{chosen}");
    let there = |name: &str| entries(&folder.path().join("out")).iter().any(|file| file == name);
    assert!(there("material-lsdyna.k"));
    // The card of the fit before must not stand beside the new material.
    let text =
        succeed(folder.path(), &[&fit[..], &["--law", "ogden_3"]].concat()).replace("\n  ", " ").replace('\n', " ");
    assert!(text.contains("the coefficients of Ogden 3 are not to be used: its terms cancel"), "{text}");
    assert!(text.contains("! not written: out/material-lsdyna.k: its digits give the uniaxial stress"), "{text}");
    assert!(!there("material-lsdyna.k") && there("material.ssv") && there("material.h"));
    let json = json(folder.path(), &[&fit[..], &["--law", "ogden_3", "--json"]].concat());
    assert!(json["not_written"]["material-lsdyna.k"].as_str().unwrap().contains("expected a difference of 0.1 %"));
}

/// A stretch of compression in percent titled as a strain: the specimen would be softest where it is stretched most.
#[test]
fn a_fit_worse_than_the_mean_is_no_result() {
    let folder = folder();
    let rows: String = (0..21)
        .map(|k| 1.0 - 0.01 * f64::from(k))
        .map(|l| format!("{:.0},{:.3}\n", 100.0 * l, 280.0 * (l.powi(-2) - l)))
        .collect();
    std::fs::write(folder.path().join("wrong.csv"), format!("strain [%],stress [kPa]\n{rows}")).unwrap();
    let line = fail(folder.path(), &["fit", "--uniaxial", "wrong.csv"], 1);
    assert!(line.contains("no stable law describes the data") && line.contains("(--columns)"), "{line}");
    let line = fail(folder.path(), &["fit", "--uniaxial", "wrong.csv", "--law", "neo_hookean"], 1);
    assert!(line.contains("neo-Hookean is farther from the data than their mean (R2 = -"), "{line}");
    let fit = json(folder.path(), &["fit", "--uniaxial", "wrong.csv", "--law", "yeoh_3", "--json"]);
    assert!(fit["laws"].as_array().unwrap().iter().all(|law| law["r_squared"].as_f64().unwrap() >= 0.0), "{fit}");
}

#[test]
fn the_volume_of_a_specimen_is_known_or_said_to_be_assumed() {
    let folder = folder();
    let path = |name: &str| folder.path().join(name);
    // A compressible neo-Hookean solid of C10 = 40 kPa and Poisson's ratio 0.2 of logarithmic strains.
    let row = |k: u32| {
        let l = 1.0 - 0.04 * f64::from(k);
        let lateral = l.powf(-0.2);
        let stress = 80.0 * (l * lateral * lateral).powf(-2.0 / 3.0) * (l * l - lateral * lateral) / l;
        (l, lateral, stress)
    };
    let lines = |lateral: bool| -> String {
        let head = if lateral { "stretch,lateral stretch,stress [kPa]\n" } else { "stretch,stress [kPa]\n" };
        let line = |(l, t, s): (f64, f64, f64)| if lateral { format!("{l},{t},{s}\n") } else { format!("{l},{s}\n") };
        head.to_string() + &(1..16).map(row).map(line).collect::<String>()
    };
    std::fs::write(path("solid.csv"), lines(true)).unwrap();
    std::fs::write(path("foam.csv"), lines(false)).unwrap();
    let c10 = |options: &[&str]| {
        let fit = json(folder.path(), &[&["fit", "--law", "neo_hookean", "--json"], options].concat());
        let law = fit["laws"].as_array().unwrap().iter().find(|law| law["law"] == "neo_hookean").unwrap();
        (law["parameters"]["c10"].as_f64().unwrap(), fit["volume"]["known_by"].as_str().unwrap().to_string())
    };
    let measured = c10(&["--uniaxial", "solid.csv", "--out", "out"]);
    assert!((measured.0 / 40e3 - 1.0).abs() < 1e-9 && measured.1 == "measurement", "{measured:?}");
    let material = std::fs::read_to_string(path("out/material.toml")).unwrap();
    assert!(material.contains("\npoissons_ratio = 0.2"), "{material}");
    let stated = c10(&["--uniaxial", "foam.csv", "--poissons-ratio", "0.2"]);
    assert!((stated.0 / 40e3 - 1.0).abs() < 1e-9 && stated.1 == "statement", "{stated:?}");
    let text = succeed(folder.path(), &["fit", "--uniaxial", "foam.csv"]).replace("\n  ", " ");
    assert!(text.contains("is taken as constant") && text.contains("\"foam\" stands in foam.csv"), "{text}");
    assert_eq!(c10(&["--uniaxial", "foam.csv"]).1, "assumption");
    let refused = fail(folder.path(), &["fit", "--planar", "foam.csv", "--poissons-ratio", "0.2"], 2);
    assert!(refused.contains("legal with a Poisson's ratio below 0.45 is --uniaxial and --equibiaxial"), "{refused}");
    let refused = fail(folder.path(), &["fit", "--uniaxial", "foam.csv", "--poissons-ratio", "0.7"], 2);
    assert!(refused.starts_with("--poissons-ratio: ") && refused.contains("expected"), "{refused}");
}

#[test]
fn what_is_no_result_is_not_shown_as_one() {
    let folder = folder();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    write("falling.csv", "strain [-],stress [kPa]\n0.1,10\n0.2,8\n0.3,6\n0.4,4\n0.5,1\n");
    let error = fail(folder.path(), &["fit", "--uniaxial", "falling.csv", "--law", "neo_hookean"], 1);
    assert!(error.contains("is farther from the data than their mean (R2 = -"), "{error}");
    write("stretch.csv", "mean_strain,mean_stress [kPa]\n1.0,-0.0\n0.9,95\n0.8,221\n");
    let error = fail(folder.path(), &["fit", "--uniaxial", "stretch.csv"], 2);
    assert!(error.contains("is 1 where there is no load, as a stretch is"), "{error}");
    let pairs =
        "Time 1 (s),Force 1 (N),Time 2 (s),Force 2 (N)\n0,4,0,3\n1,3,1,2\n2,2.5,2,1.5\n3,2.3,3,1.4\n4,2.2,4,1.3\n";
    write("pairs.csv", pairs);
    let error = fail(folder.path(), &["fit", "--relaxation", "pairs.csv"], 2);
    assert!(error.contains("2 columns of time: name one with --relaxation-columns"), "{error}");
    let columns = "-, -, time [s], force [N]";
    succeed(folder.path(), &["fit", "--relaxation", "pairs.csv", "--relaxation-columns", columns, "--terms", "1"]);
}

#[test]
fn columns_may_begin_with_one_that_is_passed_over() {
    let folder = folder();
    let rows = "0,1.0,0\n1,1.1,27\n2,1.2,50\n3,1.3,71\n";
    std::fs::write(folder.path().join("abc.csv"), format!("a,b,c\n{rows}")).unwrap();
    let text = succeed(folder.path(), &["fit", "--uniaxial", "abc.csv", "--columns", "-, stretch, stress [kPa]"]);
    assert!(text.contains("stress [kPa] over stretch"), "{text}");
}

/// A foam of one term with a Poisson's ratio of 0: P = 2 mu / alpha (l^(alpha - 1) - 1 / l).
fn foam(strains: impl Iterator<Item = f64>) -> String {
    let stress = |l: f64| 2.0 * 80.0 / 8.0 * (l.powi(7) - 1.0 / l);
    strains.map(|e| format!("{:.4};{:.6}\n", 100.0 * e, -stress(1.0 - e))).collect()
}

/// Positive strains in percent and positive stresses, whose title says compression; nothing tells density and Poisson's ratio.
#[test]
fn a_foam_is_fitted_by_compression_alone() {
    let folder = folder();
    let rows = foam((1..18).map(|k| 0.04 * f64::from(k)));
    let text = format!("compressive strain [%];compressive stress [kPa]\n{rows}");
    std::fs::write(folder.path().join("foam.csv"), text).unwrap();
    let fit = ["fit", "--foam", "--uniaxial", "foam.csv", "--out", "out"];
    let text = succeed(folder.path(), &fit).replace("\n  ", " ");
    for part in [
        "> Ogden-Hill foam 1",
        "Poisson's ratio: it is taken as 0",
        "written: out/material-lsdyna.k",
        "uniaxial compression",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
    let material = std::fs::read_to_string(folder.path().join("out/material.toml")).unwrap();
    let value = |key: &str| {
        let line = material.lines().find(|line| line.starts_with(&format!("{key} = "))).unwrap();
        line.split([' ', '#']).nth(2).unwrap().parse::<f64>().unwrap()
    };
    assert!(material.contains("\n[pad]\n") && material.contains("\n# poissons_ratio = "), "{material}");
    assert!((value("foam_mu_1") / 80e3 - 1.0).abs() < 1e-3 && (value("foam_alpha_1") / 8.0 - 1.0).abs() < 1e-3);
    assert_eq!((value("foam_nu_1"), value("density")), (0.0, 50.0));
    // The file lays the foam into the set-up of a standard.
    let protect = ["protect", "--preset", "rugby-soft-anvil", "--material", "out/material.toml", "--json"];
    assert_eq!(json(folder.path(), &protect)["pads"][0]["complete"], true);
}

/// What a rubber's laws say of a shear is what they say of the same deformation in a planar test.
#[test]
fn a_simple_shear_of_a_rubber_is_fitted() {
    let folder = folder();
    let row = |k: i32| 0.1 * f64::from(k);
    let rows: String = (-10..=10).map(row).map(|g| format!("{g:.1},{:.4}\n", 200.0 * g)).collect();
    std::fs::write(folder.path().join("shear.csv"), format!("shear strain [-],shear stress [kPa]\n{rows}")).unwrap();
    let fit = json(folder.path(), &["fit", "--simple-shear", "shear.csv", "--law", "neo_hookean", "--json"]);
    assert_eq!(fit["data"][0]["amount_of_shear"].as_array().unwrap().len(), 21);
    let law = fit["laws"].as_array().unwrap().iter().find(|law| law["law"] == "neo_hookean").unwrap();
    assert!((law["parameters"]["c10"].as_f64().unwrap() / 100e3 - 1.0).abs() < 1e-9, "{law}");
    assert_eq!(law["tests"][0]["test"], "simple shear");
}

#[test]
fn a_layer_is_said_by_name_or_place() {
    let folder = folder();
    for (layer, section, place) in [("pad=0", "[pad]", 0), ("skin", "[skin]", 1), ("2", "[pad]", 2)] {
        let fit = ["fit", "--uniaxial", "curve.csv", "--law", "neo_hookean", "--layer", layer, "--out", "out"];
        succeed(folder.path(), &fit);
        let read = |name: &str| std::fs::read_to_string(folder.path().join("out").join(name)).unwrap();
        assert!(read("material.toml").contains(&format!("\n{section}\n")), "{layer}");
        assert!(read("material.ssv").contains(&format!("layers[{place}].c10")), "{layer}");
        assert!(read("material.h").contains(&format!("SOFTANVIL_PARAMETER_OF_LAYER({place}, ")), "{layer}");
    }
    assert!(fail(folder.path(), &["fit", "--uniaxial", "curve.csv", "--layer", "4"], 2).contains("0 to 3"));
    let refused = fail(folder.path(), &["fit", "--foam", "--uniaxial", "curve.csv", "--law", "yeoh_2"], 2);
    assert!(refused.contains("expected foam_1, foam_2, foam_3"), "{refused}");
}
