//! Ants that go from cell to cell of a grid and lay pheromone on their ways, [ANTBAT] §3.1 and [WOLF-ANT] §5.1.
//!
//! There is one colony. What its planners differ in is exchanged: how an ant sees the cells around it (`ground`), how it
//! chooses among them (`walk`), and what it lays (`update`). `pheromone` keeps τ and the choice weights, which are made
//! once per iteration for each cell that an ant comes to; a step is then a look-up and one random number.

pub mod aco;
pub mod aco_dijkstra;
pub mod aco_direction;
pub mod aco_wolf;
mod draw;
mod explain;
mod ground;
mod parameters;
mod pheromone;
mod scouts;
#[cfg(test)]
mod tests;
mod update;
mod walk;

use std::sync::Arc;

use crate::{
    describe::{CONVERGED, Start, layers},
    exact,
    kernel::{
        Candidate, Error, Explain, Facets, Frame, Inspection, Item, Planner, Progress, Readings, ReferenceOptimum, Solution, Started,
        State, rng::Stream,
    },
    scene::grid_path::{self, GridPath, SMOOTH},
    settled::{SETTLED, Settled},
};

use ground::{Direction, Ground, Heuristic};
use parameters::{
    ALPHA, ANT_STEPS, ANTS, ARRIVED, BACKTRACKS, BEST, BETA, GREED, ITERATIONS, LOST, MEAN, Q, RHO, STEP_LIMIT, STUCK, TAU_0, TAU_MAX,
    TAU_MIN,
};
use pheromone::Pheromone;
use update::Update;
use walk::{End, Rules, Seen, Walks, walk};

pub use explain::SYMBOLS;

/// How many bytes a cell go into keeping the walks of an iteration; ants beyond go their ways again when they are needed.
const KEPT: usize = 16;

/// What one colony has and another has not.
#[derive(Debug, Clone, Copy)]
struct Traits {
    heuristic: Heuristic,
    /// γ: how much the direction of a step counts.
    gamma: f64,
    direction: Direction,
    update: Update,
    /// Q is multiplied by the distance from start to goal, so that it means the same on every map.
    relative: bool,
    /// q0 at the start and at the end.
    greed: [f64; 2],
    /// By how much a Dijkstra path's pheromone is multiplied before the first ant sets out; 1: not at all.
    seeded: f64,
}

impl Traits {
    /// The traditional colony, [ANTBAT] (1); the others differ from it.
    const TRADITIONAL: Self = Self {
        heuristic: Heuristic::Distance,
        gamma: 0.0,
        direction: Direction::Squared,
        update: Update::Traditional,
        relative: false,
        greed: [0.0; 2],
        seeded: 1.0,
    };
}

/// A colony of ants. One iteration: all ants walk, then pheromone evaporates and what they lay is added.
#[derive(Clone, State)]
pub(crate) struct Colony {
    #[state(shared)]
    ground: Arc<Ground>,
    #[state(shared)]
    traits: Traits,
    #[state(shared)]
    rules: Rules,
    #[state(shared)]
    ants: usize,
    #[state(shared)]
    q: f64,
    #[state(shared)]
    smooth: bool,
    pheromone: Pheromone,
    walks: Walks,
    /// How many steps of an iteration are kept.
    #[state(shared)]
    kept: usize,
    /// An ant whose way was not kept goes it again here; scratch space.
    #[state(skip)]
    again: Walks,
    #[state(skip)]
    seen: Seen,
    #[state(skip)]
    lengths: Vec<f64>,
    best: Option<Found>,
    /// When the best was found.
    converged: u64,
    settled: Settled,
    iteration: u64,
    #[state(shared)]
    limit: u64,
    rng: Stream,
}

/// The best way so far.
#[derive(Debug, Clone, State)]
struct Found {
    /// Its directions from the start on.
    directions: Vec<u8>,
    /// In the scene's unit.
    length: f64,
    #[state(skip)]
    way: GridPath,
}

impl Found {
    fn new(ground: &Ground, directions: &[u8], length: f64) -> Self {
        let path = ground.endpoints.path(&ground.cells, ground.way(directions));
        Self { directions: directions.to_vec(), length, way: GridPath::new(path) }
    }
}

