//! The exact shortest path of a round robot's centre through a grid, at any angle: A* over tangents made on demand.
//!
//! The blocked cells grown by the robot's radius have rounded corners. A shortest path is made of straight pieces that
//! are tangent to circles about the cells' convex corners (or end in start or goal) and of arcs on these circles, each
//! within the quarter into which its corner points. A point robot's circles have no radius, and the same rules hold.
//! Of two corners that a tangent joins, one sees the other past the blocked cells as they are: the robot sweeps a convex
//! strip with both corners on its rim and nothing inside. So `lattice` finds the candidates by sight, exactly.
//! The grid's bounds are convex, so a shortest path never bends there; it only must not leave them.

mod lattice;
mod outline;
#[cfg(test)]
mod tests;

use std::{cmp::Reverse, collections::BinaryHeap, f64::consts::FRAC_PI_2};

use crate::{
    geometry::Field,
    kernel::Exact,
    math::{self, Length},
};

use lattice::Lattice;

/// How deep, relative to the grid's size, a tangent may seem to cut a third corner before it counts as blocked:
/// tangents that touch three corners are common on grids and must not be lost to rounding.
const SLACK: f64 = 1e-11;

/// How much wider, relative to the grid's size, the robot is taken to be if it does not fit through a gap of its own
/// width: more than the slack.
const WIDER: f64 = 1e-10;

/// How far a path may seem to turn the wrong way, in radians: rounding again.
const BACK: f64 = 1e-9;

/// How near, in cells, a point passes what it touches. [`Field`] allows it as much.
const HAIR: f64 = 1e-9;

/// The shortest path from `start` to `goal` through a grid; `None` if there is none. The grid has `columns` cells per row,
/// `blocked` row by row, each a square of side `cell`; `field` must be made from them and holds the robot. The path may touch
/// obstacles and stays in the grid. A point robot may run along blocked cells, but not between two of them or between one and
/// the grid's border, and where two touch diagonally it passes only if `squeeze` allows it.
///
/// Where a gap is exactly as wide as the robot but for rounding, [`Field`] decides. If it closes the gap, the answer is
/// that for a robot wider by 1e-10 of the grid's size. (Except where the start or the goal touches an obstacle: then the
/// length is right, but the path may be cut by the last bit.)
///
/// There is no limit but time and memory, and both grow with what is seen from the corners that could be on the way:
/// with a quarter of the cells blocked at random, milliseconds for 30 × 30, tenths of a second for 128 × 128, some
/// seconds and 150 MB for 512 × 512; far less where more or much less is blocked.
pub fn shortest_on_grid(
    [start, goal]: [[f64; 2]; 2],
    cell: f64,
    columns: usize,
    blocked: &[bool],
    field: &Field,
    squeeze: bool,
) -> Option<Exact> {
    if start == goal {
        return Some(Exact::way(0.0, vec![start, goal]));
    }
    let solve = |wider| Search::new([start, goal], cell, Lattice::new(columns, blocked, squeeze, field.radius() > 0.0), field, wider).run();
    let (exact, is_free) = solve(0.0)?;
    if is_free {
        return Some(exact);
    }
    // By rounding the robot does not fit where it just should. One wider by a hair goes elsewhere, or nowhere; unless an end
    // has no room for it.
    let hair = 2.0 * WIDER * field.size()[0].max(field.size()[1]);
    let roomy = [start, goal].iter().all(|&end| field.is_nearly_free(end, end, -hair));
    solve(WIDER).map(|(wider, _)| wider).or_else(|| (!roomy).then_some(exact))
}

/// Places where a path can turn are numbered: the start, the goal, then each corner twice, for left and right turns.
const START: usize = 0;
const GOAL: usize = 1;

/// A straight piece from one turn to the next.
#[derive(Clone, Copy)]
struct Edge {
    from: usize,
    to: usize,
    /// Its direction, of length 1.
    along: [f64; 2],
    length: f64,
    /// How far into the quarter of the corner it comes from it leaves, in radians as the path turns.
    leave: f64,
    /// How far into the quarter of the corner it goes to it arrives.
    arrive: f64,
    /// The straight distance from its end to the goal.
    ahead: f64,
    /// The least cost it was left with so far, less the arc from the quarter's beginning.
    best: f64,
    state: State,
}

#[derive(Clone, Copy, PartialEq)]
enum State {
    Unknown,
    Free,
    Blocked,
}

/// How near a line of the grid an end must be to lie on it, in cells.
const SNAP: f64 = 1e-9;

/// A turn that was reached.
struct Turn {
    /// Its edges, by where they leave.
    edges: std::ops::Range<usize>,
    /// What other blocked cells cover of the quarter, in radians as the path turns.
    covered: Vec<[f64; 2]>,
}

