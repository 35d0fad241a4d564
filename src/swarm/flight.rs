//! The swarm of [WCPSO](crate#papers): velocities, schedules, and (for some) hen and chick.

use std::{ops::Range, sync::Arc};

use crate::{
    kernel::{Candidate, Explain, Facets, Frame, Inspection, Item, Planner, Progress, Readings, Started, State, rng::Stream},
    math::clamp,
    message,
    params::Parameters,
};

use super::{
    clock::Clock,
    objective::Objective,
    parameters::{
        CHICKS, COGNITIVE, EVALUATIONS, FROM_TREES, HENS, K, OMEGA, PER_PARTICLE, POPULATION, SOCIAL, STAGNATING, V_MAX, V_MAX_ABSOLUTE,
    },
    perturbation::{self, Event, Keep, Partner, Patience, Perturbation, Timing},
    population::Population,
    schedule::{Coefficients, Schedule},
    sheet::introduce,
};

/// What distinguishes one swarm of [WCPSO](crate#papers) from another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flight {
    /// How ω, c1 and c2 change over the iterations.
    pub schedule: Schedule,
    /// What moves particles that stagnate; `None`: nothing.
    pub perturbation: Option<Perturbation>,
}

/// The random numbers of one particle's step: a pair r1, r2 for each coordinate, or one pair for all of them.
#[derive(Clone, Copy)]
struct Draws(Option<[f64; 2]>);

impl Draws {
    #[inline]
    fn begin(per_particle: bool, rng: &mut Stream) -> Self {
        Self(per_particle.then(|| [rng.unit(), rng.unit()]))
    }

    #[inline]
    fn next(self, rng: &mut Stream) -> [f64; 2] {
        self.0.unwrap_or_else(|| [rng.unit(), rng.unit()])
    }
}

/// A particle swarm: v ← ω v + c1 r1 (p − x) + c2 r2 (g − x), x ← x + v, [WCPSO](crate#papers) (1, 2) and (6, 7).
///
/// It is a [`Planner`] for any [`Objective`]: `Started::from(Swarm::new(…))` is a run of it.
#[derive(Clone, State)]
pub struct Swarm {
    pub(super) population: Population,
    /// Velocities v.
    pub(super) v: Vec<f64>,
    /// The most each coordinate of a velocity may be.
    #[state(shared)]
    v_max: Arc<[f64]>,
    /// One pair r1, r2 for a particle's step instead of one for each of its coordinates.
    #[state(shared)]
    per_particle: bool,
    /// Where a particle stood before the hen moved it, should the jump not count.
    #[state(skip)]
    held: Vec<f64>,
    /// What particles cost before they were evaluated.
    #[state(skip)]
    before: Vec<f64>,
    pub(super) patience: Vec<Patience>,
    /// What moved each particle in this iteration.
    pub(super) events: Vec<Event>,
    #[state(shared)]
    pub(super) flight: Flight,
    /// The coefficients of the step that led here (of the first step, before it).
    pub(super) coefficients: Coefficients,
    /// By how many extensions of a tree each particle's first path was found (`None`: it was drawn), where trees were grown.
    #[state(shared)]
    pub(super) origins: Option<Arc<[Option<u64>]>>,
    pub(super) rng: Stream,
    clock: Clock,
}

/// Rising cost this many times in a row counts as stagnating where no perturbation says otherwise.
const PATIENCE: u8 = 3;

impl Swarm {
    /// Positions as the objective draws them, velocities zero. It reads `population`, `iterations`, `early_stop` and
    /// [`FLIGHT`](super::FLIGHT): the entry has to list them, as that of every swarm does.
    pub fn new(objective: Arc<dyn Objective>, parameters: &Parameters, seed: u64, flight: Flight) -> Self {
        let mut rng = Stream::new(seed, 0);
        let population = Population::new(objective, parameters[POPULATION] as usize, &mut rng);
        Self::of(population, parameters, rng, flight)
    }

