//! The search itself: the most promising cell is settled, its neighbours are reached from it, and so on to the goal.

use std::sync::Arc;

use crate::{
    describe::Start,
    geometry::DIRECTIONS,
    kernel::{Error, Part, Progress, State, Status},
};

use super::{
    found::Found,
    link::{Link, onward},
    open::{Open, Place, apart, place},
    rules::{DIAGONAL, Guess, Relaxation, Rules, STRAIGHT},
    sight::walk,
    task::Task,
};

/// So many cells are settled in a part of a step.
const PORTION: usize = 50_000;

/// A best-first search over a grid's cells. Lengths are in units of a straight step by [`STRAIGHT`].
#[derive(Clone, State)]
pub(super) struct Search {
    #[state(shared)]
    pub(super) task: Arc<Task>,
    /// The best way known to each cell: the complement of its length's bits, so that a shorter way is a greater number,
    /// and 0 no way at all (memory that is 0 costs nothing until it is used).
    ways: Vec<u64>,
    /// How each cell that was reached was reached.
    links: Vec<Link>,
    open: Open,
    pub(super) iteration: u64,
    /// How many cells are settled.
    pub(super) expanded: u64,
    /// How many are reached and not settled.
    pub(super) frontier: u64,
    /// The lowest f on the frontier; once the goal is settled, the goal's.
    pub(super) lowest: Option<f64>,
    pub(super) found: Option<Arc<Found>>,
    #[state(skip)]
    part: Part,
}

fn way(g: f64) -> u64 {
    !g.to_bits()
}

fn length(way: u64) -> f64 {
    f64::from_bits(!way)
}

impl Search {
    pub(super) fn new(start: &Start, rules: Rules, weight: f64) -> Result<Self, Error> {
        Ok(Self::begin(Task::new(start, rules, weight)?))
    }

    /// The start alone is reached.
    fn begin(task: Task) -> Self {
        let (n, start) = (task.cells.len(), task.endpoints.start);
        let first = place(task.cells.place(start));
        let h = task.guess.ahead(apart(first));
        let mut search = Self {
            task: Arc::new(task),
            ways: vec![0; n],
            links: vec![Link::default(); n],
            open: Open::default(),
            iteration: 0,
            expanded: 0,
            frontier: 1,
            lowest: Some(h),
            found: None,
            part: Part::default(),
        };
        (search.ways[start], search.links[start]) = (way(0.0), Link::new(start, 0));
        search.open.push(h, first);
        search
    }

    /// The same search by another guess, with as many cells settled.
    pub(super) fn guessing(&self, guess: Guess) -> Self {
        let mut other = Self::begin(Task { guess, table: guess.table(&self.task.cells), ..(*self.task).clone() });
        while other.expanded < self.expanded && other.settle() == Progress::Continue {}
        other
    }

