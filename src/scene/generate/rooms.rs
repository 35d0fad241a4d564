//! Rooms with doors between them; a maze is rooms of one cell, joined by as few doors as will do.

use crate::{
    describe::Generator,
    kernel::{rng::Stream, words},
    params::{Param, Parameters},
    scene::{GRID, MAX_SIDE, reach::beside},
};

use super::{
    grids,
    moving::STOPS_AND_MOVING,
    plot::{CELL, COLUMNS, Plot, ROWS},
};

/// Rooms with doors.
pub const ROOMS: Generator = Generator {
    name: "rooms",
    title: "Rooms",
    help: words("Rooms behind walls one cell thick, with doors: at least as many as it takes to come from each room to each other."),
    kind: GRID,
    parameters: &[&[COLUMNS.entry(), ROWS.entry(), CELL.entry(), ROOM.entry(), DOOR.entry(), LOOPS.entry()], STOPS_AND_MOVING],
    draw: |parameters, seed| {
        grids::grid(parameters, seed, |parameters, plot, stream| {
            let room = parameters[ROOM] as usize;
            let spans = [plot.columns, plot.rows].map(|length| spans(length, room, stream));
            plot.open(&spans, parameters, parameters[DOOR] as usize, stream);
        })
    },
};

/// Corridors one cell wide.
pub const MAZE: Generator = Generator {
    name: "maze",
    title: "Maze",
    help: words(
        "Corridors and walls one cell wide; without loops there is exactly one way between any two cells. In an even number of \
           columns or rows the last one is wall.",
    ),
    kind: GRID,
    parameters: &[
        &[COLUMNS.default_to(41).entry(), ROWS.default_to(31).entry(), CELL.entry(), LOOPS.default_to(0.0).entry()],
        STOPS_AND_MOVING,
    ],
    draw: |parameters, seed| {
        grids::grid(parameters, seed, |parameters, plot, stream| {
            // What an even side has too much stays blocked.
            let spans = [plot.columns, plot.rows].map(|length| spans(length - usize::from(length % 2 == 0), 1, stream));
            plot.open(&spans, parameters, 1, stream);
        })
    },
};

const ROOM: Param<u64> = Param::integer(
    "room",
    "",
    "Room",
    [1, MAX_SIDE as u64, 7],
    "About how many cells a room has along each side; more where the grid does not divide evenly.",
)
.slider(1.0, 30.0, false);
const DOOR: Param<u64> =
    Param::integer("door", "", "Door", [1, MAX_SIDE as u64, 1], "How many cells wide a door is, where the wall is long enough.")
        .slider(1.0, 10.0, false);
const LOOPS: Param<f64> = Param::number(
    "loops",
    "",
    "Loops",
    [0.0, 1.0, 0.3],
    "The chance of a door in each wall that does not need one; 0: one way only between any two rooms.",
);

/// First cell, and the wall after the last, of each room along an axis. Rooms have about `room` cells, half of them at least.
fn spans(length: usize, room: usize, stream: &mut Stream) -> Vec<[usize; 2]> {
    let rooms = ((length + 1) / (room + 1)).max(1);
    let (play, mut from) = (room / 4, 0);
    let mut spans = Vec::with_capacity(rooms);
    for i in 1..=rooms {
        let wall = if i < rooms { i * (length + 1) / rooms - 1 + stream.below(2 * play + 1) - play } else { length };
        spans.push([from, wall]);
        from = wall + 1;
    }
    spans
}

impl Plot {
    /// Blocks all but the rooms of these spans, and opens doors: those of a random tree, and others by chance.
    fn open(&mut self, [across, down]: &[Vec<[usize; 2]>; 2], parameters: &Parameters, door: usize, stream: &mut Stream) {
        self.blocked.fill(true);
        let columns = across.len();
        let place = |room: usize| (across[room % columns], down[room / columns]);
        for room in 0..columns * down.len() {
            let ([left, right], [top, bottom]) = place(room);
            self.clear([left, right], [top, bottom]);
            self.ends[1] = (bottom - 1) * self.columns + right - 1;
        }
        let loops = parameters[LOOPS];
        for (wall, needed) in tree(columns, down.len(), stream).into_iter().enumerate() {
            let (room, below) = (wall / 2, wall % 2 == 1);
            let ([left, right], [top, bottom]) = place(room);
            let outer = if below { room / columns + 1 == down.len() } else { room % columns + 1 == columns };
            if outer || !(needed || stream.unit() < loops) {
                continue;
            }
            let [from, to] = if below { [left, right] } else { [top, bottom] };
            let width = door.min(to - from);
            let from = from + stream.below(to - from - width + 1);
            let opening = [from, from + width];
            if below {
                self.clear(opening, [bottom, bottom + 1]);
            } else {
                self.clear([right, right + 1], opening);
            }
        }
    }

    fn clear(&mut self, [left, right]: [usize; 2], [top, bottom]: [usize; 2]) {
        for row in top..bottom {
            self.blocked[row * self.columns + left..row * self.columns + right].fill(false);
        }
    }
}

/// Which walls between neighbouring rooms must be open for a random tree over all: for room `i` number `2 i` is the wall to
/// the right, `2 i + 1` the wall below. A walk that goes on to a room where it has not been, and back where there is none.
fn tree(columns: usize, rows: usize, stream: &mut Stream) -> Vec<bool> {
    let count = columns * rows;
    let mut open = vec![false; 2 * count];
    let mut seen = vec![false; count];
    let mut way = vec![0];
    seen[0] = true;
    while let Some(&room) = way.last() {
        let new: Vec<usize> = beside(room, columns, count).filter(|&next| !seen[next]).collect();
        if new.is_empty() {
            way.pop();
            continue;
        }
        let next = new[stream.below(new.len())];
        seen[next] = true;
        way.push(next);
        let (first, second) = (room.min(next), room.max(next));
        open[2 * first + usize::from(second - first == columns)] = true;
    }
    open
}
