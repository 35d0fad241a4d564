//! A grid's convex corners, and which of them a point sees. Lengths are in cells here, so what lies in a line does so
//! exactly: slopes are quotients of small whole numbers, and equal ones have equal bits.

/// A corner of one blocked cell that a path can turn round.
#[derive(Debug, Clone, Copy)]
pub(super) struct Corner {
    pub at: [f64; 2],
    /// Which way it points: 0 north-east, 1 north-west, 2 south-west, 3 south-east; y grows northwards.
    pub quarter: usize,
}

pub(super) struct Lattice<'a> {
    columns: usize,
    rows: usize,
    blocked: &'a [bool],
    /// Whether a path may go through a point where two blocked cells touch diagonally.
    squeeze: bool,
    /// The blocked cells of each row, those side by side as one: where it begins and ends.
    runs: Table<[f64; 2]>,
    /// The corners of each lattice line, from left to right.
    corners: Table<Corner>,
}

/// Items line by line.
struct Table<T> {
    items: Vec<T>,
    first: Vec<usize>,
}

impl<T> Table<T> {
    fn of(&self, line: usize) -> &[T] {
        &self.items[self.first[line]..self.first[line + 1]]
    }
}

impl<'a> Lattice<'a> {
    /// `wide`: for a robot with a size. Where two cells touch diagonally their round corners bury each other and are no
    /// corners; sight may go through, for what the robot cannot follow is seen when its way is tried.
    pub fn new(columns: usize, blocked: &'a [bool], squeeze: bool, wide: bool) -> Self {
        let (diagonal, squeeze) = (squeeze && !wide, squeeze || wide);
        let rows = blocked.len() / columns.max(1);
        let runs = Table { items: Vec::new(), first: vec![0] };
        let corners = Table { items: Vec::new(), first: vec![0] };
        let mut lattice = Self { columns, rows, blocked, squeeze, runs, corners };
        for row in 0..rows {
            let mut from = 0;
            for cells in blocked[row * columns..(row + 1) * columns].chunk_by(|a, b| a == b) {
                let to = from + cells.len();
                if cells[0] {
                    // What lies at the border reaches beyond it, so that nothing slips along there.
                    let begin = if from == 0 { -1.0 } else { from as f64 };
                    lattice.runs.items.push([begin, (if to == columns { to + 1 } else { to }) as f64]);
                }
                from = to;
            }
            lattice.runs.first.push(lattice.runs.items.len());
        }
        for y in 0..=rows {
            for x in 0..=columns {
                let around = lattice.around(x, y);
                let count = around.iter().filter(|&&b| b).count();
                if count == 1 || (diagonal && is_pinch(around)) {
                    let at = [x as f64, y as f64];
                    lattice.corners.items.extend((0..4).filter(|&q| around[q]).map(|quarter| Corner { at, quarter }));
                }
            }
            lattice.corners.first.push(lattice.corners.items.len());
        }
        lattice
    }

    pub fn corners(&self) -> &[Corner] {
        &self.corners.items
    }

    pub fn size(&self) -> [f64; 2] {
        [self.columns as f64, self.rows as f64]
    }

    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Begin and end of the blocked cells of a row, those side by side as one.
    pub fn runs(&self, row: usize) -> &[[f64; 2]] {
        self.runs.of(row)
    }

    /// Whether the cells south-west, south-east, north-east and north-west of a lattice point are blocked. The blocked
    /// cell of number q has its corner point into quarter q. Outside of the grid everything is: nothing goes between a
    /// blocked cell and the border.
    fn around(&self, x: usize, y: usize) -> [bool; 4] {
        let cell = |right: usize, up: usize| {
            let (column, row) = ((x + right).wrapping_sub(1), (y + up).wrapping_sub(1));
            column >= self.columns || row >= self.rows || self.blocked[row * self.columns + column]
        };
        [cell(0, 0), cell(1, 0), cell(1, 1), cell(0, 1)]
    }

    /// Whether a point going straight from `a` to `b` passes where two blocked cells touch diagonally, or between one and
    /// the border. Only asked for ways that cross no blocked cell. What is nearer than `hair` is met.
    pub fn slips(&self, a: [f64; 2], b: [f64; 2], hair: f64) -> bool {
        let at_end = |p: [f64; 2]| [a, b].iter().any(|e| (e[0] - p[0]).abs() <= hair && (e[1] - p[1]).abs() <= hair);
        let pinch = |x: f64, y: f64| !self.squeeze && !at_end([x, y]) && is_pinch(self.around(x as usize, y as usize));
        let (low, high): ([f64; 2], [f64; 2]) = (std::array::from_fn(|i| a[i].min(b[i])), std::array::from_fn(|i| a[i].max(b[i])));
        let along = (0..2).find(|&axis| high[1 - axis] - low[1 - axis] <= hair);
        let Some(along) = along else {
            return (low[1].ceil() as usize..=high[1].floor() as usize).any(|line| {
                let x = a[0] + (b[0] - a[0]) * ((line as f64 - a[1]) / (b[1] - a[1]));
                (x - x.round()).abs() <= hair && pinch(x.round(), line as f64)
            });
        };
        let line = low[1 - along].round();
        let point = |at: usize| if along == 0 { [at as f64, line] } else { [line, at as f64] };
        let seam = |at: usize| {
            let [_, south_east, north_east, north_west] = self.around(point(at)[0] as usize, point(at)[1] as usize);
            north_east && if along == 0 { south_east } else { north_west }
        };
        (low[1 - along] - line).abs() <= hair
            && ((low[along].ceil() as usize..=high[along].floor() as usize).any(|at| pinch(point(at)[0], point(at)[1]))
                || ((low[along] + hair).floor() as usize..(high[along] - hair).ceil() as usize).any(seam))
    }

