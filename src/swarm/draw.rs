//! What a swarm looks like: its particles (points, or the paths they stand for), their bests, and who was perturbed.

use crate::{
    describe::layers,
    kernel::{Frame, LayerKey, Shape},
    math,
};

use super::{flight::Swarm, perturbation::Event, population::Population};

/// Personal bests and velocities are context: they get this share of a layer's budget.
pub(super) const CONTEXT: usize = 4;

impl Swarm {
    pub(super) fn draw_layers(&self, frame: &mut Frame) {
        let population = &self.population;
        population.draw_members(frame);
        let perturbed = [(layers::HENS.key, Event::Hen), (layers::CHICKS.key, Event::Chick)];
        for (layer, event) in perturbed.into_iter().filter(|_| self.flight.perturbation.is_some()) {
            population.draw(frame, layer, &population.x, &|i| self.events[i] == event, &|_| 0.0, 1);
        }
        population.draw_velocities(frame, &self.v);
        population.draw_result(frame);
    }
}

impl Population {
    /// How to shade a particle: 0 the best of the moment, towards 1 the worse it is; the mean cost gives 0.63.
    fn weights(&self) -> impl Fn(usize) -> f64 {
        let least = self.cost.iter().copied().fold(f64::INFINITY, f64::min);
        let scale = (self.mean() - least).max(f64::MIN_POSITIVE);
        move |i| 1.0 - math::exp((least - self.cost[i]) / scale)
    }

    /// Draws what the positions lie on, the personal bests and the particles.
    pub fn draw_members(&self, frame: &mut Frame) {
        self.objective.draw_guides(frame);
        self.draw(frame, layers::PERSONAL_BESTS.key, &self.p, &|_| true, &|_| 0.0, CONTEXT);
        self.draw(frame, layers::PARTICLES.key, &self.x, &|_| true, &self.weights(), 1);
    }

    /// The same where each particle is its own personal best.
    pub(super) fn draw_particles(&self, frame: &mut Frame) {
        self.objective.draw_guides(frame);
        self.draw(frame, layers::PARTICLES.key, &self.x, &|_| true, &self.weights(), 1);
    }

    /// Draws the result, and what becomes of it.
    pub fn draw_result(&self, frame: &mut Frame) {
        let (_, best) = self.reported();
        self.draw_one(frame, layers::BEST.key, best, 0.0);
        self.objective.draw_result(best, frame);
    }

    /// Draws the chosen rows: all points in one span, or a polyline each. The first piece drawn is always row 0.
    pub(super) fn draw(
        &self,
        frame: &mut Frame,
        layer: LayerKey,
        rows: &[f64],
        chosen: &dyn Fn(usize) -> bool,
        weight: &dyn Fn(usize) -> f64,
        share: usize,
    ) {
        let lines = self.objective.ends().is_some();
        let vertices = self.objective.point_count() + if lines { 2 } else { 0 };
        let every =
            if share == 1 { frame.thin(self.size, vertices, lines) } else { frame.thin_context(self.size * share, vertices, lines) };
        if !lines {
            frame.begin(layer, Shape::Points);
        }
        for i in (0..self.size).step_by(every).filter(|&i| chosen(i)) {
            if lines {
                self.draw_one(frame, layer, &rows[self.row(i)], weight(i));
            } else {
                self.objective.points(&rows[self.row(i)]).for_each(|point| frame.push(point, weight(i)));
            }
        }
    }

    /// Draws the velocities `v` from where the particles are.
    pub(super) fn draw_velocities(&self, frame: &mut Frame, v: &[f64]) {
        let every = frame.thin_context(self.size * CONTEXT, 2 * self.objective.point_count(), true);
        frame.begin(layers::VELOCITIES.key, Shape::Segments);
        let mut tip = vec![0.0; self.dimension];
        for i in (0..self.size).step_by(every) {
            let (x, v) = (&self.x[self.row(i)], &v[self.row(i)]);
            tip.iter_mut().zip(x).zip(v).for_each(|((tip, x), v)| *tip = x + v);
            for (from, to) in self.objective.points(x).zip(self.objective.points(&tip)) {
                frame.push(from, 0.0);
                frame.push(to, 0.0);
            }
        }
    }

    /// Draws one row as a piece of its own.
    pub(super) fn draw_one(&self, frame: &mut Frame, layer: LayerKey, x: &[f64], weight: f64) {
        let ends = self.objective.ends();
        frame.begin(layer, if ends.is_some() { Shape::Polyline } else { Shape::Points });
        ends.iter().for_each(|ends| frame.push(ends.0, weight));
        self.objective.points(x).for_each(|point| frame.push(point, weight));
        ends.iter().for_each(|ends| frame.push(ends.1, weight));
    }
}