/// A path so far: to the end of `edge`, of this length.
struct Label {
    length: f64,
    /// `Edge::best` at the time.
    cost: f64,
    edge: usize,
    /// The label before; its own number if there is none.
    via: usize,
}

/// In cells, not in the scene's unit.
struct Search<'a> {
    /// Start and goal in the scene's unit.
    given: [[f64; 2]; 2],
    ends: [[f64; 2]; 2],
    cell: f64,
    radius: f64,
    /// The longer side of the grid.
    size: f64,
    /// How much less than the radius a straight piece may stay away.
    slack: f64,
    field: &'a Field,
    lattice: Lattice<'a>,
    turns: Vec<Option<Turn>>,
    edges: Vec<Edge>,
    /// Scratch space.
    seen: Vec<usize>,
}

impl<'a> Search<'a> {
    fn new(given: [[f64; 2]; 2], cell: f64, lattice: Lattice<'a>, field: &'a Field, wider: f64) -> Self {
        let turns = (0..2 + 2 * lattice.corners().len()).map(|_| None).collect();
        let [width, height] = lattice.size();
        let size = width.max(height);
        // A coordinate that is a line of the grid but for rounding (0.1 · 3 / 0.1) is that line; none lies outside.
        let snap = |p: f64, most: f64| {
            let (c, line) = (p / cell, (p / cell).round());
            math::clamp(if (c - line).abs() <= SNAP { line } else { c }, 0.0, most)
        };
        let ends = given.map(|p| [snap(p[0], width), snap(p[1], height)]);
        let radius = field.radius() / cell + if field.radius() > 0.0 { wider * size } else { 0.0 };
        Self { given, ends, cell, radius, size, slack: (SLACK - wider) * size, field, lattice, turns, edges: Vec::new(), seen: Vec::new() }
    }

    /// The shortest path, and whether its outline is free to the bit.
    fn run(mut self) -> Option<(Exact, bool)> {
        let mut labels: Vec<Label> = Vec::new();
        let mut open = BinaryHeap::new();
        self.leave(START, 0.0);
        for (edge, e) in self.edges.iter_mut().enumerate() {
            e.best = 0.0;
            open.push(Reverse((Length(e.length + e.ahead), edge)));
            labels.push(Label { length: e.length, cost: 0.0, edge, via: edge });
        }
        while let Some(Reverse((_, at))) = open.pop() {
            let Label { length, cost, edge, .. } = labels[at];
            // Most edges are never the best way to anywhere, so they are looked at only now.
            if cost > self.edges[edge].best || !self.is_free(edge) {
                continue;
            }
            let &Edge { to, arrive, .. } = &self.edges[edge];
            if to == GOAL {
                let (path, is_free) = self.outline(&labels, at);
                return Some((Exact::way(length * self.cell, path), is_free));
            }
            if self.radius <= 0.0 && self.turns[to].is_some() {
                // A point got here by a shorter way, from where it could go on as well.
                continue;
            }
            let edges = self.leave(to, arrive);
            let end = self.end_of_arc(to, arrive);
            let cost = length - self.radius * arrive;
            let begin = edges.start + self.edges[edges.clone()].partition_point(|edge| edge.leave < arrive - BACK);
            for next in begin..edges.end {
                let e = &mut self.edges[next];
                if e.leave > end + BACK || cost >= e.best {
                    break; // whoever left here cheaper did so further on as well
                }
                e.best = cost;
                if e.state != State::Blocked {
                    let length = length + self.radius * (e.leave - arrive).max(0.0) + e.length;
                    open.push(Reverse((Length(length + e.ahead), labels.len())));
                    labels.push(Label { length, cost, edge: next, via: at });
                }
            }
        }
        None
    }

    /// Where a turn is, and how it goes: 1 left (about a centre on the left), −1 right, 0 not at all.
    fn center(&self, turn: usize) -> ([f64; 2], f64) {
        if turn < 2 { (self.ends[turn], 0.0) } else { (self.lattice.corners()[turn / 2 - 1].at, if is_left(turn) { 1.0 } else { -1.0 }) }
    }

    /// The point of the turn where a straight piece in the direction `along` touches its circle, and which way it is
    /// from the centre.
    fn touch(&self, turn: usize, along: [f64; 2]) -> ([f64; 2], [f64; 2]) {
        let ([x, y], side) = self.center(turn);
        let out = [side * along[1], -side * along[0]];
        ([x + self.radius * out[0], y + self.radius * out[1]], out)
    }

