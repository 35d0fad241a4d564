//! The quantum swarm by the stepped contract.

use crate::{
    describe::layers,
    kernel::{Candidate, Explain, Facets, Frame, Inspection, Item, Planner, Progress, Readings, Started, rng::Stream},
    message,
    swarm::{
        draw::CONTEXT,
        parameters::{EVALUATIONS, K},
        sheet,
    },
};

use super::{
    leap::Quantum,
    parameters::{ALPHA, GS, IP, SELECTED},
};

impl From<Quantum> for Started {
    fn from(swarm: Quantum) -> Self {
        swarm.clock.start(swarm)
    }
}

impl Planner for Quantum {
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
        self.population.read(out);
        out.push(K, self.clock.iteration.saturating_sub(1) as f64);
        out.push(ALPHA, self.width);
        if self.adaptive.is_some() {
            out.push(IP, self.ip.iter().sum::<f64>() / self.ip.len() as f64);
            out.push(GS, self.gs.iter().sum::<f64>() / self.gs.len() as f64);
            out.push(SELECTED, self.replaced.iter().flatten().count() as f64);
        }
        out.push(EVALUATIONS, self.population.evaluations as f64);
    }

    fn draw(&self, frame: &mut Frame) {
        let population = &self.population;
        population.draw_members(frame);
        if self.adaptive.is_some() {
            population.draw(frame, layers::SELECTED.key, &population.x, &|i| self.replaced[i].is_some(), &|_| 0.0, 1);
        }
        population.draw(frame, layers::ATTRACTORS.key, &self.attractors, &|_| true, &|_| 0.0, CONTEXT);
        population.draw_one(frame, layers::MEAN_BEST.key, &self.m, 0.0);
        population.draw_result(frame);
    }

    fn facets(&self) -> Facets<'_> {
        Facets::default().explain(self).failure(&self.population)
    }
}

impl Explain for Quantum {
    fn inspect(&self, item: Item) -> Option<Inspection> {
        let i = item.index;
        let origin = message!("swarm-quantum-begins", "Particle {i} begins here, drawn at random; it has no velocity, now or later.", i);
        (self.clock.iteration == 0).then(|| sheet::introduce(&self.population, item, origin)).flatten()
    }

    fn explain_next(&self, item: Item) -> Option<Inspection> {
        self.explain_step(item, None)
    }

    fn suppose(&self, item: Item, supposition: &str, others: &Stream) -> Option<Inspection> {
        self.explain_step(item, Some((supposition, others)))
    }
}
