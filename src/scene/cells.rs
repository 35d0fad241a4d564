//! A grid as planners see it that go from cell to cell: which steps are allowed, and what a way over cells is as a path.

use std::f64::consts::{FRAC_PI_4, SQRT_2};

use crate::{geometry::Field, kernel::Error};

use super::{GridScene, YAxis};

/// Column and row of a step in each direction; direction `d` points to `d · 45°`, odd ones are diagonal. Rows are counted
/// along y, whichever way y grows.
pub const DIRECTIONS: [[i32; 2]; 8] = [[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, -1]];

/// Names of directions, for rows that grow upwards and for rows that grow downwards.
const COMPASS: [[&str; 8]; 2] = [
    ["east", "north-east", "north", "north-west", "west", "south-west", "south", "south-east"],
    ["east", "south-east", "south", "south-west", "west", "north-west", "north", "north-east"],
];

/// The direction's angle from the x axis, in radians.
pub fn angle(direction: usize) -> f64 {
    direction as f64 * FRAC_PI_4
}

/// Straight and diagonal steps. Two ways are equally long exactly if these are equal (√2 is irrational).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Steps {
    /// Steps to a cell that shares a side.
    pub straight: u32,
    /// Steps to a cell that shares a corner.
    pub diagonal: u32,
}

impl Steps {
    /// Their length in cells: straight + √2 diagonal.
    pub fn length(self) -> f64 {
        f64::from(self.straight) + SQRT_2 * f64::from(self.diagonal)
    }

    /// One step more.
    #[must_use]
    pub fn and(self, direction: usize) -> Self {
        let diagonal = (direction & 1) as u32;
        Self { straight: self.straight + 1 - diagonal, diagonal: self.diagonal + diagonal }
    }
}

/// Cells and the steps between them. A cell's number is row · columns + column.
///
/// A cell is free if the robot's circle fits at its centre; a step is allowed if it fits all along it. Reading of
/// [ANTBAT] §3.1: without corner cutting a diagonal step needs both cells beside it free.
#[derive(Debug, Clone, PartialEq)]
pub struct Cells {
    /// The side of a cell, in the scene's unit.
    pub side: f64,
    /// Cells a row.
    pub columns: usize,
    /// Rows.
    pub rows: usize,
    /// Bit `d`: the step in direction `d` is allowed.
    moves: Vec<u8>,
    free: Vec<bool>,
    offsets: [isize; 8],
    /// Whether y grows downwards where people look at the grid.
    down: bool,
}

impl Cells {
    /// The cells of a grid. `radius` is the robot's; 0 for a point.
    pub fn new(grid: &GridScene) -> Self {
        let (columns, rows) = (grid.columns, grid.rows());
        let offsets = DIRECTIONS.map(|[x, y]| y as isize * columns.cast_signed() + x as isize);
        let mut cells =
            Self { side: grid.cell, columns, rows, moves: Vec::new(), free: Vec::new(), offsets, down: grid.y_axis == YAxis::Down };
        let wide = (grid.radius() > 0.0).then(|| &**grid.field());
        cells.free = grid.blocked.iter().map(|blocked| !blocked).collect();
        if let Some(field) = wide {
            cells.free = (0..columns * rows).map(|i| cells.free[i] && field.is_free(cells.centre(i), cells.centre(i))).collect();
        }
        cells.moves = cells.allowed(grid.corner_cutting, wide);
        cells
    }

    /// The steps allowed from each cell.
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

    /// The same without the steps into some cells; who stands there may leave.
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

    /// How many cells there are.
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

    /// Bit `d`: the step from this cell in direction `d` is allowed.
    #[inline]
    pub fn moves(&self, cell: usize) -> u8 {
        self.moves[cell]
    }

    /// The cell next to this one in a direction that is allowed.
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
    pub fn told(&self, cell: usize) -> [usize; 2] {
        let [column, row] = self.place(cell);
        [column + 1, if self.down { row + 1 } else { self.rows - row }]
    }

