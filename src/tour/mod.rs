//! Tours through many stops, [ANTBAT](crate#papers) §3.2 and §3.3: a road network first, then an order of the stops.
//!
//! There is one run of two stages, `Tours`. On a grid the first stage has other planners build the road between each
//! two stops (`roads`); scenes of kind `tour` have their distances already. The second searches the order: what its
//! planners differ in is a `Search`, a file each. `problem` is what they search, `moves` are the changes that they make.

pub mod bat;
mod explain;
pub mod ga;
pub mod held_karp;
pub mod hybrid_bat;
mod kicks;
mod local;
mod moves;
mod nearest;
mod parameters;
mod problem;
mod roads;
pub mod sa;
mod swaps;
#[cfg(test)]
mod tests;
pub mod tour_pso;
pub mod two_opt;

use std::sync::Arc;

use crate::{
    describe::{Reading, Start, layers},
    exact::{MAX_EXACT_STOPS, shortest_tour},
    kernel::{
        Candidate, Error, Explain, Facets, Failure, Frame, Inspection, Item, LayerKey, Members, Planner, Progress, Readings,
        ReferenceOptimum, Shape, Solution, Stage, Started, State, Status, Subtasks, TourEnds, rng::Stream,
    },
    params::Parameters,
    scene::{GridScene, TourScene},
    settled::{SETTLED, Settled},
};

use parameters::{BEST, BUILT, BY_ROAD, DIFFERENT, FAILED, FOUND, ITERATIONS, MEAN, ROADS, SMOOTH};
use problem::{Problem, Stop, Tour};
use roads::Network;

/// How a planner searches the order of the stops. It evaluates its first tours when it begins.
trait Search: State + Send {
    /// Takes one step.
    fn step(&mut self);
    /// Whether it has something left to do.
    fn progress(&self) -> Progress {
        Progress::Continue
    }
    /// How many tours it has evaluated.
    fn evaluations(&self) -> u64;
    /// The shortest tour so far.
    fn best(&self) -> Option<&Tour>;
    /// How many search side by side.
    fn members(&self) -> usize {
        0
    }
    /// The tour of one of them.
    fn member(&self, _i: usize) -> Option<&Tour> {
        None
    }
    /// Adds numbers of its own to the readings.
    fn read(&self, _out: &mut Readings) {}
    /// Adds a member's numbers, those of the entry's `members` in their order.
    fn tell_member(&self, _i: usize, _out: &mut Vec<f64>) {}
    /// What a member did in the last step: completes what is told of every tour (its title, its order beside the best).
    fn explain(&self, _i: usize, _told: &mut Inspection) {}
    /// The same once more.
    fn copy(&self) -> Box<dyn Search>;
}

impl Clone for Box<dyn Search> {
    fn clone(&self) -> Self {
        self.copy()
    }
}

/// How a search begins: the problem, the parameters, and its stream of random numbers.
type Begin = fn(&Arc<Problem>, &Parameters, Stream) -> Box<dyn Search>;

/// Roads, then a tour.
#[derive(Clone, State)]
struct Tours {
    #[state(shared)]
    settings: Arc<Parameters>,
    #[state(shared)]
    seed: u64,
    /// What the search adds to the readings, of its members and of its own, in this order: unknown while roads are built.
    #[state(shared)]
    tells: &'static [Reading],
    #[state(shared)]
    begin: Begin,
    #[state(shared)]
    round: TourEnds,
    /// Where the stops are drawn.
    #[state(shared)]
    places: Arc<[[f64; 2]]>,
    network: Option<Network>,
    search: Option<(Arc<Problem>, Box<dyn Search>)>,
    /// The length of the shortest tour by these very roads, while it can be computed.
    by_road: f64,
    /// No tour is possible: a road is missing, whatever stops it would lead over.
    torn: bool,
    iteration: u64,
    /// The search's iteration in which its best was found.
    converged: u64,
    settled: Settled,
}

