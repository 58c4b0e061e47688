//! Colours, paths and the colour bar of the section's pictures.

use svg::node::element::{Group, Path, Rectangle, Text};

use crate::section::Levels;

/// Behind everything.
pub const BACKGROUND: &str = "#ffffff";
/// Text and outlines.
pub const INK: &str = "#262a30";
/// Steel.
pub const STEEL: &str = "#b4bac2";
/// Font of all text; the viewer chooses it.
pub const FONT: &str = "sans-serif";

/// Height of the colours of a colour bar, px.
const HEIGHT: f64 = 16.0;

/// Closed polygons as one path, so that no seam shows between them.
pub fn closed<'a>(polygons: impl Iterator<Item = &'a [[f64; 2]]>) -> Path {
    let mut data = String::new();
    for polygon in polygons {
        data += &points(polygon);
        data.push('z');
    }
    Path::new().set("d", data)
}

/// An open line.
pub fn open(line: &[[f64; 2]]) -> Path {
    Path::new().set("d", points(line)).set("fill", "none")
}

/// "Mx y x y ...", to a tenth of a pixel.
fn points(line: &[[f64; 2]]) -> String {
    let texts = line.iter().map(|[x, y]| format!("{x:.1} {y:.1}"));
    format!("M{}", texts.collect::<Vec<_>>().join(" "))
}

/// A colour bar with ticks at the bounds of the bands.
pub fn colour_bar(label: &str, levels: &Levels, width: f64) -> Group {
    let step = width / levels.bands() as f64;
    // Ticks need about 48 px.
    let every = (48.0 / step).ceil().max(1.0) as usize;
    // One of them at zero.
    let first = levels.zero() % every;
    let mut group = Group::new().set("font-size", 13);
    for band in 0..levels.bands() {
        let block = Rectangle::new().set("x", round(band as f64 * step)).set("width", round(step + 0.5));
        group = group.add(block.set("height", HEIGHT).set("fill", levels.colour(band)));
    }
    for (index, bound) in levels.bounds.iter().enumerate().filter(|(index, _)| index % every == first) {
        let anchor = match index {
            0 => "start",
            last if last == levels.bands() => "end",
            _ => "middle",
        };
        let text = Text::new(levels.text(*bound)).set("x", round(index as f64 * step)).set("y", HEIGHT + 16.0);
        group = group.add(text.set("text-anchor", anchor));
    }
    let label = Text::new(format!("{label} ({}), means at the nodes", levels.unit));
    group.add(label.set("x", 0).set("y", HEIGHT + 38.0).set("font-size", 15))
}

fn round(value: f64) -> f64 {
    (value * 10.0).round() / 10.0
}
