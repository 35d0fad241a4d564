//! The cells of a grid, the moves between them, and paths over cells.

use std::f64::consts::{FRAC_PI_4, SQRT_2};

use super::Field;

/// The change of column and row by a move in each direction; direction `d` points to `d · 45°`, odd ones are diagonal. Rows are
/// counted along y, whichever way y grows.
pub const DIRECTIONS: [[i32; 2]; 8] = [[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, -1]];

/// The direction's angle from the x axis, in radians.
pub fn angle(direction: usize) -> f64 {
    direction as f64 * FRAC_PI_4
}

/// The numbers of straight and diagonal moves of a path. Two paths are equally long exactly if these are equal (√2 is
/// irrational).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Steps {
    /// Moves to a cell that shares a side.
    pub straight: u32,
    /// Moves to a cell that shares a corner.
    pub diagonal: u32,
}

impl Steps {
    /// Their length in cells: straight + √2 diagonal.
    pub fn length(self) -> f64 {
        f64::from(self.straight) + SQRT_2 * f64::from(self.diagonal)
    }

    /// The same with one more move in a direction.
    #[must_use]
    pub fn and(self, direction: usize) -> Self {
        let diagonal = (direction & 1) as u32;
        Self { straight: self.straight + 1 - diagonal, diagonal: self.diagonal + diagonal }
    }
}

/// The direction in which y grows in a scene's coordinates. The file lists the top row first in either case.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "lowercase"))]
pub enum YAxis {
    /// Origin at the top left, as in pictures.
    #[default]
    Down,
    /// Origin at the bottom left, as on paper.
    Up,
}

impl YAxis {
    /// Both variants.
    pub const ALL: [Self; 2] = [Self::Down, Self::Up];

    /// The name that scene files use.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Down => "down",
            Self::Up => "up",
        }
    }
}

/// The description of a grid that [`Cells`] are made from.
#[derive(Debug, Clone, Copy)]
pub struct Plan<'a> {
    /// The side of a cell, in the scene's unit.
    pub side: f64,
    /// Cells per row.
    pub columns: usize,
    /// Blocked cells, row by row.
    pub blocked: &'a [bool],
    /// Whether a diagonal move may cut a blocked cell's corner.
    pub corner_cutting: bool,
    /// The direction in which y grows.
    pub y_axis: YAxis,
}

/// Cells and the moves between them. A cell's index is row · columns + column.
///
/// A cell is free if the robot's circle fits at its centre; a move is allowed if it fits all along it. Reading of
/// [ANTBAT](crate#papers) §1.1: without corner cutting a diagonal move needs both cells next to it free.
#[derive(Debug, Clone, PartialEq)]
pub struct Cells {
    /// The side of a cell, in the scene's unit.
    pub side: f64,
    /// Cells per row.
    pub columns: usize,
    /// The number of rows.
    pub rows: usize,
    /// Bit `d`: the move in direction `d` is allowed.
    moves: Vec<u8>,
    free: Vec<bool>,
    offsets: [isize; 8],
    /// Whether y grows downwards where people look at the grid.
    down: bool,
}

impl Cells {
    /// The cells of a grid. `field` is where the robot's centre may be; `None` for a point robot.
    pub fn new(plan: &Plan, field: Option<&Field>) -> Self {
        let Plan { side, columns, blocked, corner_cutting, y_axis } = *plan;
        let rows = blocked.len() / columns.max(1);
        let offsets = DIRECTIONS.map(|[x, y]| y as isize * columns.cast_signed() + x as isize);
        let mut cells = Self { side, columns, rows, moves: Vec::new(), free: Vec::new(), offsets, down: y_axis == YAxis::Down };
        cells.free = blocked.iter().map(|blocked| !blocked).collect();
        if let Some(field) = field {
            cells.free = (0..columns * rows).map(|i| cells.free[i] && field.is_free(cells.centre(i), cells.centre(i))).collect();
        }
        cells.moves = cells.allowed(corner_cutting, field);
        cells
    }

    /// The moves allowed from each cell.
    fn allowed(&self, cutting: bool, wide: Option<&Field>) -> Vec<u8> {
        // A border of blocked cells all round spares every question whether a neighbour exists.
        let width = self.columns + 2;
        let mut padded = vec![0_u8; width * (self.rows + 2)];
        for (row, cells) in self.free.chunks(self.columns.max(1)).enumerate() {
            let from = (row + 1) * width + 1;
            padded[from..from + self.columns].iter_mut().zip(cells).for_each(|(to, &free)| *to = u8::from(free));
        }
        // Whole rows at a time and without branches: compilers make vectors of that.
        let corner = u8::from(cutting);
        let mut moves = vec![0; self.free.len()];
        for (row, moves) in moves.chunks_mut(self.columns.max(1)).enumerate() {
            let line = |below: usize, left: usize| &padded[(row + below) * width + left..][..moves.len()];
            let [before, at, after] = [0, 1, 2].map(|below| [0, 1, 2].map(|left| line(below, left)));
            for i in 0..moves.len() {
                let straight = [at[2][i], after[1][i], at[0][i], before[1][i]];
                let diagonal = [after[2][i], after[0][i], before[0][i], before[2][i]];
                let mut mask = 0;
                for d in 0..4 {
                    let beside = straight[d] & straight[(d + 1) % 4] | corner;
                    mask |= straight[d] << (2 * d) | (diagonal[d] & beside) << (2 * d + 1);
                }
                // All bits of a free cell, none of a blocked one.
                moves[i] = mask & at[1][i].wrapping_neg();
            }
        }
        if let Some(field) = wide {
            for (i, mask) in moves.iter_mut().enumerate() {
                for d in (0..8).filter(|d| *mask >> d & 1 != 0).collect::<Vec<_>>() {
                    if !field.is_free(self.centre(i), self.centre(i.wrapping_add_signed(self.offsets[d]))) {
                        *mask &= !(1 << d);
                    }
                }
            }
        }
        moves
    }

