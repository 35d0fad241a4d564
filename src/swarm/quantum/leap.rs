//! The quantum swarm: its state, and what it does in an iteration.

use std::sync::Arc;

use crate::{
    kernel::{Progress, State, rng::Stream},
    math,
    params::Parameters,
    swarm::{
        clock::Clock,
        objective::Objective,
        population::{Population, column, deviation},
        schedule::Law,
    },
};

use super::parameters::{ALPHA_END, ALPHA_START, C1, C2, POPULATION};

/// What `ltqpso` adds to the leap. Each part can be switched off.
#[derive(Debug, Clone, Copy)]
pub(super) struct Adaptation {
    /// Whether evolution speed scales the pull, (5) and (7).
    pub(super) evolution: bool,
    /// The largest dispersion gs of (6); `None`: gs is 1.
    pub(super) most_dispersion: Option<f64>,
    /// Whether natural selection follows.
    pub(super) selection: bool,
}

/// A swarm that leaps: X ← p ± α gs |m − X| ln(1/u).
#[derive(Clone, State)]
pub(super) struct Quantum {
    pub(super) population: Population,
    /// c1 and c2 of (22).
    #[state(shared)]
    pub(super) c: [f64; 2],
    #[state(shared)]
    alpha: Law,
    /// Evolution speed, dispersion and natural selection, (5)–(9).
    #[state(shared)]
    pub(super) adaptive: Option<Adaptation>,
    /// α of the step that led here (of the first step, before it).
    pub(super) width: f64,
    /// Evolution speed of each particle, (5); 1 without it.
    pub(super) ip: Vec<f64>,
    /// Dispersion of each coordinate, (6); 1 without it.
    pub(super) gs: Vec<f64>,
    /// Mean best, (8).
    pub(super) m: Vec<f64>,
    /// Each particle's local attractor, (7).
    pub(super) attractors: Vec<f64>,
    /// Whose position each particle got by natural selection.
    pub(super) replaced: Vec<Option<u32>>,
    /// Particles by cost; scratch space.
    #[state(skip)]
    order: Vec<(f64, usize)>,
    pub(super) rng: Stream,
    pub(super) clock: Clock,
}

/// What was drawn for a coordinate, and where it led.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Leap {
    pub(super) r: [f64; 2],
    pub(super) phi: f64,
    pub(super) u: f64,
    /// 1 or −1.
    pub(super) sign: f64,
    /// Where it landed, kept in the box.
    pub(super) to: f64,
}

/// Sees a particle's leap. `()` sees nothing and costs nothing.
pub(super) trait Watch {
    /// Which one it watches.
    fn particle(&self) -> Option<usize> {
        None
    }
    /// It is about to leap.
    fn begins(&mut self, _swarm: &mut Quantum) {}
    fn leap(&mut self, _leap: Leap) {}
}

impl Watch for () {}

impl Quantum {
    /// Particles where the objective draws them.
    pub(super) fn new(objective: Arc<dyn Objective>, settings: &Parameters, seed: u64, adaptive: Option<Adaptation>) -> Self {
        let mut rng = Stream::new(seed, 0);
        let population = Population::new(objective, settings[POPULATION] as usize, &mut rng);
        let (size, dimension) = (population.size, population.dimension);
        let mut swarm = Self {
            c: [settings[C1], settings[C2]],
            alpha: Law::Linear(settings[ALPHA_START], settings[ALPHA_END]),
            adaptive,
            width: settings[ALPHA_START],
            ip: vec![1.0; size],
            gs: vec![1.0; dimension],
            m: vec![0.0; dimension],
            attractors: population.p.clone(),
            replaced: vec![None; size],
            order: Vec::with_capacity(size),
            rng,
            clock: Clock::new(settings, population.bests()),
            population,
        };
        swarm.prepare();
        swarm
    }

    /// One iteration. `watch` sees what happens to a particle that somebody asked about.
    pub(super) fn iterate(&mut self, watch: &mut dyn Watch) -> Progress {
        let watched = watch.particle();
        if !self.population.is_under_way() {
            self.width = self.alpha.at(self.clock.iteration, self.clock.limit);
            self.prepare();
        }
        let part = self.population.next_part(1);
        for i in part.clone() {
            if watched == Some(i) {
                watch.begins(self);
                self.leap(i, watch);
            } else {
                self.leap(i, &mut ());
            }
        }
        self.population.evaluate_all(part);
        if self.population.is_under_way() {
            return Progress::Partly;
        }
        let progress = self.population.end(&mut self.clock);
        if self.adaptive.is_some_and(|parts| parts.selection) {
            self.select();
        }
        progress
    }

