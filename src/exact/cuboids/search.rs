//! The search over sequences of edges.

use std::{array::from_fn, cmp::Reverse, collections::BinaryHeap};

use crate::{
    geometry::Cuboid,
    math::{self, Length},
};

use super::{
    edges::{Edge, Side, Step, steps},
    grow::grow,
    taut::{Crossing, Line, Place},
};

/// How often a crossing is moved before the search gives up: tenths of a second.
const MAX_MOVES: u64 = 5_000_000;

/// How much shorter than what was found, relative to the largest coordinate, a bound must be to be followed up.
const PROVEN: f64 = 1e-13;

/// How near, relative to the largest coordinate, a line's length must come to its bound to tell whether it is free.
const CLOSE: f64 = 1e-9;

/// How deep, relative to the largest coordinate, such a line may lie in a cuboid that the taut line does not meet.
const LOOSE: f64 = 1e-3;

/// Into how many parts edges are divided to see what is hidden of one from the other.
const PARTS: usize = 6;

/// Edges in the order in which a path crosses them.
struct Sequence {
    line: Line,
    /// Beside which face of the last edge the path goes on.
    out: Side,
}

pub(super) struct Search {
    edges: Vec<Edge>,
    /// What a straight piece must not meet.
    barriers: Vec<Cuboid>,
    ends: [[f64; 3]; 2],
    scale: f64,
    /// Where a path can go on from an edge, by twice the edge's number and side; made when asked for.
    steps: Vec<Option<Vec<Step>>>,
    /// How often a crossing was moved.
    moves: u64,
}

impl Search {
    pub(super) fn new(edges: Vec<Edge>, barriers: Vec<Cuboid>, ends: [[f64; 3]; 2], scale: f64) -> Self {
        let steps = (0..2 * edges.len()).map(|_| None).collect();
        Self { edges, barriers, ends, scale, steps, moves: 0 }
    }

    /// The corners of the shortest path; `None` if it was given up.
    pub(super) fn run(&mut self) -> Option<Vec<[f64; 3]>> {
        let mut best: Option<Line> = None;
        let mut sequences: Vec<Sequence> = Vec::new();
        let mut doubt = f64::INFINITY;
        let mut open = BinaryHeap::new();
        let mut found = self.first();
        loop {
            for sequence in found.drain(..) {
                if sequence.line.bound >= self.limit(best.as_ref()) {
                    continue;
                }
                self.keep_if_better(&sequence.line, &mut best);
                open.push(Reverse((Length(sequence.line.bound), sequences.len())));
                sequences.push(sequence);
            }
            let Some(Reverse((Length(bound), number))) = open.pop() else { break };
            if bound >= self.limit(best.as_ref()) {
                break;
            }
            if self.moves > MAX_MOVES {
                return None;
            }
            let line = &mut sequences[number].line;
            if line.gap() > PROVEN * self.scale && (line.gap() > CLOSE * self.scale || self.is_free(line, LOOSE * self.scale)) {
                self.moves += line.tighten(self.place());
                self.keep_if_better(line, &mut best);
            }
            if line.gap() > CLOSE * self.scale {
                doubt = doubt.min(line.bound);
            }
            self.follow(&sequences[number], self.limit(best.as_ref()), &mut found);
        }
        // A line that never came to rest may hide a shorter path than the best one.
        best.filter(|best| best.length - doubt <= CLOSE * self.scale).map(|line| line.points(&self.edges, self.ends))
    }

