//! The road network, [ANTBAT](crate#papers) §3.2: a way for each pair of stops, found by a run of another planner: by its
//! preset [`ROAD`] where it has one, otherwise with its defaults.

use std::sync::Arc;

use crate::{
    describe::{ROAD, Start},
    exact::{Distances, is_reachable},
    geometry,
    kernel::{Error, Message, State, Subtask, SubtaskResult, Subtasks, digits::coordinates, rng::Stream},
    message,
    params::{Overrides, Value},
    scene::GridScene,
};

use super::parameters::{ROADS, SMOOTH};

/// A way from one stop to a later one.
#[derive(Debug, Clone, PartialEq, State)]
pub struct Road {
    /// Its corners, in the scene's unit; empty if the run found none.
    pub path: Vec<[f64; 2]>,
    /// Infinite if the run found none.
    pub length: f64,
    /// The iteration in which the run found it.
    pub converged: f64,
    /// The stops that it leads over: none, unless the run found no way and other roads serve instead.
    pub over: Vec<usize>,
}

impl Road {
    /// Whether the run found it.
    pub fn is_found(&self) -> bool {
        !self.path.is_empty() && self.over.is_empty()
    }
}

impl From<SubtaskResult> for Road {
    fn from(found: SubtaskResult) -> Self {
        let length = if found.cost.is_some() { geometry::length(&found.path) } else { f64::INFINITY };
        Self { path: found.path, length, converged: found.converged, over: Vec::new() }
    }
}

/// Who builds the roads of a scene, and those that are built. A step builds one stop's roads to all later stops.
#[derive(Debug, Clone, State)]
pub struct Network {
    #[state(shared)]
    pub stops: Vec<[f64; 2]>,
    #[state(shared)]
    planner: &'static str,
    #[state(shared)]
    params: Overrides,
    /// A seed for each pair.
    #[state(shared)]
    pub seeds: Arc<[u64]>,
    /// What drew them.
    rng: Stream,
    /// Those that are built, pair by pair.
    pub roads: Vec<Arc<Road>>,
    /// What the runs of the next step found.
    #[state(skip)]
    provided: Vec<SubtaskResult>,
}

impl Network {
    /// The network of a grid's stops, nothing built.
    ///
    /// # Errors
    /// As [`Start::planner`]; [`Error::Refused`] for a stop that the others cannot be reached from, by its name.
    pub fn new(start: &Start, grid: &GridScene) -> Result<Self, Error> {
        let entry = start.planner(ROADS)?;
        let stops = grid.stops.clone();
        for (i, &stop) in (1..).zip(&stops[1..]) {
            let name = format!("stops[{i}]");
            let endpoints = grid.endpoints_between(["stops[0]", &name], [stops[0], stop])?;
            if !is_reachable(grid.cells(), endpoints.start, endpoints.goal) {
                let allowed = message!("tour-stop-apart", "where it can be reached from stops[0]: there is no way between them");
                return Err(Error::refused(name, coordinates(&stop), allowed));
            }
        }
        let mut rng = Stream::new(start.seed, 1);
        let n = stops.len();
        let sized = entry.presets.iter().find(|preset| preset.name == ROAD).map(|preset| entry.preset(preset.name, start.scene.kind()));
        let mut params = sized.transpose()?.unwrap_or_default();
        params.insert(SMOOTH.name(), Value::Flag(start.parameters[SMOOTH]));
        Ok(Self {
            planner: entry.name,
            params,
            seeds: (0..n * (n - 1) / 2).map(|_| rng.below(1 << 31) as u64).collect(),
            rng,
            roads: Vec::new(),
            provided: Vec::new(),
            stops,
        })
    }

    /// How many steps it takes to build all.
    pub fn steps(&self) -> u64 {
        self.stops.len() as u64 - 1
    }

    /// How many pairs of stops there are.
    pub fn pairs(&self) -> usize {
        self.seeds.len()
    }

