//! The colony: its state, and what it does in an iteration.

use std::sync::Arc;

use crate::{
    exact,
    geometry::Cells,
    kernel::{Error, Part, Progress, State, rng::Stream},
    message,
    params::Parameters,
    scene::{
        GridScene,
        grid_path::{GridPath, SMOOTH},
    },
    settled::Settled,
};

use super::{
    ground::{Direction, Ground, Heuristic},
    parameters::{ALPHA, ANTS, BACKTRACKS, BETA, ITERATIONS, Q, RHO, STEP_LIMIT, TAU_0, TAU_MAX, TAU_MIN},
    pheromone::Pheromone,
    update::{self, Update},
    walk::{End, Rules, Seen, Walks, walk},
};

/// So many steps of ants are a part of an iteration.
pub(super) const PORTION: usize = 500_000;

/// How many bytes a cell go into keeping the walks of an iteration; ants beyond go their ways again when they are needed.
pub(super) const KEPT: usize = 16;

/// What distinguishes one colony from another: `Variant { gamma: 2.5, ..Variant::TRADITIONAL }`.
#[derive(Debug, Clone, Copy)]
pub struct Variant {
    /// η: how an ant sees the cells around it.
    pub heuristic: Heuristic,
    /// γ: how much the direction of a step counts, [ANTBAT](crate#papers) (3); 0: not at all.
    pub gamma: f64,
    /// ψ: how it counts, [ANTBAT](crate#papers) (2).
    pub direction: Direction,
    /// Δτ: what an ant lays on its path.
    pub update: Update,
    /// Q is multiplied by the distance from start to goal, so that it means the same on every map.
    pub relative: bool,
    /// q0 at the start and at the end, 0 to 1: how often an ant takes the best step instead of drawing one.
    pub greed: [f64; 2],
    /// By how much a Dijkstra path's pheromone is multiplied before the first ant sets out; 1: not at all.
    pub seeded: f64,
}

impl Variant {
    /// The traditional colony, [ANTBAT](crate#papers) (1); the others differ from it.
    pub const TRADITIONAL: Self = Self {
        heuristic: Heuristic::Distance,
        gamma: 0.0,
        direction: Direction::Squared,
        update: Update::Traditional,
        relative: false,
        greed: [0.0; 2],
        seeded: 1.0,
    };

    fn check(&self) -> Result<(), Error> {
        let Self { gamma, greed: [from, to], seeded, .. } = *self;
        for (field, value, most) in [("gamma", gamma, 100.0), ("greed[0]", from, 1.0), ("greed[1]", to, 1.0), ("seeded", seeded, 1e12)] {
            if !(0.0..=most).contains(&value) {
                return Err(Error::refused(
                    field,
                    value,
                    message!("error-number-from-to", "a number from {low} to {high}", low = 0.0, high = most),
                ));
            }
        }
        Ok(())
    }
}

/// A colony of ants on a grid. One iteration: all ants walk, then pheromone evaporates and what they lay is added.
///
/// It is a [`Planner`](crate::kernel::Planner): `Started::from(Colony::new(…)?)` is a run of it.
#[derive(Clone, State)]
pub struct Colony {
    #[state(shared)]
    pub(super) ground: Arc<Ground>,
    #[state(shared)]
    pub(super) variant: Variant,
    #[state(shared)]
    pub(super) rules: Rules,
    #[state(shared)]
    pub(super) ants: usize,
    #[state(shared)]
    pub(super) q: f64,
    #[state(shared)]
    pub(super) smooth: bool,
    pub(super) pheromone: Pheromone,
    pub(super) walks: Walks,
    /// How many steps of an iteration are kept.
    #[state(shared)]
    pub(super) kept: usize,
    /// An ant whose way was not kept goes it again here; scratch space.
    #[state(skip)]
    pub(super) again: Walks,
    #[state(skip)]
    pub(super) seen: Seen,
    #[state(skip)]
    pub(super) lengths: Vec<f64>,
    pub(super) best: Option<Found>,
    /// When the best was found.
    pub(super) converged: u64,
    pub(super) settled: Settled,
    pub(super) iteration: u64,
    #[state(shared)]
    pub(super) limit: u64,
    pub(super) rng: Stream,
    #[state(skip)]
    pub(super) part: Part,
}

/// The best way so far.
#[derive(Debug, Clone, State)]
pub(super) struct Found {
    /// Its directions from the start on.
    pub(super) directions: Vec<u8>,
    /// In the scene's unit.
    pub(super) length: f64,
    #[state(skip)]
    pub(super) way: GridPath,
}

impl Found {
    pub(super) fn new(ground: &Ground, directions: &[u8], length: f64) -> Self {
        let path = ground.endpoints.path(&ground.cells, ground.way(directions));
        Self { directions: directions.to_vec(), length, way: GridPath::new(path) }
    }
}

