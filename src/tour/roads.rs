//! The road network, [ANTBAT] §3.2: a way for each pair of stops, found by a run of another planner.

use std::sync::{Arc, OnceLock};

use crate::{
    error::Error,
    exact::is_reachable,
    geometry,
    params::{Given, Settings, Value},
    planner::{Finding, Job},
    rng::Stream,
    scene::{Course, Distances, GridScene, Scene},
    session,
};

/// A way from one stop to a later one.
#[derive(Debug, Clone, PartialEq)]
pub struct Road {
    /// Its corners, in the scene's unit; empty if the run found none.
    pub path: Vec<[f64; 2]>,
    /// Infinite if the run found none.
    pub length: f64,
    /// The iteration in which the run found it.
    pub converged: f64,
}

impl From<Finding> for Road {
    fn from(found: Finding) -> Self {
        let length = if found.cost.is_some() { geometry::length(&found.path) } else { f64::INFINITY };
        Self { path: found.path, length, converged: found.converged }
    }
}

/// Who builds the roads of a scene, and those that are built. A step builds one stop's roads to all later stops.
#[derive(Debug, Clone)]
pub struct Network {
    scene: Arc<Scene>,
    pub stops: Vec<[f64; 2]>,
    planner: &'static str,
    params: Given,
    /// A seed for each pair.
    seeds: Arc<[u64]>,
    /// Those that are built, pair by pair.
    pub roads: Vec<Arc<Road>>,
    /// All of them, once somebody had to build them here: what is built again is the same, so copies share it.
    known: Arc<OnceLock<Vec<Arc<Road>>>>,
    supplied: Option<Vec<Finding>>,
}

impl Network {
    /// The network of a grid's stops, nothing built.
    ///
    /// # Errors
    /// [`Error::Refused`] for a stop that the others cannot be reached from, by its name.
    pub fn new(scene: &Arc<Scene>, grid: &GridScene, settings: &Settings, seed: u64) -> Result<Self, Error> {
        let planner = super::parameters::BUILDERS.iter().map(|builder| builder.value).find(|name| *name == settings.choice("roads"));
        let stops = grid.stops.clone();
        for (i, &stop) in stops.iter().enumerate().skip(1) {
            let name = format!("stops[{i}]");
            let course = Course::between(grid, ["stops[0]", &name], [stops[0], stop])?;
            if !is_reachable(grid.cells(), course.start, course.goal) {
                let allowed = "where it can be reached from stops[0]: there is no way between them";
                return Err(Error::refused(name, format!("({}, {})", stop[0], stop[1]), allowed));
            }
        }
        let mut rng = Stream::new(seed, 1);
        let n = stops.len();
        let mut params = Given::new();
        params.insert("smooth", Value::Flag(settings.flag("smooth")));
        Ok(Self {
            scene: Arc::clone(scene),
            planner: planner.unwrap_or("a-star"),
            params,
            seeds: (0..n * (n - 1) / 2).map(|_| rng.below(1 << 31) as u64).collect(),
            roads: Vec::new(),
            known: Arc::default(),
            supplied: None,
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

    fn job(&self, number: usize) -> Job {
        let ends = self.pair(number).map(|stop| self.stops[stop]);
        Job { planner: self.planner, params: self.params.clone(), seed: self.seeds[number], ends: Some(ends) }
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

    /// The runs that the next step needs, unless they were supplied.
    pub fn jobs(&self) -> Vec<Job> {
        if self.supplied.is_some() || self.known.get().is_some() { Vec::new() } else { self.next().map(|pair| self.job(pair)).collect() }
    }

    /// Takes what the runs of [`Network::jobs`] found.
    pub fn supply(&mut self, found: Vec<Finding>) {
        if found.len() == self.next().len() {
            self.supplied = Some(found);
        }
    }

    /// Builds one stop's roads.
    pub fn step(&mut self) {
        let next = self.next();
        if let Some(found) = self.supplied.take() {
            self.roads.extend(found.into_iter().map(|found| Arc::new(Road::from(found))));
            return;
        }
        let all = self.known.get_or_init(|| {
            let jobs: Vec<_> = (0..self.seeds.len()).map(|pair| self.job(pair)).collect();
            // What starting a run could refuse was refused for the tour's own.
            let found = session::carry_out_all(&self.scene, &jobs).unwrap_or_default();
            found.into_iter().map(|found| Arc::new(Road::from(found))).collect()
        });
        let none = || Arc::new(Road { path: Vec::new(), length: f64::INFINITY, converged: 0.0 });
        self.roads.extend(next.map(|pair| all.get(pair).cloned().unwrap_or_else(none)));
    }

    /// Whether every road is built.
    pub fn is_built(&self) -> bool {
        self.roads.len() == self.seeds.len()
    }

    /// The distances by road. Where a run found no road the way leads over other stops; `None` if it cannot.
    pub fn distances(&mut self) -> Option<Distances> {
        let n = self.stops.len();
        for (number, via) in (0..self.roads.len()).flat_map(|number| (0..n).map(move |via| (number, via))) {
            let [i, j] = self.pair(number);
            if self.roads[number].path.is_empty() && via != i && via != j {
                self.join(number, via);
            }
        }
        self.roads.iter().all(|road| !road.path.is_empty()).then(|| Distances::of(n, |i, j| self.roads[self.number(i, j)].length))
    }

    /// Makes the missing road of a pair over another stop, if there are roads to and from that one.
    fn join(&mut self, number: usize, via: usize) {
        let [i, j] = self.pair(number);
        let (mut path, rest) = (self.way(i, via), self.way(via, j));
        if !path.is_empty() && !rest.is_empty() {
            path.extend(&rest[1..]);
            self.roads[number] = Arc::new(Road { length: geometry::length(&path), path, converged: f64::NAN });
        }
    }

    /// The road between two stops in the direction in which it is gone; empty if there is none.
    pub fn way(&self, from: usize, to: usize) -> Vec<[f64; 2]> {
        let mut path = self.roads.get(self.number(from, to)).map_or(Vec::new(), |road| road.path.clone());
        if from > to {
            path.reverse();
        }
        path
    }

    /// The memory it takes, in bytes; roads are shared.
    pub fn bytes(&self) -> usize {
        size_of::<Self>() + size_of::<Arc<Road>>() * self.roads.len() + 16 * self.stops.len()
    }
}