    /// Positions, costs and bests.
    pub fn population(&self) -> &Population {
        &self.population
    }

    /// The velocity of particle `i`.
    pub fn velocity(&self, i: usize) -> &[f64] {
        &self.v[self.population.row(i)]
    }

    /// ω, c1 and c2 of the step that led here.
    pub fn coefficients(&self) -> Coefficients {
        self.coefficients
    }

    /// Of particles that have their positions; velocities zero.
    pub(super) fn of(population: Population, settings: &Parameters, rng: Stream, flight: Flight) -> Self {
        let size = population.size;
        let v_max = settings[V_MAX];
        let absolute = settings[V_MAX_ABSOLUTE];
        let v_max = population.objective.search_box().sides().map(|side| if absolute { v_max } else { v_max * side }).collect();
        let clock = Clock::new(settings, population.bests());
        Self {
            v: vec![0.0; population.x.len()],
            v_max,
            per_particle: settings[PER_PARTICLE],
            held: vec![0.0; population.dimension],
            before: Vec::with_capacity(population.found.len()),
            patience: vec![Patience::default(); size],
            events: vec![Event::Move; size],
            flight,
            coefficients: flight.schedule.at(0, clock.limit),
            origins: None,
            rng,
            clock,
            population,
        }
    }

    /// An iteration, or a part of it. `watch` sees what happens to a particle that somebody asked about.
    pub(super) fn iterate(&mut self, watch: &mut dyn Watch) -> Progress {
        self.coefficients = self.flight.schedule.at(self.clock.iteration, self.clock.limit);
        let perturbation = self.flight.perturbation;
        let [instead, after] = [Timing::Instead, Timing::After].map(|timing| perturbation.filter(|p| p.timing == timing));
        let watched = watch.particle();
        let part = self.population.next_part(1);
        // Who flew and was not evaluated yet: nothing in a flight depends on what others found in this iteration.
        let mut flown = part.start;
        for i in part.clone() {
            if watched == Some(i) {
                self.evaluate_flown(flown..i);
                flown = i;
                watch.begins(self);
            }
            self.events[i] = instead.map_or(Event::Move, |p| self.patience[i].next(p.patience));
            if let (Event::Hen | Event::Chick, Some(perturbation)) = (self.events[i], instead) {
                self.evaluate_flown(flown..i);
                flown = i + 1;
                let before = self.population.cost[i];
                self.jump(i, perturbation, watched, watch);
                self.patience[i].note(before, self.population.cost[i]);
                continue;
            }
            if watched == Some(i) {
                self.fly(i, watch);
            } else {
                self.fly(i, &mut ());
            }
            if let Some(perturbation) = after {
                let before = self.population.cost[i];
                self.evaluate_flown(flown..i + 1);
                flown = i + 1;
                self.events[i] = self.patience[i].next(perturbation.patience);
                if self.events[i] != Event::Move {
                    self.jump(i, perturbation, watched, watch);
                    self.patience[i].after_hen &= self.population.cost[i] >= before;
                }
            }
        }
        self.evaluate_flown(flown..part.end);
        if self.population.is_under_way() {
            return Progress::Partly;
        }
        self.population.end(&mut self.clock)
    }

    /// Evaluates particles that flew, and counts whether their costs rise.
    fn evaluate_flown(&mut self, flown: Range<usize>) {
        self.before.clear();
        self.before.extend(&self.population.cost[flown.clone()]);
        self.population.evaluate_all(flown.clone());
        for (i, before) in flown.zip(&self.before) {
            self.patience[i].note(*before, self.population.cost[i]);
        }
    }

