//! What never changes during a drive.

use std::{
    cmp::Reverse,
    collections::BinaryHeap,
    sync::{Arc, OnceLock},
};

use crate::{
    geometry::{Cells, Endpoints},
    kernel::{Border, Error},
    math::Length,
    message,
    params::Parameters,
    scene::{GridScene, Motion, Scene},
};

use super::{body::Body, parameters::PERIOD};

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

    /// Seconds from a cell to the goal without turns, by Dijkstra's search from the goal; infinite where no way leads.
    pub(super) fn ahead(&self, cell: usize) -> f64 {
        let all = || {
            let cells = &self.cells;
            let mut best = vec![f64::INFINITY; cells.len()];
            let mut open = BinaryHeap::from([(Reverse(Length(0.0)), self.endpoints.goal)]);
            best[self.endpoints.goal] = 0.0;
            while let Some((Reverse(Length(length)), at)) = open.pop() {
                if length > best[at] {
                    continue;
                }
                for d in (0..8).filter(|d| cells.moves(at) >> d & 1 != 0) {
                    let (next, to) = (cells.next(at, d), length + if d & 1 == 0 { 1.0 } else { std::f64::consts::SQRT_2 });
                    if to < best[next] {
                        best[next] = to;
                        open.push((Reverse(Length(to)), next));
                    }
                }
            }
            best.iter_mut().for_each(|length| *length *= cells.side / self.body.speed);
            best
        };
        self.ahead.get_or_init(all)[cell]
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
