//! Obstacles that are strewn about: exactly the share that is asked for, as far as a way is left.
//!
//! Reading of "a given share, start and goal always connected": cells are drawn as if nothing had to be connected. If no
//! way is left, the one that crosses the fewest blocked cells is cleared, and as many other cells are blocked instead.
//! The share, of all cells, is met to the nearest cell, but for shares that leave too few cells for the shortest way
//! (columns + rows − 1): then all but a shortest way is blocked, and a note says so.

use crate::{
    describe::Generator,
    kernel::{rng::Stream, words},
    params::{Param, Parameters},
    scene::{
        GRID,
        reach::{beside, crossing},
    },
};

use super::{
    grids,
    moving::STOPS_AND_MOVING,
    plot::{CELL, COLUMNS, Plot, ROWS},
};

const SHARE: Param<f64> = Param::number("share", "", "Share", [0.0, 1.0, 0.3], "How much of the grid is blocked.");
const SIZE: Param<u64> =
    Param::integer("size", "", "Largest heap", [1, 1000, 7], "Heaps are 1 to this many cells across, more or less round.")
        .slider(1.0, 30.0, false);

/// Single cells.
pub const RANDOM: Generator = Generator {
    name: "random",
    title: "Random obstacles",
    help: words(
        "Single cells, each as likely as the others, until the share is blocked. Where that would leave no way, one is cleared \
           and as many other cells are blocked.",
    ),
    kind: GRID,
    parameters: &[&[COLUMNS.entry(), ROWS.entry(), CELL.entry(), SHARE.entry()], STOPS_AND_MOVING],
    draw: |parameters, seed| {
        grids::grid(parameters, seed, |parameters, plot, stream| {
            plot.scatter(parameters[SHARE], stream, &mut |plot, stream, count| {
                let mut free = plot.free();
                for _ in 0..count {
                    plot.blocked[free.swap_remove(stream.below(free.len()))] = true;
                }
            });
        })
    },
};

/// Heaps of cells.
pub const RUBBLE: Generator = Generator {
    name: "rubble",
    title: "Rubble",
    help: words("Heaps of different sizes, each grown from a cell at random, until the share is blocked."),
    kind: GRID,
    parameters: &[&[COLUMNS.entry(), ROWS.entry(), CELL.entry(), SHARE.entry(), SIZE.entry()], STOPS_AND_MOVING],
    draw: |parameters, seed| grids::grid(parameters, seed, rubble),
};

fn rubble(parameters: &Parameters, plot: &mut Plot, stream: &mut Stream) {
    let largest = parameters[SIZE] as usize;
    plot.scatter(parameters[SHARE], stream, &mut |plot, stream, mut count| {
        let mut free = plot.free();
        while count > 0 && !free.is_empty() {
            let across = 1 + stream.below(largest);
            let mut left = count.min(across * across);
            // A heap grows by one cell of its edge at a time; where it cannot grow it stays smaller.
            let mut edge = vec![free.swap_remove(stream.below(free.len()))];
            while left > 0 && !edge.is_empty() {
                let cell = edge.swap_remove(stream.below(edge.len()));
                if !plot.blocked[cell] && !plot.kept[cell] {
                    plot.blocked[cell] = true;
                    (left, count) = (left - 1, count - 1);
                    edge.extend(beside(cell, plot.columns, plot.blocked.len()));
                }
            }
        }
    });
}

impl Plot {
    /// The cells that can be blocked.
    fn free(&self) -> Vec<usize> {
        (0..self.blocked.len()).filter(|&cell| !self.blocked[cell] && !self.kept[cell]).collect()
    }

    /// Lets `fill` block a share of the cells, and sees to it that a way is left.
    fn scatter(&mut self, share: f64, stream: &mut Stream, fill: &mut dyn FnMut(&mut Self, &mut Stream, usize)) {
        let all = self.blocked.len();
        let asked = (share * all as f64).round() as usize;
        let count = asked.min(all - (self.columns + self.rows - 1));
        if count < asked {
            self.note = Some(format!("{count} of {all} cells are blocked, not {asked}: more would leave no way from start to goal."));
        }
        let [start, goal] = self.ends;
        (self.kept[start], self.kept[goal]) = (true, true);
        fill(self, stream, count);
        let mut way = crossing(&self.blocked, self.columns, start, goal);
        if way.iter().any(|&cell| self.blocked[cell]) {
            if way.len() > all - count {
                way = self.stairs(stream);
            }
            let mut cleared = 0;
            for cell in way {
                cleared += usize::from(self.blocked[cell]);
                (self.blocked[cell], self.kept[cell]) = (false, true);
            }
            fill(self, stream, cleared);
        }
    }

    /// A shortest way in a grid without obstacles, its turns at random.
    fn stairs(&self, stream: &mut Stream) -> Vec<usize> {
        let (mut cell, goal) = (0, self.blocked.len() - 1);
        let mut way = vec![cell];
        while cell != goal {
            let (right, down) = (self.columns - 1 - cell % self.columns, self.rows - 1 - cell / self.columns);
            cell += if stream.below(right + down) < right { 1 } else { self.columns };
            way.push(cell);
        }
        way
    }
}
