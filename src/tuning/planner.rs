//! The swarm as a planner: how it starts, which runs it asks for, and what it recommends.

use std::sync::Arc;

use crate::{
    describe::{Start, layers},
    exact::is_reachable,
    geometry::{self, Cells, Endpoints},
    kernel::{
        Candidate, Error, Explain, Facets, Frame, Inspection, Item, Planner, Progress, Readings, Recommend, Recommendation,
        ReferenceOptimum, Shape, Solution, Started, Subtask, SubtaskResult, Subtasks, limits, rng::Stream,
    },
    message,
    params::Parameters,
    scene::GridScene,
};

use super::{
    explain,
    parameters::{BEST, C1, C2, COLONY, FOUND, ITERATIONS, LENGTH, MEAN, POPULATION, ROUNDS, RUNS, SEEDS, TUNABLE, TUNE, W},
    swarm::{Axis, NONE, Tuning},
};

pub(super) fn start(start: &Start) -> Result<Started, Error> {
    let &Start { scene, parameters: settings, seed, .. } = start;
    let colony = start.planner(COLONY)?;
    let chosen = &settings[TUNE];
    let axes: Vec<_> = colony.all_parameters().filter(|p| chosen.split(',').any(|name| name == p.name)).filter_map(Axis::new).collect();
    if axes.is_empty() {
        let known: Vec<_> = TUNABLE.iter().map(|option| option.value).filter(|name| colony.parameter(name).is_some()).collect();
        let allowed = message!("tuning-some-of", "some of {known}, which {colony} has", known = known.join(", "), colony = colony.name);
        return Err(Error::refused(TUNE.name(), chosen, allowed));
    }
    let grid = scene.get::<GridScene>()?;
    let endpoints = grid.endpoints()?;
    check_results(grid.cells(), &endpoints, settings)?;
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

/// The bytes of a result besides its way, at the most: the same wherever it runs.
const NUMBERS: usize = 64;

/// Refuses more sets of parameters than there is memory for: each of their runs gives a way, with a corner for each cell, and no way has
/// fewer cells than one straight to the goal.
fn check_results(cells: &Cells, endpoints: &Endpoints, settings: &Parameters) -> Result<(), Error> {
    let [[ax, ay], [bx, by]] = [endpoints.start, endpoints.goal].map(|cell| cells.place(cell));
    let fewest = 1 + ax.abs_diff(bx).max(ay.abs_diff(by));
    let way = NUMBERS + fewest * size_of::<[f64; 2]>();
    limits::check_members(POPULATION.name(), settings[POPULATION], settings[SEEDS] as usize * way)
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
