//! Collision tests against the blocked cells of a grid, inflated by a robot's radius.

use super::{Block, ObstacleField, Oriented};

/// What a point robot's obstacles are smaller by, in cells: it may touch them, and rounding must not turn touching into
/// crossing.
const HAIR: f64 = 1e-9;

/// What planners keep away beyond that, in cells, so that a path that cost them nothing is still free when it is cut into
/// pieces and their ends are rounded.
const MARGIN: f64 = 5e-10;

/// Up to this many blocks in a row are looked at one after the other.
const FEW: usize = 8;

/// A grid's blocked cells, inflated by the radius of a round robot. A robot may touch an obstacle, not enter it.
///
/// Row `k` covers `k · cell ≤ y ≤ (k + 1) · cell`. The cells of a row that lie side by side form one [`Block`].
#[derive(Debug, Clone, PartialEq)]
pub struct Field {
    size: [f64; 2],
    /// What every block is grown by; negative by a hair for a point.
    grow: f64,
    /// The robot's radius.
    radius: f64,
    /// [`MARGIN`] in the scene's unit.
    margin: f64,
    cells: Rows,
    /// For a point robot: what lies across the line between two rows, so that it cannot slip along it.
    seams: Rows,
}

/// Blocks row by row, those of a row from left to right.
#[derive(Debug, Clone, PartialEq)]
struct Rows {
    /// The side of a cell.
    cell: f64,
    /// How many cells high the blocks are.
    height: usize,
    blocks: Vec<Block>,
    /// `blocks[first[k]..first[k + 1]]` are those that begin in row `k`.
    first: Vec<usize>,
}

impl Field {
    /// The obstacles of a grid of `columns` cells per row, `blocked` row by row, for a robot of this radius. `squeeze`: a point
    /// robot may pass where two cells touch diagonally.
    pub fn new(cell: f64, columns: usize, blocked: &[bool], radius: f64, squeeze: bool) -> Self {
        let rows = blocked.len() / columns.max(1);
        let is = |row: usize, column: usize| blocked[row * columns + column];
        let (cells, seams, grow) = if radius > 0.0 {
            (Rows::new(cell, [columns, rows], 1, is), Rows::new(cell, [columns, 0], 2, is), radius)
        } else {
            let grow = -HAIR * cell;
            let seam = |row, column| is(row, column) && is(row + 1, column);
            let mut seams = Rows::new(cell, [columns, rows.saturating_sub(1)], 2, seam);
            if !squeeze {
                seams.close_pinches(columns, is);
            }
            let mut cells = Rows::new(cell, [columns, rows], 1, is);
            // Nor between a cell at the border and the border itself.
            for block in &mut cells.blocks {
                let size = [columns as f64 * cell, rows as f64 * cell];
                block.min = block.min.map(|low| if low == 0.0 { -cell } else { low });
                block.max = [0, 1].map(|axis| block.max[axis] + if block.max[axis] == size[axis] { cell } else { 0.0 });
            }
            (cells, seams, grow)
        };
        Self { size: [columns as f64 * cell, rows as f64 * cell], grow, radius, margin: MARGIN * cell, cells, seams }
    }

    /// The robot's radius.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// The blocked cells, those side by side in a row as one block, row by row. For a point robot those at the border
    /// reach beyond it.
    pub fn blocks(&self) -> &[Block] {
        &self.cells.blocks
    }

    /// The distance of a turned rectangle from the nearest blocked cell; negative: the depth of the overlap, at least (what
    /// several rows form together may be deeper). `None` without obstacles. The robot's radius does not count.
    pub fn distance(&self, outline: &Oriented) -> Option<f64> {
        let (center, radius) = (outline.center, outline.radius());
        let mut reach = self.cells.cell;
        // Every block that is nearer than `reach` has been looked at; the first look that finds one so near is the last.
        while !self.cells.blocks.is_empty() && reach.is_finite() {
            let mut least = f64::INFINITY;
            walk([&self.cells], center, center, radius + reach, &mut |block| {
                let bound = (least + radius).max(0.0);
                if block.distance_squared_to(center) <= bound * bound {
                    least = least.min(outline.distance(block));
                }
                true
            });
            if least <= reach {
                return Some(least);
            }
            reach = if least.is_finite() { least } else { 2.0 * reach };
        }
        None
    }

