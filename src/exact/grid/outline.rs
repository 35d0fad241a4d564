//! From a chain of tangents to a polyline that the exact collision test accepts.

use std::f64::consts::TAU;

use crate::math;

use super::{GOAL, Label, START, Search};

/// The least lift, relative to the grid's size: a few units in the last place.
const LIFT: f64 = 1e-15;
/// How often what is cut by rounding is lifted; each time by twice as much. The greatest lift is 1e-9 of the size.
const ROUNDS: usize = 20;

/// A point of the path, in the scene's unit: near `at`, outwards by `lift`.
struct Mark {
    at: [f64; 2],
    out: [f64; 2],
    lift: f64,
}

impl Search<'_> {
    /// The path that a label stands for; arcs as corners just outside, two degrees each. Where rounding has a piece cut
    /// a blocked cell, its ends are lifted by a hair. Also: whether that helped.
    pub(super) fn outline(&self, labels: &[Label], last: usize) -> (Vec<[f64; 2]>, bool) {
        let mut chain = vec![last];
        while let Some(&at) = chain.last().filter(|&&at| labels[at].via != at) {
            chain.push(labels[at].via);
        }
        let unit = LIFT * self.size * self.cell;
        let mut marks = Vec::new();
        for (i, &at) in chain.iter().rev().enumerate() {
            let edge = labels[at].edge;
            if i > 0 {
                self.arc(labels[chain[chain.len() - i]].edge, edge, unit, &mut marks);
            }
            self.straight(edge, &mut marks);
        }
        let mut free = false;
        for round in 0..ROUNDS {
            let lift = unit * f64::from(1 << round);
            free = true;
            for i in 1..marks.len() {
                let (a, b) = (&marks[i - 1], &marks[i]);
                let [a, b] = [a, b].map(|mark| [self.place(mark, mark.lift), self.place(mark, mark.lift.max(lift))]);
                if self.field.is_free(a[0], b[0]) {
                    continue;
                }
                free = false;
                // One end, if that will do: the other may be in a gap with no room.
                let first = self.field.is_free(a[1], b[0]);
                let second = !first && self.field.is_free(a[0], b[1]);
                for (mark, lifted) in marks[i - 1..=i].iter_mut().zip([!second, !first]) {
                    mark.lift = if lifted { mark.lift.max(lift) } else { mark.lift };
                }
            }
            if free {
                break;
            }
        }
        let mut path: Vec<_> = marks.iter().map(|mark| self.place(mark, mark.lift)).collect();
        path.dedup();
        (path, free)
    }

    fn place(&self, mark: &Mark, lift: f64) -> [f64; 2] {
        let size = self.field.size();
        std::array::from_fn(|axis| math::clamp(mark.at[axis] + lift * mark.out[axis], 0.0, size[axis]))
    }

    fn mark(&self, turn: usize, along: [f64; 2]) -> Mark {
        let (at, out) = self.touch(turn, along);
        let lifted = if self.radius > 0.0 { out } else { [0.0; 2] };
        Mark { at: at.map(|c| c * self.cell), out: lifted, lift: 0.0 }
    }

    /// Appends both ends of an edge, and the corners in between that rounding has it cut: they can be lifted.
    fn straight(&self, edge: usize, marks: &mut Vec<Mark>) {
        let edge = &self.edges[edge];
        let [mut a, mut b] = [edge.from, edge.to].map(|turn| self.mark(turn, edge.along));
        // Start and goal to the bit as they were given.
        if edge.from == START {
            a.at = self.given[START];
        }
        if edge.to == GOAL {
            b.at = self.given[GOAL];
        }
        let slack = super::SLACK * self.size * self.cell;
        let mut touched: Vec<(f64, usize)> = Vec::new();
        if self.radius > 0.0 && !self.field.is_free(a.at, b.at) {
            for (i, corner) in self.lattice.corners().iter().enumerate() {
                let [x, y] = self.beside(a.at, edge.along, corner.at);
                let touches = (y.abs() - self.radius * self.cell).abs() <= 4.0 * slack;
                if touches && x > slack && x < edge.length * self.cell - slack {
                    touched.push((x, i));
                }
            }
            math::sort(&mut touched);
        }
        let begin = a.at;
        marks.push(a);
        for (x, i) in touched {
            let [_, y] = self.beside(begin, edge.along, self.lattice.corners()[i].at);
            let side = y.signum();
            let at = [begin[0] + x * edge.along[0], begin[1] + x * edge.along[1]];
            marks.push(Mark { at, out: [side * edge.along[1], -side * edge.along[0]], lift: 0.0 });
        }
        marks.push(b);
    }

    /// Where a corner is as seen from the line from `begin` in the direction `along`: how far ahead and to the left.
    fn beside(&self, begin: [f64; 2], along: [f64; 2], corner: [f64; 2]) -> [f64; 2] {
        let (x, y) = (corner[0] * self.cell - begin[0], corner[1] * self.cell - begin[1]);
        [x * along[0] + y * along[1], y * along[0] - x * along[1]]
    }

    /// Appends what lies between the end of one edge and the beginning of the next.
    fn arc(&self, before: usize, after: usize, unit: f64, marks: &mut Vec<Mark>) {
        let (turn, from) = (self.edges[before].to, self.edges[before].arrive);
        let sweep = self.edges[after].leave - from;
        if self.radius <= 0.0 || sweep <= super::BACK {
            return;
        }
        let ([x, y], side) = self.center(turn);
        let [out_x, out_y] = self.touch(turn, self.edges[before].along).1;
        let pieces = (sweep / TAU * 180.0).ceil().max(2.0);
        let step = sweep / pieces;
        let (first, last) = (0, pieces as usize - 1);
        let radius = self.radius / math::cos(step / 2.0);
        for i in first..=last {
            let angle = side * (i as f64 + 0.5) * step;
            let (sine, cosine) = (math::sin(angle), math::cos(angle));
            let out = [out_x * cosine - out_y * sine, out_x * sine + out_y * cosine];
            let mut mark = Mark { at: [(x + radius * out[0]) * self.cell, (y + radius * out[1]) * self.cell], out, lift: unit };
            // The outermost lie on the straight pieces, and move along them: a gap may have no room for anything else.
            if let Some((edge, ahead)) = [(before, i == first, 1.0), (after, i == last, -1.0)].iter().find(|e| e.1).map(|e| (e.0, e.2)) {
                let along = self.edges[edge].along;
                let reach = ahead * radius * math::sin(step / 2.0) * self.cell;
                let end = self.mark(turn, along).at;
                mark.at = [end[0] + reach * along[0], end[1] + reach * along[1]];
                mark.out = along.map(|c| ahead * c);
            }
            marks.push(mark);
        }
    }
}
