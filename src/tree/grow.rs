//! What every tree planner is made of: trees, what the last extension did, and the path once there is one.

use std::sync::Arc;

use crate::{arm::Posture, kernel::State};

use super::{
    forest::Tree,
    found::Found,
    task::Task,
    vector::{distance, squared},
};

/// What became of a sample.
#[derive(Debug, Clone, Copy, PartialEq, Eq, State)]
#[repr(u8)]
#[non_exhaustive]
pub enum SampleOutcome {
    /// The tree has grown towards it.
    Taken,
    /// Its direction was not among the best.
    NotKept,
    /// Another was drawn by the roulette wheel, and there the tree could grow.
    NotDrawn,
    /// It is nearer than a step.
    TooNear,
    /// The new node would lie outside the space.
    Outside,
    /// The way to the new node is blocked.
    Blocked,
    /// The new node would be nearer to another node than to its parent.
    DoublesBack,
    /// The arm has no posture with which it gets to the new node.
    Unreachable,
}

/// A point that the tree was asked to grow to.
#[derive(Debug, Clone, Copy, State)]
pub(super) struct Sample<const N: usize> {
    pub(super) point: [f64; N],
    /// The angle between its direction and the goal's, seen from the node that was to grow, in radians.
    pub(super) angle: f64,
    /// Its share of the roulette wheel when it was drawn, or would have been at first; 0 if it was not kept.
    pub(super) share: f64,
    pub(super) outcome: SampleOutcome,
}

/// How a sample came about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, State)]
#[non_exhaustive]
pub enum Source {
    /// Drawn from all of the space.
    Uniform,
    /// The goal itself.
    Goal,
    /// Drawn where a shorter path can lead.
    Informed,
    /// The other tree's newest node.
    Other,
    /// One of many.
    Guided(By),
}

/// What decides which of many samples the tree grows to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, State)]
pub enum By {
    /// Those with the smallest angles to the goal's direction are kept, a roulette wheel chooses among them.
    Angle,
    /// A roulette wheel draws those that are kept, by their distances to the goal, and the nearest comes first.
    Distance,
}

/// What the last extension did.
#[derive(Debug, Clone, State)]
pub(super) struct Extension<const N: usize> {
    pub(super) source: Source,
    /// The tree that was to grow.
    pub(super) tree: usize,
    /// The node that was to grow, or has grown.
    pub(super) near: usize,
    /// What was drawn; of a guided extension that failed, and of the plain one that followed.
    pub(super) samples: Vec<Sample<N>>,
    /// The guided samples led nowhere: the last one is a plain step's.
    pub(super) fell_back: bool,
    /// Whether a node was added.
    pub(super) added: bool,
    /// How many nodes were given a new parent.
    pub(super) rewired: usize,
}

/// A node's place in the order in which all were added.
#[derive(Debug, Clone, Copy, State)]
pub(super) struct Birth {
    pub(super) tree: u8,
    pub(super) node: u32,
    pub(super) iteration: u32,
}

/// A straight piece that is free.
#[derive(Debug, Clone, Copy, State)]
struct Piece<const N: usize> {
    tree: usize,
    node: usize,
    to: [f64; N],
    /// The arm's posture there.
    posture: Posture,
}

/// Two trees and what came of growing them: what a [`Method`](super::Method) works on. Tree 0 grows from the start; tree 1 has nodes
/// only where one grows from the goals.
#[derive(Debug, Clone, State)]
pub struct Forest<const N: usize> {
    pub(super) trees: [Tree<N>; 2],
    /// All nodes in the order in which they were added.
    pub(super) births: Vec<Birth>,
    pub(super) last: Extension<N>,
    pub(super) found: Option<Arc<Found<N>>>,
    /// How many straight pieces were tested.
    pub(super) tested: u64,
    /// How many extensions added nothing.
    pub(super) rejected: u64,
    /// The squared distance of the start's tree from the goal.
    pub(super) nearest: f64,
    /// Whose it is.
    pub(super) nearest_node: usize,
    pub(super) iteration: u64,
    /// The piece of an arm's tree that was tested last and is free.
    #[state(skip)]
    last_free: Option<Piece<N>>,
}

impl<const N: usize> Forest<N> {
    /// A root at the start and nothing else.
    pub(super) fn new(task: &Task<N>) -> Self {
        let tree = Tree::new;
        let last = Extension { source: Source::Uniform, tree: 0, near: 0, samples: Vec::new(), fell_back: false, added: false, rewired: 0 };
        let mut forest = Self {
            trees: [tree(), tree()],
            births: Vec::new(),
            last,
            found: None,
            tested: 0,
            rejected: 0,
            nearest: f64::INFINITY,
            nearest_node: 0,
            iteration: 0,
            last_free: None,
        };
        forest.root(task, 0, task.start);
        forest
    }

    /// Tree 0, from the start, or 1, from the goals.
    pub fn tree(&self, tree: usize) -> &Tree<N> {
        &self.trees[tree]
    }

    /// The node of tree 0 that is nearest to a goal.
    pub fn nearest_to_goal(&self) -> usize {
        self.nearest_node
    }

    /// The path from start to goal along the trees, once there is one, and its length.
    pub fn path(&self) -> Option<(&[[f64; N]], f64)> {
        self.found.as_ref().map(|found| (&*found.raw, found.cost))
    }

