//! A* over cells of which some are occupied, each time from scratch: P. Hart, N. Nilsson, B. Raphael, *A formal basis for
//! the heuristic determination of minimum cost paths*, IEEE Transactions on Systems Science and Cybernetics 4(2), 1968.

use std::{sync::Arc, task::Poll};

use crate::{
    geometry::{Cells, Steps},
    kernel::{Part, State},
};

use super::{
    parts::{PORTION, complete},
    queue::Queue,
    steps::{NEVER, all_next, octile, ordered, previous, shorter, straightest, sum},
};

/// A shortest way over cells of which some are occupied. The robot may stand on an occupied cell and leave it; it enters
/// none.
///
/// Among cells with equal f the one with the larger g is settled first, for it is nearer to the goal; among those the one
/// with the smaller number. The way is read backwards from the goal, by lengths alone, and among the shortest ways over
/// cells that were reached it is one with few turns ([`straightest`]).
#[derive(Debug, Clone, State)]
pub(super) struct AStar {
    #[state(shared)]
    cells: Arc<Cells>,
    /// The shortest way known to each cell.
    #[state(skip)]
    g: Vec<Steps>,
    /// The cells to which there is one.
    #[state(skip)]
    reached: Vec<u32>,
    #[state(skip)]
    open: Queue,
    expanded: u64,
    /// What the search under way must not enter, and where it begins and ends.
    #[state(skip)]
    occupied: Vec<bool>,
    #[state(skip)]
    ends: [usize; 2],
}

impl AStar {
    pub(super) fn new(cells: &Arc<Cells>) -> Self {
        let n = cells.len();
        let occupied = vec![false; n];
        let (cells, g) = (Arc::clone(cells), vec![NEVER; n]);
        Self { cells, g, reached: Vec::new(), open: Queue::new(n), expanded: 0, occupied, ends: [0; 2] }
    }

    /// The cells of a shortest way, both ends included; `None` where there is none.
    pub(super) fn way(&mut self, occupied: &[bool], from: usize, to: usize) -> Option<Vec<usize>> {
        self.begin(occupied, from, to);
        complete(|| self.go_on())
    }

    /// Begins to look for a way.
    pub(super) fn begin(&mut self, occupied: &[bool], from: usize, to: usize) {
        self.occupied.copy_from_slice(occupied);
        self.ends = [from, to];
        self.forget();
        // Where nothing enters the goal, all there is to reach would be searched for nothing.
        if !occupied[to] || from == to {
            self.reach(from, Steps::default(), to);
        }
    }

    /// Goes on with a part of the search that has begun.
    pub(super) fn go_on(&mut self) -> Poll<Option<Vec<usize>>> {
        let (cells, [from, to]) = (Arc::clone(&self.cells), self.ends);
        for _ in 0..Part::at_most(PORTION) {
            let Some(cell) = self.open.pop() else {
                return Poll::Ready(None);
            };
            self.expanded += 1;
            if cell == to {
                return Poll::Ready(self.back(from, to));
            }
            // No cell is settled twice: the octile distance is consistent, Hart et al., lemma 2.
            for (next, d) in all_next(&cells, cell) {
                let g = self.g[cell].and(d);
                if !self.occupied[next] && shorter(g, self.g[next]) {
                    self.reach(next, g, to);
                }
            }
        }
        Poll::Pending
    }

    /// A cell is reached by a shorter way than before.
    fn reach(&mut self, cell: usize, g: Steps, to: usize) {
        if self.g[cell] == NEVER {
            self.reached.push(cell as u32);
        }
        self.g[cell] = g;
        let f = sum(g, octile(&self.cells, cell, to));
        self.open.put(cell, [ordered(f), !ordered(g)]);
    }

    /// The way back from the goal. A neighbour is on a shortest way if with the step its length is the goal-side cell's:
    /// had it not been settled, it would have its shortest length all the same, or the goal's side would be shorter.
    fn back(&self, from: usize, to: usize) -> Option<Vec<usize>> {
        let on = |cell: usize, before: usize, d| self.g[before] != NEVER && self.g[before].and(d) == self.g[cell];
        let mut way = straightest(to, from, |cell, d| previous(&self.cells, cell, d).filter(|&before| on(cell, before, d)))?;
        way.reverse();
        Some(way)
    }

    /// Makes room for the next search: only what the last one reached is wiped.
    fn forget(&mut self) {
        self.reached.drain(..).for_each(|cell| self.g[cell as usize] = NEVER);
        self.open.clear();
    }

