//! What stays the same in a run of a tree.

use std::sync::Arc;

use crate::params::Parameters;

use super::{
    finish::Finish,
    parameters::{ITERATIONS, STEP},
    space::Space,
    vector::{distance, minus},
};

/// What stays the same in a run.
pub(super) struct Task<const N: usize> {
    pub(super) space: Arc<dyn Space<N>>,
    pub(super) start: [f64; N],
    pub(super) min: [f64; N],
    pub(super) max: [f64; N],
    /// L of (11), in the space's unit.
    pub(super) step: f64,
    pub(super) goal_bias: f64,
    pub(super) limit: u64,
    pub(super) finish: Finish,
}

impl<const N: usize> Task<N> {
    /// Of a space, with the settings that every tree planner has.
    pub(super) fn new(space: Arc<dyn Space<N>>, settings: &Parameters, goal_bias: f64) -> Self {
        let (min, max) = space.bounds();
        let step = settings[STEP] * space.unit();
        Self { start: space.start(), min, max, step, goal_bias, limit: settings[ITERATIONS], finish: Finish::new(settings, step), space }
    }

    /// The goal, for planners that know one only.
    pub(super) fn goal(&self) -> [f64; N] {
        self.space.goals()[0]
    }

    /// Whether a point lies in the box.
    #[inline]
    pub(super) fn contains(&self, point: &[f64; N]) -> bool {
        (0..N).all(|i| self.min[i] <= point[i] && point[i] <= self.max[i])
    }

    /// x_new of (11).
    #[inline]
    pub(super) fn towards(&self, near: &[f64; N], sample: &[f64; N]) -> [f64; N] {
        let way = minus(sample, near);
        let length = distance(sample, near);
        std::array::from_fn(|i| near[i] + self.step * way[i] / length)
    }
}
