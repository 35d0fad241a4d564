//! The colony as a planner: how it starts, steps, reads and draws.

use crate::{
    describe::{CONVERGED, Start, layers},
    kernel::{
        Candidate, Error, Explain, Facets, Frame, Inspection, Item, Planner, Progress, Readings, ReferenceOptimum, Solution, Started,
        rng::Stream,
    },
    scene::grid_path::{self},
    settled::SETTLED,
};

use super::{
    colony::{Colony, Variant},
    draw, explain,
    parameters::{ANT_STEPS, ARRIVED, BEST, GREED, LOST, MEAN, STUCK},
    walk::End,
};

/// Starts a colony of this variant on a grid; the entry lists the parameters of [`aco`](super::aco::ENTRY).
///
/// # Errors
/// [`Error::Refused`] for another kind of scene, and as [`Colony::new`].
pub fn start(start: &Start, variant: Variant) -> Result<Started, Error> {
    Ok(Colony::new(&start.scene.share()?, start.parameters, start.seed, variant)?.into())
}

impl From<Colony> for Started {
    fn from(colony: Colony) -> Self {
        let (limit, reachable) = (colony.limit, colony.ground.reachable);
        let reference = if colony.smooth { ReferenceOptimum::AnyAngle } else { ReferenceOptimum::Cells };
        Self::new(colony, limit).measured_by(reference).solvable(reachable)
    }
}

impl Planner for Colony {
    fn advance(&mut self) -> Progress {
        self.iterate()
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
        if self.variant.greed != [0.0; 2] {
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
            layer if layer == layers::PHEROMONE.key => explain::cell(self, item, None),
            layer if layer == layers::ANTS.key => explain::ant(self, item),
            _ => None,
        }
    }

    fn suppose(&self, item: Item, supposition: &str, others: &Stream) -> Option<Inspection> {
        explain::other_ant(self, item, supposition, others)
    }

    fn suppose_now(&self, item: Item, supposition: &str) -> Option<Inspection> {
        (item.layer == layers::PHEROMONE.key).then(|| explain::cell(self, item, Some(supposition)))?
    }
}
