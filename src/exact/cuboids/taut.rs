//! The shortest line over given edges in a given order, whatever is in its way: a convex problem.

use std::array::from_fn;

use crate::math;

use super::edges::Edge;

/// An edge that a line crosses.
#[derive(Debug, Clone, Copy)]
pub(super) struct Crossing {
    pub(super) edge: usize,
    /// Between which coordinates along the edge.
    pub(super) range: [f64; 2],
    /// At which.
    pub(super) at: f64,
}

impl Crossing {
    /// In the middle of a part of an edge.
    pub(super) fn within(edge: usize, range: [f64; 2]) -> Self {
        Self { edge, range, at: f64::midpoint(range[0], range[1]) }
    }

    /// The least component of a direction after the crossing (for `sign` 1; before it for −1) that keeps the crossing where it
    /// is, given the component on its other side: the same, or none where the crossing is at an end of its range anyway.
    fn least_beside(&self, other: f64, sign: f64, near: f64) -> f64 {
        let held = if sign * other > 0.0 { self.at <= self.range[0] + near } else { self.at >= self.range[1] - near };
        if held { 0.0 } else { other }
    }
}

/// A line from start to goal over edges, and what is known about the shortest such line.
#[derive(Debug, Clone)]
pub(super) struct Line {
    pub(super) crossings: Vec<Crossing>,
    /// Its length.
    pub(super) length: f64,
    /// No line over these edges is shorter.
    pub(super) bound: f64,
}

/// How hard to try.
struct Effort {
    /// Rounds; in each, every crossing is moved once.
    rounds: usize,
    /// How much smoothing is left after each.
    left: f64,
    /// How near, relative to the largest coordinate, length and bound must come.
    near: f64,
}

/// For one line of many.
const QUICK: Effort = Effort { rounds: 60, left: 0.3, near: 1e-10 };
/// For a line that may be the path.
const PATIENT: Effort = Effort { rounds: 4000, left: 0.6, near: 1e-14 };
/// How much the first round is smoothed, relative to the largest coordinate.
const SMOOTH: f64 = 0.03;
/// Smoothing ends below this.
const LEAST_SMOOTH: f64 = 1e-14;

/// A piece shorter than this has no direction of its own, relative to the largest coordinate.
const NONE: f64 = 1e-11;

/// What a line is among.
#[derive(Clone, Copy)]
pub(super) struct Place<'a> {
    pub(super) edges: &'a [Edge],
    pub(super) ends: [[f64; 3]; 2],
    /// The largest coordinate.
    pub(super) scale: f64,
}

impl Line {
    /// The shortest line, nearly, or one that cannot be shorter than `limit`; and how often a crossing was moved for it.
    pub(super) fn taut(crossings: Vec<Crossing>, place: Place<'_>, limit: f64) -> (Self, u64) {
        let mut line = Self { crossings, length: f64::INFINITY, bound: 0.0 };
        let moves = line.relax(&QUICK, place, limit);
        (line, moves)
    }

    /// The same with more patience.
    pub(super) fn tighten(&mut self, place: Place<'_>) -> u64 {
        let bound = self.bound;
        let moves = self.relax(&PATIENT, place, f64::INFINITY);
        self.bound = self.bound.max(bound);
        moves
    }

    /// How much its length exceeds its bound.
    pub(super) fn gap(&self) -> f64 {
        self.length - self.bound
    }

