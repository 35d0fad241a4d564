//! Start and goal for maps that have none.

use forage::{
    geometry::YAxis,
    kernel::Message,
    message,
    scene::{GridScene, reach::reach},
};

/// Puts start and goal where the way is long: the first free cell, in reading order, of the largest region that hangs
/// together, and the cell that is the farthest from it. Returns a note; `None` if no cell is free.
pub(super) fn choose(grid: &mut GridScene) -> Option<Message> {
    let (columns, rows) = (grid.columns, grid.rows());
    let mut seen = vec![false; grid.blocked.len()];
    let mut best: Option<(usize, [usize; 2])> = None;
    for row in 0..rows {
        // Reading begins with the top row, whichever way y grows.
        let row = if grid.y_axis == YAxis::Up { rows - 1 - row } else { row };
        for cell in row * columns..(row + 1) * columns {
            if !grid.blocked[cell] && !seen[cell] {
                let region = reach(&grid.blocked, columns, cell, &mut seen);
                if best.is_none_or(|(size, _)| region.len() > size) {
                    best = Some((region.len(), [cell, *region.last()?]));
                }
            }
        }
    }
    let (_, ends) = best?;
    let [start, goal] = ends.map(|cell| [cell % columns, cell / columns].map(|i| (i as f64 + 0.5) * grid.cell));
    (grid.start, grid.goal) = (Some(start), Some(goal));
    let [ax, ay] = start;
    let [bx, by] = goal;
    Some(message!(
        "files-chose-ends",
        "The file has no start and no goal: they were put far apart in its largest region, at ({ax}, {ay}) and ({bx}, {by}).",
        ax,
        ay,
        bx,
        by
    ))
}