    #[cfg(test)]
    fn all(&self) -> impl Iterator<Item = &Block> {
        self.cells.blocks.iter().chain(&self.seams.blocks)
    }

    /// Visits the blocks that a segment could come within `reach` of, and says no where `visit` did.
    fn all_near(&self, a: [f64; 2], b: [f64; 2], reach: f64, visit: &mut dyn FnMut(&Block) -> bool) -> bool {
        walk([&self.cells, &self.seams], a, b, reach, visit)
    }

    /// Whether the robot's centre may go from `a` straight to `b`.
    #[inline]
    pub fn is_free(&self, a: [f64; 2], b: [f64; 2]) -> bool {
        self.all_near(a, b, self.radius, &mut |block| !hits(block, self.grow, a, b))
    }

    /// The same for a round robot whose radius is smaller by `slack`, so that what touches by construction is not lost to
    /// rounding; larger if `slack` is negative, by up to a billionth of a cell. A point stays a point.
    pub fn is_nearly_free(&self, a: [f64; 2], b: [f64; 2], slack: f64) -> bool {
        let grow = (self.radius - slack).max(self.radius / 2.0);
        let apart = &mut |block: &Block| block.distance_squared(a, b) >= grow * grow;
        if self.radius > 0.0 { self.all_near(a, b, self.radius, apart) } else { self.is_free(a, b) }
    }

    /// The robot's smallest distance from an obstacle along `a`–`b`; negative: the depth of the overlap, at least (what several
    /// rows form together may be deeper). `None` without obstacles.
    pub fn clearance(&self, a: [f64; 2], b: [f64; 2]) -> Option<f64> {
        let signed = |block: &Block| {
            let squared = block.distance_squared(a, b);
            // A hair's overlap is what a point robot is allowed: it touches.
            let depth = || Some(block.depth(a, b)).filter(|&depth| depth > -self.grow.min(0.0)).unwrap_or(0.0);
            if squared > 0.0 { squared.sqrt() } else { -depth() }
        };
        if self.cells.blocks.is_empty() {
            return None;
        }
        // Every block that is nearer than `reach` has been looked at; the first look that finds one so near is the last.
        let mut reach = self.radius.max(self.cells.cell);
        loop {
            let mut least = f64::INFINITY;
            self.all_near(a, b, reach, &mut |block| {
                least = least.min(signed(block));
                true
            });
            if least <= reach || !reach.is_finite() {
                // Adding 0 turns −0 into 0.
                return Some(least - self.radius + 0.0);
            }
            reach *= 2.0;
        }
    }

    /// The width and height of the whole grid.
    pub fn size(&self) -> [f64; 2] {
        self.size
    }
}

impl ObstacleField for Field {
    /// The exact length of the part of `a`–`b` on which the robot overlaps an obstacle. The robot is larger by half a billionth
    /// of a cell here: where the length is 0, the segment is free, and remains so when it is cut into pieces. `pieces` is
    /// scratch space.
    fn length_inside(&self, a: [f64; 2], b: [f64; 2], pieces: &mut Vec<[f64; 2]>) -> f64 {
        pieces.clear();
        let (margin, grow) = (self.margin, self.grow + self.margin);
        self.all_near(a, b, self.radius + margin, &mut |block| {
            let piece = if grow <= 0.0 {
                block.grown(grow).clip(a, b)
            } else if block.distance_squared(a, b) < grow * grow {
                Some(block.clip_grown(grow, a, b).unwrap_or([0.0, 0.0]))
            } else {
                None
            };
            let Some(piece) = piece else { return true };
            // They are few: put in order one by one.
            let at = pieces.iter().take_while(|other| other[0] <= piece[0]).count();
            pieces.insert(at, piece);
            true
        });
        if pieces.is_empty() {
            return 0.0;
        }
        let (mut covered, mut end) = (0.0, 0.0);
        for &[from, to] in pieces.iter() {
            covered += (to - from.max(end)).max(0.0);
            end = to.max(end);
        }
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        (covered * (dx * dx + dy * dy).sqrt()).max(f64::MIN_POSITIVE)
    }