    /// Adds a root to a tree.
    pub(super) fn root(&mut self, task: &Task<N>, tree: usize, point: [f64; N]) {
        let node = self.trees[tree].root(point);
        self.trees[tree].postures.0.extend(task.space.end_postures().map(|ends| ends[tree]));
        self.note(task, tree, node);
    }

    /// Adds a child to a node of a tree; its number. The straight piece between them must be free: [`test`](Self::test) says so.
    #[inline(never)]
    pub fn add(&mut self, task: &Task<N>, tree: usize, point: [f64; N], parent: usize) -> usize {
        let Tree { points, postures, .. } = &self.trees[tree];
        let posture = postures.0.get(parent).map(|from| match self.last_free {
            Some(piece) if (piece.tree, piece.node, piece.to) == (tree, parent, point) => piece.posture,
            _ => task.space.posture_at(&points[parent], from, &point, None).unwrap_or(*from),
        });
        self.trees[tree].postures.0.extend(posture);
        let node = self.trees[tree].add(point, parent);
        self.note(task, tree, node);
        self.last.added = true;
        node
    }

    fn note(&mut self, task: &Task<N>, tree: usize, node: usize) {
        self.births.push(Birth { tree: tree as u8, node: node as u32, iteration: self.iteration as u32 });
        if tree == 0 {
            let point = &self.trees[0].points[node];
            let nearest = task.space.goals().iter().map(|goal| squared(point, goal)).fold(f64::INFINITY, f64::min);
            if nearest < self.nearest {
                (self.nearest, self.nearest_node) = (nearest, node);
            }
        }
    }

    /// Whether the straight piece from a node of a tree to a new one is free, and the new one inside: then it is `Taken`. Counts as an
    /// evaluation.
    #[inline]
    pub fn test(&mut self, task: &Task<N>, tree: usize, node: usize, to: &[f64; N]) -> SampleOutcome {
        self.test_to(task, tree, node, to, None)
    }

    /// The same to another node of that tree.
    #[inline(never)]
    pub(super) fn test_to(&mut self, task: &Task<N>, tree: usize, node: usize, to: &[f64; N], other: Option<usize>) -> SampleOutcome {
        if !task.contains(to) {
            return SampleOutcome::Outside;
        }
        self.tested += 1;
        let Tree { points, postures, .. } = &self.trees[tree];
        let from = &points[node];
        if !task.space.is_free(from, to) {
            return SampleOutcome::Blocked;
        }
        if let Some(at) = postures.0.get(node) {
            let Some(posture) = task.space.posture_at(from, at, to, other.map(|other| &postures.0[other])) else {
                return SampleOutcome::Unreachable;
            };
            self.last_free = Some(Piece { tree, node, to: *to, posture });
        }
        SampleOutcome::Taken
    }

    /// Begins an extension of a tree: what a method does first. Explanations tell the source.
    pub fn begin(&mut self, source: Source, tree: usize) {
        self.last.samples.clear();
        (self.last.source, self.last.tree, self.last.near) = (source, tree, 0);
        (self.last.added, self.last.fell_back, self.last.rewired) = (false, false, 0);
    }

    /// Notes a sample, and what became of it, for drawing and explanations.
    pub fn record(&mut self, point: [f64; N], outcome: SampleOutcome) {
        self.last.samples.push(Sample { point, angle: f64::NAN, share: 1.0, outcome });
    }

    /// Extends the nearest node of the tree that was begun with towards a sample: by [ARM-RRT](crate#papers) (11) a whole step,
    /// or, where `clip` says so, no farther than the sample. The new node's number, if that is free.
    #[inline(never)]
    pub fn extend(&mut self, task: &Task<N>, sample: [f64; N], clip: bool) -> Option<usize> {
        let tree = self.last.tree;
        let near = self.trees[tree].nearest(&sample);
        let from = self.trees[tree].points[near];
        let far = distance(&from, &sample);
        self.last.near = near;
        let new = if clip && far <= task.step { sample } else { task.towards(&from, &sample) };
        let outcome = if far == 0.0 { SampleOutcome::TooNear } else { self.test(task, tree, near, &new) };
        self.record(sample, outcome);
        (outcome == SampleOutcome::Taken).then(|| self.add(task, tree, new, near))
    }

    /// Keeps the path over a node of tree 0 if the goal is no farther from it than a step and the piece between them is free. Whether
    /// that is so.
    #[inline(never)]
    pub fn reach(&mut self, task: &Task<N>, node: usize) -> bool {
        let (point, goal) = (self.trees[0].points[node], task.goal());
        if distance(&point, &goal) > task.step || self.test(task, 0, node, &goal) != SampleOutcome::Taken {
            return false;
        }
        let (mut path, mut postures) = (self.trees[0].path_to(node), self.trees[0].postures_to(node));
        if point != goal {
            path.push(goal);
            postures.extend(self.last_free.map(|piece| piece.posture));
        }
        self.keep(path, postures);
        true
    }

    /// Keeps a path from start to goal whose pieces are free, with the posture at each of its points, or an empty list where there is
    /// none: the result.
    #[inline(never)]
    pub fn keep(&mut self, path: Vec<[f64; N]>, postures: Vec<Posture>) {
        debug_assert!(postures.is_empty() || postures.len() == path.len(), "there is a posture at each point, or at none");
        self.found = Some(Arc::new(Found::new(path, postures, self.iteration)));
    }
}