    /// What is the same for all particles of an iteration: mean best, evolution speed, dispersion.
    fn prepare(&mut self) {
        let population = &self.population;
        mean(&population.p, &mut self.m);
        let Some(Adaptation { evolution, most_dispersion, .. }) = self.adaptive else { return };
        if evolution {
            self.ip.iter_mut().zip(&population.p_cost).for_each(|(ip, &cost)| *ip = evolution_speed(population.g_cost, cost));
        }
        if let Some(most) = most_dispersion {
            for (j, gs) in self.gs.iter_mut().enumerate() {
                *gs = dispersion(column(&population.p, population.dimension, j), column(&population.x, population.dimension, j)).min(most);
            }
        }
    }

    /// (7) and (9), or with ip = gs = 1 (4) and (1). Reading: positions are kept in the box, [LTQPSO](crate#papers) §4 (8).
    #[inline]
    fn leap<W: Watch + ?Sized>(&mut self, i: usize, watch: &mut W) {
        let [c1, c2] = self.c;
        let (ip, alpha) = (self.ip[i], self.width);
        let row = self.population.row(i);
        let n = row.len();
        let Population { x, p, g, objective, .. } = &mut self.population;
        let search_box = objective.search_box();
        let (x, p, attractors) = (&mut x[row.clone()], &p[row.clone()], &mut self.attractors[row]);
        let (g, m, gs, low, high) = (&g[..n], &self.m[..n], &self.gs[..n], &search_box.low()[..n], &search_box.high()[..n]);
        for j in 0..n {
            let r = [self.rng.positive_unit(), self.rng.positive_unit()];
            let phi = c1 * r[0] / (c1 * r[0] + c2 * r[1]);
            attractors[j] = g[j] + phi * ip * (p[j] - g[j]);
            let u = self.rng.positive_unit();
            let sign = if self.rng.unit() < 0.5 { 1.0 } else { -1.0 };
            let reached = attractors[j] + sign * (alpha * gs[j] * (m[j] - x[j]).abs() * -math::ln(u));
            x[j] = math::clamp(reached, low[j], high[j]);
            watch.leap(Leap { r, phi, u, sign, to: x[j] });
        }
    }

    /// Natural selection: the best half's positions overwrite the worst half's, in the order of their costs. Each keeps
    /// its own personal best. Reading: in an odd population the middle one is left alone.
    fn select(&mut self) {
        let Population { x, cost, size, dimension, .. } = &mut self.population;
        self.order.clear();
        self.order.extend(cost.iter().copied().zip(0..));
        math::sort(&mut self.order);
        self.replaced.fill(None);
        let half = *size / 2;
        for k in 0..half {
            let (from, to) = (self.order[k].1, self.order[*size - half + k].1);
            x.copy_within(from * *dimension..(from + 1) * *dimension, to * *dimension);
            cost[to] = cost[from];
            self.replaced[to] = Some(from as u32);
        }
    }
}

/// ip = F(G) / F(P), (5): how far a personal best is from the global best's cost. Reading: a zero denominator gives 1,
/// and costs that are not positive are kept in 0..1.
fn evolution_speed(global: f64, personal: f64) -> f64 {
    if personal == 0.0 { 1.0 } else { math::clamp(global / personal, 0.0, 1.0) }
}

/// gs = σ(P) / σ(X), (6): how scattered the personal bests are compared with the positions, in one coordinate. Reading: a zero
/// denominator gives 1.
fn dispersion<'a>(p: impl Iterator<Item = &'a f64> + Clone, x: impl Iterator<Item = &'a f64> + Clone) -> f64 {
    let around = deviation(x);
    if around == 0.0 { 1.0 } else { deviation(p) / around }
}

