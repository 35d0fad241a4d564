//! Pheromone as a field and as trails, and the ants' walks.

use crate::{
    describe::layers,
    geometry::Cells,
    kernel::{Frame, LayerKey, Shape},
};

use super::{
    ground::Ground,
    pheromone::Pheromone,
    walk::{End, Walks},
};

/// Cells looked at beyond which single steps cannot be seen.
const NEAR: usize = 2500;

/// How much more lies on the strongest step from each cell than where no ant has been; of large grids, on the strongest of a square
/// of cells.
pub(super) fn pheromone(cells: &Cells, pheromone: &Pheromone, frame: &mut Frame) {
    let mut side = 1;
    while cells.columns.div_ceil(side) * cells.rows.div_ceil(side) > frame.budget() {
        side += 1;
    }
    let (columns, rows) = (cells.columns.div_ceil(side), cells.rows.div_ceil(side));
    let untouched = pheromone.elsewhere();
    frame.begin(layers::PHEROMONE.key, Shape::Field);
    let middle = |i: usize| (i as f64 + 0.5) * side as f64 * cells.side;
    for row in 0..rows {
        for column in 0..columns {
            let mut most = -1.0_f64;
            for y in row * side..((row + 1) * side).min(cells.rows) {
                for x in column * side..((column + 1) * side).min(cells.columns) {
                    most = most.max(pheromone.strongest(cells, y * cells.columns + x));
                }
            }
            let more = if most < 0.0 { most } else { (most - untouched).max(0.0) };
            frame.push_field([middle(column), middle(row)], columns, more);
        }
    }
}

/// How much more lies on each step than where no ant has been, from the cell's centre half way to its neighbour, in the part
/// that is looked at from near.
pub(super) fn trails(cells: &Cells, pheromone: &Pheromone, frame: &mut Frame) {
    let Some(window) = frame.window() else {
        return;
    };
    let range = |axis: usize, n: usize| {
        let index = |c: f64| ((c / cells.side).floor().max(0.0) as usize).min(n);
        index(window.min[axis])..(index(window.max[axis]) + 1).min(n)
    };
    let (columns, rows) = (range(0, cells.columns), range(1, cells.rows));
    if columns.len() * rows.len() > NEAR {
        return;
    }
    let untouched = pheromone.elsewhere();
    let most = pheromone.most() - untouched;
    frame.begin(layers::TRAILS.key, Shape::Segments);
    for row in rows {
        for cell in columns.clone().map(|column| row * cells.columns + column) {
            let allowed = cells.moves(cell);
            let from = cells.centre(cell);
            for d in (0..8).filter(|d| allowed >> d & 1 != 0) {
                let to = cells.centre(cells.next(cell, d));
                let more = pheromone.tau(cell, d) - untouched;
                let share = if more > 0.0 { more / most } else { 0.0 };
                frame.push(from, share);
                frame.push([f64::midpoint(from[0], to[0]), f64::midpoint(from[1], to[1])], share);
            }
        }
    }
}

/// Each ant's walk of this iteration; weight 1: it arrived.
pub(super) fn ants(ground: &Ground, walks: &Walks, frame: &mut Frame) {
    let points: usize = walks.ants.iter().map(|ant| walks.of(ant).len() + 1).sum();
    let every = frame.thin(walks.ants.len(), points.div_ceil(walks.ants.len().max(1)), true);
    for ant in walks.ants.iter().step_by(every) {
        let weight = f64::from(u8::from(ant.end == End::Arrived));
        frame.begin(layers::ANTS.key, Shape::Polyline);
        let mut last = [0.0; 2];
        for cell in ground.way(walks.of(ant)) {
            last = ground.cells.centre(cell);
            frame.push(last, weight);
        }
        if walks.of(ant).is_empty() {
            frame.push(last, weight); // a line needs two ends
        }
    }
}

pub(super) fn line(frame: &mut Frame, layer: LayerKey, path: &[[f64; 2]]) {
    frame.begin(layer, Shape::Polyline);
    path.iter().for_each(|&point| frame.push(point, 0.0));
}