    /// Moves one crossing after the other to where the line over it is shortest while its neighbours stay. Where two edges
    /// meet in a corner this could come to rest too early, so lengths are smoothed at first: √(ℓ² + ε²), ε → 0.
    fn relax(&mut self, effort: &Effort, place: Place<'_>, limit: f64) -> u64 {
        let Place { edges, ends, scale } = place;
        let mut smooth = SMOOTH * scale;
        let mut moves = 0;
        for round in 1..=effort.rounds {
            moves += self.crossings.len() as u64;
            for i in 0..self.crossings.len() {
                let Crossing { edge, range, .. } = self.crossings[i];
                let edge = &edges[edge];
                let before = i.checked_sub(1).map_or(ends[0], |i| self.point(i, edges));
                let after = if i + 1 < self.crossings.len() { self.point(i + 1, edges) } else { ends[1] };
                // Turned about the edge into one plane, the line is straight.
                let (a, b) = (beside(edge, before, smooth), beside(edge, after, smooth));
                if a + b > 0.0 {
                    let at = (before[edge.axis] * b + after[edge.axis] * a) / (a + b);
                    self.crossings[i].at = math::clamp(at, range[0], range[1]);
                }
            }
            smooth = if smooth > LEAST_SMOOTH * scale { effort.left * smooth } else { 0.0 };
            if round % 4 == 0 || round == effort.rounds {
                self.measure(edges, ends, NONE * scale);
                if self.gap() <= effort.near * scale || self.bound >= limit {
                    break;
                }
            }
        }
        moves
    }

    /// Its length, and the bound that its directions prove: for any vectors w_i no longer than 1,
    /// Σ |p_{i+1} − p_i| ≥ Σ w_i · (p_{i+1} − p_i), which is linear in each crossing and so least at an end of its range.
    fn measure(&mut self, edges: &[Edge], ends: [[f64; 3]; 2], none: f64) {
        let n = self.crossings.len();
        let (mut ways, mut directions) = (Vec::with_capacity(n + 1), Vec::with_capacity(n + 1));
        self.length = 0.0;
        let mut from = ends[0];
        for i in 0..=n {
            let to = if i < n { self.point(i, edges) } else { ends[1] };
            let way: [f64; 3] = from_fn(|axis| to[axis] - from[axis]);
            let length = norm(way);
            self.length += length;
            ways.push(way);
            directions.push(if length > none { way.map(|c| c / length) } else { [0.0; 3] });
            from = to;
        }
        // The best of a piece of no length is the shortest vector that its neighbours allow.
        for i in 1..n {
            if directions[i] == [0.0; 3] {
                let (a, b) = (self.crossings[i - 1], self.crossings[i]);
                let (along_a, along_b) = (edges[a.edge].axis, edges[b.edge].axis);
                let mut w = [0.0; 3];
                w[along_a] = a.least_beside(directions[i - 1][along_a], 1.0, none);
                w[along_b] = b.least_beside(directions[i + 1][along_b], -1.0, none);
                let length = norm(w);
                directions[i] = if length > 1.0 { w.map(|c| c / length) } else { w };
            }
        }
        self.bound = ways.iter().zip(&directions).fold(0.0, |sum, (way, w)| sum + (0..3).fold(0.0, |dot, axis| dot + way[axis] * w[axis]));
        for (i, crossing) in self.crossings.iter().enumerate() {
            let axis = edges[crossing.edge].axis;
            let slope = directions[i][axis] - directions[i + 1][axis];
            let to = if slope > 0.0 { crossing.range[0] } else { crossing.range[1] };
            self.bound += (to - crossing.at) * slope;
        }
    }

    fn point(&self, i: usize, edges: &[Edge]) -> [f64; 3] {
        edges[self.crossings[i].edge].point(self.crossings[i].at)
    }

    /// The line's corners, from start to goal.
    pub(super) fn points(&self, edges: &[Edge], [start, goal]: [[f64; 3]; 2]) -> Vec<[f64; 3]> {
        let corners = (0..self.crossings.len()).map(|i| self.point(i, edges));
        let mut points: Vec<_> = [start].into_iter().chain(corners).chain([goal]).collect();
        points.dedup();
        points
    }
}

/// The distance of a point from an edge's line, smoothed.
#[inline]
fn beside(edge: &Edge, point: [f64; 3], smooth: f64) -> f64 {
    let (u, v) = ((edge.axis + 1) % 3, (edge.axis + 2) % 3);
    let (du, dv) = (point[u] - edge.at[u], point[v] - edge.at[v]);
    (du * du + dv * dv + smooth * smooth).sqrt()
}

fn norm(vector: [f64; 3]) -> f64 {
    vector.iter().fold(0.0, |sum, c| sum + c * c).sqrt()
}
