//! Local search: 2-opt and Or-opt moves that make a tour shorter, until neither does (Bentley 1992).
//!
//! A stop is looked at only while something near it has changed, and only its nearest neighbours count as new ones: a move
//! that helps makes some stop's way shorter. A move's gain is known in O(1) before it is made.

use std::{cell::Cell, collections::VecDeque, sync::Arc};

use super::{
    field::{Field, Nearest},
    moves::turn,
    problem::{Problem, Stop, Tour},
};
use crate::kernel::{Digest, State, rng::Stream};

/// How many neighbours of a stop are tried.
const NEIGHBOURS: usize = 10;
/// The longest stretch that is moved as a whole.
const STRETCH: usize = 3;
/// A stop has no such place.
const NONE: usize = u32::MAX as usize;
/// How a hash has it: as it was when places had sixteen bits.
const NONE_HASHED: u64 = 0xffff;

/// The place of each stop in a row, or that it has none.
#[derive(Debug, Clone)]
struct Places(Vec<u32>);

impl State for Places {
    fn digest(&self, out: &mut Digest) {
        out.word(self.0.len() as u64);
        self.0.iter().for_each(|&place| out.word(if place as usize == NONE { NONE_HASHED } else { place.into() }));
    }

    fn heap_size(&self) -> usize {
        self.0.heap_size()
    }
}

impl Places {
    fn none(stops: usize) -> Self {
        Self(vec![NONE as u32; stops + 1])
    }

    #[inline]
    fn of(&self, stop: Stop) -> usize {
        self.0[stop as usize] as usize
    }

    #[inline]
    fn set(&mut self, stop: Stop, place: usize) {
        self.0[stop as usize] = place as u32;
    }
}

/// Each stop's nearest neighbours with their distances, the nearest first.
pub fn neighbours(problem: &Problem) -> Arc<[Vec<(f64, Stop)>]> {
    let n = problem.n as Stop;
    if !problem.points().is_empty() {
        let field = Field::new(problem.points(), &(0..n).collect::<Vec<_>>());
        let nearest = |stop: Stop| {
            let mut found = field.nearest(stop, NEIGHBOURS);
            found.iter_mut().for_each(|(d, other)| *d = problem.d(stop, *other));
            found
        };
        return (0..n).map(nearest).collect();
    }
    let nearest = |stop: Stop| {
        let mut nearest = Nearest::new(NEIGHBOURS);
        (0..n).filter(|other| *other != stop).for_each(|other| nearest.offer(problem.d(stop, other), other));
        nearest.found
    };
    (0..n).map(nearest).collect()
}

/// A move that makes the tour shorter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Move {
    /// The stops at these places are reversed: 2-opt.
    Reverse(usize, usize),
    /// The stops from the first to the second place go behind the third, backwards or not: Or-opt.
    Carry(usize, usize, usize, bool),
}

/// The local search of one row at a time: [`LocalSearch::polish`] at once, or [`LocalSearch::load`] and step by step. Rows are
/// those of tours of its problem.
#[derive(Debug, Clone, State)]
pub struct LocalSearch {
    #[state(shared)]
    problem: Arc<Problem>,
    #[state(shared)]
    near: Arc<[Vec<(f64, Stop)>]>,
    /// Where a stop stands with another behind it, and where it stands behind another. They differ for the ends alone: the
    /// first stop of a closed tour is its head and its tail.
    left: Places,
    right: Places,
    /// Stops to look at.
    queue: VecDeque<Stop>,
    queued: Vec<bool>,
    /// Gains below this may be rounding: two tours must not each be shorter than the other.
    #[state(skip)]
    least: f64,
    /// How many moves were measured.
    tried: Cell<u64>,
}

impl LocalSearch {
    /// For tours of a problem.
    pub fn new(problem: &Arc<Problem>) -> Self {
        let n = problem.n;
        Self {
            problem: Arc::clone(problem),
            near: neighbours(problem),
            left: Places::none(n),
            right: Places::none(n),
            queue: VecDeque::with_capacity(n + 1),
            queued: vec![false; n + 1],
            least: 0.0,
            tried: Cell::new(0),
        }
    }

