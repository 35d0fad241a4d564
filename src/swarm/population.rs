//! Positions, costs and bests: what every swarm has, whatever moves its particles.

use std::{ops::Range, sync::Arc};

use crate::{
    describe::{Layer, Reading, layers},
    kernel::{Candidate, Failure, Message, Part, Progress, Readings, State, Status, digits::Digits, rng::Stream},
    message,
};

use super::{
    clock::Clock,
    objective::{Evaluation, Objective, Scratch},
    parameters::{BEST, FREE, GUIDES, LENGTH, MEAN, SMOOTHED, SMOOTHNESS, SPREAD},
};

/// Particles in the box of an objective: positions, costs, personal bests and the global best, whatever moves the particles.
///
/// A swarm that moves in its own way keeps one: it moves the particles of [`Population::next_part`] by [`Population::position_mut`],
/// evaluates each, and settles once in an iteration. Its entry lists [`Population::READINGS`] and [`Population::LAYERS`].
// Particle `i`'s coordinates are the `i`-th row of `dimension` numbers.
#[derive(Clone, State)]
pub struct Population {
    #[state(shared)]
    pub(super) objective: Arc<dyn Objective>,
    #[state(skip)]
    scratch: Scratch,
    /// What was evaluated at once.
    #[state(skip)]
    pub(super) found: Vec<Evaluation>,
    /// The first position whose cost the objective refused, which ends the run.
    #[state(shared)]
    refused: Option<Box<Refused>>,
    #[state(shared)]
    pub(super) size: usize,
    #[state(shared)]
    pub(super) dimension: usize,
    /// Positions x.
    pub(super) x: Vec<f64>,
    /// Their costs f(x).
    pub(super) cost: Vec<f64>,
    /// Personal bests p.
    pub(super) p: Vec<f64>,
    /// Their costs.
    pub(super) p_cost: Vec<f64>,
    /// The global best g, as it was when the last iteration ended.
    pub(super) g: Vec<f64>,
    /// Its cost.
    pub(super) g_cost: f64,
    /// The cheapest position that violates nothing that was ever evaluated, and its cost (infinite: none yet).
    ///
    /// The swarm follows `g`, as published; but close to the optimum `g` often cuts a disc by a hair, because the
    /// penalty is finite. What is reported is this one, so that a collision-free path that was found is never lost.
    pub(super) free: Vec<f64>,
    pub(super) free_cost: f64,
    pub(super) evaluations: u64,
    #[state(skip)]
    part: Part,
}

/// So many coordinates are moved and evaluated in a part of a step.
const PORTION: usize = 20_000;
/// So many particles are that at most.
fn portion(size: usize, dimension: usize) -> usize {
    size.min(PORTION / dimension.max(1)).max(1)
}
/// How often particles are drawn anew in all: where no path is free, a big swarm must begin all the same.
const MOST_REDRAWS: u64 = 20_000;

impl Population {
    /// The readings that [`Population::read`] adds; the last three only where positions are paths.
    pub const READINGS: &'static [Reading] = &[BEST, MEAN, SPREAD, FREE, LENGTH, SMOOTHNESS];

    /// The layers that [`Population::draw_members`] and [`Population::draw_result`] draw.
    pub const LAYERS: &'static [Layer] = &[GUIDES, layers::PERSONAL_BESTS, layers::PARTICLES, layers::BEST, SMOOTHED];

    /// So many positions (one at least) as the objective draws them, evaluated.
    pub fn new(objective: Arc<dyn Objective>, size: usize, rng: &mut Stream) -> Self {
        Self::begun(objective, size, rng, |_, _, _| false)
    }

