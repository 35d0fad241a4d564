//! Who plans the ways: before the drive, and again when something is in the way. What the drives differ in.

use std::task::Poll;

use crate::{
    geometry::{Cells, Endpoints},
    kernel::{Frame, Inspection, Item, Progress, State},
};

use super::{
    body::{Plan, Step},
    ground::{Ahead, Ground},
};

/// A planner of ways over cells, some of which may be occupied for the time being.
pub(super) trait Route: State + Send {
    /// How many steps it takes to plan before the drive.
    fn steps(&self) -> u64 {
        0
    }
    /// Takes one of them, or a part of one.
    fn step(&mut self) -> Progress {
        Progress::Continue
    }
    /// What it has cost so far: ants sent, and cells settled.
    fn evaluations(&self) -> u64;
    /// The cells of the way to drive, once it has taken its steps.
    fn way(&mut self) -> Option<Vec<usize>>;
    /// The length of the best way so far, in the scene's unit.
    fn shortest(&self) -> Option<f64> {
        None
    }
    /// Begins to look for a way from one cell to another, both of the planned way, that enters no occupied cell: round what is
    /// in between. False from those who do not take detours.
    fn detour(&mut self, _occupied: &[bool], _from: usize, _to: usize) -> bool {
        false
    }
    /// Begins to look for a new way to the goal that enters no occupied cell.
    fn replan(&mut self, occupied: &[bool], from: usize);
    /// Goes on with a part of that: the way if it is found, `None` if there is none.
    fn go_on(&mut self) -> Poll<Option<Vec<usize>>>;
    /// Whether to find a way may take more than a part of a step.
    fn is_long(&self) -> bool;
    /// Draws what lies under the drive; `driving`: the drive has begun.
    fn draw(&self, _driving: bool, _frame: &mut Frame) {}
    /// What can be said of an item of its layers.
    fn inspect(&self, _item: Item) -> Option<Inspection> {
        None
    }
    /// The same with one thing otherwise.
    fn suppose(&self, _item: Item, _supposition: &str) -> Option<Inspection> {
        None
    }
    /// The same once more.
    fn copy(&self) -> Box<dyn Route>;
}

/// What the robot asks for in a period. Where looking for a way takes long the period is carried out again after each, with what was
/// found so far.
pub(super) struct Ways<'a> {
    pub(super) route: &'a mut dyn Route,
    /// What was found in this period, in the order in which it is asked for, and how much of that was asked for again.
    pub(super) found: &'a mut Vec<Option<Vec<usize>>>,
    pub(super) asked: usize,
    /// What the period waits for: what comes of it until then does not count.
    pub(super) open: Option<Open>,
}

/// What takes long to find.
#[derive(Clone)]
pub(super) enum Open {
    /// A way, see [`Route::go_on`].
    Way,
    /// How far ahead of each cell the goal is.
    Ahead(Ahead),
}

impl Ways<'_> {
    /// See [`Route::detour`].
    pub(super) fn detour(&mut self, occupied: &[bool], from: usize, to: usize) -> Option<Vec<usize>> {
        self.ask(occupied, from, Some(to))
    }

    /// See [`Route::replan`].
    pub(super) fn replan(&mut self, occupied: &[bool], from: usize) -> Option<Vec<usize>> {
        self.ask(occupied, from, None)
    }

    /// Whether it is known how far ahead of each cell the goal is; otherwise the period waits for it.
    pub(super) fn knows_ahead(&mut self, ground: &Ground) -> bool {
        if self.open.is_none() && self.route.is_long() && ground.ahead.get().is_none() {
            self.open = Some(Open::Ahead(Ahead::new(ground)));
        }
        self.open.is_none()
    }

    /// A way round to a cell, or to the goal. Not inlined: it is in none of the hot loops.
    #[inline(never)]
    fn ask(&mut self, occupied: &[bool], from: usize, round_to: Option<usize>) -> Option<Vec<usize>> {
        if self.open.is_some() {
            return None;
        }
        if self.asked == self.found.len() {
            let begun = if let Some(to) = round_to {
                self.route.detour(occupied, from, to)
            } else {
                self.route.replan(occupied, from);
                true
            };
            let long = self.route.is_long();
            let found = loop {
                match begun.then(|| self.route.go_on()) {
                    None => break None,
                    Some(Poll::Ready(found)) => break found,
                    Some(Poll::Pending) if long => {
                        self.open = Some(Open::Way);
                        return None;
                    }
                    Some(Poll::Pending) => {}
                }
            };
            self.found.push(found);
        }
        self.asked += 1;
        self.found[self.asked - 1].clone()
    }
}

impl Clone for Box<dyn Route> {
    fn clone(&self) -> Self {
        self.copy()
    }
}

/// The steps of a way over cells that ends at the goal, from the middle of its first cell on (that included).
pub(super) fn steps(cells: &Cells, endpoints: &Endpoints, way: &[usize]) -> Vec<Step> {
    let mut steps: Vec<_> = way.iter().map(|&cell| Step { to: cells.centre(cell), cell, wait: 0.0 }).collect();
    if let Some(last) = steps.last().copied().filter(|last| last.cell == endpoints.goal && last.to != endpoints.ends[1]) {
        steps.push(Step { to: endpoints.ends[1], ..last });
    }
    steps
}

/// The plan of a way.
pub(super) fn plan(cells: &Cells, endpoints: &Endpoints, way: &[usize]) -> Plan {
    Plan::new(steps(cells, endpoints, way))
}
