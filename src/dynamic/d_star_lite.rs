//! D* Lite, the optimised version: S. Koenig, M. Likhachev, *D\* Lite*, AAAI 2002, figure 4. It searches from the goal
//! to the robot and, when cells become occupied or free, repairs what it knew instead of searching anew.

use std::{sync::Arc, task::Poll};

use crate::{
    geometry::{Cells, Steps},
    kernel::{Part, State},
};

use super::{
    parts::{PORTION, complete},
    queue::{Key, Queue},
    steps::{NEVER, all_next, all_previous, and, next, octile, ordered, shorter, straightest, sum},
};

/// Once k_m is longer than this many cells, the search begins anew: keys must stay where lengths are exact (see
/// [`shorter`]; a way has at most six million cells' length). A robot drives there for a long time.
const FAR: f64 = 4_194_304.0;

/// Cells that are compared at once.
const STRIP: usize = 64;

/// A shortest way to one goal over cells of which some are occupied, kept up while they change and the robot moves.
///
/// The edge from u to v costs what the step costs; it is infinite if v is occupied or the step is not allowed. So the
/// robot may stand on an occupied cell and leave it; it enters none.
///
/// Among the shortest ways the last one goes on, as far as it is still free: a robot does not waver between equals.
/// Otherwise it is one with few turns ([`straightest`]). All the shortest ways are there to choose from: their cells' keys
/// are below the robot's (k1 at most the same, k2 less), so all of them are consistent when the search ends.
#[derive(Debug, Clone, State)]
pub(super) struct DStarLite {
    #[state(shared)]
    cells: Arc<Cells>,
    occupied: Vec<bool>,
    /// The robot's cell, s_start and s_last in one: k_m grows with every move, not only before changes. Along the way that
    /// costs nothing, as the robot's key stays the same; and the robot may be anywhere when it asks again.
    robot: usize,
    goal: usize,
    /// The length of each cell's way to the goal as it was found.
    g: Vec<Steps>,
    /// One step's look-ahead of it: the least of step and g over the cells that a step leads to.
    rhs: Vec<Steps>,
    /// U: the cells that are inconsistent, g ≠ rhs. Their keys are lower bounds of what they would be now.
    open: Queue,
    /// By how much keys made from now on are too high beside older ones.
    k_m: Steps,
    /// The last way.
    last: Vec<usize>,
    expanded: u64,
}

impl DStarLite {
    /// Initialize().
    pub(super) fn new(cells: &Arc<Cells>, start: usize, goal: usize) -> Self {
        let n = cells.len();
        let mut search = Self {
            cells: Arc::clone(cells),
            occupied: vec![false; n],
            robot: start,
            goal,
            g: vec![NEVER; n],
            rhs: vec![NEVER; n],
            open: Queue::new(n),
            k_m: Steps::default(),
            last: Vec::new(),
            expanded: 0,
        };
        search.begin();
        search
    }

    /// Only the goal is known.
    fn begin(&mut self) {
        self.g.fill(NEVER);
        self.rhs.fill(NEVER);
        self.open.clear();
        self.k_m = Steps::default();
        self.rhs[self.goal] = Steps::default();
        self.open.put(self.goal, self.key(self.goal));
    }

    /// Tells which cells are occupied now. Only what changed since the last call costs anything beyond the comparison.
    pub(super) fn occupy(&mut self, occupied: &[bool]) {
        for (i, now) in occupied.chunks(STRIP).enumerate() {
            // Most strips are as they were, and whole strips are compared at once.
            if self.occupied[i * STRIP..][..now.len()] != *now {
                now.iter().enumerate().for_each(|(j, &now)| self.change(i * STRIP + j, now));
            }
        }
    }

    /// If a cell became occupied or free, all steps into it changed their costs.
    fn change(&mut self, cell: usize, occupied: bool) {
        if std::mem::replace(&mut self.occupied[cell], occupied) == occupied {
            return;
        }
        let (cells, goal) = (Arc::clone(&self.cells), self.goal);
        for (before, d) in all_previous(&cells, cell).filter(|&(before, _)| before != goal) {
            let through = and(self.g[cell], d);
            if occupied {
                self.worsen(before, through);
            } else {
                self.improve(before, through);
            }
        }
    }

    /// A shortest way from where the robot is now to the goal, both included; `None` where there is none.
    pub(super) fn way(&mut self, from: usize) -> Option<Vec<usize>> {
        self.go(from);
        complete(|| self.go_on())
    }

    /// Goes on with a part of the search from where the robot is.
    pub(super) fn go_on(&mut self) -> Poll<Option<Vec<usize>>> {
        let from = self.robot;
        // While nobody can enter the goal, no repair is worth its while.
        let way = if self.occupied[self.goal] && from != self.goal {
            None
        } else if self.search() {
            self.rest(from).or_else(|| self.downhill(from))
        } else {
            return Poll::Pending;
        };
        self.last.clone_from(way.as_ref().unwrap_or(&Vec::new()));
        Poll::Ready(way)
    }

