//! The files that edits start from: the project's own, and a small one of each layout.

use std::fs;
use std::path::Path;
use std::sync::OnceLock;

use softanvil_identify::export::{Layer, abaqus, c_source, ls_dyna, ssv};
use softanvil_kernel::preset;
use softanvil_tools::scenario_file;

/// The root of the project, seen from the folder of either package that has these targets.
pub fn root() -> &'static Path {
    let mut above = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors();
    above.find(|folder| folder.join("ARCHITECTURE.md").is_file()).unwrap()
}

/// Bytes of a seed, at most, so that edits meet what matters and readers are quick.
const LONGEST: usize = 2000;

type Seeds = OnceLock<Vec<Vec<u8>>>;

/// Files of the project by their paths, folders for all that is in them, cut after whole lines.
fn files(paths: &[&str]) -> Vec<Vec<u8>> {
    let mut all = Vec::new();
    for path in paths.iter().map(|path| root().join(path)) {
        match fs::read_dir(&path) {
            Ok(entries) => all.extend(entries.map(|entry| entry.unwrap().path()).filter(|path| path.is_file())),
            Err(_) => all.push(path),
        }
    }
    all.sort();
    all.iter().map(|path| cut(fs::read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display())))).collect()
}

fn cut(mut bytes: Vec<u8>) -> Vec<u8> {
    if bytes.len() > LONGEST {
        let end = bytes[..LONGEST].iter().rposition(|byte| *byte == b'\n').map_or(LONGEST, |end| end + 1);
        bytes.truncate(end);
    }
    bytes
}

pub fn scenarios() -> &'static [Vec<u8>] {
    static ALL: Seeds = Seeds::new();
    ALL.get_or_init(|| {
        let mut all = files(&["examples/quasi-static.toml", "calibration/best"]);
        all.push(b"[geometry]\nformulation = \"axisymmetric\"\n[mesh]\nelement_size = 5e-3\n[silicone]\nlaw = \"ogden\"\nmu = [1e5]\n".into());
        all.push(b"[[layers]]\nname = \"a\"\nthickness = 0.01\n[[layers]]\nname = \"b\"\nthickness = 2e-3\ninterface = \"separating\"\ngap = 1e-3\n".into());
        all.push(cut(scenario_file::to_toml(&preset::study()).into_bytes()));
        all
    })
}

pub fn problems() -> &'static [Vec<u8>] {
    static ALL: Seeds = Seeds::new();
    ALL.get_or_init(|| {
        files(&[
            "calibration/all.toml",
            "calibration/only-14.7.toml",
            "calibration/material-tests.toml",
            "calibration/front",
        ])
    })
}

pub fn sweeps() -> &'static [Vec<u8>] {
    static ALL: Seeds = Seeds::new();
    ALL.get_or_init(|| files(&["sweeps"]))
}

/// The project's posterior with its first samples.
pub fn posteriors() -> &'static [Vec<u8>] {
    static ALL: Seeds = Seeds::new();
    ALL.get_or_init(|| {
        let path = root().join("tools/assets/posteriors/study.json");
        let mut whole: serde_json::Value = serde_json::from_slice(&fs::read(path).unwrap()).unwrap();
        whole["samples"].as_array_mut().unwrap().truncate(2);
        whole["impacts"].as_array_mut().unwrap().clear();
        vec![whole.to_string().into_bytes()]
    })
}

fn rows(separator: &str, decimal: &str) -> String {
    let row = |i: u32| format!("{:.4}{separator}{:.2}\n", 1e-3 * f64::from(i), f64::from(i % 7) * 100.0);
    (0..30).map(row).collect::<String>().replace('.', decimal)
}