    /// Positions that `first` writes for a particle; where it says that it wrote none, one that the objective draws.
    pub(super) fn begun(
        objective: Arc<dyn Objective>,
        size: usize,
        rng: &mut Stream,
        mut first: impl FnMut(usize, &mut [f64], &mut Stream) -> bool,
    ) -> Self {
        let (size, dimension) = (size.max(1), objective.search_box().dimension());
        let mut population = Self {
            objective,
            scratch: Scratch::default(),
            found: vec![Evaluation::from(0.0); portion(size, dimension)],
            refused: None,
            size,
            dimension,
            p: vec![0.0; size * dimension],
            x: vec![0.0; size * dimension],
            cost: vec![f64::INFINITY; size],
            p_cost: vec![f64::INFINITY; size],
            g: vec![0.0; dimension],
            g_cost: f64::INFINITY,
            free: vec![0.0; dimension],
            free_cost: f64::INFINITY,
            evaluations: 0,
            part: Part::default(),
        };
        let mut left = MOST_REDRAWS;
        let redraws = population.objective.redraws() > 0;
        for i in 0..size {
            let row = population.row(i);
            match (first(i, &mut population.x[row.clone()], rng), redraws) {
                (true, true) => drop(population.evaluate(i)),
                (false, true) => population.draw_particle(i, rng, &mut left),
                (true, false) => {}
                (false, false) => population.objective.draw(&mut population.x[row], rng),
            }
        }
        if !redraws {
            population.evaluate_all(0..size);
        }
        // Where no cost is a number, bests are positions all the same.
        for i in (0..size).filter(|&i| population.p_cost[i] == f64::INFINITY) {
            let row = population.row(i);
            population.p[row.clone()].copy_from_slice(&population.x[row]);
        }
        population.g.copy_from_slice(&population.p[..dimension]);
        population.settle();
        population
    }

    /// What the positions mean and cost.
    pub fn objective(&self) -> &dyn Objective {
        &*self.objective
    }

    /// How many particles.
    pub fn size(&self) -> usize {
        self.size
    }

    /// Where particle `i` is.
    pub fn position(&self, i: usize) -> &[f64] {
        &self.x[self.row(i)]
    }

    /// The same, to move it; [`Population::evaluate`] comes next. It should stay in the search box.
    pub fn position_mut(&mut self, i: usize) -> &mut [f64] {
        let row = self.row(i);
        &mut self.x[row]
    }

    /// What particle `i`'s position costs.
    pub fn cost(&self, i: usize) -> f64 {
        self.cost[i]
    }

    /// Particle `i`'s personal best and its cost.
    pub fn personal_best(&self, i: usize) -> (&[f64], f64) {
        (&self.p[self.row(i)], self.p_cost[i])
    }

    /// The global best, as it was when the last iteration ended, and its cost.
    pub fn global_best(&self) -> (&[f64], f64) {
        (&self.g, self.g_cost)
    }

    /// How many positions were evaluated.
    pub fn evaluations(&self) -> u64 {
        self.evaluations
    }

    /// Draws particle `i` and evaluates it; while it violates a constraint, a few times anew, if any are `left`.
    fn draw_particle(&mut self, i: usize, rng: &mut Stream, left: &mut u64) {
        let row = self.row(i);
        for attempt in 0..=self.objective.redraws() {
            *left = left.saturating_sub(u64::from(attempt > 0));
            self.objective.draw(&mut self.x[row.clone()], rng);
            // A draw that is given up leaves no personal best behind.
            self.p_cost[i] = f64::INFINITY;
            if self.evaluate(i) == 0.0 || *left == 0 {
                break;
            }
        }
    }

    /// Where particle `i`'s row lies.
    #[inline]
    pub(super) fn row(&self, i: usize) -> Range<usize> {
        i * self.dimension..(i + 1) * self.dimension
    }

    /// Evaluates particle `i` where it is now, keeps its personal best and returns how much it violates.
    #[inline]
    pub fn evaluate(&mut self, i: usize) -> f64 {
        let found = self.objective.evaluate(&self.x[self.row(i)], &mut self.scratch);
        self.note(i, found);
        found.violation
    }

    /// Evaluates these particles where they are now, all at once, and keeps their personal bests: the same as one after the other, and faster
    /// for some objectives.
    pub fn evaluate_all(&mut self, of: Range<usize>) {
        let most = self.found.len();
        for first in of.clone().step_by(most) {
            let after = of.end.min(first + most);
            let rows = first * self.dimension..after * self.dimension;
            self.objective.evaluate_all(&self.x[rows], &mut self.scratch, &mut self.found[..after - first]);
            (first..after).for_each(|i| self.note(i, self.found[i - first]));
        }
    }

    /// What particle `i`'s position came to.
    #[inline]
    fn note(&mut self, i: usize, found: Evaluation) {
        let row = self.row(i);
        self.evaluations += 1;
        self.cost[i] = found.cost;
        if found.cost < self.p_cost[i] {
            self.p_cost[i] = found.cost;
            self.p[row.clone()].copy_from_slice(&self.x[row.clone()]);
        }
        if found.violation == 0.0 && found.cost < self.free_cost {
            self.free_cost = found.cost;
            self.free.copy_from_slice(&self.x[row]);
        }
        if !found.cost.is_finite() {
            self.refuse(i);
        }
    }