    /// The directions' names as the grid is seen.
    pub fn compass(&self) -> &'static [&'static str; 8] {
        &COMPASS[usize::from(self.down)]
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

    /// The length of a straight line between the centres of two cells, in cells.
    pub fn apart(&self, a: usize, b: usize) -> f64 {
        let ([ax, ay], [bx, by]) = (self.place(a), self.place(b));
        let (dx, dy) = (ax.abs_diff(bx) as f64, ay.abs_diff(by) as f64);
        (dx * dx + dy * dy).sqrt()
    }

    /// The steps of a way over neighbouring cells.
    pub fn steps(&self, way: &[usize]) -> Steps {
        way.windows(2).fold(Steps::default(), |steps, w| {
            let diagonal = w[0] % self.columns != w[1] % self.columns && w[0] / self.columns != w[1] / self.columns;
            steps.and(usize::from(diagonal))
        })
    }
}

/// A grid's cells with a start and a goal: what every planner from cell to cell runs on.
#[derive(Debug, Clone, PartialEq)]
pub struct Course {
    /// The cell of the start.
    pub start: usize,
    /// The cell of the goal.
    pub goal: usize,
    /// Start and goal as points.
    pub ends: [[f64; 2]; 2],
    /// From the start to its cell's centre and from the goal's centre to the goal, in the scene's unit: 0 for ends at centres.
    pub stubs: f64,
}

impl Course {
    /// Finds the cells of start and goal.
    ///
    /// # Errors
    /// [`Error::Refused`] if a grid has no ends, or if the robot cannot go from one to the centre of its cell.
    pub fn new(grid: &GridScene) -> Result<Self, Error> {
        let (start, goal) = grid.ends()?;
        Self::between(grid, ["start", "goal"], [start, goal])
    }

    /// Finds the cells of two points.
    ///
    /// # Errors
    /// [`Error::Refused`] if the robot cannot go from one of them to the centre of its cell, by its name.
    pub fn between(grid: &GridScene, names: [&str; 2], [start, goal]: [[f64; 2]; 2]) -> Result<Self, Error> {
        let cells = grid.cells();
        let stub = |point: [f64; 2], cell: usize| {
            let [x, y] = cells.centre(cell);
            ((x - point[0]) * (x - point[0]) + (y - point[1]) * (y - point[1])).sqrt()
        };
        let (from, to) = (entrance(grid, names[0], start)?, entrance(grid, names[1], goal)?);
        Ok(Self { start: from, goal: to, ends: [start, goal], stubs: stub(start, from) + stub(goal, to) })
    }

    /// The length of a way over cells from end to end, in the scene's unit.
    pub fn length(&self, cells: &Cells, steps: Steps) -> f64 {
        cells.side * steps.length() + self.stubs
    }

    /// A way over cells as a path from start to goal: the cells' centres, with the ends where they are not centres.
    pub fn path(&self, cells: &Cells, way: impl IntoIterator<Item = usize>) -> Vec<[f64; 2]> {
        let mut path = vec![self.ends[0]];
        path.extend(way.into_iter().map(|cell| cells.centre(cell)));
        path.push(self.ends[1]);
        path.dedup();
        path
    }
}

