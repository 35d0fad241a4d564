//! Who plans the ways: before the drive, and again when something is in the way. What the drives differ in.

use crate::{
    geometry::{Cells, Endpoints},
    kernel::{Frame, Inspection, Item, Progress, State},
};

use super::body::{Plan, Step};

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
    /// A way from one cell to another, both of the planned way, that enters no occupied cell: round what is in between.
    /// `None` from those who do not take detours.
    fn detour(&mut self, _occupied: &[bool], _from: usize, _to: usize) -> Option<Vec<usize>> {
        None
    }
    /// A new way to the goal that enters no occupied cell.
    fn replan(&mut self, occupied: &[bool], from: usize) -> Option<Vec<usize>>;
    /// Draws what lies under the drive; `driving`: the drive has begun.
    fn draw(&self, _driving: bool, _frame: &mut Frame) {}
    /// What can be said of an item of its layers.
    fn inspect(&self, _item: Item) -> Option<Inspection> {
        None
    }
    /// The same once more.
    fn copy(&self) -> Box<dyn Route>;
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
