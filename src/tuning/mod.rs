//! A particle swarm over the parameters of an ant colony, [WOLF-ANT] §5.2: a planner that runs planners.
//!
//! It knows colonies only as everybody does, by the catalogue and the stepped contract, and never runs one: its runs are
//! [`Subtasks`], which may be carried out side by side; the outcome does not depend on it.

mod entry;
mod explain;
mod parameters;
#[cfg(test)]
mod tests;

use std::sync::Arc;

use crate::{
    describe::{Entry, Reading, Start, layers},
    exact::is_reachable,
    geometry,
    kernel::{
        Candidate, Error, Explain, Facets, Frame, Inspection, Item, Planner, Progress, Readings, Recommend, Recommendation,
        ReferenceOptimum, Shape, Solution, Started, State, Subtask, SubtaskResult, Subtasks, rng::Stream,
    },
    math,
    params::{Domain, Overrides, Parameter, Value},
    scene::{GridScene, Scene},
};

pub use entry::ENTRY;
pub use parameters::SYMBOLS;

use parameters::{BEST, C1, C2, COLONY, FOUND, ITERATIONS, LENGTH, MEAN, POPULATION, READINGS, ROUNDS, RUNS, SEEDS, TUNABLE, TUNE, W};

/// A parameter that is searched, in the range that its slider offers; where that is logarithmic, so is the search.
#[derive(Debug, Clone, Copy)]
struct Axis {
    parameter: &'static Parameter,
    /// What tells its best value.
    reading: Reading,
    low: f64,
    high: f64,
    whole: bool,
}

impl Axis {
    fn new(parameter: &'static Parameter) -> Option<Self> {
        let (min, max, whole) = match parameter.domain {
            Domain::Number { min, max, .. } => (min, max, false),
            Domain::Integer { min, max, .. } => (min as f64, max as f64, true),
            _ => return None,
        };
        let reading = *READINGS.iter().find(|reading| reading.name == parameter.name)?;
        let (low, high) = parameter.slider.unwrap_or((min, max));
        let scale = |x: f64| if parameter.logarithmic { math::log10(x) } else { x };
        Some(Self { parameter, reading, low: scale(low), high: scale(high), whole })
    }

    /// The parameter's value at a coordinate.
    fn value(&self, x: f64) -> f64 {
        let (low, high) = self.parameter.slider.unwrap_or((self.low, self.high));
        let value = if self.parameter.logarithmic { math::pow(10.0, x) } else { x };
        // Rounding must not lead out of what is allowed.
        math::clamp(if self.whole { value.round() } else { value }, low, high)
    }
}

/// How good a set of parameters is. The less the better: first the mean length, then the mean iteration of convergence.
#[derive(Debug, Clone, Copy, PartialEq, State)]
struct Fitness {
    /// Infinite if a run found no way.
    length: f64,
    converged: f64,
}

const NONE: Fitness = Fitness { length: f64::INFINITY, converged: f64::INFINITY };

impl Fitness {
    /// The mean over some runs.
    fn of(found: &[SubtaskResult]) -> Self {
        let n = found.len() as f64;
        // Equal lengths in another order must give the same mean, or rounding would break ties.
        let mut lengths: Vec<_> = found.iter().map(|f| f.cost.unwrap_or(f64::INFINITY)).collect();
        math::sort_numbers(&mut lengths);
        let length = lengths.iter().sum::<f64>() / n;
        let converged = if length.is_finite() { found.iter().map(|f| f.converged).sum::<f64>() / n } else { f64::INFINITY };
        Self { length, converged }
    }

    fn better_than(self, other: Self) -> bool {
        self.length < other.length || (self.length == other.length && self.converged < other.converged)
    }
}