/// Starts a tour planner, which adds these readings to those of every tour.
fn start(start: &Start, tells: &'static [Reading], begin: Begin) -> Result<Started, Error> {
    let &Start { scene, parameters: settings, seed, .. } = start;
    let network = match scene.get::<GridScene>() {
        Ok(grid) => Some(Network::new(start, grid)?),
        Err(_) => None,
    };
    let mut tours = Tours {
        settings: Arc::new(settings.clone()),
        seed,
        tells,
        begin,
        round: parameters::round(scene, settings),
        places: scene.stops().into(),
        network,
        search: None,
        by_road: f64::NAN,
        torn: false,
        iteration: 0,
        converged: 0,
        settled: Settled::default(),
    };
    if let Ok(tour) = scene.get::<TourScene>() {
        tours.set_out(Problem::new(tour.distances(), tours.round));
    }
    let (roads, round, progress) = (tours.road_steps(), tours.round, tours.progress());
    let reference = match &tours.network {
        None => ReferenceOptimum::Matrix,
        Some(_) if settings[SMOOTH] || settings[ROADS] == "theta-star" => ReferenceOptimum::AnyAngle,
        Some(_) => ReferenceOptimum::Cells,
    };
    let search = Stage { name: "tour", title: "Tour", end: None };
    let stages = match roads {
        0 => vec![search],
        end => vec![Stage { name: "roads", title: "Roads", end: Some(end) }, search],
    };
    let started = Started::new(tours, settings[ITERATIONS] + roads).measured_by(reference).in_stages(stages);
    Ok(Started { progress, round: Some(round), ..started })
}

impl Tours {
    /// The roads stand: the search begins.
    fn set_out(&mut self, problem: Problem) {
        let problem = Arc::new(problem);
        let search = (self.begin)(&problem, &self.settings, Stream::new(self.seed, 0));
        self.search = Some((problem, search));
    }

    /// How many steps go into roads.
    fn road_steps(&self) -> u64 {
        self.network.as_ref().map_or(0, Network::steps)
    }

    fn progress(&self) -> Progress {
        match &self.search {
            _ if self.torn => Progress::Done(Status::Infeasible),
            Some((_, search)) => search.progress(),
            None => Progress::Continue,
        }
    }

    fn build(&mut self) {
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

    /// The way of a tour, by road if there are any, else straight.
    fn path(&self, problem: &Problem, tour: &Tour) -> Vec<[f64; 2]> {
        let stops: Vec<Stop> = tour.row.iter().copied().filter(|&stop| usize::from(stop) < problem.n).collect();
        let Some(network) = &self.network else {
            return stops.iter().map(|&stop| self.places[usize::from(stop)]).collect();
        };
        let mut path = vec![self.places[usize::from(stops[0])]];
        for leg in stops.windows(2) {
            let way = network.way(usize::from(leg[0]), usize::from(leg[1]));
            path.extend_from_slice(way.get(1..).unwrap_or_default());
        }
        path
    }

    fn best_tour(&self) -> Option<(&Problem, &Tour)> {
        let (problem, search) = self.search.as_ref()?;
        Some((problem, search.best()?))
    }
}

impl Planner for Tours {
    fn advance(&mut self) -> Progress {
        self.iteration += 1;
        let roads = self.road_steps();
        match &mut self.search {
            None => self.build(),
            Some((_, search)) => {
                let before = search.best().map(|tour| tour.length);
                search.step();
                if search.best().is_some_and(|now| before.is_none_or(|before| now.length < before)) {
                    self.converged = self.iteration - roads;
                }
                if search.members() > 0 {
                    // One alone always agrees with itself: it is held against the best so far.
                    let so_far = search.best().filter(|_| search.members() == 1).map_or(f64::INFINITY, |best| best.length);
                    let best = lengths(&**search).fold(so_far, f64::min);
                    self.settled.note(self.iteration - roads, mean(&**search), best);
                }
            }
        }
        self.progress()
    }

    fn evaluations(&self) -> u64 {
        self.search.as_ref().map_or(0, |(_, search)| search.evaluations())
    }

    fn best(&self) -> Option<Candidate> {
        let (problem, tour) = self.best_tour()?;
        let solution = Solution::Tour { order: tour.order(problem), round: self.round, path: self.path(problem, tour) };
        Some(Candidate { cost: tour.length, solution })
    }

    fn facets(&self) -> Facets<'_> {
        Facets::default().explain(self).members(self).failure(self)
    }

    fn subtasks(&mut self) -> Option<&mut dyn Subtasks> {
        self.network.as_mut().filter(|network| !network.is_built()).map(|network| network as &mut dyn Subtasks)
    }

