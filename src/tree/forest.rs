//! Trees of nodes: where each is, whose child, and how long the way to it is.

use crate::{arm::Posture, kernel::State};

use super::{nearest::Nearest, space::Postures, vector::distance};

/// No node.
pub(super) const NONE: u32 = u32::MAX;

/// A tree, or several with a root each. Nodes are numbered in the order in which they were added; no other numbers mean anything.
#[derive(Debug, Clone, State)]
pub struct Tree<const N: usize> {
    pub(super) points: Vec<[f64; N]>,
    /// Whose child each node is; [`NONE`] for a root.
    pub(super) parents: Vec<u32>,
    /// The length of the way from the root.
    pub(super) costs: Vec<f64>,
    /// An arm's posture at each node; empty where nodes have none.
    pub(super) postures: Postures,
    #[state(skip)]
    index: Nearest<N>,
}

impl<const N: usize> Tree<N> {
    /// A tree without nodes.
    pub(super) fn new() -> Self {
        Self { points: Vec::new(), parents: Vec::new(), costs: Vec::new(), postures: Postures::default(), index: Nearest::new() }
    }

    /// How many nodes.
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// Whether there is no node.
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// Where a node is.
    pub fn point(&self, node: usize) -> &[f64; N] {
        &self.points[node]
    }

    /// Whose child a node is; `None` for a root.
    pub fn parent(&self, node: usize) -> Option<usize> {
        Some(self.parents[node]).filter(|&parent| parent != NONE).map(|parent| parent as usize)
    }

    /// The length of the path from the root to a node.
    pub fn cost(&self, node: usize) -> f64 {
        self.costs[node]
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

    /// The node nearest to a point; of equals the first.
    #[inline]
    pub fn nearest(&self, to: &[f64; N]) -> usize {
        self.index.nearest(&self.points, to).0
    }

    /// Writes the nodes within a radius, in the order of their numbers.
    pub fn within(&self, to: &[f64; N], radius: f64, out: &mut Vec<u32>) {
        self.index.within(&self.points, to, radius, out);
    }

    /// The points from a root to a node.
    #[inline(never)]
    pub fn path_to(&self, node: usize) -> Vec<[f64; N]> {
        self.along(node).into_iter().map(|node| self.points[node]).collect()
    }

    /// The posture at each of these points; empty where there is none.
    #[inline(never)]
    pub fn postures_to(&self, node: usize) -> Vec<Posture> {
        self.along(node).into_iter().filter_map(|node| self.postures.0.get(node).copied()).collect()
    }

    /// The nodes from a root to one.
    #[inline(never)]
    fn along(&self, node: usize) -> Vec<usize> {
        let mut all: Vec<_> = std::iter::successors(Some(node), |&node| self.parent(node)).collect();
        all.reverse();
        all
    }
}