    /// A cost that is no number, or infinite.
    #[cold]
    fn refuse(&mut self, i: usize) {
        if self.refused.is_none()
            && let Some(why) = self.objective.refuses(self.cost[i])
        {
            self.refused = Some(Box::new(Refused { at: self.x[self.row(i)].to_vec(), why }));
        }
    }

    /// Which particles are moved next, in passes over all of them: all, or as many as can be waited for. See [`Part`].
    pub fn next_part(&mut self, passes: usize) -> Range<usize> {
        self.part.take(PORTION / self.dimension.max(1), passes * self.size)
    }

    /// Whether some particles of an iteration are moved and others are not yet.
    pub fn is_under_way(&self) -> bool {
        self.part.is_under_way()
    }

    /// Ends an iteration: the best personal best becomes the global best; the first of equals wins.
    pub fn settle(&mut self) {
        let mut best = None;
        for (i, &cost) in self.p_cost.iter().enumerate() {
            if cost < self.g_cost {
                self.g_cost = cost;
                best = Some(i);
            }
        }
        if let Some(i) = best {
            let row = self.row(i);
            self.g.copy_from_slice(&self.p[row]);
        }
    }

    /// Whether the run can go on: not after a cost that the objective refuses.
    pub fn progress(&self) -> Progress {
        if self.refused.is_none() { Progress::Continue } else { Progress::Done(Status::Failed) }
    }

    /// Ends an iteration of a run that stops by this clock.
    pub(super) fn end(&mut self, clock: &mut Clock) -> Progress {
        self.settle();
        let progress = clock.tick(self.bests());
        if self.refused.is_none() { progress } else { self.progress() }
    }

    /// The position that is reported, with its cost: the cheapest without penalty, or else the cheapest.
    pub(super) fn reported(&self) -> (f64, &[f64]) {
        if self.free_cost < f64::INFINITY { (self.free_cost, &self.free) } else { (self.g_cost, &self.g) }
    }

    /// The best position of all that violate nothing, or, if there is none, the global best.
    pub fn best(&self) -> Candidate {
        let (cost, x) = self.reported();
        Candidate { cost, solution: self.objective.solution(x) }
    }

    /// The mean cost of the present positions.
    pub(super) fn mean(&self) -> f64 {
        self.cost.iter().sum::<f64>() / self.size as f64
    }

    /// How far the particles are apart: the mean over the coordinates of their standard deviation, as a share of the box.
    fn spread(&self) -> f64 {
        // A side without length has no spread.
        let share = |(j, side): (usize, f64)| deviation(column(&self.x, self.dimension, j)) / side.max(f64::MIN_POSITIVE);
        self.objective.search_box().sides().enumerate().map(share).sum::<f64>() / self.dimension as f64
    }

    /// The best costs so far: with penalty, and of what breaks no rule.
    pub(super) fn bests(&self) -> [f64; 2] {
        [self.g_cost, self.free_cost]
    }

    /// Adds the costs, and what the reported path measures.
    pub fn read(&self, out: &mut Readings) {
        out.push(BEST, self.g_cost);
        out.push(MEAN, self.mean());
        out.push(SPREAD, self.spread());
        if self.objective.constrained() {
            out.push(FREE, if self.free_cost.is_finite() { self.free_cost } else { f64::NAN });
        }
        self.objective.read(self.reported().1, out);
    }
}

/// Where particles of a part of a step were before they moved, should they return.
#[derive(Debug, Clone, State)]
pub(super) struct Held {
    first: usize,
    x: Vec<f64>,
    cost: Vec<f64>,
}

impl Held {
    pub(super) fn new(population: &Population) -> Self {
        let most = population.found.len();
        Self { first: 0, x: Vec::with_capacity(most * population.dimension), cost: Vec::with_capacity(most) }
    }

    pub(super) fn hold(&mut self, population: &Population, particles: Range<usize>) {
        self.first = particles.start;
        self.x.clear();
        self.x.extend_from_slice(&population.x[particles.start * population.dimension..particles.end * population.dimension]);
        self.cost.clear();
        self.cost.extend_from_slice(&population.cost[particles]);
    }