    /// The stops of a pair, by its number.
    pub fn pair(&self, number: usize) -> [usize; 2] {
        let n = self.stops.len();
        let mut first = 0;
        let mut left = number;
        while left >= n - 1 - first {
            left -= n - 1 - first;
            first += 1;
        }
        [first, first + 1 + left]
    }

    /// The number of a pair.
    fn number(&self, i: usize, j: usize) -> usize {
        let (i, j) = (i.min(j), i.max(j));
        i * (2 * self.stops.len() - i - 1) / 2 + j - i - 1
    }

    fn job(&self, number: usize) -> Subtask {
        let ends = self.pair(number).map(|stop| self.stops[stop]);
        Subtask { planner: self.planner, params: self.params.clone(), seed: self.seeds[number], ends: Some(ends) }
    }

    /// The pairs whose roads the next step builds.
    fn next(&self) -> std::ops::Range<usize> {
        let from = self.roads.len();
        if from == self.seeds.len() {
            return from..from;
        }
        let [first, _] = self.pair(from);
        from..from + self.stops.len() - 1 - first
    }

    /// Builds one stop's roads of what was provided.
    pub fn step(&mut self) {
        let nothing = || SubtaskResult { cost: None, converged: 0.0, path: Vec::new() };
        let count = self.next().len();
        let found = std::mem::take(&mut self.provided).into_iter().chain(std::iter::repeat_with(nothing));
        self.roads.extend(found.take(count).map(|found| Arc::new(Road::from(found))));
    }

    /// Whether every road is built.
    pub fn is_built(&self) -> bool {
        self.roads.len() == self.seeds.len()
    }

    /// How many runs found no road.
    pub fn failed(&self) -> usize {
        self.roads.iter().filter(|road| !road.is_found()).count()
    }

    /// The distances by road. Where a run found none, the shortest way over other stops takes its place; `None` if there
    /// is not for every pair such a way.
    pub fn distances(&mut self) -> Option<Distances> {
        if self.failed() > 0 {
            self.join();
        }
        let built = self.roads.iter().all(|road| !road.path.is_empty());
        built.then(|| Distances::of(self.stops.len(), |i, j| self.roads[self.number(i, j)].length))
    }

    /// Makes the missing roads of those that were found (Floyd 1962).
    fn join(&mut self) {
        let n = self.stops.len();
        let length = |i: usize, j: usize| if i == j { 0.0 } else { self.roads[self.number(i, j)].length };
        let mut best: Vec<_> = (0..n * n).map(|k| length(k / n, k % n)).collect();
        // The stop that comes next on the way from i to j.
        let mut next: Vec<_> = (0..n * n).map(|k| k % n).collect();
        for via in 0..n {
            for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
                let over = best[i * n + via] + best[via * n + j];
                if over < best[i * n + j] {
                    (best[i * n + j], next[i * n + j]) = (over, next[i * n + via]);
                }
            }
        }
        let missing: Vec<_> = (0..self.roads.len()).filter(|&number| self.roads[number].path.is_empty()).collect();
        let joined: Vec<_> = missing.into_iter().filter_map(|number| Some((number, self.over(number, &best, &next)?))).collect();
        for (number, road) in joined {
            self.roads[number] = Arc::new(road);
        }
    }

    /// The road of a pair over other stops; `None` if none leads there.
    fn over(&self, number: usize, best: &[f64], next: &[usize]) -> Option<Road> {
        let n = self.stops.len();
        let [from, to] = self.pair(number);
        if best[from * n + to].is_infinite() {
            return None;
        }
        let (mut at, mut over, mut path) = (from, Vec::new(), vec![self.stops[from]]);
        while at != to {
            let hop = next[at * n + to];
            path.extend_from_slice(self.way(at, hop).get(1..).unwrap_or_default());
            over.extend((hop != to).then_some(hop));
            at = hop;
        }
        Some(Road { length: geometry::length(&path), path, converged: f64::NAN, over })
    }

    /// Why there is no tour: the first pair of stops without a road, and what to do.
    pub fn failure(&self) -> Option<Message> {
        let [i, j] = self.pair(self.roads.iter().position(|road| road.path.is_empty())?);
        Some(message!(
            "tour-no-road",
            "{planner} found no road from stops[{i}] to stops[{j}], and none leads there over other stops; roads=a-star finds one wherever there is one",
            planner = self.planner,
            i,
            j
        ))
    }

    /// The road between two stops in the direction in which it is gone; empty if there is none.
    pub fn way(&self, from: usize, to: usize) -> Vec<[f64; 2]> {
        let mut path = self.roads.get(self.number(from, to)).map_or(Vec::new(), |road| road.path.clone());
        if from > to {
            path.reverse();
        }
        path
    }
}