/// Starts a colony with these traits.
fn start(start: &Start, traits: Traits) -> Result<Started, Error> {
    let colony = Colony::new(start, traits)?;
    let (limit, reachable) = (colony.limit, colony.ground.reachable);
    let reference = if colony.smooth { ReferenceOptimum::AnyAngle } else { ReferenceOptimum::Cells };
    Ok(Started::new(colony, limit).measured_by(reference).solvable(reachable))
}

impl Colony {
    fn new(start: &Start, traits: Traits) -> Result<Self, Error> {
        let &Start { scene, parameters: settings, seed, .. } = start;
        let bounds = [settings[TAU_MIN], settings[TAU_MAX]];
        let ground = Ground::new(scene, traits.heuristic, settings[BETA], traits.gamma, traits.direction)?;
        let cells = &ground.cells;
        let mut pheromone = Pheromone::new(cells, settings[TAU_0], settings[ALPHA], settings[RHO], bounds);
        if traits.seeded != 1.0
            && let Some(way) = exact::shortest_way(cells, ground.endpoints.start, ground.endpoints.goal)
        {
            for step in way.windows(2) {
                let direction = (0..8).find(|&d| cells.next(step[0], d) == step[1]).unwrap_or(0);
                pheromone.favour(&ground, step[0], direction, traits.seeded);
            }
        }
        let limit = match settings[STEP_LIMIT] {
            0 => 2 * cells.len() as u64,
            steps => steps,
        };
        Ok(Self {
            traits,
            rules: Rules { backtracks: settings[BACKTRACKS], limit },
            ants: settings[ANTS] as usize,
            q: settings[Q] * if traits.relative { ground.apart() } else { 1.0 },
            smooth: settings[SMOOTH],
            walks: Walks::default(),
            kept: KEPT * cells.len(),
            again: Walks::default(),
            seen: Seen::new(cells.len()),
            lengths: Vec::new(),
            best: None,
            converged: 0,
            settled: Settled::default(),
            iteration: 0,
            limit: settings[ITERATIONS],
            rng: Stream::new(seed, 0),
            pheromone,
            ground: Arc::new(ground),
        })
    }

    /// Whether any way leads from start to goal.
    pub(crate) fn is_reachable(&self) -> bool {
        self.ground.reachable
    }

    /// q0 of an iteration, counted from 0: it changes evenly over the run.
    fn greed(&self, iteration: u64) -> f64 {
        let [from, to] = self.traits.greed;
        from + (to - from) * (iteration as f64 / (self.limit.max(2) - 1) as f64).min(1.0)
    }

    /// All ants walk, one after another; the iteration is counted already.
    fn send(&mut self) {
        let greed = self.greed(self.iteration - 1);
        self.walks.clear();
        for _ in 0..self.ants {
            let begun = self.rng.clone();
            walk(&self.ground, &mut self.pheromone, self.rules, greed, &mut self.seen, &mut self.rng, &mut self.walks);
            self.walks.forget(self.kept, begun);
        }
    }

    /// An ant's directions; one whose way was not kept goes it again. (The weights are those of its iteration until
    /// pheromone has settled.)
    fn way(&mut self, i: usize) -> Vec<u8> {
        let ant = &self.walks.ants[i];
        let Some(mut rng) = ant.again.clone() else {
            return self.walks.of(ant).to_vec();
        };
        let greed = self.greed(self.iteration - 1);
        self.again.clear();
        walk(&self.ground, &mut self.pheromone, self.rules, greed, &mut self.seen, &mut rng, &mut self.again);
        self.again.ants.first().map_or(Vec::new(), |ant| self.again.of(ant).to_vec())
    }

    /// Keeps the iteration's shortest way if it is shorter than the best so far.
    fn judge(&mut self) {
        let arrived = self.walks.ants.iter().enumerate().filter(|(_, ant)| ant.end == End::Arrived);
        let shortest = arrived.map(|(i, ant)| (i, ant.length)).min_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((i, length)) = shortest.filter(|&(_, length)| self.best.as_ref().is_none_or(|best| length < best.length)) {
            let way = self.way(i);
            self.best = Some(Found::new(&self.ground, &way, length));
            self.converged = self.iteration;
        }
        self.settled.note(self.iteration, self.mean(), shortest.map_or(f64::NAN, |(_, length)| length));
    }

