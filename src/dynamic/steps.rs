//! What the searches over cells that are occupied now and then have in common: lengths, neighbours, and which of the
//! shortest ways is taken.

use std::{cmp::Reverse, iter::successors};

use crate::{
    geometry::{Cells, DIRECTIONS, Steps},
    kernel::{Digest, State},
};

/// Longer than any way: there is none.
pub(super) const NEVER: Steps = Steps { straight: u32::MAX, diagonal: u32::MAX };

impl State for Steps {
    fn digest(&self, out: &mut Digest) {
        out.word(u64::from(self.straight) << 32 | u64::from(self.diagonal));
    }
    fn heap_size(&self) -> usize {
        0
    }
}

/// Whether one way is shorter than another.
///
/// Sums of steps are whole numbers, so it is of no account in which order they were added up. Rounding does not blur
/// their order either: if a ≠ b√2, the two differ by 1 / (a + b√2) at least, since a² ≠ 2b²; below ten million cells that
/// is 5e-8, and lengths are rounded by less than 5e-9.
#[inline]
pub(super) fn shorter(a: Steps, b: Steps) -> bool {
    a.length() < b.length()
}

/// A length as part of a key: numbers that are not negative are ordered as their bits.
#[inline]
pub(super) fn ordered(steps: Steps) -> u64 {
    if steps == NEVER { u64::MAX } else { steps.length().to_bits() }
}

/// One way after another. Neither is [`NEVER`].
#[inline]
pub(super) fn sum(a: Steps, b: Steps) -> Steps {
    Steps { straight: a.straight + b.straight, diagonal: a.diagonal + b.diagonal }
}

/// A way and one step more; where there is no way, still none.
#[inline]
pub(super) fn and(way: Steps, direction: usize) -> Steps {
    if way == NEVER { NEVER } else { way.and(direction) }
}

/// The shortest way between two cells if nothing were in the way, the octile distance: no way is shorter, and no step
/// brings it down by more than the step's length.
#[inline]
pub(super) fn octile(cells: &Cells, a: usize, b: usize) -> Steps {
    let ([ax, ay], [bx, by]) = (cells.place(a), cells.place(b));
    let (dx, dy) = (ax.abs_diff(bx) as u32, ay.abs_diff(by) as u32);
    Steps { straight: dx.abs_diff(dy), diagonal: dx.min(dy) }
}

/// The cell that the step in a direction leads to, if it is allowed.
#[inline]
pub(super) fn next(cells: &Cells, cell: usize, direction: usize) -> Option<usize> {
    (cells.moves(cell) >> direction & 1 != 0).then(|| cells.next(cell, direction))
}

/// The cell from which the step in a direction leads here, if it is allowed. It is not asked whether the step back is: for
/// a wide robot that just touches, the one may be allowed and the other not, by rounding.
#[inline]
pub(super) fn previous(cells: &Cells, cell: usize, direction: usize) -> Option<usize> {
    previous_to(cells, cells.place(cell), direction)
}

#[inline]
fn previous_to(cells: &Cells, [x, y]: [usize; 2], direction: usize) -> Option<usize> {
    let [dx, dy] = DIRECTIONS[direction];
    let column = x.checked_add_signed(-dx as isize).filter(|&column| column < cells.columns)?;
    let row = y.checked_add_signed(-dy as isize).filter(|&row| row < cells.rows)?;
    let previous = row * cells.columns + column;
    (cells.moves(previous) >> direction & 1 != 0).then_some(previous)
}

/// All cells that a step leads to, each with its direction.
#[inline]
pub(super) fn all_next(cells: &Cells, cell: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..8).filter_map(move |d| Some((next(cells, cell, d)?, d)))
}

/// All cells from which a step leads here, each with its direction.
#[inline]
pub(super) fn all_previous(cells: &Cells, cell: usize) -> impl Iterator<Item = (usize, usize)> {
    let place = cells.place(cell);
    (0..8).filter_map(move |d| Some((previous_to(cells, place, d)?, d)))
}