    /// How far into the quarter of a turn's corner the direction `out` is, in radians as the path turns; a little
    /// outside counts as at its border. `None` outside. (0 for start and goal.)
    fn turned(&self, turn: usize, out: [f64; 2]) -> Option<f64> {
        if turn < 2 {
            return Some(0.0);
        }
        let [x, y] = match self.lattice.corners()[turn / 2 - 1].quarter {
            0 => out,
            1 => [out[1], -out[0]],
            2 => [-out[0], -out[1]],
            _ => [-out[1], out[0]],
        };
        let inside = x >= -BACK && y >= -BACK;
        // Not `max`: it may leave −0, of which the arc tangent makes half a turn.
        let [x, y] = [x, y].map(|c| if c > 0.0 { c } else { 0.0 });
        inside.then(|| if is_left(turn) { math::atan2(y, x) } else { math::atan2(x, y) })
    }

    /// The edges that leave a turn where one arrives so far into its quarter; made at the first call. (A point calls once.)
    fn leave(&mut self, turn: usize, arrive: f64) -> std::ops::Range<usize> {
        if let Some(turn) = &self.turns[turn] {
            return turn.edges.clone();
        }
        let begin = self.edges.len();
        let mut seen = std::mem::take(&mut self.seen);
        self.look(turn, arrive, &mut seen);
        // A corner between two quadrants is seen in both.
        math::sort_indices(&mut seen);
        seen.dedup();
        self.join(turn, GOAL);
        for corner in seen.drain(..) {
            self.join(turn, 2 + 2 * corner);
            self.join(turn, 3 + 2 * corner);
        }
        self.seen = seen;
        let unordered = self.edges.split_off(begin);
        self.edges.extend(math::ordered(unordered.iter().map(|edge| edge.leave)).into_iter().map(|(_, place)| unordered[place]));
        let edges = begin..self.edges.len();
        self.turns[turn] = Some(Turn { edges: edges.clone(), covered: self.covered(turn) });
        edges
    }

    /// The corners that tangents from a turn can lead to.
    fn look(&self, turn: usize, arrive: f64, seen: &mut Vec<usize>) {
        const ALL: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];
        let (at, side) = self.center(turn);
        if turn < 2 {
            (0..4).for_each(|quadrant| self.lattice.seen(at, quadrant, half(quadrant), seen));
            return;
        }
        let quarter = self.lattice.corners()[turn / 2 - 1].quarter;
        // A path about a corner goes at right angles to the quarter it points into.
        let quadrant = if side > 0.0 { (quarter + 1) % 4 } else { (quarter + 3) % 4 };
        if self.radius > 0.0 {
            // A tangent to the far side of another circle crosses the line between the centres.
            self.lattice.seen(at, quadrant, ALL, seen);
            if quadrant / 2 != quarter / 2 {
                self.lattice.seen(at, quarter, ALL, seen);
            }
            return;
        }
        // A point need not look back from where it is going. A left turn in the first quadrant goes from slope +∞ to 0.
        let [low, high] = half(quadrant);
        let (sine, cosine) = (math::sin(arrive), math::cos(arrive));
        let left = side > 0.0;
        let upright = left == (quadrant.is_multiple_of(2)); // whether it turns towards the upright
        let slope = if upright { cosine / sine } else { sine / cosine } * (if upright { 1.0 + BACK } else { 1.0 - BACK });
        let range = match (low < 0.0, upright) {
            (false, true) => [low, slope],
            (false, false) => [slope - BACK, high],
            (true, true) => [-slope, high],
            (true, false) => [low, BACK - slope],
        };
        self.lattice.seen(at, quadrant, range, seen);
    }

    /// Adds the tangent from one turn to another, if it leaves and arrives in the corners' quarters.
    fn join(&mut self, from: usize, to: usize) {
        let ((a, side), (b, other)) = (self.center(from), self.center(to));
        let between = [b[0] - a[0], b[1] - a[1]];
        let squared = between[0] * between[0] + between[1] * between[1];
        let distance = squared.sqrt();
        // How much further left the centre it goes to must lie than the one it comes from.
        let offset = (other - side) * self.radius;
        let sine = if offset == 0.0 { 0.0 } else { offset / distance };
        if from == to || sine.abs() > 1.0 + SLACK || sine.is_nan() {
            return;
        }
        // Circles that touch: what is left of the cosine is rounding.
        let cosine = if sine.abs() > 1.0 - SLACK { 0.0 } else { (1.0 - sine * sine).sqrt() };
        let unit = [between[0] / distance, between[1] / distance];
        let along = [unit[0] * cosine + unit[1] * sine, unit[1] * cosine - unit[0] * sine];
        let ((p, out), (q, inward)) = (self.touch(from, along), self.touch(to, along));
        let size = self.lattice.size();
        let slack = SLACK * self.size;
        let inside = |p: [f64; 2]| (0..2).all(|axis| p[axis] >= -slack && p[axis] <= size[axis] + slack);
        let (Some(leave), Some(arrive)) = (self.turned(from, out), self.turned(to, inward)) else { return };
        if inside(p) && inside(q) {
            let [gx, gy] = self.ends[GOAL];
            let ahead = ((gx - q[0]) * (gx - q[0]) + (gy - q[1]) * (gy - q[1])).sqrt();
            let length = distance * cosine;
            self.edges.push(Edge { from, to, along, length, leave, arrive, ahead, best: f64::INFINITY, state: State::Unknown });
        }
    }

    /// Where an edge begins and ends.
    fn points(&self, edge: usize) -> [[f64; 2]; 2] {
        let Edge { from, to, along, .. } = self.edges[edge];
        [from, to].map(|turn| self.touch(turn, along).0)
    }

    fn is_free(&mut self, edge: usize) -> bool {
        if self.edges[edge].state == State::Unknown {
            let [a, b] = self.points(edge);
            let [from, to] = [a, b].map(|p| p.map(|c| c * self.cell));
            let seen = self.radius <= 0.0 && self.edges[edge].to != GOAL; // by sight: exact
            let free = seen
                || self.field.is_nearly_free(from, to, self.slack * self.cell) && (self.radius > 0.0 || !self.lattice.slips(a, b, HAIR));
            self.edges[edge].state = if free { State::Free } else { State::Blocked };
        }
        self.edges[edge].state == State::Free
    }

    /// How far a path can follow the circle of a turn.
    fn end_of_arc(&self, turn: usize, arrive: f64) -> f64 {
        let covered = self.turns[turn].as_ref().map_or(&[][..], |turn| &turn.covered);
        covered.iter().filter(|piece| piece[1] > arrive + BACK).map(|piece| piece[0].max(arrive)).fold(FRAC_PI_2, f64::min)
    }

    /// The pieces of a turn's quarter that other blocked cells cover.
    fn covered(&self, turn: usize) -> Vec<[f64; 2]> {
        let mut pieces = Vec::new();
        if turn < 2 || self.radius <= 0.0 {
            return pieces;
        }
        let corner = self.lattice.corners()[turn / 2 - 1];
        let [cx, cy] = corner.at;
        let reach = 2.0 * self.radius;
        let rows = (cy - reach - 1.0).max(0.0) as usize..((cy + reach).ceil() as usize).min(self.lattice.rows());
        for row in rows {
            let runs = self.lattice.runs(row);
            let begin = runs.partition_point(|run| run[1] < cx - reach);
            for run in runs[begin..].iter().take_while(|run| run[0] <= cx + reach) {
                // As seen from the corner, turned so that it points north-east; in radii.
                let (x, y) = (run.map(|x| (x - cx) / self.radius), [0.0, 1.0].map(|up| (row as f64 + up - cy) / self.radius));
                let (x, y) = match corner.quarter {
                    0 => (x, y),
                    1 => (y, [-x[1], -x[0]]),
                    2 => ([-x[1], -x[0]], [-y[1], -y[0]]),
                    _ => ([-y[1], -y[0]], x),
                };
                cover(x, y, &mut pieces);
            }
        }
        if !is_left(turn) {
            pieces.iter_mut().for_each(|piece| *piece = [FRAC_PI_2 - piece[1], FRAC_PI_2 - piece[0]]);
        }
        pieces
    }
}

