//! Pictures of the section, as SVG: contours and deformed meshes, with the core and the impactor, to scale.

mod canvas;
mod panel;

use svg::Document;
use svg::node::element::{Group, Rectangle, Text};

use super::animation::{Animation, SHADES, Shade};
use super::{Frame, Instant, Levels};
use canvas::{BACKGROUND, FONT, INK};
use panel::{PANEL, Panel};

/// One run in a picture.
pub struct Shot<'a> {
    /// What its panels are called.
    pub label: String,
    /// Its frames.
    pub animation: &'a Animation,
}

/// Margin around a picture and between its parts, px.
const MARGIN: f64 = 20.0;
/// Height of the title, px.
const TITLE: f64 = 40.0;
/// Height of a colour bar with its ticks, px.
const BAR: f64 = 76.0;

/// The contours of `quantity` at the instants of a run.
pub fn instants(shot: &Shot, quantity: &Shade) -> String {
    let animation = shot.animation;
    let levels = Levels::new(animation.range(quantity));
    let panels =
        animation.instants().iter().filter_map(|instant| panel_of(animation, instant, quantity, &levels)).collect();
    let title = format!("{}: {}", shot.label, quantity.label);
    compose(&title, panels, 2, &[(quantity, levels)])
}

/// Both stresses of every run at its maximum compression.
pub fn maximum_compression(shots: &[Shot]) -> String {
    let scales = SHADES.each_ref().map(|shade| {
        let ranges = shots.iter().filter_map(|shot| {
            let values = shot.animation.shaded(shot.animation.deepest()?, shade);
            Some(values.into_iter().fold([0.0, 0.0], |[a, b]: [f64; 2], v| [a.min(v), b.max(v)]))
        });
        Levels::new(ranges.fold([0.0, 0.0], |[a, b]: [f64; 2], [low, high]| [a.min(low), b.max(high)]))
    });
    let mut panels = Vec::new();
    for shot in shots {
        for (shade, levels) in SHADES.iter().zip(&scales) {
            let Some((mesh, frame)) = shot.animation.mesh().zip(shot.animation.deepest()) else { continue };
            let caption = format!("{}, {}", shot.label, numbers(shot.animation, frame));
            panels.push(Panel::contours(mesh, frame, &shot.animation.shaded(frame, shade), levels).titled(caption));
        }
    }
    let [first, second] = &SHADES;
    let [a, b] = scales;
    compose("Maximum compression", panels, 2, &[(first, a), (second, b)])
}

/// The mesh of every run at its maximum compression, over its outline at rest.
pub fn deformed_mesh(shots: &[Shot]) -> String {
    let panels = shots.iter().filter_map(|shot| {
        let (mesh, frame) = shot.animation.mesh().zip(shot.animation.deepest())?;
        Some(Panel::mesh(mesh, frame).titled(format!("{}, {}", shot.label, numbers(shot.animation, frame))))
    });
    compose("Deformed mesh at maximum compression", panels.collect(), 1, &[])
}

fn panel_of(animation: &Animation, instant: &Instant, quantity: &Shade, levels: &Levels) -> Option<Panel> {
    let (mesh, frame) = animation.mesh().zip(animation.frames().get(instant.frame))?;
    let caption = format!("{}: {}", instant.label, numbers(animation, frame));
    Some(Panel::contours(mesh, frame, &animation.shaded(frame, quantity), levels).titled(caption))
}

/// Time since contact, deformation and force of a frame.
fn numbers(animation: &Animation, frame: &Frame) -> String {
    format!(
        "{:.2} ms, {:.2} mm, {:.0} N",
        animation.since_contact(frame) * 1e3,
        frame.scalars.impactor.deformation() * 1e3,
        frame.scalars.sampler.last.contact_force
    )
}

/// A picture of `panels` in rows of `columns`, with the colour bars under the columns.
fn compose(title: &str, panels: Vec<Panel>, columns: usize, bars: &[(&Shade, Levels)]) -> String {
    let rows = panels.len().div_ceil(columns);
    let width = columns as f64 * (PANEL[0] + MARGIN) + MARGIN;
    let top = TITLE + MARGIN;
    let bars_at = top + rows as f64 * (PANEL[1] + MARGIN);
    let height = bars_at + if bars.is_empty() { 0.0 } else { BAR };
    let mut document = Document::new()
        .set("width", width)
        .set("height", height)
        .set("viewBox", (0.0, 0.0, width, height))
        .set("font-family", FONT)
        .set("fill", INK)
        .add(Rectangle::new().set("width", width).set("height", height).set("fill", BACKGROUND))
        .add(Text::new(title).set("x", MARGIN).set("y", MARGIN + 18.0).set("font-size", 20));
    for (index, panel) in panels.into_iter().enumerate() {
        let place = [(index % columns) as f64 * (PANEL[0] + MARGIN), (index / columns) as f64 * (PANEL[1] + MARGIN)];
        document = document.add(moved(panel.draw(), [MARGIN + place[0], top + place[1]]));
    }
    let share = (width - MARGIN) / bars.len().max(1) as f64;
    for (index, (shade, levels)) in bars.iter().enumerate() {
        let bar = canvas::colour_bar(shade.label, levels, share - MARGIN);
        document = document.add(moved(bar, [MARGIN + index as f64 * share, bars_at]));
    }
    format!("{document}\n")
}

fn moved(group: Group, [x, y]: [f64; 2]) -> Group {
    group.set("transform", format!("translate({x} {y})"))
}