/// One of the shortest ways between two cells, with few turns. `step` leads from a cell in a direction if that is part of
/// a shortest way to the end.
///
/// It goes straight on while that is no detour; where it has to turn, it takes the direction in which it can go straight
/// on for the most cells (among equals the one with the smaller number). Ways with fewer turns there may be, but to be
/// sure of the fewest, all shortest ways would have to be looked at, and they cover whole fields.
pub(super) fn straightest(start: usize, end: usize, step: impl Fn(usize, usize) -> Option<usize>) -> Option<Vec<usize>> {
    let run = |cell, d| successors(step(cell, d), |&cell| step(cell, d)).count();
    let farthest = |cell| (0..8).map(|d| (run(cell, d), Reverse(d))).max().map(|(_, Reverse(d))| d);
    let (mut way, mut cell, mut heading) = (vec![start], start, None);
    while cell != end {
        heading = heading.filter(|&d| step(cell, d).is_some()).or_else(|| farthest(cell));
        cell = step(cell, heading?)?;
        way.push(cell);
    }
    Some(way)
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::scene::GridScene;

    #[test]
    fn lengths_that_hardly_differ_are_told_apart() {
        let [straight, diagonal] = [(9_369_319, 0), (0, 6_625_109)].map(|(straight, diagonal)| Steps { straight, diagonal });
        let (a, b) = (u64::from(straight.straight), u64::from(diagonal.diagonal));
        assert_eq!((a * a).abs_diff(2 * b * b), 1, "a convergent of √2: nothing so short is closer");
        assert_eq!(shorter(straight, diagonal), a * a < 2 * b * b);
        assert_eq!(shorter(diagonal, straight), a * a > 2 * b * b);
        assert!(shorter(sum(straight, diagonal), NEVER) && ordered(sum(straight, diagonal)) < ordered(NEVER));
        assert_eq!(and(NEVER, 1), NEVER);
    }

    #[test]
    fn what_leads_to_a_cell_and_what_leads_from_it_are_the_same_steps() {
        let mut rng = crate::kernel::rng::Stream::new(3, 0);
        let blocked = (0..9 * 7).map(|_| rng.unit() < 0.3).collect();
        let cells = Arc::clone(GridScene::new(1.0, 9, blocked).cells());
        let mut forth: Vec<_> = (0..63).flat_map(|a| all_next(&cells, a).map(move |(b, d)| (a, b, d))).collect();
        let mut back: Vec<_> = (0..63).flat_map(|b| all_previous(&cells, b).map(move |(a, d)| (a, b, d))).collect();
        forth.sort_unstable();
        back.sort_unstable();
        assert!(forth == back && !forth.is_empty());
    }

    #[test]
    fn the_octile_distance_is_a_way_over_free_cells() {
        let cells = Arc::clone(GridScene::new(1.0, 9, vec![false; 63]).cells());
        assert_eq!(octile(&cells, 0, 9 * 2 + 5), Steps { straight: 3, diagonal: 2 });
        assert_eq!(octile(&cells, 62, 8), Steps { straight: 6, diagonal: 0 });
        assert_eq!(octile(&cells, 6, 6), Steps::default());
    }

    #[test]
    fn among_shortest_ways_one_with_few_turns_is_taken() {
        // To the far corner of an open field: (8, 6) takes 2 straight and 6 diagonal steps in any order.
        let cells = Arc::clone(GridScene::new(1.0, 9, vec![false; 63]).cells());
        let far = |cell| octile(&cells, cell, 62);
        let way = straightest(0, 62, |cell, d| next(&cells, cell, d).filter(|&next| far(next).and(d) == far(cell))).unwrap();
        assert_eq!(way, [0, 10, 20, 30, 40, 50, 60, 61, 62], "one turn");
        assert_eq!(straightest(5, 5, |_, _| None), Some(vec![5]));
        assert_eq!(straightest(5, 6, |_, _| None), None);
    }
}