/// Whether a turn at a corner is a left turn.
fn is_left(turn: usize) -> bool {
    turn.is_multiple_of(2)
}

/// The slopes of a quadrant.
fn half(quadrant: usize) -> [f64; 2] {
    if quadrant == 0 || quadrant == 3 { [0.0, f64::INFINITY] } else { [f64::NEG_INFINITY, 0.0] }
}

/// Appends the angles from 0 to π/2 at which the unit circle runs within 1 of the rectangle: inside one of two boxes or
/// of four discs.
fn cover([x0, x1]: [f64; 2], [y0, y1]: [f64; 2], pieces: &mut Vec<[f64; 2]>) {
    let mut push = |from: f64, to: f64| {
        let (from, to) = (from.max(0.0), to.min(FRAC_PI_2));
        if to > from + BACK {
            pieces.push([from, to]);
        }
    };
    let angle = |cosine: f64| math::acos(cosine.clamp(0.0, 1.0));
    for [dx, dy] in [[1.0, 0.0], [0.0, 1.0]] {
        // Both coordinates are monotone on the quarter. sin t > y is t > π/2 − acos y.
        let (low, high) = (angle(x1 + dx), angle(x0 - dx));
        push(low.max(FRAC_PI_2 - angle(y0 - dy)), high.min(FRAC_PI_2 - angle(y1 + dy)));
    }
    for x in [x0, x1] {
        for y in [y0, y1] {
            let distance = (x * x + y * y).sqrt();
            // The corner itself is exactly 1 away.
            if distance > BACK && distance < 2.0 {
                let (middle, reach) = (math::atan2(y, x), math::acos(distance / 2.0));
                push(middle - reach, middle + reach);
            }
        }
    }
}