    fn is_free(&self, a: [f64; 2], b: [f64; 2]) -> bool {
        self.is_free(a, b)
    }
}

impl Rows {
    /// Runs of cells that are `on`, `height` cells high.
    fn new(cell: f64, [columns, rows]: [usize; 2], height: usize, on: impl Fn(usize, usize) -> bool) -> Self {
        let (mut blocks, mut first) = (Vec::new(), vec![0]);
        let corner = |column: usize, row: usize| [column as f64 * cell, row as f64 * cell];
        for row in 0..rows {
            push_runs(
                columns,
                |column| on(row, column),
                |from, to| {
                    blocks.push(Block { min: corner(from, row), max: corner(to, row + height) });
                },
            );
            first.push(blocks.len());
        }
        Self { cell, height, blocks, first }
    }

    /// Adds a block, small but more than a hair, wherever two cells touch diagonally.
    fn close_pinches(&mut self, columns: usize, is: impl Fn(usize, usize) -> bool) {
        let (mut blocks, mut first) = (Vec::new(), vec![0]);
        for row in 0..self.first.len() - 1 {
            let mut old = self.blocks[self.first[row]..self.first[row + 1]].iter().copied().peekable();
            for column in 1..columns {
                let [a, b, c, d] = [(row, column - 1), (row, column), (row + 1, column - 1), (row + 1, column)].map(|(r, c)| is(r, c));
                if (a && d && !b && !c) || (b && c && !a && !d) {
                    let corner = [column as f64 * self.cell, (row + 1) as f64 * self.cell];
                    while let Some(block) = old.next_if(|block| block.min[0] < corner[0]) {
                        blocks.push(block);
                    }
                    blocks.push(Block { min: corner, max: corner }.grown(4.0 * HAIR * self.cell));
                }
            }
            blocks.extend(old);
            first.push(blocks.len());
        }
        (self.blocks, self.first) = (blocks, first);
    }
}

/// Visits the blocks that a segment could come within `reach` of, and stops and says no where `visit` does: whole rows are
/// passed over, and within a row what lies beside the segment's box or beyond its line. (One walk for all who need one: it is
/// not small.)
fn walk<const N: usize>(sets: [&Rows; N], a: [f64; 2], b: [f64; 2], reach: f64, visit: &mut dyn FnMut(&Block) -> bool) -> bool {
    let (x0, x1) = if a[0] <= b[0] { (a[0] - reach, b[0] + reach) } else { (b[0] - reach, a[0] + reach) };
    let (y0, y1) = if a[1] <= b[1] { (a[1] - reach, b[1] + reach) } else { (b[1] - reach, a[1] + reach) };
    // A normal of the line, and how far from it a point within reach may be, in the normal's own length.
    let normal = [a[1] - b[1], b[0] - a[0]];
    let width = reach * (normal[0] * normal[0] + normal[1] * normal[1]).sqrt();
    // Twice the distance of a block's middle from the line, against the most that it may be within reach.
    let beside = |block: &Block| {
        let middle = [0, 1].map(|axis| block.min[axis] + block.max[axis] - 2.0 * a[axis]);
        let size = [0, 1].map(|axis| block.max[axis] - block.min[axis]);
        let across = normal[0] * middle[0] + normal[1] * middle[1];
        // A hair more, so that rounding passes over nothing that is touched.
        across.abs() > (size[0] * normal[0].abs() + size[1] * normal[1].abs() + 2.0 * width) * (1.0 + HAIR)
    };
    for Rows { cell, height, blocks, first } in sets {
        if blocks.is_empty() {
            continue;
        }
        // A negative number becomes 0: a row more than needed.
        let from = (y0 / cell - *height as f64) as usize;
        let to = ((y1 / cell) as usize).saturating_add(1).min(first.len() - 1);
        let from = from.min(to);
        let few = &blocks[first[from]..first[to]];
        if few.len() <= FEW {
            if !few.iter().all(|block| block.min[0] > x1 || block.max[0] < x0 || beside(block) || visit(block)) {
                return false;
            }
            continue;
        }
        for row in from..to {
            let mut blocks = &blocks[first[row]..first[row + 1]];
            if blocks.len() > FEW {
                blocks = &blocks[blocks.partition_point(|block| block.max[0] < x0)..];
            }
            for block in blocks {
                if block.min[0] > x1 {
                    break;
                }
                if block.max[0] >= x0 && !beside(block) && !visit(block) {
                    return false;
                }
            }
        }
    }
    true
}