pub fn traces() -> &'static [Vec<u8>] {
    static ALL: Seeds = Seeds::new();
    ALL.get_or_init(|| {
        let (dots, commas, tabs) = (rows(",", "."), rows(";", ","), rows("\t", "."));
        let scope: String = dots.lines().map(|line| format!(",,,{line}\n")).collect();
        let unicode = format!("\u{feff}t [s];F [N]\n{commas}");
        let mut all = vec![
            format!("# a drop\nMass,5.0,kg\ntime [s],force [N]\n{dots}Max,6\n").into_bytes(),
            format!("Zeit;Kraft\nms;kN\n{commas}").into_bytes(),
            format!("time [ms],acceleration [g],displacement [mm]\n{}", dots.replace('\n', ",1\n")).into_bytes(),
            format!("LabVIEW Measurement\nSeparator\tTab\nDecimal_Separator\t.\n***End_of_Header***\nX0\t0\nDelta_X\t0.001\nX_Value\tForce [N]\tComment\n{tabs}").into_bytes(),
            format!("X,CH1,Start,Increment\nSequence,Volt,-1e-3,1e-3\n{dots}").into_bytes(),
            format!("Record Length,40,,0.1,0.2\nSample Interval,0.001,,0.2,0.3\nVertical Units,V,,0.3,0.1\n{scope}").into_bytes(),
            unicode.encode_utf16().flat_map(u16::to_le_bytes).collect(),
            b"Unit :N\nChannel code :D0ANVL000000FOZP\nSampling interval :1E-3\n1\n2\n3\n4\n5\n".into(),
        ];
        all.extend(files(&["data/tutorial"]));
        all
    })
}

pub fn material_tests() -> &'static [Vec<u8>] {
    static ALL: Seeds = Seeds::new();
    ALL.get_or_init(|| {
        let mut all = files(&["data/treloar", "data/foam"]);
        all.push(
            format!("\"strain [%]\",\"stress [kPa]\"\n{0}\nstrain [%],stress [kPa]\n{0}", rows(",", ".")).into_bytes(),
        );
        all.push(format!("displacement [mm];force [N]\n{}", rows(";", ",")).into_bytes());
        all.push(format!("time [s],strain [%],stress [MPa]\n{}", rows(",", ".").replace('\n', ",0.3\n")).into_bytes());
        all.push(b"time [s],stress [kPa]\n0,100\n1,80\n10,60\n100,55\n1000,55\n".into());
        all
    })
}

/// Sheets of a workbook, as XML.
pub fn sheets() -> &'static [Vec<u8>] {
    static ALL: Seeds = Seeds::new();
    ALL.get_or_init(|| {
        let text = |name: &str, text: &str| format!("<c r=\"{name}\" t=\"inlineStr\"><is><t>{text}</t></is></c>");
        let row = |i: u32| {
            format!(
                "<row r=\"{i}\"><c r=\"A{i}\"><v>{}</v></c><c r=\"B{i}\"><v>{}</v></c></row>",
                f64::from(i) * 1e-3,
                i % 7
            )
        };
        let sheet = |titles: [&str; 2]| {
            let head = format!("<row r=\"1\">{}{}</row>", text("A1", titles[0]), text("B1", titles[1]));
            (head + &(2..30).map(row).collect::<String>()).into_bytes()
        };
        vec![sheet(["time [s]", "force [N]"]), sheet(["strain [%]", "stress [kPa]"])]
    })
}

/// A material in the words of each other program.
pub fn cards() -> &'static [Vec<u8>] {
    static ALL: Seeds = Seeds::new();
    ALL.get_or_init(|| {
        let material = &preset::study().layers[0].material;
        let layer = Layer { place: 0, name: "silicone".into() };
        let mut all = vec![
            ssv::text("study", material, &layer).unwrap(),
            c_source::text("study", material, &layer),
            scenario_file::material_to_toml(&preset::study(), 0, "study"),
        ];
        all.extend(abaqus::text("study", "study", material));
        all.extend(ls_dyna::text("study", "study", material));
        all.into_iter().map(String::into_bytes).collect()
    })
}
