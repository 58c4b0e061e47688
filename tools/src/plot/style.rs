//! Sizes and colours of the pictures.

use plotters::chart::SeriesLabelPosition;
use plotters::style::RGBColor;

/// Drawing units in a pixel. The drawing library rounds every coordinate to a whole unit; whole pixels would make
/// steps of the curves.
pub const UNITS: u32 = 8;

/// Width and height of one panel.
pub const PANEL_SIZE: (u32, u32) = (800 * UNITS, 530 * UNITS);
/// Margin around a panel.
pub const MARGIN: u32 = 20 * UNITS;
/// Height of the title's strip.
pub const TITLE_AREA: u32 = 54 * UNITS;
/// Width of the labels of the vertical axis.
pub const Y_LABEL_AREA: u32 = 76 * UNITS;
/// Height of the labels of the horizontal axis.
pub const X_LABEL_AREA: u32 = 48 * UNITS;

/// Font of all text; the viewer chooses it.
pub const FONT: &str = "sans-serif";
/// Size of the title.
pub const TITLE_SIZE: u32 = 22 * UNITS;
/// Size of axis descriptions and legend.
pub const LABEL_SIZE: u32 = 18 * UNITS;
/// Size of tick labels.
pub const TICK_LABEL_SIZE: u32 = 17 * UNITS;

/// Length of a tick.
pub const TICK: u32 = 5 * UNITS;
/// Width of grid and axes.
pub const THIN: u32 = UNITS;
/// Width of a curve.
pub const CURVE: u32 = 9 * UNITS / 4;
/// Length of the dashes of a measured level and of the gaps between them.
pub const DASH: (u32, u32) = (6 * UNITS, 4 * UNITS);
/// Radius of a marker.
pub const MARKER: u32 = 6 * UNITS;
/// Length of a line in the legend.
pub const LEGEND_LINE: u32 = 28 * UNITS;

/// Upper left of the axes, beside the vertical one.
pub const LEGEND_UPPER_LEFT: SeriesLabelPosition = SeriesLabelPosition::Coordinate(2 * UNITS as i32, 2 * UNITS as i32);

/// Behind everything.
pub const BACKGROUND: RGBColor = RGBColor(255, 255, 255);
/// Text and axes.
pub const INK: RGBColor = RGBColor(38, 42, 48);
/// Grid lines.
pub const GRID: RGBColor = RGBColor(226, 229, 233);

/// Colours of the runs: from the palette of Okabe and Ito, told apart with any colour vision.
const RUNS: [RGBColor; 6] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
];

/// Colour of the run with this index.
pub fn colour(index: usize) -> RGBColor {
    RUNS[index % RUNS.len()]
}

/// Lengths of the dashes of the run with this index and of the gaps between them, which tell runs apart in grey; none for a whole
/// line.
pub fn dash(index: usize) -> Option<(u32, u32)> {
    const DASHES: [Option<(u32, u32)>; 4] =
        [None, Some((12 * UNITS, 4 * UNITS)), Some((3 * UNITS, 3 * UNITS)), Some((8 * UNITS, 8 * UNITS))];
    DASHES[index % DASHES.len()]
}

/// What marks points of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Mark {
    /// A filled circle.
    Circle,
    /// A filled square.
    Square,
    /// A filled triangle.
    Triangle,
    /// A cross.
    Cross,
}

/// The mark of the run with this index.
pub fn mark(index: usize) -> Mark {
    const MARKS: [Mark; 4] = [Mark::Circle, Mark::Square, Mark::Triangle, Mark::Cross];
    MARKS[index % MARKS.len()]
}

/// Marks along a curve, at most.
pub const MARKS: usize = 7;
/// Radius of a mark.
pub const MARK: u32 = 4 * UNITS;

/// The picture at its size in pixels; the view box keeps the drawing units.
pub fn in_pixels(svg: &str, (width, height): (u32, u32)) -> String {
    let attributes = |scale: u32| format!("width=\"{}\" height=\"{}\"", width / scale, height / scale);
    svg.replacen(&attributes(1), &attributes(UNITS), 1)
}
