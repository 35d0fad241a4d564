//! A tour under way: roads first, then the search.

use std::sync::Arc;

use crate::{
    describe::Reading,
    exact::shortest_tour,
    kernel::{Progress, State, Status, TourEnds, rng::Stream},
    params::Parameters,
    settled::Settled,
};

use super::{
    problem::{Problem, Stop, Tour},
    roads::Network,
    search::{Begin, Search, lengths, mean},
};

/// Roads, then a tour.
#[derive(Clone, State)]
pub(super) struct Tours {
    #[state(shared)]
    pub(super) settings: Arc<Parameters>,
    #[state(shared)]
    pub(super) seed: u64,
    /// The readings that come with the search: no numbers while roads are built.
    #[state(shared)]
    pub(super) own_readings: &'static [Reading],
    #[state(shared)]
    pub(super) begin: Begin,
    #[state(shared)]
    pub(super) round: TourEnds,
    /// Where the stops are drawn.
    #[state(shared)]
    pub(super) places: Arc<[[f64; 2]]>,
    pub(super) network: Option<Network>,
    pub(super) search: Option<(Arc<Problem>, Box<dyn Search>)>,
    /// The length of the shortest tour by these very roads, while it can be computed.
    pub(super) by_road: f64,
    /// No tour is possible: a road is missing, whatever stops it would lead over.
    pub(super) torn: bool,
    pub(super) iteration: u64,
    /// The length of the search's best before the step that is under way.
    #[state(skip)]
    pub(super) before: Option<f64>,
    /// The search's iteration in which its best was found.
    pub(super) converged: u64,
    pub(super) settled: Settled,
}

impl Tours {
    /// The roads stand: the search begins.
    pub(super) fn set_out(&mut self, problem: Problem) {
        let problem = Arc::new(problem);
        let search = (self.begin)(&problem, &self.settings, Stream::new(self.seed, 0));
        self.search = Some((problem, search));
    }

    /// How many steps go into roads.
    pub(super) fn road_steps(&self) -> u64 {
        self.network.as_ref().map_or(0, Network::steps)
    }

    pub(super) fn progress(&self) -> Progress {
        match &self.search {
            _ if self.torn => Progress::Done(Status::Infeasible),
            Some((_, search)) => search.progress(),
            None => Progress::Continue,
        }
    }

    pub(super) fn build(&mut self) {
        let Some(network) = &mut self.network else {
            return;
        };
        network.step();
        if network.is_built() {
            match network.distances() {
                Some(distances) => {
                    self.by_road = shortest_tour(&distances, self.round).map_or(f64::NAN, |(_, length)| length);
                    self.set_out(Problem::new(&distances, self.round));
                }
                None => self.torn = true,
            }
        }
    }

    /// Notes what the search's step, which is over, came to.
    pub(super) fn note(&mut self) {
        let Some((_, search)) = &self.search else {
            return;
        };
        let step = self.iteration - self.network.as_ref().map_or(0, Network::steps);
        if search.best().is_some_and(|now| self.before.is_none_or(|before| now.length < before)) {
            self.converged = step;
        }
        if search.members() > 0 {
            // One alone always agrees with itself: it is held against the best so far.
            let so_far = search.best().filter(|_| search.members() == 1).map_or(f64::INFINITY, |best| best.length);
            let best = lengths(&**search).fold(so_far, f64::min);
            self.settled.note(step, mean(&**search), best);
        }
    }

    /// The way of a tour, by road if there are any, else straight.
    pub(super) fn path(&self, problem: &Problem, tour: &Tour) -> Vec<[f64; 2]> {
        let stops: Vec<Stop> = tour.row.iter().copied().filter(|&stop| (stop as usize) < problem.n).collect();
        let Some(network) = &self.network else {
            return stops.iter().map(|&stop| self.places[stop as usize]).collect();
        };
        let mut path = vec![self.places[stops[0] as usize]];
        for leg in stops.windows(2) {
            let way = network.way(leg[0] as usize, leg[1] as usize);
            path.extend_from_slice(way.get(1..).unwrap_or_default());
        }
        path
    }

    pub(super) fn best_tour(&self) -> Option<(&Problem, &Tour)> {
        let (problem, search) = self.search.as_ref()?;
        Some((problem, search.best()?))
    }
}
