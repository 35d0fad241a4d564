//! Trees of nodes: where each is, whose child, and how long the way to it is.

use crate::kernel::State;

use super::{nearest::Nearest, vector::distance};

/// No node.
pub(super) const NONE: u32 = u32::MAX;

/// A tree, or several with a root each.
#[derive(Debug, Clone, State)]
pub(super) struct Tree<const N: usize> {
    pub(super) points: Vec<[f64; N]>,
    /// Whose child each node is; [`NONE`] for a root.
    pub(super) parents: Vec<u32>,
    /// The length of the way from the root.
    pub(super) costs: Vec<f64>,
    #[state(skip)]
    index: Nearest<N>,
}

impl<const N: usize> Tree<N> {
    /// A tree without nodes.
    pub(super) fn new() -> Self {
        Self { points: Vec::new(), parents: Vec::new(), costs: Vec::new(), index: Nearest::new() }
    }

    /// How many nodes.
    pub(super) fn len(&self) -> usize {
        self.points.len()
    }

    /// Adds a root.
    pub(super) fn root(&mut self, point: [f64; N]) -> usize {
        self.push(point, NONE, 0.0)
    }

    /// Adds a child.
    pub(super) fn add(&mut self, point: [f64; N], parent: usize) -> usize {
        let cost = self.costs[parent] + distance(&self.points[parent], &point);
        self.push(point, parent as u32, cost)
    }

    fn push(&mut self, point: [f64; N], parent: u32, cost: f64) -> usize {
        self.points.push(point);
        self.parents.push(parent);
        self.costs.push(cost);
        self.index.add(&self.points);
        self.points.len() - 1
    }

    /// The node nearest to a point.
    #[inline]
    pub(super) fn nearest(&self, to: &[f64; N]) -> usize {
        self.index.nearest(&self.points, to).0
    }

    /// The nodes within a radius.
    pub(super) fn within(&self, to: &[f64; N], radius: f64, out: &mut Vec<u32>) {
        self.index.within(&self.points, to, radius, out);
    }

    /// From a root to a node.
    pub(super) fn way(&self, to: usize) -> Vec<[f64; N]> {
        let parent = |&node: &usize| Some(self.parents[node]).filter(|&parent| parent != NONE).map(|parent| parent as usize);
        let mut way: Vec<_> = std::iter::successors(Some(to), parent).map(|node| self.points[node]).collect();
        way.reverse();
        way
    }
}
