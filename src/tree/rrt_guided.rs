//! `rrt-guided`: the tree that looks where the goal is, [ARM-RRT] §3.2.1 and §3.3.
//!
//! Readings. x_near is the node nearest to the goal, as step 2 (2) of the paper's algorithm says. The roulette wheel's
//! weights are not printed: ours are π − φ, which fall with the angle. A candidate that is blocked, outside, or doubles
//! back leaves the wheel, and it is turned again.

use std::{f64::consts::PI, sync::Arc};

use crate::{catalogue::Entry, error::Error, params::Settings, rng::Stream, scene::Scene};

use super::{
    draw::GUIDED_LAYERS,
    finish::{FITTED, HERMITE},
    grow::{Fate, Forest, Grown, Method, Sample, Source, Task},
    parameters::{FORMULA_ANGLE, FORMULA_ROULETTE, FORMULA_STEP, ITERATIONS, KEEP, KINDS, READINGS, SAMPLES, STEP, with_finish},
    sample::{angle, uniform},
    vector::{distance, minus},
};

/// See the module.
pub const ENTRY: Entry = Entry {
    name: "rrt-guided",
    title: "Guided RRT: towards the goal",
    family: "tree",
    source: "[ARM-RRT] §3.2.1",
    summary: "Of twenty random points the four whose directions are nearest to the goal’s are kept, a roulette wheel chooses among them, and the node nearest to the goal grows towards it. Where all four are blocked, a random step follows.",
    kinds: KINDS,
    stops: false,
    most_stops: None,
    parameters: &with_finish!(ITERATIONS, STEP, SAMPLES, KEEP),
    readings: READINGS,
    formulas: &[FORMULA_STEP, FORMULA_ANGLE, FORMULA_ROULETTE, FITTED, HERMITE],
    layers: GUIDED_LAYERS,
    members: &[],
    events: &[],
    presets: &[],
    suggest: |_| None,
    start: |scene, settings, seed| Ok(Box::new(grown(scene, settings, seed)?)),
};

/// The planner behind the entry.
pub(super) fn grown(scene: &Arc<Scene>, settings: &Settings, seed: u64) -> Result<Grown<3, Guided>, Error> {
    let (samples, keep) = (settings.integer("samples") as usize, settings.integer("keep") as usize);
    super::grown(scene, settings, seed, 0.0, |_| Guided { samples, keep, order: Vec::with_capacity(samples) })
}

#[derive(Clone)]
pub(super) struct Guided {
    samples: usize,
    keep: usize,
    /// Angles and numbers of the samples, re-used.
    order: Vec<(f64, usize)>,
}

impl<const N: usize> Method<N> for Guided {
    fn grow(&mut self, forest: &mut Forest<N>, task: &Task<N>, rng: &mut Stream) {
        forest.begin(Source::Guided, 0);
        let near = forest.nearest_node;
        self.draw(forest, task, near, rng);
        if let Some(new) = self.roulette(forest, task, near, rng).or_else(|| plain(forest, task, rng)) {
            forest.reach(task, new);
        }
    }
}

impl Guided {
    /// Draws the samples and keeps those with the smallest angles.
    fn draw<const N: usize>(&mut self, forest: &mut Forest<N>, task: &Task<N>, near: usize, rng: &mut Stream) {
        let from = forest.trees[0].points[near];
        let ahead = minus(&task.goal(), &from);
        self.order.clear();
        for i in 0..self.samples {
            let point = uniform(&task.min, &task.max, rng);
            let angle = angle(&minus(&point, &from), &ahead);
            self.order.push((angle, i));
            forest.last.samples.push(Sample { point, angle, share: 0.0, fate: Fate::NotKept });
        }
        crate::math::sort(&mut self.order);
        self.order.truncate(self.keep);
        forest.last.near = near;
        let all: f64 = self.order.iter().fold(0.0, |sum, (angle, _)| sum + (PI - angle));
        for &(angle, i) in &self.order {
            let sample = &mut forest.last.samples[i];
            (sample.share, sample.fate) = (if all > 0.0 { (PI - angle) / all } else { 1.0 / self.keep as f64 }, Fate::NotDrawn);
        }
    }

    /// Turns the wheel until the tree can grow towards what it shows, or nothing is left on it.
    fn roulette<const N: usize>(&mut self, forest: &mut Forest<N>, task: &Task<N>, near: usize, rng: &mut Stream) -> Option<usize> {
        let from = forest.trees[0].points[near];
        while !self.order.is_empty() {
            let all = self.order.iter().fold(0.0, |sum, (angle, _)| sum + (PI - angle));
            let mut left = rng.unit() * all;
            let chosen = self.order.iter().position(|(angle, _)| {
                left -= PI - angle;
                left < 0.0
            });
            // Rounding may leave a little.
            let (_, i) = self.order.remove(chosen.unwrap_or(self.order.len() - 1));
            let sample = forest.last.samples[i].point;
            let (fate, new) = if distance(&from, &sample) < task.step {
                (Fate::TooNear, from)
            } else {
                let new = task.towards(&from, &sample);
                let doubles_back = task.contains(&new) && forest.trees[0].nearest(&new) != near;
                (if doubles_back { Fate::DoublesBack } else { forest.test(task, &from, &new) }, new)
            };
            forest.last.samples[i].fate = fate;
            if fate == Fate::Taken {
                return Some(forest.add(task, 0, new, near));
            }
        }
        None
    }
}

/// A plain step, but for a sample that is nearer than a step: that is skipped.
fn plain<const N: usize>(forest: &mut Forest<N>, task: &Task<N>, rng: &mut Stream) -> Option<usize> {
    forest.last.fell_back = true;
    let sample = uniform(&task.min, &task.max, rng);
    let near = forest.trees[0].nearest(&sample);
    if distance(&forest.trees[0].points[near], &sample) < task.step {
        forest.last.near = near;
        forest.last.samples.push(Sample { point: sample, angle: f64::NAN, share: 1.0, fate: Fate::TooNear });
        return None;
    }
    forest.extend(task, sample, false)
}
