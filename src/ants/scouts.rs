//! Ants that are sent round something on pheromone that a colony has laid, [WOLF-ANT](crate#papers) §5.3.

use std::sync::Arc;

use crate::{
    exact,
    geometry::Endpoints,
    kernel::{Frame, Planner, Progress, rng::Stream},
};

use super::{colony::Colony, draw, ground::Ground, update::Update, walk::Walks};

/// How often the ants that look for a way round set out.
const SORTIES: u64 = 10;

impl Colony {
    /// Draws the pheromone and the trails.
    pub(crate) fn draw_pheromone(&self, frame: &mut Frame) {
        draw::pheromone(&self.ground.cells, &self.pheromone, frame);
        draw::trails(&self.ground.cells, &self.pheromone, frame);
    }

    /// Whether it is [WOLF-ANT](crate#papers)'s.
    pub(crate) fn is_wolf(&self) -> bool {
        matches!(self.variant.update, Update::Wolf)
    }

    /// Goes on along the pheromone from one cell to another without entering an occupied one: as many ants as in an
    /// iteration, [`SORTIES`] times, on a copy of the pheromone as it lies. The shortest of their ways; `None` if none arrives. `sent` counts them.
    pub(crate) fn scouts(&self, occupied: &[bool], from: usize, to: usize, rng: &mut Stream, sent: &mut u64) -> Option<Vec<usize>> {
        let cells = Arc::new(self.ground.cells.without(occupied));
        if !exact::is_reachable(&cells, from, to) {
            return None;
        }
        let ends = [from, to].map(|cell| cells.centre(cell));
        let endpoints = Endpoints { start: from, goal: to, ends, stubs: 0.0 };
        let ground = Ground { endpoints, cells, grid: Arc::clone(&self.ground.grid), ..*self.ground };
        let pheromone = self.pheromone.seen_from(&ground);
        let (walks, best) = (Walks::default(), None);
        let mut colony =
            Self { ground: Arc::new(ground), pheromone, walks, best, iteration: 0, limit: SORTIES, rng: rng.clone(), ..self.clone() };
        for _ in 0..SORTIES {
            while colony.iterate() == Progress::Partly {}
        }
        *rng = colony.rng.clone();
        *sent += colony.evaluations();
        colony.path()
    }
}
