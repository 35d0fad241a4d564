//! Drawing a grid: blocked cells, then stops and what moves.

use crate::{describe::Draft, kernel::rng::Stream, params::Parameters, scene::GridScene};

use super::{
    calls,
    moving::{self, MOVING},
    plot::{CELL, COLUMNS, Plot, ROWS, STOPS},
};

/// Draws a grid: `draw` blocks cells, and sees to it that there is a way; then come stops and what moves.
pub(super) fn grid(parameters: &Parameters, seed: u64, draw: fn(&Parameters, &mut Plot, &mut Stream)) -> Draft {
    let [columns, rows, stops, moving] =
        [parameters[COLUMNS], parameters[ROWS], parameters[STOPS], parameters[MOVING]].map(|count| count as usize);
    let count = columns * rows;
    let mut plot = Plot { columns, rows, blocked: vec![false; count], kept: vec![false; count], ends: [0, count - 1], note: None };
    draw(parameters, &mut plot, &mut Stream::new(seed, 0));
    let cell = parameters[CELL];
    let [start, goal] = plot.ends.map(|end| Some([end % columns, end / columns].map(|i| (i as f64 + 0.5) * cell)));
    let mut grid = GridScene { start, goal, ..GridScene::new(cell, columns, plot.blocked) };
    let mut notes: Vec<_> = plot.note.into_iter().collect();
    // Both from streams of their own: the grid is the same with them and without.
    if stops > 0 {
        let there = calls::place(&mut grid, stops, &mut Stream::new(seed, 1));
        if there < stops {
            notes.push(format!("There are {there} stops, not {stops}: there is room for no more."));
        }
    }
    if moving > 0 {
        let there = moving::place(&mut grid, parameters, &mut Stream::new(seed, 2));
        if there < moving {
            notes.push(format!("There are {there} moving obstacles, not {moving}: there is no room for more clear of the start."));
        }
    }
    let rows = grid.rows();
    Draft {
        size_in_title: format!("{columns} × {rows}"),
        note: Some(notes.join(" ")).filter(|text| !text.is_empty()),
        // Where nothing moves, the command is the one that it was before anything did.
        unused: if moving > 0 { "" } else { MOVING.name() },
        ..Draft::new(grid, format!("{columns}x{rows}"))
    }
}
