//! Pictures as PNG, wherever a command writes one: the picture that SVG has, with its text, on machines without a font.

use std::fs;
use std::path::Path;

use crate::common::{entries, fail, succeed, svg_texts};
use resvg::tiny_skia::Pixmap;
use softanvil_tools::plot::picture_format::PictureFormat;

/// Points of a PNG to a pixel of the SVG.
const SCALE: u32 = 2;

/// Width and height of an SVG, pixels.
fn size(svg: &str) -> [u32; 2] {
    let document = roxmltree::Document::parse(svg).unwrap();
    ["width", "height"].map(|name| document.root_element().attribute(name).unwrap().parse().unwrap())
}

/// The SVG with its texts empty.
fn without_texts(svg: &str) -> String {
    let document = roxmltree::Document::parse(svg).unwrap();
    let texts = document.descendants().filter(|node| node.is_text() && node.parent().unwrap().has_tag_name("text"));
    let mut text = svg.to_string();
    for node in texts.collect::<Vec<_>>().iter().rev() {
        text.replace_range(node.range(), "");
    }
    text
}

/// Points that differ.
fn differences(one: &Pixmap, other: &Pixmap) -> usize {
    assert_eq!((one.width(), one.height()), (other.width(), other.height()));
    one.pixels().iter().zip(other.pixels()).filter(|(a, b)| a != b).count()
}

/// Checks that `png` shows what `svg` does.
fn same_picture(png: &Path, svg: &Path) {
    let (name, source) = (png.display(), fs::read_to_string(svg).unwrap());
    let found = Pixmap::decode_png(&fs::read(png).unwrap()).unwrap();
    assert_eq!([found.width(), found.height()], size(&source).map(|length| SCALE * length), "{name}");
    assert!(found.pixels().iter().all(|point| point.alpha() == u8::MAX), "{name}");
    // The margin is white, and something stands in it.
    let white = |x, y| found.pixel(x, y).unwrap().red() == u8::MAX;
    assert!(white(0, 0) && white(found.width() - 1, found.height() - 1), "{name}");
    let drawn = found.pixels().iter().filter(|point| point.red() < 200 || point.blue() < 200).count();
    assert!(drawn > found.pixels().len() / 100, "{name}: {drawn} points drawn");
    // Without its texts it is another picture: each of them has a few dozen points of ink at least.
    let bare = PictureFormat::Png.file(without_texts(&source)).unwrap();
    let ink = differences(&found, &Pixmap::decode_png(&bare).unwrap());
    let letters: usize = svg_texts(svg).iter().map(|text| text.chars().filter(|c| !c.is_whitespace()).count()).sum();
    assert!(letters > 20 && ink > 20 * letters, "{name}: {ink} points of text for {letters} letters");
}

/// Runs a command that writes a folder of pictures in both formats, and compares them; the number of pictures.
fn both_formats(folder: &Path, command: &[&str]) -> usize {
    succeed(folder, &[command, &["--out", "drawn"]].concat());
    succeed(folder, &[command, &["--out", "points", "--pictures", "png"]].concat());
    let [drawn, points] = ["drawn", "points"].map(|name| folder.join(name));
    let mut expected: Vec<String> = entries(&drawn).iter().map(|name| name.replace(".svg", ".png")).collect();
    expected.sort();
    let found = entries(&points);
    assert_eq!(found, expected);
    let pictures: Vec<String> = found.iter().filter(|name| name.ends_with(".png")).cloned().collect();
    for name in &pictures {
        same_picture(&points.join(name), &drawn.join(name.replace(".png", ".svg")));
    }
    pictures.len()
}

#[test]
fn a_run_draws_png_by_the_name() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    for name in ["drop.svg", "drop.png", "DROP.PNG"] {
        let text = succeed(folder.path(), &["run", "--energy", "4.9", "--plot", name]);
        assert!(text.contains(&format!("written: {name}")), "{text}");
    }
    same_picture(&path("drop.png"), &path("drop.svg"));
    assert!(fs::read(path("drop.png")).unwrap() == fs::read(path("DROP.PNG")).unwrap());
}

#[test]
fn a_measurement_draws_png_by_the_name() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["read.svg", "read.png"] {
        succeed(folder.path(), &["measure", "--energy", "4.9", "--plot", name]);
    }
    same_picture(&folder.path().join("read.png"), &folder.path().join("read.svg"));
}

#[test]
fn folders_have_their_pictures_as_png_when_asked() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(both_formats(folder.path(), &[]), 7);

    let folder = tempfile::tempdir().unwrap();
    assert_eq!(both_formats(folder.path(), &["sweep", "silicone.thickness=0.02,0.025"]), 1);
    let page = fs::read_to_string(folder.path().join("points/silicone.thickness.md")).unwrap();
    assert!(page.contains("(silicone.thickness.png)") && !page.contains(".svg"), "{page}");

    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("curve.csv"), "stretch,stress [Pa]\n1,0\n0.9,-20000\n0.8,-46000\n0.7,-82000\n")
        .unwrap();
    let data = ["fit", "--uniaxial", "curve.csv", "--law", "neo_hookean"];
    assert_eq!(both_formats(folder.path(), &data), 1);
}

#[test]
fn other_formats_are_refused_before_anything_is_computed() {
    let folder = tempfile::tempdir().unwrap();
    for command in ["run", "measure"] {
        for name in ["force.jpg", "force", ".png", "png", "force.svg.pdf"] {
            let line = fail(folder.path(), &[command, "--plot", name, "--csv", "trace.csv"], 2);
            assert!(line.contains(&format!("--plot {name} is refused")), "{line}");
            assert!(line.contains("expected a file name that ends in .svg or .png"), "{line}");
        }
    }
    for command in [&[][..], &["sweep", "impactor.mass=4"], &["fit", "--paper"]] {
        let line = fail(folder.path(), &[command, &["--pictures", "jpg", "--out", "out"]].concat(), 2);
        assert!(line.contains("jpg") && line.contains("svg") && line.contains("png"), "{line}");
    }
    assert!(entries(folder.path()).is_empty());
}