/// The swarm. Positions are drawn when it starts; the first step judges them, each later one moves and judges them.
#[derive(Clone, State)]
struct Tuning {
    #[state(shared)]
    scene: Arc<Scene>,
    #[state(shared)]
    colony: &'static Entry,
    #[state(shared)]
    rounds: u64,
    #[state(shared)]
    axes: Vec<Axis>,
    #[state(shared)]
    population: usize,
    /// w, c1, c2.
    #[state(shared)]
    weights: [f64; 3],
    /// The seeds that every set of parameters is judged by.
    #[state(shared)]
    seeds: Vec<u64>,
    /// Positions of the particles, judged in the last step; then the positions that the next step judges.
    shown: Vec<f64>,
    x: Vec<f64>,
    v: Vec<f64>,
    cost: Vec<Fitness>,
    p: Vec<f64>,
    p_cost: Vec<Fitness>,
    g: Vec<f64>,
    g_cost: Fitness,
    /// The shortest way that each particle's parameters gave in the last step, and the best one's.
    ways: Vec<Vec<[f64; 2]>>,
    best: Vec<[f64; 2]>,
    /// What the runs of the next step found.
    #[state(skip)]
    provided: Vec<SubtaskResult>,
    iteration: u64,
    rng: Stream,
}

fn start(start: &Start) -> Result<Started, Error> {
    let &Start { scene, parameters: settings, seed, .. } = start;
    let colony = start.planner(COLONY)?;
    let chosen = &settings[TUNE];
    let axes: Vec<_> = colony.all_parameters().filter(|p| chosen.split(',').any(|name| name == p.name)).filter_map(Axis::new).collect();
    if axes.is_empty() {
        let known: Vec<_> = TUNABLE.iter().map(|option| option.value).filter(|name| colony.parameter(name).is_some()).collect();
        return Err(Error::refused(TUNE.name(), chosen, format!("some of {}, which {} has", known.join(", "), colony.name)));
    }
    let grid = scene.get::<GridScene>()?;
    let endpoints = grid.endpoints()?;
    let population = settings[POPULATION] as usize;
    let mut rng = Stream::new(seed, 0);
    let seeds = (0..settings[SEEDS]).map(|_| rng.below(1 << 31) as u64).collect();
    let mut x = Vec::with_capacity(population * axes.len());
    let mut v = Vec::with_capacity(x.capacity());
    for _ in 0..population {
        for axis in &axes {
            x.push(rng.between(axis.low, axis.high));
            v.push(rng.between(axis.low - axis.high, axis.high - axis.low));
        }
    }
    let tuning = Tuning {
        scene: Arc::clone(scene),
        colony,
        rounds: settings[ROUNDS],
        population,
        weights: [settings[W], settings[C1], settings[C2]],
        seeds,
        shown: x.clone(),
        cost: vec![NONE; population],
        p: x.clone(),
        p_cost: vec![NONE; population],
        g: x[..axes.len()].to_vec(),
        g_cost: NONE,
        ways: vec![Vec::new(); population],
        best: Vec::new(),
        provided: Vec::new(),
        iteration: 0,
        x,
        v,
        axes,
        rng,
    };
    let reachable = is_reachable(grid.cells(), endpoints.start, endpoints.goal);
    Ok(Started::new(tuning, settings[ITERATIONS]).measured_by(ReferenceOptimum::Cells).solvable(reachable))
}

impl Tuning {
    /// The colony's parameters at a position.
    fn given(&self, x: &[f64]) -> Overrides {
        let mut given = Overrides::new();
        given.insert(ITERATIONS.name(), Value::from(self.rounds as f64));
        for (axis, &x) in self.axes.iter().zip(x) {
            given.insert(axis.parameter.name, Value::from(axis.value(x)));
        }
        given
    }

    fn row(&self, i: usize) -> std::ops::Range<usize> {
        i * self.axes.len()..(i + 1) * self.axes.len()
    }

    /// What the runs found, particle by particle, and the bests that follow.
    fn judge(&mut self, found: &[SubtaskResult]) {
        self.shown.copy_from_slice(&self.x);
        for (i, found) in found.chunks_exact(self.seeds.len()).enumerate() {
            let row = self.row(i);
            let cost = Fitness::of(found);
            self.cost[i] = cost;
            let shortest = found.iter().filter(|f| f.cost.is_some()).min_by(|a, b| a.cost.unwrap_or(0.0).total_cmp(&b.cost.unwrap_or(0.0)));
            self.ways[i] = shortest.map_or(Vec::new(), |f| f.path.clone());
            if cost.better_than(self.p_cost[i]) {
                self.p_cost[i] = cost;
                self.p[row.clone()].copy_from_slice(&self.x[row.clone()]);
            }
            if cost.better_than(self.g_cost) {
                self.g_cost = cost;
                self.g.copy_from_slice(&self.x[row]);
                self.best.clone_from(&self.ways[i]);
            }
        }
    }

