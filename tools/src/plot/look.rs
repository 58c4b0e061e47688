//! How a picture is drawn: as a file of its own, or for a page that has title and legend beside it.

use serde::Serialize;

use super::style::{PANEL_SIZE, UNITS};

/// How a panel is drawn.
#[derive(Clone, Copy, Debug)]
pub struct Look {
    /// Width and height, in drawing units.
    pub size: (u32, u32),
    /// Whether it has a title and a legend.
    pub lettered: bool,
    /// The part of the horizontal axis that is shown; all of it if there is none.
    pub window: Option<[f64; 2]>,
}

impl Look {
    /// A panel of a file.
    pub const FILE: Self = Self { size: PANEL_SIZE, lettered: true, window: None };

    /// For a page: so many pixels, and a part of the horizontal axis.
    pub fn bare([width, height]: [u32; 2], window: Option<[f64; 2]>) -> Self {
        Self { size: (width * UNITS, height * UNITS), lettered: false, window }
    }
}

/// Where the axes of a drawn panel are, by which a page finds values under a pointer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Place {
    /// Left and right end of the horizontal axis, lower and upper of the vertical one, px from the upper left corner.
    pub pixels: [[f64; 2]; 2],
    /// What stands there.
    pub values: [[f64; 2]; 2],
}

/// A panel for a page.
#[derive(Clone, Debug, Serialize)]
pub struct Bare {
    /// The picture.
    pub svg: String,
    /// Its axes.
    pub place: Place,
}

/// The part of `points` whose abscissa is within `window`, in pieces, ends interpolated; all of them where there is none.
pub fn within(points: &[(f64, f64)], window: Option<[f64; 2]>) -> Vec<Vec<(f64, f64)>> {
    let Some([low, high]) = window else { return vec![points.to_vec()] };
    let mut pieces: Vec<Vec<(f64, f64)>> = Vec::new();
    let mut open = false;
    for pair in points.windows(2) {
        let [(x0, y0), (x1, y1)] = [pair[0], pair[1]];
        // Shares of the segment at which it enters and leaves.
        let share = |x: f64| if x1 == x0 { 0.0 } else { (x - x0) / (x1 - x0) };
        let (first, last) = if x1 >= x0 { (share(low), share(high)) } else { (share(high), share(low)) };
        let (from, to) = (first.max(0.0), if x1 == x0 { 1.0 } else { last.min(1.0) });
        if from > to || (x1 == x0 && !(low..=high).contains(&x0)) {
            open = false;
            continue;
        }
        let at = |share: f64| (x0 + share * (x1 - x0), y0 + share * (y1 - y0));
        if !open {
            pieces.push(vec![at(from)]);
        }
        if let Some(piece) = pieces.last_mut() {
            piece.push(at(to));
        }
        open = to == 1.0;
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_window_cuts_a_loop_into_the_pieces_that_are_in_it() {
        let there_and_back = [(0.0, 0.0), (2.0, 4.0), (4.0, 6.0), (2.0, 3.0), (0.0, 0.0)];
        assert_eq!(within(&there_and_back, None), [there_and_back.to_vec()]);
        let pieces = within(&there_and_back, Some([1.0, 3.0]));
        assert_eq!(pieces, [vec![(1.0, 2.0), (2.0, 4.0), (3.0, 5.0)], vec![(3.0, 4.5), (2.0, 3.0), (1.0, 1.5)]]);
        assert!(within(&there_and_back, Some([5.0, 6.0])).is_empty());
        assert_eq!(within(&[(1.0, 0.0), (1.0, 2.0)], Some([0.0, 2.0])), [vec![(1.0, 0.0), (1.0, 2.0)]]);
    }
}