    /// The mean length of the iteration's ways that arrived; NaN if none did.
    fn mean(&self) -> f64 {
        let (sum, arrived) = self.walks.arrived().fold((0.0, 0), |(sum, n), ant| (sum + ant.length, n + 1));
        if arrived > 0 { sum / f64::from(arrived) } else { f64::NAN }
    }

    /// [ANTBAT] (4), [WOLF-ANT] (10).
    fn renew(&mut self) {
        self.pheromone.evaporate();
        if let Some(best) = self.best.as_ref().filter(|_| self.walks.leads_anywhere()) {
            update::lay(self.traits.update, self.q, best.length, &mut self.walks, &mut self.lengths);
        }
        for i in 0..self.walks.ants.len() {
            let ant = &self.walks.ants[i];
            let (laid, kept) = (ant.laid, ant.again.is_none());
            if ant.end != End::Arrived {
                continue;
            }
            if kept {
                lay(&self.ground, &mut self.pheromone, self.walks.of(ant), laid);
            } else {
                let way = self.way(i);
                lay(&self.ground, &mut self.pheromone, &way, laid);
            }
        }
        self.pheromone.settle();
    }

    fn count(&self, end: End) -> usize {
        self.walks.ants.iter().filter(|ant| ant.end == end).count()
    }
}

/// Adds to each step of a way.
fn lay(ground: &Ground, pheromone: &mut Pheromone, way: &[u8], amount: f64) {
    let mut cell = ground.endpoints.start;
    for d in way.iter().map(|&d| usize::from(d)) {
        pheromone.lay(cell, d, amount);
        cell = ground.cells.next(cell, d);
    }
}

impl Planner for Colony {
    fn advance(&mut self) -> Progress {
        self.iteration += 1;
        self.send();
        self.judge();
        self.renew();
        Progress::Continue
    }

    fn evaluations(&self) -> u64 {
        self.iteration * self.ants as u64
    }

    fn best(&self) -> Option<Candidate> {
        let best = self.best.as_ref()?;
        let path = if self.smooth { best.way.smooth(&self.ground.grid) } else { &best.way.path };
        Some(Candidate { cost: best.length, solution: Solution::Path(path.to_vec()) })
    }

    fn read(&self, out: &mut Readings) {
        out.push(BEST, self.best.as_ref().map_or(f64::NAN, |best| best.length));
        out.push(MEAN, self.mean());
        grid_path::read(self.best.as_ref().map(|best| &best.way), &self.ground.grid, out);
        out.push(CONVERGED, if self.best.is_some() { self.converged as f64 } else { f64::NAN });
        out.push(SETTLED, self.settled.iteration());
        out.push(ARRIVED, self.count(End::Arrived) as f64);
        out.push(STUCK, self.count(End::Stuck) as f64);
        out.push(LOST, self.count(End::Lost) as f64);
        out.push(ANT_STEPS, self.walks.taken as f64);
        if self.traits.greed != [0.0; 2] {
            out.push(GREED, self.greed(self.iteration.saturating_sub(1)));
        }
    }

    fn draw(&self, frame: &mut Frame) {
        draw::pheromone(&self.ground.cells, &self.pheromone, frame);
        draw::trails(&self.ground.cells, &self.pheromone, frame);
        draw::ants(&self.ground, &self.walks, frame);
        if let Some(best) = &self.best {
            draw::line(frame, layers::BEST.key, &best.way.path);
            if self.smooth {
                draw::line(frame, layers::SMOOTHED.key, best.way.smooth(&self.ground.grid));
            }
        }
    }

    fn facets(&self) -> Facets<'_> {
        Facets::default().explain(self)
    }
}

impl Explain for Colony {
    fn inspect(&self, item: Item) -> Option<Inspection> {
        match item.layer {
            layer if layer == layers::PHEROMONE.key => explain::cell(self, item),
            layer if layer == layers::ANTS.key => explain::ant(self, item),
            _ => None,
        }
    }
}