    /// The robot moves. The keys in the queue stay lower bounds if all new ones are higher by as much as the heuristic
    /// may have fallen.
    pub(super) fn go(&mut self, to: usize) {
        self.k_m = sum(self.k_m, octile(&self.cells, self.robot, to));
        self.robot = to;
        if self.k_m.length() > FAR {
            self.begin();
        }
    }

    /// ComputeShortestPath(), or a part of it: whether it is over.
    fn search(&mut self) -> bool {
        for _ in 0..Part::at_most(PORTION) {
            let robot = self.robot;
            let Some((key, cell)) = self.open.first().filter(|&(key, _)| key < self.key(robot) || shorter(self.g[robot], self.rhs[robot]))
            else {
                return true;
            };
            let now = self.key(cell);
            if key < now {
                self.open.put(cell, now);
                continue;
            }
            self.expanded += 1;
            if shorter(self.rhs[cell], self.g[cell]) {
                self.lower(cell);
            } else {
                self.raise(cell);
            }
        }
        false
    }

    /// An overconsistent cell: its way is as short as it looks, and others may go through it.
    fn lower(&mut self, cell: usize) {
        self.g[cell] = self.rhs[cell];
        self.open.remove(cell);
        let cells = Arc::clone(&self.cells);
        for (before, d) in self.entrances(&cells, cell) {
            self.improve(before, self.g[cell].and(d));
        }
    }

    /// An underconsistent cell: its way is longer than it was thought, and so may be those that lead through it.
    fn raise(&mut self, cell: usize) {
        let old = std::mem::replace(&mut self.g[cell], NEVER);
        self.update(cell);
        let cells = Arc::clone(&self.cells);
        for (before, d) in self.entrances(&cells, cell) {
            self.worsen(before, old.and(d));
        }
    }

    /// The cells that can enter this one, other than the goal, whose rhs is 0 for ever.
    fn entrances<'a>(&self, cells: &'a Cells, cell: usize) -> impl Iterator<Item = (usize, usize)> + use<'a> {
        let (goal, free) = (self.goal, !self.occupied[cell]);
        all_previous(cells, cell).filter(move |&(before, _)| free && before != goal)
    }

    /// There is a way from here that may be shorter than the one that was seen. (The paper updates the cell in any case;
    /// but where rhs stays, its key in the queue is a lower bound as it was.)
    fn improve(&mut self, cell: usize, way: Steps) {
        if shorter(way, self.rhs[cell]) {
            self.rhs[cell] = way;
            self.update(cell);
        }
    }

    /// There is a way from here no more; it may have been the one that was seen.
    fn worsen(&mut self, cell: usize, way: Steps) {
        if self.rhs[cell] == way {
            self.rhs[cell] = self.look_ahead(cell);
            self.update(cell);
        }
    }

    /// The least of step and g over all cells that can be entered from here.
    fn look_ahead(&self, cell: usize) -> Steps {
        let ways = all_next(&self.cells, cell).filter(|&(next, _)| !self.occupied[next]).map(|(next, d)| and(self.g[next], d));
        ways.fold(NEVER, |least, way| if shorter(way, least) { way } else { least })
    }

    /// UpdateVertex().
    fn update(&mut self, cell: usize) {
        if self.g[cell] == self.rhs[cell] {
            self.open.remove(cell);
        } else {
            self.open.put(cell, self.key(cell));
        }
    }

    /// CalculateKey().
    fn key(&self, cell: usize) -> Key {
        let (g, rhs) = (self.g[cell], self.rhs[cell]);
        let least = if shorter(g, rhs) { g } else { rhs };
        if least == NEVER {
            return [u64::MAX; 2];
        }
        [ordered(sum(sum(least, octile(&self.cells, self.robot, cell)), self.k_m)), ordered(least)]
    }

    /// What is left of the last way, if it leads on from here, is free, and is still a shortest.
    fn rest(&self, from: usize) -> Option<Vec<usize>> {
        let rest = &self.last[self.last.iter().position(|&cell| cell == from)?..];
        let free = rest[1..].iter().all(|&cell| !self.occupied[cell]);
        (free && self.cells.steps(rest) == self.rhs[from]).then(|| rest.to_vec())
    }

    /// The way along which g falls by the lengths of the steps.
    fn downhill(&self, from: usize) -> Option<Vec<usize>> {
        let on = |cell: usize, next: usize, d| !self.occupied[next] && self.g[next] != NEVER && self.g[next].and(d) == self.rhs[cell];
        straightest(from, self.goal, |cell, d| next(&self.cells, cell, d).filter(|&next| on(cell, next, d)))
    }

    /// How many cells were settled so far. A cell counts whenever its g changes.
    pub(super) fn expanded(&self) -> u64 {
        self.expanded
    }
}

#[cfg(test)]
mod tests;