    fn read(&self, out: &mut Readings) {
        let best = self.best_tour();
        out.push(BEST, best.map_or(f64::NAN, |(_, tour)| tour.length));
        if let Some(network) = &self.network {
            out.push(BUILT, network.roads.len() as f64);
            out.push(FAILED, network.failed() as f64);
            if network.stops.len() <= MAX_EXACT_STOPS {
                out.push(BY_ROAD, self.by_road);
            }
        }
        out.push(FOUND, if best.is_some() { self.converged as f64 } else { f64::NAN });
        if let Some((problem, search)) = &self.search {
            let members = (0..search.members()).filter_map(|i| search.member(i));
            if let (Some((_, best)), 1..) = (best, search.members()) {
                let different: usize = members.map(|tour| moves::hamming(problem, &tour.row, &best.row)).sum();
                out.push(MEAN, mean(&**search));
                out.push(DIFFERENT, different as f64 / search.members() as f64);
                out.push(SETTLED, self.settled.iteration());
            }
            search.read(out);
        } else {
            self.tells.iter().for_each(|&reading| out.push(reading, f64::NAN));
        }
    }

    fn draw(&self, frame: &mut Frame) {
        if let Some(network) = &self.network {
            let longest = network.roads.iter().map(|road| road.path.len()).max().unwrap_or(0);
            let every = frame.thin_context(network.roads.len(), longest, true);
            for (number, road) in network.roads.iter().enumerate().step_by(every) {
                // One that was not found is a dot at its first stop, so that the others keep their numbers.
                let nowhere = [self.places[network.pair(number)[0]]; 2];
                line(frame, layers::ROADS.key, if road.path.len() > 1 { &road.path } else { &nowhere }, road.length);
            }
        }
        let mut places = vec![-1.0; self.places.len()];
        if let Some((problem, search)) = &self.search {
            let members = search.members();
            let corners = self.network.as_ref().map_or(1, |network| network.roads.iter().map(|road| road.path.len()).max().unwrap_or(1));
            let every = frame.thin_context(members, corners * (self.places.len() + 1), true);
            for tour in (0..members).step_by(every).filter_map(|i| search.member(i)) {
                line(frame, layers::TOURS.key, &self.path(problem, tour), tour.length);
            }
            if let Some(best) = search.best() {
                line(frame, layers::TOUR.key, &self.path(problem, best), best.length);
                best.order(problem).iter().enumerate().for_each(|(place, &stop)| places[stop] = place as f64);
            }
        }
        frame.begin(layers::STOPS.key, Shape::Points);
        self.places.iter().zip(places).for_each(|(&stop, place)| frame.push(stop, place));
    }
}

impl Explain for Tours {
    fn inspect(&self, item: Item) -> Option<Inspection> {
        match (item.layer, &self.search) {
            (layer, _) if layer == layers::ROADS.key => explain::road(self.network.as_ref()?, item),
            (layer, _) if layer == layers::STOPS.key => explain::stop(self.best_tour(), &self.places, item),
            (layer, Some((problem, search))) if layer == layers::TOURS.key => {
                let tour = search.member(item.index)?;
                let mut told = explain::tour(problem, tour, search.best()?, &self.places, item);
                told.marks.insert(0, explain::way(self.path(problem, tour)));
                search.explain(item.index, &mut told);
                Some(told)
            }
            (layer, None) if layer == layers::TOURS.key => Some(explain::no_tour(item)),
            _ => None,
        }
    }
}

impl Members for Tours {
    fn members(&self, out: &mut Vec<f64>) {
        if let Some((_, search)) = &self.search {
            (0..search.members()).for_each(|i| search.tell_member(i, out));
        }
    }
}

impl Failure for Tours {
    fn failure(&self, _status: Status) -> Option<String> {
        self.network.as_ref().filter(|_| self.torn).and_then(Network::failure)
    }
}

/// The mean length of the tours of those that search side by side.
fn mean(search: &dyn Search) -> f64 {
    lengths(search).sum::<f64>() / search.members() as f64
}

fn lengths(search: &dyn Search) -> impl Iterator<Item = f64> {
    (0..search.members()).filter_map(|i| search.member(i)).map(|tour| tour.length)
}

fn line(frame: &mut Frame, layer: LayerKey, path: &[[f64; 2]], weight: f64) {
    frame.begin(layer, Shape::Polyline);
    path.iter().for_each(|&point| frame.push(point, weight));
}
