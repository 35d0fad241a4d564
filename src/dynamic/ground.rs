//! What never changes during a drive.

use std::{
    sync::{Arc, OnceLock},
    task::Poll,
};

use crate::{
    geometry::{Cells, Endpoints},
    kernel::{Border, Error, Part},
    message,
    params::Parameters,
    scene::{GridScene, Motion, Scene},
};

use super::{
    body::Body,
    parameters::PERIOD,
    parts::{PORTION, complete},
    queue::Queue,
};

/// How often a second an obstacle may bounce to and fro: what goes faster is everywhere at once, and takes as long to follow.
pub(super) const BOUNCES: f64 = 100.0;

/// What never changes during a drive.
pub(super) struct Ground {
    pub(super) scene: Arc<Scene>,
    pub(super) grid: Arc<GridScene>,
    pub(super) cells: Arc<Cells>,
    pub(super) endpoints: Endpoints,
    pub(super) body: Body,
    /// Seconds a step.
    pub(super) period: f64,
    /// Seconds from each cell to the goal without turns; made when it is first needed.
    pub(super) ahead: OnceLock<Vec<f64>>,
}

impl Ground {
    pub(super) fn new(scene: &Arc<Scene>, settings: &Parameters) -> Result<Self, Error> {
        let grid = scene.share::<GridScene>()?;
        let body = Body::new(&grid, settings)?;
        if body.border == Border::Bounce {
            check_bounces(&grid)?;
        }
        Ok(Self {
            cells: Arc::clone(grid.cells()),
            endpoints: grid.endpoints()?,
            body,
            period: settings[PERIOD],
            ahead: OnceLock::new(),
            scene: Arc::clone(scene),
            grid,
        })
    }

    /// Whether a search over all cells may take more than a part of a step.
    pub(super) fn is_large(&self) -> bool {
        self.cells.len() > Part::at_most(PORTION)
    }

    /// Seconds from a cell to the goal without turns; infinite where no way leads.
    pub(super) fn ahead(&self, cell: usize) -> f64 {
        let all = || {
            let mut search = Ahead::new(self);
            complete(|| search.go_on(self))
        };
        self.ahead.get_or_init(all)[cell]
    }
}

/// Dijkstra's search from the goal for the seconds from all cells to it.
#[derive(Clone)]
pub(super) struct Ahead {
    /// In cells' sides.
    best: Vec<f64>,
    open: Queue,
}

impl Ahead {
    pub(super) fn new(ground: &Ground) -> Self {
        let goal = ground.endpoints.goal;
        let mut best = vec![f64::INFINITY; ground.cells.len()];
        best[goal] = 0.0;
        let mut open = Queue::new(best.len());
        open.put(goal, [0; 2]);
        Self { best, open }
    }

    /// Goes on with a part of the search.
    pub(super) fn go_on(&mut self, ground: &Ground) -> Poll<Vec<f64>> {
        let cells = &ground.cells;
        for _ in 0..Part::at_most(PORTION) {
            let Some(at) = self.open.pop() else {
                let mut seconds = std::mem::take(&mut self.best);
                seconds.iter_mut().for_each(|length| *length *= cells.side / ground.body.speed);
                return Poll::Ready(seconds);
            };
            for d in (0..8).filter(|d| cells.moves(at) >> d & 1 != 0) {
                let (next, to) = (cells.next(at, d), self.best[at] + if d & 1 == 0 { 1.0 } else { std::f64::consts::SQRT_2 });
                if to < self.best[next] {
                    self.best[next] = to;
                    // Numbers from 0 on are ordered as their bits are.
                    self.open.put(next, [to.to_bits(), 0]);
                }
            }
        }
        Poll::Pending
    }
}

/// Refuses obstacles that would bounce too often.
pub(super) fn check_bounces(grid: &GridScene) -> Result<(), Error> {
    for (i, disc) in grid.moving.iter().enumerate() {
        let Motion::Velocity(velocity) = disc.motion else { continue };
        for (axis, speed) in velocity.into_iter().enumerate() {
            let room = grid.bounds().max[axis] - 2.0 * disc.radius;
            if room > 0.0 && speed.abs() > BOUNCES * room {
                let allowed = message!(
                    "drive-bounces",
                    "at most {most} a second where obstacles bounce: {times} times to and fro",
                    most = BOUNCES * room,
                    times = BOUNCES
                );
                return Err(Error::refused(format!("moving[{i}].velocity[{axis}]"), speed, allowed));
            }
        }
    }
    Ok(())
}
