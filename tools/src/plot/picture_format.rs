//! What a picture is stored as: drawn as SVG, it stays that or becomes the points of a PNG.

use std::path::Path;

use clap::ValueEnum;
use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::{Options, Tree};

use crate::plot::PlotError;

/// The font of a PNG, so that it has its text, and the same, on every machine.
const FONT: &[u8] = include_bytes!("../../assets/LiberationSans-Regular.ttf");
const FONT_NAME: &str = "Liberation Sans";
/// Points of a PNG to a pixel of the SVG, in each direction: sharp on screens of twice the usual resolution and in print.
const SCALE: f32 = 2.0;

/// Format of a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum PictureFormat {
    /// Lines and text, to any size.
    #[default]
    Svg,
    /// Points on white, two to a pixel of the SVG.
    Png,
}

impl PictureFormat {
    /// The format that the name of a file asks for, by its extension in capitals or not.
    pub fn of(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_str()?;
        [Self::Svg, Self::Png].into_iter().find(|format| extension.eq_ignore_ascii_case(format.extension()))
    }

    /// How names of its files end.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Svg => "svg",
            Self::Png => "png",
        }
    }

    /// The file of a picture drawn as SVG.
    ///
    /// # Errors
    /// What the drawing library refuses.
    pub fn file(self, svg: String) -> Result<Vec<u8>, PlotError> {
        match self {
            Self::Svg => Ok(svg.into_bytes()),
            Self::Png => png(&svg),
        }
    }
}

fn png(svg: &str) -> Result<Vec<u8>, PlotError> {
    let mut options = Options { font_family: FONT_NAME.into(), ..Options::default() };
    let fonts = options.fontdb_mut();
    fonts.load_font_data(FONT.to_vec());
    fonts.set_sans_serif_family(FONT_NAME);
    let tree = Tree::from_str(svg, &options).map_err(PlotError::new)?;
    let [width, height] = [tree.size().width(), tree.size().height()].map(|length| (SCALE * length).round() as u32);
    let mut points = Pixmap::new(width, height).ok_or_else(|| PlotError::new("it is too large"))?;
    points.fill(Color::WHITE);
    resvg::render(&tree, Transform::from_scale(SCALE, SCALE), &mut points.as_mut());
    points.encode_png().map_err(PlotError::new)
}
