//! What stays the same in a run of a tree.

use std::sync::Arc;

use crate::{
    kernel::{Error, error::list_of, rng::Stream},
    message,
    params::Parameters,
};

use super::{
    finish::Finish,
    parameters::{ITERATIONS, STEP},
    sample::uniform,
    space::Space,
    vector::{distance, minus},
};

/// A space and the settings that every tree planner has: what stays the same in a run.
pub struct Task<const N: usize> {
    pub(super) space: Arc<dyn Space<N>>,
    pub(super) start: [f64; N],
    pub(super) min: [f64; N],
    pub(super) max: [f64; N],
    /// L of (11), in the space's unit.
    pub(super) step: f64,
    pub(super) limit: u64,
    pub(super) finish: Finish,
}

impl<const N: usize> Task<N> {
    /// Of a space, with the settings that every tree planner has.
    ///
    /// # Errors
    /// As [`Trees::new`](super::Trees::new).
    pub(super) fn new(space: Arc<dyn Space<N>>, settings: &Parameters) -> Result<Self, Error> {
        let step = settings[STEP] * space.unit();
        let task = Self::with(space, step, settings[ITERATIONS], Finish::new(settings, step));
        check(&task.min, &task.max, &task.start, task.space.goals().as_flattened(), step)?;
        Ok(task)
    }

    /// The same with a step in the space's unit.
    pub(super) fn with(space: Arc<dyn Space<N>>, step: f64, limit: u64, finish: Finish) -> Self {
        let (min, max) = space.bounds();
        Self { start: space.start(), min, max, step, limit, finish, space }
    }

    /// What the tree grows through.
    pub fn space(&self) -> &dyn Space<N> {
        &*self.space
    }

    /// L of [ARM-RRT](crate#papers) (11): how far a node grows, in the space's unit.
    pub fn step(&self) -> f64 {
        self.step
    }

    /// The first goal, for methods that know one only.
    pub fn goal(&self) -> [f64; N] {
        self.space.goals()[0]
    }

    /// Whether a point lies in the box.
    #[inline]
    pub fn contains(&self, point: &[f64; N]) -> bool {
        (0..N).all(|i| self.min[i] <= point[i] && point[i] <= self.max[i])
    }

    /// A point drawn evenly from the box.
    #[inline]
    pub fn uniform(&self, rng: &mut Stream) -> [f64; N] {
        uniform(&self.min, &self.max, rng)
    }

    /// The point a step from one point towards another, x_new of [ARM-RRT](crate#papers) (11). They must differ.
    #[inline]
    pub fn towards(&self, near: &[f64; N], sample: &[f64; N]) -> [f64; N] {
        let way = minus(sample, near);
        let length = distance(sample, near);
        std::array::from_fn(|i| near[i] + self.step * way[i] / length)
    }
}

/// Refuses a space in which nothing can grow.
fn check(min: &[f64], max: &[f64], start: &[f64], goals: &[f64], step: f64) -> Result<(), Error> {
    if goals.is_empty() {
        return Err(Error::refused("goals", list_of(0), message!("tree-one-goal", "one point at least")));
    }
    if !(step > 0.0 && step.is_finite()) {
        return Err(Error::refused("unit", step, message!("tree-step", "a step greater than 0")));
    }
    for (field, numbers) in [("bounds", min), ("bounds", max), ("start", start), ("goals", goals)] {
        if let Some(number) = numbers.iter().find(|number| !number.is_finite()) {
            return Err(Error::refused(field, *number, message!("tree-finite", "finite numbers")));
        }
    }
    match min.iter().zip(max).find(|(min, max)| min > max) {
        Some((min, max)) => Err(Error::refused("bounds", *max, message!("tree-at-least", "{min} at least", min))),
        None => Ok(()),
    }
}
