//! Whether one cell's centre can be seen from another's: whether the robot can go straight.

use std::cmp::Ordering;

use crate::geometry::Cells;

/// For a point robot, in whole numbers: every cell that the line enters must be free. Where it goes through a corner of
/// cells, it only touches the two beside it; if both are blocked, it passes if corners may be cut.
///
/// That is [`crate::geometry::Field::is_free`]: a line between centres lies on no line of the grid, and if it misses a corner, then by at
/// least half a cell over its length, a ten thousandth of a cell; a field looks away from a billionth.
pub(super) fn walk(cells: &Cells, cutting: bool, from: usize, to: usize) -> bool {
    let ([x, y], [to_x, to_y]) = (cells.place(from), cells.place(to));
    let (dx, dy) = (x.abs_diff(to_x).cast_signed(), y.abs_diff(to_y).cast_signed());
    let across = if to_x > x { 1 } else { -1 };
    let along = cells.columns.cast_signed() * if to_y > y { 1 } else { -1 };
    // Twice the line's distance from the next corner, in cells over its length: which side of the cell it leaves by.
    let mut side = dx - dy;
    let mut at = from;
    while at != to {
        let (next_x, next_y) = (at.wrapping_add_signed(across), at.wrapping_add_signed(along));
        match side.cmp(&0) {
            Ordering::Greater => {
                at = next_x;
                side -= 2 * dy;
            }
            Ordering::Less => {
                at = next_y;
                side += 2 * dx;
            }
            Ordering::Equal if !cutting && !cells.is_free(next_x) && !cells.is_free(next_y) => return false,
            Ordering::Equal => {
                at = next_x.wrapping_add_signed(along);
                side += 2 * (dx - dy);
            }
        }
        if !cells.is_free(at) {
            return false;
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{kernel::rng::Stream, scene::GridScene};

    #[test]
    fn the_walk_says_what_the_field_says() {
        let mut rng = Stream::new(3, 0);
        let mut seen = [0; 2];
        for grid in 0..120 {
            let [columns, rows] = [1 + rng.below(24), 1 + rng.below(24)];
            let density = 0.4 * rng.unit();
            let blocked: Vec<_> = (0..columns * rows).map(|_| rng.unit() < density).collect();
            let side = [1.0, 0.15, 1e-6, 1000.0][grid % 4];
            let scene = GridScene { corner_cutting: grid % 3 == 0, ..GridScene::new(side, columns, blocked) };
            let (cells, field) = (scene.cells(), scene.field());
            for _ in 0..300 {
                let (a, b) = (rng.below(cells.len()), rng.below(cells.len()));
                if cells.is_free(a) && cells.is_free(b) {
                    let free = field.is_free(cells.centre(a), cells.centre(b));
                    assert_eq!(walk(cells, scene.corner_cutting, a, b), free, "{:?} {a} {b}", scene.lines());
                    seen[usize::from(free)] += 1;
                }
            }
        }
        assert!(seen.iter().all(|&n| n > 3000), "{seen:?}");
    }
}