    /// The same without the moves into some cells; moves out of them stay.
    #[must_use]
    pub fn without(&self, occupied: &[bool]) -> Self {
        let mut cells = self.clone();
        for (cell, _) in occupied.iter().enumerate().filter(|(_, occupied)| **occupied) {
            for d in (0..8).filter(|d| self.moves[cell] >> d & 1 != 0) {
                // A step and the step back are allowed alike.
                cells.moves[self.next(cell, d)] &= !(1 << (d ^ 4));
            }
        }
        cells
    }

    /// The number of cells.
    pub fn len(&self) -> usize {
        self.moves.len()
    }

    /// Whether there are none; a valid scene has some.
    pub fn is_empty(&self) -> bool {
        self.moves.is_empty()
    }

    /// Whether a cell is free.
    pub fn is_free(&self, cell: usize) -> bool {
        self.free[cell]
    }

    /// The moves from this cell; bit `d`: the move in direction `d` is allowed.
    #[inline]
    pub fn moves(&self, cell: usize) -> u8 {
        self.moves[cell]
    }

    /// The neighbour of a cell in a direction that is allowed.
    #[inline]
    pub fn next(&self, cell: usize, direction: usize) -> usize {
        cell.wrapping_add_signed(self.offsets[direction])
    }

    /// Column and row.
    #[inline]
    pub fn place(&self, cell: usize) -> [usize; 2] {
        [cell % self.columns, cell / self.columns]
    }

    /// Column and row as people count them: from 1, the top row first.
    pub fn counted_place(&self, cell: usize) -> [usize; 2] {
        let [column, row] = self.place(cell);
        [column + 1, if self.down { row + 1 } else { self.rows - row }]
    }

    /// A direction as it looks in pictures: how many eighths of a turn it lies from the right, counterclockwise.
    pub fn eighths(&self, direction: usize) -> usize {
        if self.down { (8 - direction) % 8 } else { direction }
    }

    /// The centre, in the scene's unit.
    pub fn centre(&self, cell: usize) -> [f64; 2] {
        self.place(cell).map(|i| (i as f64 + 0.5) * self.side)
    }

    /// The cell that contains a point of the grid.
    pub fn at(&self, point: [f64; 2]) -> usize {
        let index = |c: f64, n: usize| ((c / self.side) as usize).min(n.saturating_sub(1));
        index(point[1], self.rows) * self.columns + index(point[0], self.columns)
    }

    /// The distance between the centres of two cells, in cells.
    pub fn apart(&self, a: usize, b: usize) -> f64 {
        let ([ax, ay], [bx, by]) = (self.place(a), self.place(b));
        let (dx, dy) = (ax.abs_diff(bx) as f64, ay.abs_diff(by) as f64);
        (dx * dx + dy * dy).sqrt()
    }

    /// The moves of a path over neighbouring cells.
    pub fn steps(&self, way: &[usize]) -> Steps {
        way.windows(2).fold(Steps::default(), |steps, w| {
            let diagonal = w[0] % self.columns != w[1] % self.columns && w[0] / self.columns != w[1] / self.columns;
            steps.and(usize::from(diagonal))
        })
    }
}

/// Start and goal of a path over cells.
#[derive(Debug, Clone, PartialEq)]
pub struct Endpoints {
    /// The cell of the start.
    pub start: usize,
    /// The cell of the goal.
    pub goal: usize,
    /// Start and goal as points.
    pub ends: [[f64; 2]; 2],
    /// The sum of the distances of start and goal from the centres of their cells, in the scene's unit.
    pub stubs: f64,
}

impl Endpoints {
    /// The length of a path over cells from start to goal, in the scene's unit.
    pub fn length(&self, cells: &Cells, steps: Steps) -> f64 {
        cells.side * steps.length() + self.stubs
    }

    /// A path over cells as points from start to goal: the cells' centres, and start and goal where they are not centres.
    pub fn path(&self, cells: &Cells, way: impl IntoIterator<Item = usize>) -> Vec<[f64; 2]> {
        let mut path = vec![self.ends[0]];
        path.extend(way.into_iter().map(|cell| cells.centre(cell)));
        path.push(self.ends[1]);
        path.dedup();
        path
    }
}
