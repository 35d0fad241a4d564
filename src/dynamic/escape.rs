//! What to do when neither a way round nor standing still is safe: a search over places, headings and time for motions,
//! waits among them, that keep away from every obstacle as far as the robot looks ahead.
//!
//! Ours: the paper says what to do only where there is a way round. A* over (cell, heading, time), time in bins: of two
//! ways to the same cell in the same bin with the same heading one is enough.

use std::{
    cmp::{Ordering, Reverse},
    collections::{BTreeSet, BinaryHeap},
};

use super::{
    body::{Deed, Pose, Step, Stretch, endpoints},
    ground::Ground,
    world::{Distance, View},
};

/// The most states that are looked at: fewer where each has to be compared with more than a few obstacles.
const MOST: usize = 20_000;
const FEW: usize = 16;

/// A state that can be reached.
#[derive(Debug, Clone, Copy)]
struct Node {
    /// A cell; or the number of cells: where the robot is now.
    spot: usize,
    at: [f64; 2],
    heading: [f64; 2],
    time: f64,
    parent: usize,
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Cost(f64);

impl Eq for Cost {}
impl PartialOrd for Cost {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
impl Ord for Cost {
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.total_cmp(&other.0)
    }
}

/// What was found.
#[derive(Debug, Clone)]
pub(super) struct Escape {
    /// From where the robot is; waits included.
    pub steps: Vec<Step>,
    /// How the search ended.
    pub end: End,
}

/// How a search ended. Unless its steps are safe, they are those that put a collision off for longest.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum End {
    /// Nothing comes too near as far as it looks ahead, or up to the goal.
    Safe,
    /// Nothing that can be reached is safe.
    Nothing,
    /// It gave up after so many states.
    GaveUp(usize),
}

/// The motion that keeps away from everything and promises to be at the goal first.
pub(super) fn escape(view: &View, distance: Distance, pose: &Pose, ground: &Ground) -> Escape {
    let mut search =
        Search { view, distance, pose, ground, horizon: view.now + ground.body.look_ahead, nodes: Vec::new(), open: BinaryHeap::new() };
    search.run()
}

struct Search<'a> {
    view: &'a View,
    distance: Distance,
    pose: &'a Pose,
    ground: &'a Ground,
    horizon: f64,
    nodes: Vec<Node>,
    open: BinaryHeap<(Reverse<Cost>, Reverse<usize>)>,
}

impl Search<'_> {
    fn run(&mut self) -> Escape {
        let ground = self.ground;
        let cells = &ground.cells;
        let n = cells.len();
        let [behind, ahead] = self.pose.between;
        let centred = behind == ahead && self.pose.at == cells.centre(ahead);
        let spot = if centred { ahead } else { n };
        self.push(Node { spot, at: self.pose.at, heading: self.pose.heading, time: self.view.now, parent: 0 });
        let pause = cells.side / ground.body.speed / 2.0;
        let mut seen = BTreeSet::new();
        let mut longest = 0;
        while let Some((_, Reverse(number))) = self.open.pop() {
            let node = self.nodes[number];
            let heading = node.heading.map(|c| (2.0 * c).round() as i8);
            let bin = ((node.time - self.view.now) / pause * 2.0) as u32;
            if !seen.insert((node.spot, heading, bin)) {
                continue;
            }
            if node.time >= self.horizon || node.spot == ground.endpoints.goal {
                return Escape { steps: self.steps(number), end: End::Safe };
            }
            if node.time > self.nodes[longest].time {
                longest = number;
            }
            if self.nodes.len() > MOST * FEW / (FEW + self.view.threats.len()) {
                return Escape { steps: self.steps(longest), end: End::GaveUp(self.nodes.len()) };
            }
            self.wait(number, pause);
            if node.spot == n {
                self.go(number, ahead);
                if behind != ahead {
                    self.go(number, behind);
                }
            } else {
                let moves = cells.moves(node.spot);
                (0..8).filter(|d| moves >> d & 1 != 0).for_each(|d| self.go(number, cells.next(node.spot, d)));
            }
        }
        Escape { steps: self.steps(longest), end: End::Nothing }
    }

    fn push(&mut self, node: Node) {
        let ground = self.ground;
        let near = |cell: usize| endpoints(node.at, ground.cells.centre(cell)).1 / ground.body.speed + ground.ahead(cell);
        let left = match self.pose.between {
            [behind, ahead] if node.spot == ground.cells.len() => near(ahead).min(near(behind)),
            _ => ground.ahead(node.spot),
        };
        self.open.push((Reverse(Cost(node.time + left)), Reverse(self.nodes.len())));
        self.nodes.push(node);
    }

    fn is_clear(&self, stretch: Stretch) -> bool {
        self.view.is_clear(&stretch, self.distance, self.horizon, &self.ground.grid, &self.ground.body)
    }

    fn wait(&mut self, number: usize, pause: f64) {
        let node = self.nodes[number];
        let until = node.time + pause;
        if self.is_clear(Stretch { from: node.time, until, at: node.at, velocity: [0.0; 2], deed: Deed::Wait, step: 0 }) {
            self.push(Node { time: until, parent: number, ..node });
        }
    }

    fn go(&mut self, number: usize, cell: usize) {
        let (node, body) = (self.nodes[number], &self.ground.body);
        let to = self.ground.cells.centre(cell);
        let (way, distance) = endpoints(node.at, to);
        // Only who goes at once goes on with a turn that was begun.
        let turn = if node.parent == number { self.pose.turn } else { None };
        let turned = node.time + Pose { heading: node.heading, turn, ..*self.pose }.turning(way, body);
        let until = turned + distance / body.speed;
        let velocity = way.map(|c| c * body.speed);
        let clear = (turned == node.time
            || self.is_clear(Stretch { from: node.time, until: turned, at: node.at, velocity: [0.0; 2], deed: Deed::Turn, step: 0 }))
            && self.is_clear(Stretch { from: turned, until, at: node.at, velocity, deed: Deed::Go, step: 0 });
        if clear {
            self.push(Node { spot: cell, at: to, heading: if distance > 0.0 { way } else { node.heading }, time: until, parent: number });
        }
    }

    /// The steps that lead to a state.
    fn steps(&self, to: usize) -> Vec<Step> {
        let mut chain: Vec<_> = std::iter::successors(Some(to), |&k| Some(self.nodes[k].parent).filter(|&parent| parent != k)).collect();
        chain.reverse();
        let (mut steps, mut wait) = (Vec::new(), 0.0);
        for pair in chain.windows(2) {
            let [from, to] = [pair[0], pair[1]].map(|k| self.nodes[k]);
            if from.spot == to.spot && from.at == to.at {
                wait += to.time - from.time;
            } else {
                steps.push(Step { to: to.at, cell: to.spot, wait });
                wait = 0.0;
            }
        }
        // The last wait is a step that leads nowhere.
        if let Some(last) = chain.last().map(|&k| self.nodes[k]).filter(|_| wait > 0.0) {
            let cell = if last.spot == self.ground.cells.len() { self.pose.between[1] } else { last.spot };
            steps.push(Step { to: last.at, cell, wait });
        }
        steps
    }
}