impl Subtasks for Network {
    fn requests(&self) -> Vec<Subtask> {
        self.next().map(|pair| self.job(pair)).collect()
    }

    fn provide(&mut self, found: Vec<SubtaskResult>) {
        self.provided = found;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{params::Parameters, standard};

    /// An open grid with stops at (0.5, 0.5), (3.5, 0.5), (0.5, 3.5), (3.5, 3.5), and the lengths of the roads that were
    /// found: between 0 and 1, 0 and 2, 0 and 3, 1 and 2, 1 and 3, 2 and 3.
    fn network(found: [Option<f64>; 6]) -> Network {
        let text = r#"{"format": "forage-scene", "version": 1, "kind": "grid", "name": "o", "title": "O", "cell": 1,
            "rows": ["....", "....", "....", "...."], "stops": [[0.5, 0.5], [3.5, 0.5], [0.5, 3.5], [3.5, 3.5]]}"#;
        let scene = Arc::new(standard().read_scene(text).unwrap());
        let grid = scene.get::<GridScene>().unwrap();
        let entry = crate::standard().planner("bat").unwrap();
        let settings = Parameters::new(entry.parameters, scene.kind(), &Overrides::new()).unwrap();
        let start = Start { entry, scene: &scene, parameters: &settings, seed: 1, entries: &**standard() };
        let mut network = Network::new(&start, grid).unwrap();
        let road = |(number, length): (usize, Option<f64>)| {
            let path = network.pair(number).map(|stop| network.stops[stop]).to_vec();
            Arc::new(match length {
                Some(length) => Road { path, length, converged: 1.0, over: Vec::new() },
                None => Road { path: Vec::new(), length: f64::INFINITY, converged: 0.0, over: Vec::new() },
            })
        };
        network.roads = found.into_iter().enumerate().map(road).collect();
        network
    }

    #[test]
    fn a_missing_road_leads_the_shortest_way_over_those_that_were_found() {
        // From 0 to 3: over 1 it is 3 + 9, over 2 it is 4 + 5.
        let mut over = network([Some(3.0), Some(4.0), None, Some(6.0), Some(9.0), Some(5.0)]);
        assert!(over.distances().is_some());
        assert_eq!((over.failed(), &over.roads[2].over[..]), (1, &[2][..]));
        assert_eq!(over.roads[2].path, [[0.5, 0.5], [0.5, 3.5], [3.5, 3.5]]);
        assert_eq!(over.way(3, 0), [[3.5, 3.5], [0.5, 3.5], [0.5, 0.5]]);
        assert_eq!(over.failure(), None);
    }

    #[test]
    fn a_chain_of_roads_is_enough_for_all_pairs() {
        // 0 – 3 – 2 – 1 and nothing else.
        let mut chain = network([None, None, Some(1.0), Some(1.0), None, Some(1.0)]);
        assert!(chain.distances().is_some());
        assert_eq!(chain.roads[0].over, [3, 2]);
        assert_eq!(chain.failed(), 3);
    }

    #[test]
    fn what_no_road_leads_to_is_named() {
        let mut apart = network([Some(1.0), None, None, None, None, Some(1.0)]);
        assert!(apart.distances().is_none());
        assert!(apart.failure().unwrap().text().contains("stops[0] to stops[2]"));
    }
}