    /// (6) and (7). Reading: velocities are limited, positions are kept in the box, and a coordinate that hits a wall stops.
    #[inline]
    fn fly<W: Watch + ?Sized>(&mut self, i: usize, watch: &mut W) {
        let Coefficients { w, c1, c2 } = self.coefficients;
        let row = self.population.row(i);
        let n = row.len();
        let Population { x, p, g, objective, .. } = &mut self.population;
        let search_box = objective.search_box();
        // Slices of one known length: the loop below needs no bounds checks.
        let (x, v, p, g) = (&mut x[row.clone()], &mut self.v[row.clone()], &p[row], &g[..n]);
        let (low, high, v_max) = (&search_box.low()[..n], &search_box.high()[..n], &self.v_max[..n]);
        let draws = Draws::begin(self.per_particle, &mut self.rng);
        for j in 0..n {
            let [r1, r2] = draws.next(&mut self.rng);
            let (inertia, cognitive, social) = (w * v[j], c1 * r1 * (p[j] - x[j]), c2 * r2 * (g[j] - x[j]));
            let step = clamp(inertia + cognitive + social, -v_max[j], v_max[j]);
            watch.term(Term { r: [r1, r2], inertia, cognitive, social, step });
            let reached = x[j] + step;
            x[j] = clamp(reached, low[j], high[j]);
            v[j] = if x[j] == reached { step } else { 0.0 };
        }
    }

    /// Moves a stagnating particle by the equation that is due, and evaluates it.
    fn jump(&mut self, i: usize, perturbation: Perturbation, watched: Option<usize>, watch: &mut dyn Watch) {
        let nobody: &mut dyn Watch = &mut ();
        let watch = if watched == Some(i) { watch } else { nobody };
        let row = self.population.row(i);
        self.held.copy_from_slice(&self.population.x[row.clone()]);
        watch.leaves(&self.held);
        let before = self.population.cost[i];
        let hen = self.events[i] == Event::Hen;
        if hen {
            self.follow_hen(i, perturbation, watch);
        } else {
            self.follow_chick(i, perturbation.f_l, watch);
        }
        self.population.evaluate(i);
        if hen && perturbation.keep == Keep::Better && self.population.cost[i] >= before {
            watch.refused(&self.population.x[row.clone()]);
            self.population.x[row].copy_from_slice(&self.held);
            self.population.cost[i] = before;
        }
    }

    /// (9). Reading: the particle jumps instead of flying (or after it); its velocity stays. Another particle that comes
    /// earlier in the order has already moved.
    fn follow_hen(&mut self, i: usize, perturbation: Perturbation, watch: &mut dyn Watch) {
        let population = &mut self.population;
        let t = perturbation::other(i, population.size, &mut self.rng);
        let f_i = population.p_cost[i];
        let s1 = perturbation::s1(f_i, population.g_cost);
        let s2 = t.map_or(0.0, |t| perturbation::s2(perturbation.sign, f_i, population.p_cost[t]));
        watch.hen(t, [s1, s2]);
        let t = t.unwrap_or(i);
        let draws = Draws::begin(self.per_particle, &mut self.rng);
        for j in 0..population.dimension {
            let r = draws.next(&mut self.rng);
            let (at, from) = (population.row(i).start + j, population.row(t).start + j);
            let x_t = match perturbation.partner {
                Partner::Position => population.x[from],
                Partner::Best => population.p[from],
            };
            let x = perturbation::hen(population.x[at], population.g[j], x_t, [s1, s2], r);
            watch.jump(r, x_t);
            population.x[at] = population.objective.search_box().clamp(j, x);
        }
    }

    /// (12).
    fn follow_chick(&mut self, i: usize, f_l: f64, watch: &mut dyn Watch) {
        let population = &mut self.population;
        let row = population.row(i);
        for (j, x) in population.x[row].iter_mut().enumerate() {
            watch.jump([f_l, 0.0], 0.0);
            *x = population.objective.search_box().clamp(j, perturbation::chick(*x, population.g[j], f_l));
        }
    }

    fn count(&self, event: Event) -> f64 {
        self.events.iter().filter(|&&e| e == event).count() as f64
    }