    /// How many cells were settled so far, over all searches.
    pub(super) fn expanded(&self) -> u64 {
        self.expanded
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::GridScene;

    fn cells(rows: &[&str]) -> Arc<Cells> {
        let blocked = rows.iter().flat_map(|row| row.chars().map(|c| c == '#')).collect();
        Arc::clone(GridScene::new(1.0, rows[0].len(), blocked).cells())
    }

    /// The cells marked with an `x`.
    fn occupied(rows: &[&str]) -> Vec<bool> {
        rows.iter().flat_map(|row| row.chars().map(|c| c == 'x')).collect()
    }

    #[test]
    fn it_goes_round_what_is_occupied_past_its_corners_but_not_past_those_of_walls() {
        let map = ["....", ".#..", "...."];
        let (cells, none) = (cells(&map), [false; 12]);
        let mut search = AStar::new(&cells);
        // To the wall's other side: 4 straight steps round it by either side, as its corners must not be cut.
        let way = search.way(&none, 4, 6).unwrap();
        assert_eq!(cells.steps(&way), Steps { straight: 4, diagonal: 0 });
        // From (2, 0) to (3, 2): 1 straight and 1 diagonal step, past the occupied cell (3, 1).
        let way = search.way(&occupied(&["....", ".#.x", "...."]), 2, 11);
        assert_eq!(way, Some(vec![2, 6, 11]));
        let way = search.way(&occupied(&["..x.", ".#..", "..x."]), 0, 3);
        assert_eq!(way, None, "the wall's corners and the occupied cells close both sides");
    }

    #[test]
    fn straight_ahead_only_the_cells_of_the_way_are_settled() {
        let cells = cells(&["........."; 7]);
        let mut search = AStar::new(&cells);
        assert_eq!(search.way(&[false; 63], 0, 62), Some(vec![0, 10, 20, 30, 40, 50, 60, 61, 62]), "one turn");
        assert_eq!(search.expanded(), 9, "the larger g first");
        search.way(&[false; 63], 0, 62);
        assert_eq!(search.expanded(), 18, "over all searches");
    }

    #[test]
    fn the_robot_leaves_an_occupied_cell_and_enters_none() {
        let cells = cells(&["....", "####"]);
        let mut search = AStar::new(&cells);
        assert_eq!(search.way(&occupied(&["x...", "...."]), 0, 3), Some(vec![0, 1, 2, 3]));
        assert_eq!(search.way(&occupied(&["xx..", "...."]), 0, 3), None);
        assert_eq!(search.way(&occupied(&["...x", "...."]), 0, 3), None, "nor the goal");
        assert_eq!(search.way(&occupied(&["...x", "...."]), 3, 3), Some(vec![3]), "where it is already");
        assert_eq!(search.way(&[false; 8], 4, 3), None, "nothing leaves a wall");
    }

    /// It is not proved, but so it is: turns are made from the goal's side, which stays while the robot moves.
    #[test]
    fn who_searches_anew_at_every_cell_stays_on_the_way() {
        for seed in 0..40 {
            let mut rng = crate::kernel::rng::Stream::new(seed, 5);
            let walls = [0.0, 0.1, 0.2, 0.3][seed as usize % 4];
            let cells = Arc::clone(GridScene::new(1.0, 50, (0..2500).map(|_| rng.unit() < walls).collect()).cells());
            let (from, to, none) = (rng.below(2500), rng.below(2500), [false; 2500]);
            let mut search = AStar::new(&cells);
            let Some(way) = search.way(&none, from, to) else { continue };
            for at in 1..way.len() {
                assert_eq!(search.way(&none, way[at], to).as_deref(), Some(&way[at..]));
            }
        }
    }

    /// What a search leaves behind does not reach the next.
    #[test]
    fn a_used_one_answers_as_a_new_one() {
        let mut rng = crate::kernel::rng::Stream::new(4, 0);
        let cells = Arc::clone(GridScene::new(1.0, 12, (0..120).map(|_| rng.unit() < 0.2).collect()).cells());
        let mut used = AStar::new(&cells);
        for _ in 0..300 {
            let occupied: Vec<_> = (0..120).map(|_| rng.unit() < 0.2).collect();
            let (from, to) = (rng.below(120), rng.below(120));
            assert_eq!(used.way(&occupied, from, to), AStar::new(&cells).way(&occupied, from, to));
        }
    }
}
