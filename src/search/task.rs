//! What does not change while a search runs.

use std::sync::Arc;

use crate::{
    describe::Start,
    geometry::{Cells, Endpoints},
    kernel::Error,
    scene::GridScene,
    scene::grid_path::SMOOTH,
};

use super::{
    open::{apart, place},
    parameters::{EXPAND, ITERATIONS},
    rules::{DIAGONAL, Guess, Relaxation, Rules, STRAIGHT, line},
};

/// Steps that a run takes at most if the number of cells a step is automatic.
const STEPS: usize = 1024;

/// What does not change while a search runs.
#[derive(Clone)]
pub(super) struct Task {
    pub(super) cells: Arc<Cells>,
    /// What is in the way. It is made when somebody looks farther than to the next cell.
    pub(super) grid: Arc<GridScene>,
    pub(super) endpoints: Endpoints,
    pub(super) rules: Rules,
    pub(super) guess: Guess,
    /// What it says of each cell, if it is an own one.
    pub(super) table: Vec<f64>,
    /// Hand over the smoothed path.
    pub(super) smooth: bool,
    pub(super) cutting: bool,
    /// The robot has a size.
    pub(super) wide: bool,
    /// Cells settled a step.
    pub(super) expand: usize,
    pub(super) limit: u64,
}

impl Task {
    pub(super) fn new(start: &Start, rules: Rules, weight: f64) -> Result<Self, Error> {
        let &Start { scene, parameters: settings, .. } = start;
        let grid = scene.share::<GridScene>()?;
        let (cells, endpoints) = (Arc::clone(grid.cells()), grid.endpoints()?);
        let at = |cell: usize| apart(place(cells.place(cell)));
        let guess = Guess { heuristic: rules.heuristic, weight, goal: at(endpoints.goal) };
        let table = guess.table(&cells);
        let expand = match settings[EXPAND] {
            0 => cells.len().div_ceil(STEPS),
            given => given as usize,
        };
        Ok(Self {
            wide: grid.radius() > 0.0,
            rules,
            guess,
            table,
            smooth: settings[SMOOTH],
            cutting: grid.corner_cutting,
            expand,
            // No cell is settled twice: what is left of a higher limit would only be room on a timeline.
            limit: settings[ITERATIONS].min(cells.len().div_ceil(expand) as u64),
            cells,
            endpoints,
            grid,
        })
    }

    /// The distance that a step or a straight line adds.
    #[inline]
    pub(super) fn between(&self, from: usize, to: usize) -> f64 {
        let ([x, y], [to_x, to_y]) = (apart(place(self.cells.place(from))), apart(place(self.cells.place(to))));
        let by = [to_x - x, to_y - y];
        match self.rules.relaxation {
            Relaxation::Step => [STRAIGHT, DIAGONAL][usize::from(by[0] != 0 && by[1] != 0)],
            Relaxation::Sight => line(by),
        }
    }

    /// A length in the scene's unit.
    pub(super) fn length(&self, units: f64) -> f64 {
        units / STRAIGHT * self.cells.side
    }
}