    /// Begins with a row; nothing in it is to be looked at yet.
    pub fn load(&mut self, row: &[Stop]) {
        self.queue.clear();
        self.queued.fill(false);
        self.settle(row, 0, row.len() - 1);
        self.left.set(row[row.len() - 1], NONE);
        self.right.set(row[0], NONE);
        self.left.set(row[0], 0);
        self.right.set(row[row.len() - 1], row.len() - 1);
        self.least = 1e-10 * self.problem.length(row) / row.len() as f64;
    }

    /// Notes where the stops at some places stand; the ends keep theirs.
    fn settle(&mut self, row: &[Stop], from: usize, to: usize) {
        for (place, &stop) in (from..).zip(&row[from..=to]) {
            self.left.set(stop, place);
            self.right.set(stop, place);
        }
    }

    /// How many moves it has measured so far.
    pub fn tried(&self) -> u64 {
        self.tried.get()
    }

    fn count(&self) {
        self.tried.set(self.tried.get() + 1);
    }

    /// A stop near which something has changed: it is looked at again.
    pub fn touch(&mut self, stop: Stop) {
        let i = stop as usize;
        if i < self.problem.n && !self.queued[i] {
            self.queued[i] = true;
            self.queue.push_back(stop);
        }
    }

    /// Makes one move that helps; its gain. `None`: no more is found.
    pub fn step(&mut self, row: &mut [Stop]) -> Option<f64> {
        while let Some(&stop) = self.queue.front() {
            if let Some((change, gain)) = self.reversal(row, stop).or_else(|| self.carry(row, stop)).or_else(|| self.fetch(row, stop)) {
                self.apply(row, change);
                return Some(gain);
            }
            self.queue.pop_front();
            self.queued[stop as usize] = false;
        }
        None
    }

    /// Makes moves until none helps; what they gain together.
    pub fn descend(&mut self, row: &mut [Stop]) -> f64 {
        let mut gained = 0.0;
        while let Some(gain) = self.step(row) {
            gained += gain;
        }
        gained
    }

    /// Takes over what is known of another row, without allocating.
    pub fn copy_from(&mut self, other: &Self) {
        self.left.0.copy_from_slice(&other.left.0);
        self.right.0.copy_from_slice(&other.right.0);
    }

    /// Every stop is to be looked at.
    pub fn touch_all(&mut self) {
        (0..self.problem.n as Stop).for_each(|stop| self.touch(stop));
    }

    /// A tour that is as short as moves can make it. (What changes near one stop can give another a move; so all stops are
    /// looked at until none has one.)
    pub fn polish(&mut self, tour: &mut Tour) {
        self.load(&tour.row);
        self.touch_all();
        while self.step(&mut tour.row).is_some() {
            self.descend(&mut tour.row);
            self.touch_all();
        }
        tour.settle(&self.problem);
    }

    /// The first 2-opt move that brings a near neighbour behind a stop, or before it.
    fn reversal(&self, row: &[Stop], a: Stop) -> Option<(Move, f64)> {
        let d = |a, b| self.problem.d(a, b);
        let near = &self.near[a as usize];
        let p = self.left.of(a);
        if p != NONE {
            let b = row[p + 1];
            let old = d(a, b);
            for &(apart, c) in near {
                let nearer = old - apart;
                if nearer <= self.least {
                    break;
                }
                let q = self.left.of(c);
                if q == NONE {
                    continue;
                }
                self.count();
                let gain = nearer + d(c, row[q + 1]) - d(b, row[q + 1]);
                if gain > self.least {
                    return Some((Move::Reverse(p.min(q) + 1, p.max(q)), gain));
                }
            }
        }
        let p = self.right.of(a);
        if p != NONE {
            let b = row[p - 1];
            let old = d(a, b);
            for &(apart, c) in near {
                let nearer = old - apart;
                if nearer <= self.least {
                    break;
                }
                let q = self.right.of(c);
                if q == NONE {
                    continue;
                }
                self.count();
                let gain = nearer + d(c, row[q - 1]) - d(b, row[q - 1]);
                if gain > self.least {
                    return Some((Move::Reverse(p.min(q), p.max(q) - 1), gain));
                }
            }
        }
        None
    }