    fn place(&self) -> Place<'_> {
        Place { edges: &self.edges, ends: self.ends, scale: self.scale }
    }

    /// What a bound must stay below to leave room for a shorter path than the best one.
    fn limit(&self, best: Option<&Line>) -> f64 {
        best.map_or(f64::INFINITY, |best| best.length - PROVEN * self.scale)
    }

    fn keep_if_better(&self, line: &Line, best: &mut Option<Line>) {
        if best.as_ref().is_none_or(|best| line.length < best.length) && self.is_free(line, 0.0) {
            *best = Some(line.clone());
        }
    }

    /// The shortest line over these crossings, unless it must be longer than the limit.
    fn taut(&mut self, crossings: Vec<Crossing>, limit: f64) -> Line {
        let (line, moves) = Line::taut(crossings, self.place(), limit);
        self.moves += moves;
        line
    }

    /// One edge, from the start.
    fn first(&mut self) -> Vec<Sequence> {
        let [start, _] = self.ends;
        let mut found = Vec::new();
        for edge in 0..self.edges.len() {
            let e = self.edges[edge];
            for side in Side::BOTH.into_iter().filter(|&side| e.has_beside(side, start)) {
                let whole = [e.from, e.to];
                if let Some([_, seen]) = self.in_sight(|_| start, |i| e.point(division(whole, i))) {
                    let range = seen.map(|i| division(whole, i));
                    let line = self.taut(vec![Crossing::within(edge, range)], f64::INFINITY);
                    found.push(Sequence { line, out: side.other() });
                }
            }
        }
        found
    }

    /// One edge more.
    fn follow(&mut self, sequence: &Sequence, limit: f64, found: &mut Vec<Sequence>) {
        let Some(last) = sequence.line.crossings.last() else { return };
        let key = 2 * last.edge + sequence.out as usize;
        let steps = self.steps[key].take().unwrap_or_else(|| {
            let possible = steps(&self.edges, last.edge, sequence.out);
            possible.filter_map(|step| self.narrowed(last.edge, step)).collect()
        });
        for step in &steps {
            let here = [last.range[0].max(step.leave[0]), last.range[1].min(step.leave[1])];
            let twice = sequence.line.crossings.iter().any(|crossing| crossing.edge == step.edge);
            if twice || here[0] > here[1] {
                continue;
            }
            let mut crossings = sequence.line.crossings.clone();
            if let Some(last) = crossings.last_mut() {
                *last = Crossing { edge: last.edge, range: here, at: math::clamp(last.at, here[0], here[1]) };
            }
            crossings.push(Crossing::within(step.edge, step.arrive));
            let line = self.taut(crossings, limit);
            found.push(Sequence { line, out: step.enter.other() });
        }
        self.steps[key] = Some(steps);
    }

    /// A step without those parts of both edges that see nothing of the other; `None` if neither sees any.
    fn narrowed(&self, from: usize, step: Step) -> Option<Step> {
        let (a, b) = (self.edges[from], self.edges[step.edge]);
        let seen = self.in_sight(|i| a.point(division(step.leave, i)), |j| b.point(division(step.arrive, j)));
        seen.map(|[leave, arrive]| Step {
            leave: leave.map(|i| division(step.leave, i)),
            arrive: arrive.map(|j| division(step.arrive, j)),
            ..step
        })
    }

    /// The first and last points of division of two edges between which one may see the other. A cuboid that is in the way
    /// from both ends of a part to both ends of another is in the way from everywhere in the one to everywhere in the other,
    /// because what a convex body hides from a point is convex.
    fn in_sight(&self, a: impl Fn(usize) -> [f64; 3], b: impl Fn(usize) -> [f64; 3]) -> Option<[[usize; 2]; 2]> {
        let mut hidden = [[false; PARTS]; PARTS];
        for barrier in &self.barriers {
            let meets: [[bool; PARTS + 1]; PARTS + 1] = from_fn(|i| from_fn(|j| barrier.meets(a(i), b(j))));
            for (i, row) in hidden.iter_mut().enumerate() {
                for (j, hidden) in row.iter_mut().enumerate() {
                    *hidden |= meets[i][j] && meets[i + 1][j] && meets[i][j + 1] && meets[i + 1][j + 1];
                }
            }
        }
        let ends = |seen: &dyn Fn(usize) -> bool| {
            let first = (0..PARTS).find(|&i| seen(i))?;
            (0..PARTS).rfind(|&i| seen(i)).map(|last| [first, last + 1])
        };
        let leave = ends(&|i| hidden[i].contains(&false))?;
        let arrive = ends(&|j| hidden.iter().any(|row| !row[j]))?;
        Some([leave, arrive])
    }

    /// Whether a line goes no deeper than `by` into anything.
    fn is_free(&self, line: &Line, by: f64) -> bool {
        let points = line.points(&self.edges, self.ends);
        points.windows(2).all(|w| !self.barriers.iter().any(|barrier| grow(barrier, -by).meets(w[0], w[1])))
    }
}

/// The `i`th of the points that divide a range into [`PARTS`].
fn division(range: [f64; 2], i: usize) -> f64 {
    if i == PARTS { range[1] } else { range[0] + (range[1] - range[0]) * (i as f64 / PARTS as f64) }
}