/// Whether a segment enters a block grown by `grow`.
#[inline]
fn hits(block: &Block, grow: f64, a: [f64; 2], b: [f64; 2]) -> bool {
    if grow > 0.0 { block.distance_squared(a, b) < grow * grow } else { block.grown(grow).clip(a, b).is_some() }
}

/// Calls `push` with every maximal run of columns that are `on`.
fn push_runs(columns: usize, on: impl Fn(usize) -> bool, mut push: impl FnMut(usize, usize)) {
    let mut from = None;
    for column in 0..=columns {
        match (from, column < columns && on(column)) {
            (None, true) => from = Some(column),
            (Some(begin), false) => {
                push(begin, column);
                from = None;
            }
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows from y = 0 upwards.
    fn field(rows: &[&str], radius: f64) -> Field {
        let blocked: Vec<_> = rows.iter().flat_map(|row| row.chars().map(|c| c == '#')).collect();
        Field::new(1.0, rows[0].len(), &blocked, radius, false)
    }

    #[test]
    fn a_point_may_touch_cells_but_not_slip_between_them() {
        let field = field(&["....", ".##.", ".##.", "...."], 0.0);
        assert!(field.is_free([0.0, 1.0], [4.0, 1.0]), "along the lower side");
        assert!(field.is_free([0.0, 2.0], [2.0, 0.0]), "past the corner (1, 1)");
        assert!(!field.is_free([0.0, 2.0], [4.0, 2.0]), "along the seam between two rows");
        assert!(!field.is_free([2.0, 0.0], [2.0, 4.0]), "along the seam between two columns");
        assert!(!field.is_free([0.0, 2.0], [2.0, 0.01]));
        let diagonal = ["....", ".#..", "..#.", "...."];
        assert!(!self::field(&diagonal, 0.0).is_free([0.5, 3.5], [3.5, 0.5]), "where two cells touch diagonally");
        let blocked: Vec<_> = diagonal.iter().flat_map(|row| row.chars().map(|c| c == '#')).collect();
        assert!(Field::new(1.0, 4, &blocked, 0.0, true).is_free([0.5, 3.5], [3.5, 0.5]), "unless squeezing is allowed");
        let walled = self::field(&["...", "#..", ".##"], 0.0);
        assert!(!walled.is_free([0.0, 0.0], [0.0, 3.0]), "between a cell and the border");
        assert!(!walled.is_free([0.0, 3.0], [3.0, 3.0]) && walled.is_free([0.0, 0.0], [3.0, 0.0]));
        assert_eq!(field.clearance([0.0, 0.5], [4.0, 0.5]), Some(0.5));
        assert_eq!(field.clearance([0.0, 1.0], [4.0, 1.0]), Some(0.0));
        assert!(field.clearance([0.0, 1.5], [4.0, 1.5]).unwrap() < -0.49);
    }

    #[test]
    fn a_round_robot_keeps_its_radius_away_and_corners_are_round() {
        let field = field(&["....", ".##.", "....", "...."], 0.5);
        assert!(field.is_free([0.0, 0.5], [4.0, 0.5]) && !field.is_free([0.0, 0.501], [4.0, 0.501]));
        let off = 1.0 - 0.5 * std::f64::consts::FRAC_1_SQRT_2;
        assert!(field.is_free([off - 1e-9, off - 1e-9], [off - 1e-9, off - 1e-9]), "just off the rounded corner");
        assert!(!field.is_free([off + 1e-9, off + 1e-9], [off + 1e-9, off + 1e-9]));
        assert_eq!(field.clearance([0.0, 3.0], [4.0, 3.0]), Some(0.5));
        assert_eq!(field.clearance([2.0, 0.0], [2.0, 0.75]), Some(-0.25));
    }

    /// However far the search for the nearest block has to go: against a look at every block.
    #[test]
    fn a_turned_rectangle_s_distance_is_from_the_nearest_block() {
        let mut rng = crate::kernel::rng::Stream::new(6, 0);
        for case in 0..200 {
            let blocked: Vec<_> = (0..40 * 30).map(|i| rng.unit() < 0.03 * f64::from(case % 4) || (case % 4 == 0 && i == 77)).collect();
            let field = Field::new(0.5, 40, &blocked, 0.3, false);
            for _ in 0..20 {
                let angle = rng.between(-3.0, 3.0);
                let outline = Oriented {
                    center: [rng.between(-5.0, 25.0), rng.between(-5.0, 20.0)],
                    direction: [crate::math::cos(angle), crate::math::sin(angle)],
                    half: [rng.between(0.1, 1.0), rng.between(0.1, 0.5)],
                };
                let least = field.blocks().iter().map(|block| outline.distance(block)).reduce(f64::min);
                assert_eq!(field.distance(&outline), least);
            }
        }
        let center = [1.0, 1.0];
        assert_eq!(Field::new(1.0, 3, &[false; 6], 0.3, false).distance(&Oriented { center, direction: [1.0, 0.0], half: [0.2; 2] }), None);
    }

    #[test]
    fn length_inside_counts_overlaps_once() {
        let mut pieces = Vec::new();
        let field = field(&["......", ".#.##.", ".#....", "......"], 0.5);
        // Along y = 1.5: from 0.5 to 2.5 and from 2.5 to 5.5, touching; 5 in all of 6.
        assert!((field.length_inside([0.0, 1.5], [6.0, 1.5], &mut pieces) - 5.0 - 2.0 * MARGIN).abs() < 1e-12);
        // Up x = 1.5: rows 1 and 2 together, from 0.5 to 3.5.
        assert!((field.length_inside([1.5, 0.0], [1.5, 4.0], &mut pieces) - 3.0 - 2.0 * MARGIN).abs() < 1e-12);
        assert_eq!(field.length_inside([0.0, 0.5 - 1e-9], [6.0, 0.5 - 1e-9], &mut pieces), 0.0, "a hair beside");
        assert!(field.length_inside([0.0, 0.5], [6.0, 0.5], &mut pieces) > 2.9, "planners keep a margin");
        assert!(field.is_free([0.0, 0.5], [6.0, 0.5]), "but to touch is free");
    }

    /// The rows and columns that are passed over never hide a hit: against a look at every block.
    #[test]
    fn passing_over_far_rows_changes_nothing() {
        let mut rng = crate::kernel::rng::Stream::new(5, 0);
        for case in 0..24 {
            let radius = [0.0, 0.3, 0.5, 1.7][case % 4];
            let blocked: Vec<_> = (0..12 * 9).map(|_| rng.unit() < 0.2).collect();
            let field = Field::new(0.5, 12, &blocked, radius, case % 2 == 0);
            for _ in 0..60 {
                let [a, b] = [0, 1].map(|_| [rng.between(0.0, 6.0), rng.between(0.0, 4.5)]);
                let b = if case % 3 == 0 { [b[0], a[1]] } else { b };
                let all = field.all().any(|block| hits(block, field.grow, a, b));
                assert_eq!(field.is_free(a, b), !all, "{a:?} {b:?} radius {radius}");
                let inside = field.length_inside(a, b, &mut Vec::new());
                let strict = field.all().any(|block| hits(block, field.grow + field.margin, a, b));
                assert_eq!(inside > 0.0, strict);
                let sampled = (0..400)
                    .map(|i| f64::from(i) / 400.0)
                    .map(|t| [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])])
                    .filter(|&p| field.all().any(|block| hits(block, field.grow, p, p)))
                    .count() as f64;
                let length = super::super::length(&[a, b]);
                assert!((inside - length * sampled / 400.0).abs() < length * 0.03, "{inside} {sampled}");
            }
        }
    }
}