    /// The cells that are reached and not settled.
    pub(super) fn on_the_frontier(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.ways.len()).filter(|&cell| self.ways[cell] != 0 && !self.is_closed(cell))
    }

    /// Settles some cells.
    pub(super) fn settle_some(&mut self) -> Progress {
        self.iteration += u64::from(!self.part.is_under_way());
        for _ in self.part.take(PORTION, self.task.expand) {
            let progress = self.settle();
            if progress != Progress::Continue {
                self.part = Part::default();
                return progress;
            }
        }
        if self.part.is_under_way() {
            return Progress::Partly;
        }
        self.drop_settled();
        self.lowest = self.open.first().map(|(f, _)| f);
        if self.lowest.is_some() { Progress::Continue } else { Progress::Done(Status::Infeasible) }
    }

    /// Settles the first cell of the frontier and reaches its neighbours from it.
    fn settle(&mut self) -> Progress {
        let (f, at, cell, link) = loop {
            let Some((f, at)) = self.open.pop() else {
                self.lowest = None;
                return Progress::Done(Status::Infeasible);
            };
            let cell = self.task.cell(at);
            let link = self.links[cell];
            // A cell is put in again when a shorter way to it is found.
            if !link.is_closed() {
                break (f, at, cell, link);
            }
        };
        self.links[cell] = link.closed();
        self.expanded += 1;
        self.frontier -= 1;
        if cell == self.task.endpoints.goal {
            self.lowest = Some(f);
            self.found = Some(Arc::new(Found::new(&self.task, &self.way(cell), self.iteration)));
            return Progress::Done(Status::Solved);
        }
        self.expand(cell, link, apart(at));
        Progress::Continue
    }

    /// Takes out of the queue what is settled already, so that the first one is the next.
    fn drop_settled(&mut self) {
        while self.open.first().is_some_and(|(_, at)| self.links[self.task.cell(at)].is_closed()) {
            self.open.pop();
        }
    }

    /// Reaches the neighbours of a cell that are not settled, where the way over this cell is the shortest so far.
    #[inline]
    fn expand(&mut self, cell: usize, link: Link, [column, row]: [i32; 2]) {
        let Self { task, ways, links, open, frontier, .. } = self;
        // What the loop needs, out of the shared memory that the compiler must expect to change.
        let (cells, guess, relaxation) = (&*task.cells, task.guess, task.rules.relaxation);
        let (ways, links, table) = (&mut ways[..], &mut links[..], &task.table[..]);
        let g_cell = length(ways[cell]);
        let mut moves = task.moves(cell, link);
        while moves != 0 {
            let d = moves.trailing_zeros() as usize;
            moves &= moves - 1;
            let to = cells.next(cell, d);
            let child = match relaxation {
                Relaxation::Step => Some((cell, g_cell + if d & 1 == 0 { STRAIGHT } else { DIAGONAL })).filter(|&(_, g)| way(g) > ways[to]),
                Relaxation::Sight => task.by_sight(ways, [cell, link.parent(), to]),
            };
            let Some((parent, g)) = child else { continue };
            if links[to].is_closed() {
                continue;
            }
            *frontier += u64::from(ways[to] == 0);
            (ways[to], links[to]) = (way(g), Link::new(parent, d));
            let next = [column + DIRECTIONS[d][0], row + DIRECTIONS[d][1]];
            open.push(g + guess.look_up(next, to, table), (next[1] << 16 | next[0]) as Place);
        }
    }

    /// The cells from the start to a cell that was reached, each the child of the one before.
    pub(super) fn way(&self, to: usize) -> Vec<usize> {
        let mut way: Vec<_> = std::iter::successors(Some(to), |&cell| self.parent(cell)).collect();
        way.reverse();
        way
    }

    /// Whose child a cell is; `None` for the start.
    pub(super) fn parent(&self, cell: usize) -> Option<usize> {
        Some(self.links[cell].parent()).filter(|&parent| parent != cell)
    }

    /// The best way known to a cell; `None` before it is reached.
    pub(super) fn reached(&self, cell: usize) -> Option<f64> {
        Some(self.ways[cell]).filter(|&way| way != 0).map(length)
    }

    /// Whether a cell is settled.
    pub(super) fn is_closed(&self, cell: usize) -> bool {
        self.links[cell].is_closed()
    }
}

impl Task {
    /// The number of a place's cell.
    #[inline]
    fn cell(&self, at: Place) -> usize {
        let [column, row] = apart(at);
        row as usize * self.cells.columns + column as usize
    }

    /// The steps from a cell that may lead to something new.
    #[inline]
    fn moves(&self, cell: usize, link: Link) -> u8 {
        let moves = self.cells.moves(cell);
        match self.rules.relaxation {
            Relaxation::Step if link.parent() != cell => moves & onward(self.cells.moves(link.parent()), link.direction()),
            _ => moves,
        }
    }

    /// Whether the robot can go straight between the centres of two free cells.
    fn sees(&self, from: usize, to: usize) -> bool {
        let cells = &self.cells;
        if self.wide { self.grid.field().is_free(cells.centre(from), cells.centre(to)) } else { walk(cells, self.cutting, from, to) }
    }

    /// Whose child a cell becomes that is reached from its neighbour, the child of `over`, and how long the way is, if that
    /// is shorter than the best known: path 2 of Nash et al. 2007 where the parent sees the cell, otherwise path 1, which is never shorter.
    #[inline(never)]
    fn by_sight(&self, ways: &[u64], [cell, over, to]: [usize; 3]) -> Option<(usize, f64)> {
        let from = |cell: usize| (cell, length(ways[cell]) + self.between(cell, to));
        let shorter = |&(_, g): &(usize, f64)| way(g) > ways[to];
        Some(from(over)).filter(|path| shorter(path) && self.sees(over, to)).or_else(|| Some(from(cell)).filter(shorter))
    }
}