    /// The first Or-opt move that takes a stretch which begins or ends with a stop to one of its near neighbours.
    fn carry(&self, row: &[Stop], a: Stop) -> Option<(Move, f64)> {
        let d = |a, b| self.problem.d(a, b);
        let m = row.len() - 2;
        let p = self.left.of(a);
        if !(1..=m).contains(&p) || row[p] != a {
            return None; // an end stays
        }
        for (low, high, backward) in stretches(p, m) {
            let (before, behind) = (row[low - 1], row[high + 1]);
            let z = if backward { row[low] } else { row[high] };
            let taken = d(before, row[low]) + d(row[high], behind) - d(before, behind);
            for &(apart, c) in &self.near[a as usize] {
                let nearer = taken - apart;
                if nearer <= self.least {
                    break;
                }
                // Between c and the stop behind it, or between the stop before c and c: a is next to c.
                let q = self.left.of(c);
                if q != NONE && !(low - 1..=high).contains(&q) {
                    self.count();
                    let gain = nearer + d(c, row[q + 1]) - d(z, row[q + 1]);
                    if gain > self.least {
                        return Some((Move::Carry(low, high, q, backward), gain));
                    }
                }
                let q = self.right.of(c);
                if q != NONE && !(low..=high + 1).contains(&q) {
                    self.count();
                    let gain = nearer + d(row[q - 1], c) - d(z, row[q - 1]);
                    if gain > self.least {
                        return Some((Move::Carry(low, high, q - 1, !backward), gain));
                    }
                }
            }
        }
        None
    }

    /// The first Or-opt move that fetches a stretch which begins or ends with a near neighbour of a stop: between that stop
    /// and the one behind it, or the one before it.
    fn fetch(&self, row: &[Stop], c: Stop) -> Option<(Move, f64)> {
        let d = |a, b| self.problem.d(a, b);
        let m = row.len() - 2;
        for after in [true, false] {
            let q = if after { self.left.of(c) } else { self.right.of(c) };
            if q == NONE {
                continue;
            }
            // The stretch goes behind the place `gap`.
            let (other, gap) = if after { (row[q + 1], q) } else { (row[q - 1], q - 1) };
            let old = d(c, other);
            for &(apart, a) in &self.near[c as usize] {
                let nearer = old - apart;
                if nearer <= self.least {
                    break;
                }
                let p = self.left.of(a);
                if !(1..=m).contains(&p) || row[p] != a {
                    continue;
                }
                for (low, high, backward) in stretches(p, m) {
                    if (low - 1..=high).contains(&gap) {
                        continue;
                    }
                    let z = if backward { row[low] } else { row[high] };
                    let taken = d(row[low - 1], row[low]) + d(row[high], row[high + 1]) - d(row[low - 1], row[high + 1]);
                    self.count();
                    let gain = nearer + taken - d(z, other);
                    if gain > self.least {
                        return Some((Move::Carry(low, high, gap, backward == after), gain));
                    }
                }
            }
        }
        None
    }

    /// Carries a move out; the stops at its seams are to be looked at again.
    fn apply(&mut self, row: &mut [Stop], change: Move) {
        match change {
            Move::Reverse(i, j) => {
                row[i..=j].reverse();
                self.settle(row, i, j);
                [i - 1, i, j, j + 1].into_iter().for_each(|place| self.touch(row[place]));
            }
            Move::Carry(low, high, behind, backward) => {
                if backward {
                    row[low..=high].reverse();
                }
                let length = high + 1 - low;
                let (from, to) = if behind > high {
                    turn(&mut row[low..=behind], length);
                    (low, behind)
                } else {
                    turn(&mut row[behind + 1..=high], low - behind - 1);
                    (behind + 1, high)
                };
                self.settle(row, from, to);
                let at = if behind > high { behind + 1 - length } else { behind + 1 };
                let seam = if behind > high { low } else { high + 1 };
                for place in [at - 1, at, at + length - 1, at + length, seam - 1, seam] {
                    self.touch(row[place]);
                }
            }
        }
    }