/// The cell through whose centre a path leaves or reaches a point: the one that contains it; for a point on a border
/// between cells, the first that will do.
fn entrance(grid: &GridScene, name: &str, point: [f64; 2]) -> Result<usize, Error> {
    let cells = grid.cells();
    let place = cells.place(cells.at(point));
    let near = |axis: usize, n: usize| {
        let i = place[axis];
        let before = (point[axis] <= i as f64 * grid.cell).then(|| i.checked_sub(1)).flatten();
        [Some(i), before].into_iter().flatten().filter(move |&i| i < n)
    };
    let mut all = near(1, cells.rows).flat_map(|row| near(0, cells.columns).map(move |column| row * cells.columns + column));
    let fits = |cell: usize| {
        let centre = cells.centre(cell);
        cells.is_free(cell) && (point == centre || grid.field().is_free(point, centre))
    };
    all.find(|&cell| fits(cell)).ok_or_else(|| {
        Error::refused(
            name,
            format!("({}, {})", point[0], point[1]),
            "in a cell to whose centre the robot can go: this planner goes from cell to cell",
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(rows: &[&str], cutting: bool) -> GridScene {
        let blocked = rows.iter().flat_map(|row| row.chars().map(|c| c == '#')).collect();
        GridScene {
            corner_cutting: cutting,
            start: Some([0.5, 0.5]),
            goal: Some([2.5, 2.5]),
            ..GridScene::new(1.0, rows[0].len(), blocked)
        }
    }

    #[test]
    fn a_diagonal_step_needs_both_cells_beside_it_free_unless_corners_may_be_cut() {
        let bits = |directions: &[usize]| directions.iter().fold(0_u8, |mask, d| mask | 1 << d);
        let strict = Cells::new(&grid(&["...", ".#.", "..."], false));
        assert_eq!(strict.moves(0), bits(&[0, 2]), "no step through the block, none past its corner");
        assert_eq!(strict.moves(1), bits(&[0, 4]));
        assert_eq!(strict.moves(4), 0, "nothing leaves a blocked cell");
        let cutting = Cells::new(&grid(&["...", ".#.", "..."], true));
        assert_eq!(cutting.moves(1), bits(&[0, 1, 3, 4]), "past its corners to the cells beside it");
        let open = Cells::new(&grid(&["...", "...", "..."], false));
        assert_eq!(open.moves(4), 0xff);
        assert_eq!(open.moves(8), bits(&[4, 5, 6]));
        for d in 0..8 {
            assert_eq!(open.next(open.next(4, d), (d + 4) % 8), 4);
        }
    }

    #[test]
    fn the_steps_of_every_cell_are_those_of_the_definition() {
        let mut rng = crate::kernel::rng::Stream::new(2, 0);
        for (columns, rows) in [(1, 1), (1, 7), (7, 1), (5, 9), (40, 17)] {
            for cutting in [false, true] {
                let blocked: Vec<_> = (0..columns * rows).map(|_| rng.unit() < 0.4).collect();
                let cells = Cells::new(&GridScene { corner_cutting: cutting, ..GridScene::new(1.0, columns as usize, blocked.clone()) });
                let free = |x: i32, y: i32| (0..columns).contains(&x) && (0..rows).contains(&y) && !blocked[(y * columns + x) as usize];
                for (d, [dx, dy]) in DIRECTIONS.into_iter().enumerate() {
                    for (x, y) in (0..rows).flat_map(|y| (0..columns).map(move |x| (x, y))) {
                        let beside = cutting || d % 2 == 0 || (free(x + dx, y) && free(x, y + dy));
                        let allowed = free(x, y) && free(x + dx, y + dy) && beside;
                        assert_eq!(cells.moves((y * columns + x) as usize) >> d & 1 == 1, allowed);
                    }
                }
            }
        }
    }

    #[test]
    fn a_wide_robot_needs_room_all_along_a_step() {
        use crate::scene::Robot;
        let robot = |side: f64| Some(Robot { length: Some(side), width: Some(side), ..Robot::default() });
        let narrow = GridScene { robot: robot(0.7), ..grid(&["...", ".#.", "..."], true) };
        let cells = Cells::new(&narrow);
        assert!(cells.is_free(1), "radius 0.495: it just fits beside the block");
        assert_eq!(cells.moves(1), 0b0001_0001, "but not past its corner");
        assert!(!Cells::new(&GridScene { robot: robot(0.8), ..narrow.clone() }).is_free(1), "radius 0.566");
    }

    #[test]
    fn a_way_over_cells_begins_and_ends_at_the_points_themselves() {
        let mut scene = grid(&["...", "...", "..."], false);
        let course = Course::new(&scene).unwrap();
        assert_eq!((course.start, course.goal, course.stubs), (0, 8, 0.0));
        let cells = scene.cells();
        assert_eq!(cells.steps(&[0, 4, 5, 8]), Steps { straight: 2, diagonal: 1 });
        assert_eq!(course.path(cells, [0, 4, 8]), [[0.5, 0.5], [1.5, 1.5], [2.5, 2.5]]);
        scene.start = Some([0.5, 0.0]);
        let course = Course::new(&scene).unwrap();
        assert_eq!((course.start, course.stubs), (0, 0.5));
        assert_eq!(course.path(scene.cells(), [0, 4, 8])[..2], [[0.5, 0.0], [0.5, 0.5]]);
        // A point on the border of a blocked cell belongs to its free neighbour.
        let mut scene = grid(&["#..", "...", "..."], false);
        scene.start = Some([1.0, 1.0]);
        assert_eq!(Course::new(&scene).unwrap().start, 4);
        scene.goal = Some([1.0, 0.5]);
        assert_eq!(Course::new(&scene).unwrap().goal, 1);
    }
}