impl Colony {
    /// Before the first ant sets out from the grid's start to its goal. It reads the parameters of [`aco`](super::aco::ENTRY):
    /// the entry has to list them.
    ///
    /// # Errors
    /// [`Error::Refused`] for a grid without start and goal, and for numbers of the variant beyond their range.
    pub fn new(grid: &Arc<GridScene>, settings: &Parameters, seed: u64, variant: Variant) -> Result<Self, Error> {
        variant.check()?;
        let bounds = [settings[TAU_MIN], settings[TAU_MAX]];
        let ground = Ground::new(grid, variant.heuristic, settings[BETA], variant.gamma, variant.direction)?;
        let cells = &ground.cells;
        let mut pheromone = Pheromone::new(cells, settings[TAU_0], settings[ALPHA], settings[RHO], bounds);
        if variant.seeded != 1.0
            && let Some(way) = exact::shortest_way(cells, ground.endpoints.start, ground.endpoints.goal)
        {
            for step in way.windows(2) {
                let direction = (0..8).find(|&d| cells.next(step[0], d) == step[1]).unwrap_or(0);
                pheromone.favour(&ground, step[0], direction, variant.seeded);
            }
        }
        let limit = match settings[STEP_LIMIT] {
            0 => 2 * cells.len() as u64,
            steps => steps,
        };
        Ok(Self {
            variant,
            rules: Rules { backtracks: settings[BACKTRACKS], limit },
            ants: settings[ANTS] as usize,
            q: settings[Q] * if variant.relative { ground.apart() } else { 1.0 },
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
            part: Part::default(),
            pheromone,
            ground: Arc::new(ground),
        })
    }

    /// The cells that the ants go over.
    pub fn cells(&self) -> &Cells {
        &self.ground.cells
    }

    /// τ of the step from a cell in one of the [`DIRECTIONS`](crate::geometry::DIRECTIONS).
    pub fn pheromone(&self, cell: usize, direction: usize) -> f64 {
        self.pheromone.tau(cell, direction)
    }

    /// The cells of the shortest path so far.
    pub fn path(&self) -> Option<Vec<usize>> {
        self.best.as_ref().map(|best| self.ground.way(&best.directions).collect())
    }

    /// The length of that path, in the scene's unit.
    pub fn length(&self) -> Option<f64> {
        self.best.as_ref().map(|best| best.length)
    }

    /// Whether any path leads from start to goal.
    pub fn is_reachable(&self) -> bool {
        self.ground.reachable
    }

    /// q0 of an iteration, counted from 0: it changes evenly over the run.
    pub(super) fn greed(&self, iteration: u64) -> f64 {
        let [from, to] = self.variant.greed;
        from + (to - from) * (iteration as f64 / (self.limit.max(2) - 1) as f64).min(1.0)
    }

    /// An iteration, or a part of it: all ants walk, one after another, then each lays pheromone. The iteration counts from its
    /// first ant on.
    pub(super) fn iterate(&mut self) -> Progress {
        if !self.part.is_under_way() {
            self.iteration += 1;
            self.walks.clear();
        }
        let mut left = Part::at_most(PORTION) as u64;
        while let Some(turn) = self.part.take(1, 2 * self.ants).next() {
            let steps = if turn < self.ants { self.send() } else { self.lay(turn - self.ants) };
            if turn + 1 == self.ants {
                self.judge();
                self.evaporate();
            }
            if !self.part.is_under_way() {
                break;
            }
            left = left.saturating_sub(steps);
            if left == 0 {
                return Progress::Partly;
            }
        }
        self.pheromone.settle();
        Progress::Continue
    }

    /// An ant walks: how many steps it takes.
    pub(super) fn send(&mut self) -> u64 {
        let (before, begun) = (self.walks.taken, self.rng.clone());
        let greed = self.greed(self.iteration - 1);
        walk(&self.ground, &mut self.pheromone, self.rules, greed, &mut self.seen, &mut self.rng, &mut self.walks);
        self.walks.forget(self.kept, begun);
        self.walks.taken - before
    }

    /// An ant's directions; one whose way was not kept goes it again. (The weights are those of its iteration until
    /// pheromone has settled.)
    pub(super) fn way(&mut self, i: usize) -> Vec<u8> {
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
    pub(super) fn judge(&mut self) {
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
    pub(super) fn mean(&self) -> f64 {
        let (sum, arrived) = self.walks.arrived().fold((0.0, 0), |(sum, n), ant| (sum + ant.length, n + 1));
        if arrived > 0 { sum / f64::from(arrived) } else { f64::NAN }
    }

    /// [ANTBAT](crate#papers) (4), [WOLF-ANT](crate#papers) (10): pheromone evaporates, and Δτ of each ant is computed.
    fn evaporate(&mut self) {
        self.pheromone.evaporate();
        if let Some(best) = self.best.as_ref().filter(|_| self.walks.leads_anywhere()) {
            update::lay(self.variant.update, self.q, best.length, &mut self.walks, &mut self.lengths);
        }
    }

    /// An ant that arrived lays pheromone. Returns how many steps that took: for an ant that goes its way again all of its walk, steps
    /// taken back included.
    pub(super) fn lay(&mut self, i: usize) -> u64 {
        let ant = &self.walks.ants[i];
        let (laid, kept) = (ant.laid, ant.again.is_none());
        if ant.end != End::Arrived {
            return 0;
        }
        if kept {
            let way = self.walks.of(ant);
            lay(&self.ground, &mut self.pheromone, way, laid);
            way.len() as u64
        } else {
            let before = self.again.taken;
            let way = self.way(i);
            lay(&self.ground, &mut self.pheromone, &way, laid);
            self.again.taken - before
        }
    }

    pub(super) fn count(&self, end: End) -> usize {
        self.walks.ants.iter().filter(|ant| ant.end == end).count()
    }
}

/// Adds to each step of a way.
pub(super) fn lay(ground: &Ground, pheromone: &mut Pheromone, way: &[u8], amount: f64) {
    let mut cell = ground.endpoints.start;
    for d in way.iter().map(|&d| usize::from(d)) {
        pheromone.lay(cell, d, amount);
        cell = ground.cells.next(cell, d);
    }
}
