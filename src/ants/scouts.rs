//! Ants that are sent round something on pheromone that a colony has laid, [WOLF-ANT](crate#papers) §5.3.

use std::{sync::Arc, task::Poll};

use crate::{
    exact,
    geometry::Endpoints,
    kernel::{Frame, Part, Planner, Progress, State, rng::Stream},
};

use super::{
    colony::{Colony, PORTION},
    draw,
    ground::Ground,
    update::Update,
    walk::Walks,
};

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
    /// iteration, [`SORTIES`] times, on a copy of the pheromone as it lies. `None` if no way leads there.
    pub(crate) fn scouts(&self, occupied: &[bool], from: usize, to: usize, rng: &Stream) -> Option<Scouts> {
        let cells = Arc::new(self.ground.cells.without(occupied));
        if !exact::is_reachable(&cells, from, to) {
            return None;
        }
        let ends = [from, to].map(|cell| cells.centre(cell));
        let endpoints = Endpoints { start: from, goal: to, ends, stubs: 0.0 };
        let ground = Ground { endpoints, cells, grid: Arc::clone(&self.ground.grid), ..*self.ground };
        let pheromone = self.pheromone.seen_from(&ground);
        let (walks, best) = (Walks::default(), None);
        let colony =
            Self { ground: Arc::new(ground), pheromone, walks, best, iteration: 0, limit: SORTIES, rng: rng.clone(), ..self.clone() };
        Some(Scouts { colony, left: SORTIES })
    }

    /// Whether scouts may take more steps than are a part of an iteration: in the open a way takes no more than there are columns and
    /// rows.
    pub(crate) fn sends_many(&self) -> bool {
        let cells = &self.ground.cells;
        let steps = self.ants * (cells.columns + cells.rows);
        SORTIES as usize * steps > Part::at_most(PORTION)
    }
}

/// Ants on their way round something.
#[derive(Clone, State)]
pub(crate) struct Scouts {
    colony: Colony,
    left: u64,
}

impl Scouts {
    /// Goes on with an iteration, or a part of one: the shortest of their ways when all are back, `None` if none has arrived.
    pub(crate) fn go_on(&mut self) -> Poll<Option<Vec<usize>>> {
        if self.colony.iterate() != Progress::Partly {
            self.left -= 1;
        }
        if self.left > 0 { Poll::Pending } else { Poll::Ready(self.colony.path()) }
    }

    /// How many set out.
    pub(crate) fn sent(&self) -> u64 {
        self.colony.evaluations()
    }

    /// The stream of random numbers as they left it.
    pub(crate) fn rng(&self) -> Stream {
        self.colony.rng.clone()
    }
}