    fn stagnating(&self) -> f64 {
        let patience = self.flight.perturbation.map_or(PATIENCE, |p| p.patience);
        self.patience.iter().filter(|p| p.worse >= patience).count() as f64
    }
}

/// One coordinate of a particle's flight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Term {
    /// r1 and r2.
    pub(super) r: [f64; 2],
    /// ω v
    pub(super) inertia: f64,
    /// c1 r1 (p − x)
    pub(super) cognitive: f64,
    /// c2 r2 (g − x)
    pub(super) social: f64,
    /// Their sum, limited.
    pub(super) step: f64,
}

/// Sees what a step does to one particle. `()` sees nothing and costs nothing.
pub(super) trait Watch {
    /// Which particle it watches.
    fn particle(&self) -> Option<usize> {
        None
    }
    /// It is about to be moved.
    fn begins(&mut self, _swarm: &mut Swarm) {}
    /// One coordinate of its flight.
    fn term(&mut self, _term: Term) {}
    /// The hen's other particle t, s1 and s2.
    fn hen(&mut self, _t: Option<usize>, _s: [f64; 2]) {}
    /// It is about to jump from here.
    fn leaves(&mut self, _x: &[f64]) {}
    /// One coordinate of a jump: its random numbers and what it takes from the other particle.
    fn jump(&mut self, _r: [f64; 2], _x_t: f64) {}
    /// It returns, because this position is not better.
    fn refused(&mut self, _x: &[f64]) {}
}

impl Watch for () {}

impl Planner for Swarm {
    fn advance(&mut self) -> Progress {
        self.iterate(&mut ())
    }

    fn evaluations(&self) -> u64 {
        self.population.evaluations
    }

    fn best(&self) -> Option<Candidate> {
        Some(self.population.best())
    }

    fn read(&self, out: &mut Readings) {
        let Coefficients { w, c1, c2 } = self.coefficients;
        self.population.read(out);
        out.push(K, self.clock.iteration.saturating_sub(1) as f64);
        out.push(OMEGA, w);
        out.push(COGNITIVE, c1);
        out.push(SOCIAL, c2);
        out.push(STAGNATING, self.stagnating());
        if self.flight.perturbation.is_some() {
            out.push(HENS, self.count(Event::Hen));
            out.push(CHICKS, self.count(Event::Chick));
        }
        if let Some(origins) = &self.origins {
            out.push(FROM_TREES, origins.iter().flatten().count() as f64);
        }
        out.push(EVALUATIONS, self.population.evaluations as f64);
    }

    fn draw(&self, frame: &mut Frame) {
        self.draw_layers(frame);
    }

    fn facets(&self) -> Facets<'_> {
        Facets::default().explain(self).failure(&self.population)
    }
}

impl From<Swarm> for Started {
    fn from(swarm: Swarm) -> Self {
        swarm.clock.start(swarm)
    }
}

impl Explain for Swarm {
    fn inspect(&self, item: Item) -> Option<Inspection> {
        if self.clock.iteration > 0 {
            return None;
        }
        let i = item.index;
        let extensions = self.origins.as_ref().and_then(|origins| *origins.get(i)?);
        let origin = if let Some(extensions) = extensions {
            message!(
                "swarm-begins-on-a-path",
                "Particle {i} begins here, on the path of a tree of {n} {extensions}; its velocity is zero.",
                i,
                n = extensions,
                extensions => "extension" | "extensions",
            )
        } else {
            message!("swarm-begins", "Particle {i} begins here, drawn at random; its velocity is zero.", i)
        };
        introduce(&self.population, item, origin)
    }

    fn explain_next(&self, item: Item) -> Option<Inspection> {
        self.explain_step(item, None)
    }

    fn suppose(&self, item: Item, supposition: &str, others: &Stream) -> Option<Inspection> {
        self.explain_step(item, Some((supposition, others)))
    }
}