    /// Appends the numbers of the corners that a point at `from` sees in a quadrant (numbered as quarters, borders
    /// included), on slopes Δx ÷ |Δy| from `low` to `high`. Sight may touch blocked cells and run along their sides, but
    /// passes no seam between two of them, nor, unless squeezing is allowed, where two touch diagonally.
    pub fn seen(&self, from: [f64; 2], quadrant: usize, [low, high]: [f64; 2], found: &mut Vec<usize>) {
        let [ax, ay] = from;
        let (right, up) = (quadrant == 0 || quadrant == 3, quadrant < 2);
        if ay == ay.floor() && if right { high } else { low }.is_infinite() {
            self.seen_along(ax, ay as usize, right, found);
        }
        // Closed intervals of slopes, from left to right; some are single points: sight between two corners.
        let mut open = vec![[low, high]];
        let mut next = Vec::new();
        let mut line = if up { ay.floor() as usize } else { ay.ceil() as usize };
        while if up { line < self.rows } else { line > 0 } {
            // From this line to the next one, through a row of cells.
            let row = if up { line } else { line - 1 };
            let near = if up { line as f64 - ay } else { ay - line as f64 }.max(0.0);
            self.shade(ax, row, near, if up { row as f64 + 1.0 - ay } else { ay - row as f64 }, &open, &mut next);
            if near > 0.0 && !self.squeeze {
                next.retain(|&[from, to]| {
                    let x = ax + from * near;
                    // A ray that lost all its width may have lost it in a single point.
                    from != to || (x - x.round()).abs() > 1e-9 || !is_pinch(self.around(x.round() as usize, line))
                });
            }
            std::mem::swap(&mut open, &mut next);
            if open.is_empty() {
                return;
            }
            line = if up { line + 1 } else { line - 1 };
            let away = (line as f64 - ay).abs();
            let corners = self.corners.of(line);
            let first = self.corners.first[line];
            for &[from, to] in &open {
                let begin = corners.partition_point(|corner| (corner.at[0] - ax) / away < from);
                let seen = corners[begin..].iter().take_while(|corner| (corner.at[0] - ax) / away <= to).count();
                found.extend(first + begin..first + begin + seen);
            }
        }
    }

    /// What is left of the `open` slopes behind a row that begins `near` and ends `far` from the eye.
    fn shade(&self, ax: f64, row: usize, near: f64, far: f64, open: &[[f64; 2]], left: &mut Vec<[f64; 2]>) {
        left.clear();
        let runs = self.runs(row);
        // No further than the grid.
        let (least, most) = ((0.0 - ax) / far, (self.columns as f64 - ax) / far);
        for &[low, high] in open {
            let (mut low, high) = (low.max(least), high.min(most));
            let begin = (ax + low * near).min(ax + low * far);
            let begin = runs.partition_point(|run| run[1] < begin - 1.0);
            for &[x0, x1] in &runs[begin..] {
                // The outermost of the slopes to its corners, perhaps infinite. (Never 0 ÷ 0: `far` is positive.)
                let from = (x0 - ax) / if x0 >= ax { far } else { near };
                let to = (x1 - ax) / if x1 <= ax { far } else { near };
                if from >= high {
                    break;
                }
                if to <= low {
                    continue;
                }
                if from >= low {
                    left.push([low, from]);
                }
                low = to;
                if low > high {
                    break;
                }
            }
            if low <= high {
                left.push([low, high]);
            }
        }
    }

    /// The corners seen along a lattice line.
    fn seen_along(&self, ax: f64, line: usize, right: bool, found: &mut Vec<usize>) {
        let corners = self.corners.of(line);
        let first = self.corners.first[line];
        let mut x = if right { ax.floor() } else { ax.ceil() };
        loop {
            // Into the next cell, along its side: the cells below and above must not both be blocked.
            let around = self.around(x as usize, line);
            let (below, above) = if right { (around[1], around[2]) } else { (around[0], around[3]) };
            let behind = if right { ax < x } else { ax > x };
            if (below && above) || (behind && !self.squeeze && is_pinch(around)) {
                return;
            }
            x += if right { 1.0 } else { -1.0 };
            if !(0.0..=self.columns as f64).contains(&x) {
                return;
            }
            let begin = corners.partition_point(|corner| corner.at[0] < x);
            found.extend((begin..corners.len()).take_while(|&i| corners[i].at[0] == x).map(|i| first + i));
        }
    }
}

/// Whether these four cells touch in a single point only, two and two.
fn is_pinch([a, b, c, d]: [bool; 4]) -> bool {
    a == c && b == d && a != b
}