    /// v ← w v + c1 r1 (p − x) + c2 r2 (g − x), x ← x + v; both kept in their ranges.
    fn fly(&mut self) {
        let [w, c1, c2] = self.weights;
        for i in 0..self.x.len() {
            let j = i % self.axes.len();
            let Axis { low, high, .. } = self.axes[j];
            let (r1, r2) = (self.rng.unit(), self.rng.unit());
            let v = w * self.v[i] + c1 * r1 * (self.p[i] - self.x[i]) + c2 * r2 * (self.g[j] - self.x[i]);
            self.v[i] = math::clamp(v, low - high, high - low);
            self.x[i] = math::clamp(self.x[i] + self.v[i], low, high);
        }
    }
}

impl Planner for Tuning {
    fn advance(&mut self) -> Progress {
        self.iteration += 1;
        let found = std::mem::take(&mut self.provided);
        self.judge(&found);
        self.fly();
        Progress::Continue
    }

    fn evaluations(&self) -> u64 {
        self.iteration * (self.population * self.seeds.len()) as u64
    }

    fn best(&self) -> Option<Candidate> {
        self.g_cost.length.is_finite().then(|| Candidate { cost: self.g_cost.length, solution: Solution::Path(self.best.clone()) })
    }

    fn read(&self, out: &mut Readings) {
        let known = || self.cost.iter().filter(|cost| cost.length.is_finite());
        let n = known().count();
        out.push(BEST, if self.best.is_empty() { f64::NAN } else { self.g_cost.length });
        out.push(MEAN, if n > 0 { known().map(|cost| cost.length).sum::<f64>() / n as f64 } else { f64::NAN });
        out.push(LENGTH, if self.best.is_empty() { f64::NAN } else { geometry::length(&self.best) });
        out.push(FOUND, if self.best.is_empty() { f64::NAN } else { self.g_cost.converged });
        out.push(RUNS, Planner::evaluations(self) as f64);
        for (axis, &x) in self.axes.iter().zip(&self.g) {
            out.push(axis.reading, axis.value(x));
        }
    }

    fn draw(&self, frame: &mut Frame) {
        let longest = self.ways.iter().map(Vec::len).max().unwrap_or(0);
        let every = frame.thin(self.population, longest, true);
        // One that found nothing is a dot at the start, so that the others keep their numbers.
        let nowhere = self.scene.ends().map_or([[0.0; 2]; 2], |(start, _)| [start; 2]);
        let mut line = |layer, way: &[[f64; 2]]| {
            frame.begin(layer, Shape::Polyline);
            way.iter().for_each(|&point| frame.push(point, 0.0));
        };
        for way in self.ways.iter().step_by(every) {
            line(layers::PARTICLES.key, if way.len() > 1 { way } else { &nowhere });
        }
        if self.best.len() > 1 {
            line(layers::BEST.key, &self.best);
        }
    }

    fn facets(&self) -> Facets<'_> {
        Facets::default().explain(self).recommend(self)
    }

    fn subtasks(&mut self) -> Option<&mut dyn Subtasks> {
        Some(self)
    }
}

impl Subtasks for Tuning {
    /// The runs that judge the positions.
    fn requests(&self) -> Vec<Subtask> {
        let of = |i: usize| {
            let params = self.given(&self.x[self.row(i)]);
            self.seeds.iter().map(move |&seed| Subtask { planner: self.colony.name, params: params.clone(), seed, ends: None })
        };
        (0..self.population).flat_map(of).collect()
    }

    fn provide(&mut self, found: Vec<SubtaskResult>) {
        self.provided = found;
    }
}

impl Explain for Tuning {
    fn inspect(&self, item: Item) -> Option<Inspection> {
        (item.layer == layers::PARTICLES.key && item.index < self.population).then(|| explain::particle(self, item))
    }
}

impl Recommend for Tuning {
    fn recommendation(&self) -> Option<Recommendation> {
        self.g_cost.length.is_finite().then(|| Recommendation { planner: self.colony.name, params: self.given(&self.g) })
    }
}