    /// What particle `i`'s position cost.
    pub(super) fn cost(&self, i: usize) -> f64 {
        self.cost[i - self.first]
    }

    pub(super) fn put_back(&self, population: &mut Population, i: usize) {
        let (row, at) = (population.row(i), (i - self.first) * population.dimension);
        population.x[row].copy_from_slice(&self.x[at..at + population.dimension]);
        population.cost[i] = self.cost(i);
    }
}

/// A position whose cost was refused. What follows from the cost, which is hashed, is not hashed again.
#[derive(Debug, Clone)]
struct Refused {
    at: Vec<f64>,
    why: Message,
}

/// So many coordinates of a position are said.
const SAID: usize = 6;

impl Failure for Population {
    fn failure(&self, _status: Status) -> Option<Message> {
        let Refused { at, why } = &**self.refused.as_ref()?;
        let mut position: Vec<_> = at.iter().take(SAID).map(|x| Digits(*x).to_string()).collect();
        position.extend((at.len() > SAID).then(|| "…".to_owned()));
        let (position, why) = (position.join(", "), why.clone());
        Some(message!("swarm-refused", "{why}, at ({position})", why, position))
    }

    fn failed_at(&self) -> Option<&[f64]> {
        self.refused.as_ref().map(|refused| &*refused.at)
    }
}

/// The standard deviation over the particles.
pub(super) fn deviation<'a>(numbers: impl Iterator<Item = &'a f64> + Clone) -> f64 {
    let (count, sum) = numbers.clone().fold((0.0, 0.0), |(count, sum), x| (count + 1.0, sum + x));
    let mean = sum / count;
    (numbers.map(|x| (x - mean) * (x - mean)).sum::<f64>() / count).sqrt()
}

/// Coordinate `j` of all rows.
pub(super) fn column(rows: &[f64], dimension: usize, j: usize) -> impl Iterator<Item = &f64> + Clone {
    rows[j..].iter().step_by(dimension)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Overrides, params::Parameters, shipped, swarm::encoding};

    #[test]
    fn a_deviation_is_that_of_a_population() {
        // σ of 2, 4, 4, 4, 5, 5, 7, 9 is 2.
        assert_eq!(deviation([2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0].iter()), 2.0);
        assert_eq!(column(&[1.0, 10.0, 2.0, 20.0, 6.0, 60.0], 2, 1).copied().collect::<Vec<_>>(), [10.0, 20.0, 60.0]);
    }

    /// Of the particles whose personal best is lowest the first one wins; one as good as the global best does not.
    #[test]
    fn the_first_of_the_lowest_personal_bests_becomes_the_global_best() {
        let scene = shipped("sphere-2").unwrap();
        let settings = Parameters::new(crate::swarm::pso::ENTRY.parameters, scene.kind(), &Overrides::new()).unwrap();
        let mut population = Population::new(encoding::objective(&scene, &settings).unwrap(), 3, &mut Stream::new(1, 0));
        population.p = vec![1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
        population.p_cost = vec![7.0, 0.5, 0.5];
        population.settle();
        assert_eq!(population.global_best(), (&[3.0, 4.0][..], 0.5));
        assert_eq!(population.personal_best(0), (&[1.0, 2.0][..], 7.0));
        population.p[4] = 8.0;
        population.settle();
        assert_eq!(population.global_best(), (&[3.0, 4.0][..], 0.5));
    }

    /// Two particles in the box from −100 to 100: 2, 6 and −10, 30 have deviations of 2 and 20.
    #[test]
    fn the_spread_is_the_mean_deviation_as_a_share_of_the_box() {
        let scene = shipped("sphere-2").unwrap();
        let settings = Parameters::new(crate::swarm::pso::ENTRY.parameters, scene.kind(), &Overrides::new()).unwrap();
        let mut population = Population::new(encoding::objective(&scene, &settings).unwrap(), 2, &mut Stream::new(1, 0));
        let search_box = population.objective.search_box();
        assert_eq!((search_box.low()[0], search_box.high()[1]), (-100.0, 100.0));
        population.x = vec![2.0, -10.0, 6.0, 30.0];
        assert!((population.spread() - f64::midpoint(2.0 / 200.0, 20.0 / 200.0)).abs() < 1e-15, "{}", population.spread());
    }
}