    /// Swaps two neighbouring stretches of up to 50 stops: a change that 2-opt and Or-opt moves seldom undo. What it
    /// adds to the length.
    pub fn kick(&mut self, row: &mut [Stop], rng: &mut Stream) -> f64 {
        let m = row.len() - 2;
        if m < 3 {
            return 0.0;
        }
        let span = (2 + rng.below(KICK - 1)).min(m);
        let from = 1 + rng.below(m + 1 - span);
        let middle = 1 + rng.below(span - 1);
        let d = |place: usize, other: usize| self.problem.d(row[place], row[other]);
        let (a, b, c) = (from, from + middle, from + span);
        let added = d(a - 1, b) + d(c - 1, a) + d(b - 1, c) - d(a - 1, a) - d(b - 1, b) - d(c - 1, c);
        turn(&mut row[from..from + span], middle);
        self.settle(row, from, from + span - 1);
        let seams = [from, from + span - middle, from + span];
        for place in seams {
            self.touch(row[place - 1]);
            self.touch(row[place]);
        }
        added
    }
}

/// The stretches of up to [`STRETCH`] stops, among places 1 to m, that begin or (backward) end at a place.
fn stretches(p: usize, m: usize) -> impl Iterator<Item = (usize, usize, bool)> {
    let forward = (p..(p + STRETCH).min(m + 1)).map(move |high| (p, high, false));
    let backward = (p.saturating_sub(STRETCH - 1).max(1)..p).rev().map(move |low| (low, p, true));
    forward.chain(backward)
}

/// The most stops that a kick moves.
const KICK: usize = 50;

#[cfg(test)]
mod tests {
    use super::{super::moves, *};
    use crate::{exact::Distances, kernel::TourEnds};

    fn random(n: usize, round: TourEnds, rng: &mut Stream) -> Arc<Problem> {
        let points: Vec<_> = (0..n).map(|_| [rng.unit(), rng.unit()]).collect();
        let d = |i: usize, j: usize| crate::geometry::length(&[points[i], points[j]]);
        Arc::new(Problem::new(&Distances::of(n, d), round))
    }

    #[test]
    fn every_move_gains_what_it_says_and_keeps_a_permutation() {
        let mut rng = Stream::new(3, 0);
        for case in 0..300 {
            let round = TourEnds::ALL[case % 4];
            let n = 2 + rng.below(30);
            let problem = random(n, round, &mut rng);
            let mut tour = Tour::first(&problem);
            moves::shuffle(&mut tour.row, &mut rng);
            let mut local = LocalSearch::new(&problem);
            local.load(&tour.row);
            (0..n as Stop).for_each(|stop| local.touch(stop));
            let mut length = problem.length(&tour.row);
            loop {
                while let Some(gain) = local.step(&mut tour.row) {
                    let now = problem.length(&tour.row);
                    assert!(gain > 0.0 && (length - now - gain).abs() < 1e-12, "{round:?}: {length} − {now} is not {gain}");
                    length = now;
                    assert!(round.allows(&tour.order(&problem), n));
                    let m = tour.len();
                    assert!((1..=m).all(|place| local.left.of(tour.row[place]) == place));
                }
                if rng.unit() < 0.2 {
                    break;
                }
                let added = local.kick(&mut tour.row, &mut rng);
                assert!((problem.length(&tour.row) - length - added).abs() < 1e-12);
                length = problem.length(&tour.row);
                assert!(round.allows(&tour.order(&problem), n));
            }
        }
    }

    /// With all stops as neighbours nothing is left that a 2-opt move or an insertion could gain.
    #[test]
    fn where_it_ends_no_move_helps() {
        let mut rng = Stream::new(8, 0);
        for case in 0..80 {
            let problem = random(4 + rng.below(7), TourEnds::ALL[case % 4], &mut rng);
            let mut tour = Tour::first(&problem);
            moves::shuffle(&mut tour.row, &mut rng);
            LocalSearch::new(&problem).polish(&mut tour);
            let m = tour.len();
            for i in 1..=m {
                assert!((i..=m).all(|j| moves::reversal(&problem, &tour.row, i, j) > -1e-9));
                assert!((0..=m).filter(|&j| j != i).all(|j| moves::insertion(&problem, &tour.row, i, j) > -1e-9));
            }
        }
    }
}