/// m_j = the mean of coordinate j over all rows, (8).
fn mean(rows: &[f64], m: &mut [f64]) {
    m.fill(0.0);
    for row in rows.chunks_exact(m.len()) {
        m.iter_mut().zip(row).for_each(|(m, x)| *m += x);
    }
    let count = (rows.len() / m.len()) as f64;
    m.iter_mut().for_each(|m| *m /= count);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::swarm::{
        encoding,
        quantum::{ltqpso, qpso},
    };

    #[test]
    fn evolution_speed_is_the_ratio_of_costs_5() {
        assert_eq!(evolution_speed(2.0, 8.0), 0.25);
        assert_eq!(evolution_speed(2.0, 2.0), 1.0);
        assert_eq!(evolution_speed(0.0, 3.0), 0.0);
        assert_eq!(evolution_speed(0.0, 0.0), 1.0, "reading: a zero denominator");
        assert_eq!(evolution_speed(-4.0, -2.0), 1.0, "reading: negative costs");
    }

    #[test]
    fn dispersion_is_the_ratio_of_deviations_6() {
        // σ of 1, 3 is 1; of 0, 8 it is 4.
        assert_eq!(dispersion([1.0, 3.0].iter(), [0.0, 8.0].iter()), 0.25);
        assert_eq!(dispersion([0.0, 8.0].iter(), [1.0, 3.0].iter()), 4.0);
        assert_eq!(dispersion([1.0, 3.0].iter(), [5.0, 5.0].iter()), 1.0, "reading: a zero denominator");
        assert_eq!(dispersion([1.0].iter(), [5.0].iter()), 1.0);
    }

    #[test]
    fn mean_best_is_the_mean_of_each_coordinate_8() {
        let mut m = [9.0; 2];
        mean(&[1.0, 10.0, 2.0, 20.0, 6.0, 60.0], &mut m);
        assert_eq!(m, [3.0, 30.0]);
    }

    /// `parts`: the planner is ltqpso, with these parameters.
    fn swarm(population: f64, parts: Option<&[(&str, &str)]>) -> Quantum {
        let entry = if parts.is_some() { ltqpso::ENTRY } else { qpso::ENTRY };
        let scene = crate::shipped("sphere").unwrap();
        let mut given: crate::Overrides = [("population", population.into())].into_iter().collect();
        parts.into_iter().flatten().for_each(|&(name, value)| given.insert(name, value.into()));
        let settings = Parameters::new(entry.parameters, scene.kind(), &given).unwrap();
        let objective = encoding::objective(&scene, &settings).unwrap();
        Quantum::new(objective, &settings, 4, parts.map(|_| ltqpso::adaptation(&settings)))
    }

    /// (22), (7) and (9) with the numbers that were drawn, by hand.
    #[test]
    fn a_leap_lands_where_9_says() {
        #[derive(Default)]
        struct Seen(Vec<Leap>);
        impl Watch for Seen {
            fn particle(&self) -> Option<usize> {
                Some(3)
            }
            fn leap(&mut self, leap: Leap) {
                self.0.push(leap);
            }
        }
        // qpso, and ltqpso with its parts, without a cap of gs, and without each part.
        let uncapped: &[_] = &[("dispersion", "uncapped")];
        let without: &[_] = &[("evolution", "false"), ("dispersion", "off"), ("selection", "false")];
        for (parts, evolves, most) in [
            (None, false, None),
            (Some(&[][..]), true, Some(1.0)),
            (Some(uncapped), true, Some(f64::INFINITY)),
            (Some(&[("evolution", "false")]), false, Some(1.0)),
            (Some(without), false, None),
        ] {
            let mut swarm = swarm(6.0, parts);
            swarm.iterate(&mut ());
            let before = swarm.clone();
            let mut seen = Seen::default();
            swarm.iterate(&mut seen);
            let Population { x, p, g, p_cost, g_cost, .. } = &before.population;
            let row = before.population.row(3);
            let alpha = 1.0 - 0.5 * (1.0 / before.clock.limit as f64);
            let ip = if evolves { g_cost / p_cost[3] } else { 1.0 };
            for (j, leap) in seen.0.iter().enumerate() {
                let at = row.start + j;
                let phi = 2.0 * leap.r[0] / (2.0 * leap.r[0] + 2.1 * leap.r[1]);
                let attractor = g[j] + phi * ip * (p[at] - g[j]);
                let of = |rows: &[f64]| (0..6).map(|i| rows[i * 10 + j]).collect::<Vec<_>>();
                let sigma = |v: Vec<f64>| {
                    let mean = v.iter().sum::<f64>() / 6.0;
                    (v.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / 6.0).sqrt()
                };
                let m = of(p).iter().sum::<f64>() / 6.0;
                let gs = most.map_or(1.0, |most| (sigma(of(p)) / sigma(of(x))).min(most));
                let to = attractor + leap.sign * alpha * gs * (m - x[at]).abs() * math::ln(1.0 / leap.u);
                assert!((leap.to - to.clamp(-100.0, 100.0)).abs() < 1e-9, "{} is not {to}", leap.to);
                assert!((swarm.attractors[at] - attractor).abs() < 1e-9);
            }
            assert_eq!(seen.0.len(), 10);
            let selects = parts.is_some_and(|parts| parts != without);
            assert_eq!(swarm.replaced.iter().flatten().count(), if selects { 3 } else { 0 });
        }
    }

    #[test]
    fn the_best_half_overwrites_the_worst_half_and_bests_stay() {
        for size in [1.0, 2.0, 7.0, 8.0] {
            let mut swarm = swarm(size, Some(&[]));
            let n = size as usize;
            swarm.population.cost = (0..n).map(|i| ((i * 5) % n) as f64).collect();
            let before = swarm.population.clone();
            swarm.select();
            let after = &swarm.population;
            assert_eq!((&after.p, &after.p_cost, &after.g), (&before.p, &before.p_cost, &before.g));
            for i in 0..n {
                let rank = (i * 5) % n;
                let source = if rank < n.div_ceil(2) { rank } else { rank - n.div_ceil(2) };
                let from = (0..n).find(|&k| (k * 5) % n == source).unwrap();
                assert_eq!(after.x[after.row(i)], before.x[before.row(from)], "particle {i} of {n}");
                assert_eq!(after.cost[i], before.cost[from]);
                assert_eq!(swarm.replaced[i], (from != i).then_some(from as u32));
            }
        }
    }
}
