//! Which cells the monitor visits in a step.

use crate::number::pack::LANES;

/// The monitor visits every cell at least once in this many steps. At the study's speeds a stretch changes by some
/// hundredths in that time.
pub const MONITOR_PERIOD: usize = 64;

/// The fewest cells that it visits in a step: on a small mesh, all cells have their turn sooner.
const MIN_GROUP: usize = 4;

/// The cells that a step visits: groups of neighbours.
pub(super) struct MonitorWindow {
    /// Cells of a group, a divisor of [`LANES`].
    pub group: usize,
    /// The first group.
    first: usize,
    /// Number of groups.
    pub count: usize,
    /// Groups of the mesh, after the last of which comes the first.
    of: usize,
}

impl MonitorWindow {
    /// Of the step `step_index`, for a mesh of so many `cells`, padding included.
    pub fn new(cells: usize, step_index: u64) -> Self {
        let each = cells.div_ceil(MONITOR_PERIOD);
        let (group, count, of) = if each > MIN_GROUP {
            (LANES, each.div_ceil(LANES), cells / LANES)
        } else {
            (MIN_GROUP, 1, cells / MIN_GROUP)
        };
        let first = step_index % of.div_ceil(count).max(1) as u64;
        Self { group, first: first as usize * count, count, of }
    }

    /// All `cells` of a mesh.
    pub fn whole(cells: usize) -> Self {
        Self { group: LANES, first: 0, count: cells / LANES, of: cells / LANES }
    }

    /// Of these the `number`-th part, of `size` groups but for the last one.
    pub fn part(&self, number: usize, size: usize) -> Self {
        let start = (number * size).min(self.count);
        Self { first: self.first + start, count: size.min(self.count - start), ..*self }
    }

    /// The first cell of the group `turn`.
    pub fn cell(&self, turn: usize) -> usize {
        let place = self.first + turn;
        self.group * if place < self.of { place } else { place - self.of }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_monitor_visits_every_cell_in_its_period() {
        for blocks in 1..300 {
            let cells = blocks * LANES;
            for start in [0, 1, 12_345] {
                let mut visits = [0; 300 * LANES];
                for step in start..start + MONITOR_PERIOD as u64 {
                    let share = MonitorWindow::new(cells, step);
                    for cell in (0..share.count).map(|turn| share.cell(turn)) {
                        assert_eq!(cell / LANES, (cell + share.group - 1) / LANES);
                        visits[cell..cell + share.group].iter_mut().for_each(|visits| *visits += 1);
                    }
                }
                assert!(visits[..cells].iter().all(|visits| *visits > 0), "{cells} cells from step {start}");
            }
        }
    }
}
