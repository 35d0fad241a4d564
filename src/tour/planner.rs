//! A tour by the stepped contract, and how it starts.

use std::sync::Arc;

use crate::{
    describe::{Reading, Start, layers},
    exact::MAX_EXACT_STOPS,
    kernel::{
        Candidate, Error, Explain, Facets, Failure, Frame, Inspection, Item, Label, Members, Message, Planner, Progress, Readings,
        ReferenceOptimum, Solution, Stage, Started, Status, Subtasks, limits, rng::Stream,
    },
    label, message,
    scene::{GridScene, TourScene},
    settled::{SETTLED, Settled},
};

use super::{
    explain, moves,
    parameters::{self, BEST, BUILT, BY_ROAD, DIFFERENT, FAILED, FOUND, ITERATIONS, MEAN, POPULATION, ROADS, SMOOTH},
    problem::{Problem, Tour},
    roads::Network,
    search::{Begin, mean},
    tours::Tours,
};

/// Starts a tour planner whose search begins like this, on a grid with stops or a scene of kind `tour`. The entry lists the parameters of
/// [`TOURS`](super::TOURS) and [`ITERATIONS`], and calls at stops.
///
/// `own_readings` are those that come with the search, in this order: with members [`MEAN`], [`DIFFERENT`] and [`SETTLED`], and what the
/// search itself reads.
///
/// # Errors
/// [`Error::Refused`] for another kind of scene and for stops that cannot be reached; [`Error::Unknown`] for a planner of roads that
/// is not listed.
pub fn start(start: &Start, own_readings: &'static [Reading], begin: Begin) -> Result<Started, Error> {
    let &Start { scene, parameters: settings, seed, .. } = start;
    let network = match scene.get::<GridScene>() {
        Ok(grid) => Some(Network::new(start, grid)?),
        Err(_) => None,
    };
    let mut tours = Tours {
        settings: Arc::new(settings.clone()),
        seed,
        own_readings,
        begin,
        round: parameters::round(scene, settings),
        places: scene.stops().into(),
        network,
        search: None,
        by_road: f64::NAN,
        torn: false,
        iteration: 0,
        before: None,
        converged: 0,
        settled: Settled::default(),
    };
    if tours.network.is_none() {
        let given = scene.get::<TourScene>()?;
        if !given.can_have(tours.round) {
            return Err(parameters::refuse_round(tours.round, given));
        }
        tours.set_out(Problem::new(given.distances(), tours.round));
        // A run begins with whole tours.
        while let Some((_, search)) = tours.search.as_mut().filter(|(_, search)| search.progress() == Progress::Partly) {
            search.step();
        }
    }
    let (roads, round, progress) = (tours.road_steps(), tours.round, tours.progress());
    let reference = match &tours.network {
        None => ReferenceOptimum::Matrix,
        Some(_) if settings[SMOOTH] || settings[ROADS] == "theta-star" => ReferenceOptimum::AnyAngle,
        Some(_) => ReferenceOptimum::Cells,
    };
    let search = Stage { name: "tour", title: message!("tour-stage", "Tour"), end: None };
    let stages = match roads {
        0 => vec![search],
        end => vec![Stage { name: "roads", title: message!("tour-stage-roads", "Roads"), end: Some(end) }, search],
    };
    let started = Started::new(tours, settings[ITERATIONS] + roads).measured_by(reference).in_stages(stages);
    Ok(Started { progress, ends: Some(round), ..started })
}

/// What can be supposed of a step.
const OTHER_NUMBERS: Label = label!("tour-other-random-numbers", "random", "\\xi", "with other random numbers");

/// The bytes of a member's numbers, at the most: the same wherever it runs.
const NUMBERS: usize = 256;

/// Refuses more members than there is memory for. Each has so many tours through all stops, and some numbers.
pub(super) fn check_members(start: &Start, tours: usize) -> Result<(), Error> {
    let stops = match start.scene.get::<TourScene>() {
        Ok(scene) => scene.distances().len(),
        Err(_) => start.scene.stops().len(),
    };
    limits::check_members(POPULATION.name(), start.parameters[POPULATION], NUMBERS + tours * Tour::bytes(stops))
}

impl Tours {
    /// A step, or a part of one. Its code is there once, for runs and for what is supposed.
    #[inline(never)]
    fn go_on(&mut self) -> Progress {
        let roads = self.road_steps();
        if self.iteration < roads {
            match &mut self.search {
                None => self.build(),
                // The search’s first tours: parts of the step that built the last roads.
                Some((_, search)) => search.step(),
            }
        } else if let Some((_, search)) = &mut self.search {
            if search.progress() != Progress::Partly {
                self.before = search.best().map(|tour| tour.length);
            }
            search.step();
        }
        let progress = self.progress();
        if progress != Progress::Partly {
            self.iteration += 1;
            if self.iteration > roads {
                self.note();
            }
        }
        progress
    }
}

impl Planner for Tours {
    fn advance(&mut self) -> Progress {
        self.go_on()
    }

    fn evaluations(&self) -> u64 {
        self.search.as_ref().map_or(0, |(_, search)| search.evaluations())
    }

    fn best(&self) -> Option<Candidate> {
        let (problem, tour) = self.best_tour()?;
        let solution = Solution::Tour { order: tour.order(problem), ends: self.round, path: self.path(problem, tour) };
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
            self.own_readings.iter().for_each(|&reading| out.push(reading, f64::NAN));
        }
    }

    fn draw(&self, frame: &mut Frame) {
        self.draw_layers(frame);
    }
}

impl Explain for Tours {
    fn inspect(&self, item: Item) -> Option<Inspection> {
        match (item.layer, &self.search) {
            (layer, _) if layer == layers::ROADS.key => explain::road(self.network.as_ref()?, item),
            (layer, _) if layer == layers::STOPS.key => explain::stop(self.best_tour(), &self.places, item),
            (layer, Some((problem, search))) if layer == layers::TOURS.key => {
                let tour = search.member(item.index)?;
                let mut inspection = explain::tour(problem, tour, search.best()?, &self.places, item);
                inspection.marks.insert(0, explain::way(self.path(problem, tour)));
                search.explain(item.index, &mut inspection);
                if self.iteration > self.road_steps() && search.clone().rng().is_some() {
                    inspection.suppositions = search.suppositions(item.index);
                    inspection.suppositions.push(OTHER_NUMBERS);
                }
                Some(inspection)
            }
            (layer, None) if layer == layers::TOURS.key => Some(explain::no_tour(item)),
            _ => None,
        }
    }

    fn suppose(&self, item: Item, supposition: &str, others: &Stream) -> Option<Inspection> {
        let mut next = self.clone();
        let search = &mut next.search.as_mut()?.1;
        if supposition == OTHER_NUMBERS.name {
            search.rng()?.clone_from(others);
        } else {
            search.suppose(item.index, supposition);
        }
        while next.go_on() == Progress::Partly {}
        let mut inspection = next.inspect(item)?;
        inspection.marks.iter_mut().filter(|mark| mark.layer == layers::WAY.key).for_each(|mark| mark.layer = layers::AFTER.key);
        Some(inspection)
    }
}

impl Members for Tours {
    fn members(&self, out: &mut Vec<f64>) {
        if let Some((_, search)) = &self.search {
            (0..search.members()).for_each(|i| search.read_member(i, out));
        }
    }
}

impl Failure for Tours {
    fn failure(&self, _status: Status) -> Option<Message> {
        self.network.as_ref().filter(|_| self.torn).and_then(Network::failure)
    }
}
