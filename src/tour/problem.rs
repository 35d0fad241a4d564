//! What a tour planner searches: an order of stops between fixed ends, and its length.
//!
//! Every kind of tour is a row of stops between a head and a tail that stay where they are. A closed tour leaves the first
//! stop and comes back to it; an open one comes from nowhere, or leads there, at no cost. So a move need not know what
//! kind of tour it changes.
//!
//! A fixed edge between two stops has a negative cost, larger in size than any tour is long, so that none without it is better; the
//! length of a tour that has all of them is that of its other ways.

use crate::{
    exact::Distances,
    kernel::{State, TourEnds},
};

/// A stop's number; the one after the last is nowhere.
pub type Stop = u32;

/// Distances between stops, and what the ends of a tour are.
#[derive(Debug, Clone, PartialEq, State)]
pub struct Problem {
    /// How many stops.
    #[state(shared)]
    pub n: usize,
    /// What the ends are.
    #[state(shared)]
    pub round: TourEnds,
    /// Row by row, nowhere last; empty where distances are computed. A fixed edge counts less by a bonus.
    #[state(skip)]
    d: Vec<f64>,
    /// What they are computed by.
    #[state(shared)]
    distances: Option<Distances>,
    /// All bonuses: what a tour with all fixed edges has too little.
    #[state(skip)]
    bonuses: f64,
}

impl Problem {
    /// Tours with such ends by these distances.
    pub fn new(given: &Distances, round: TourEnds) -> Self {
        let n = given.len();
        let mut d = Vec::new();
        let distances = (!given.points().is_empty()).then(|| given.clone());
        if distances.is_none() {
            d.reserve_exact((n + 1) * (n + 1));
            for row in given.rows() {
                d.extend_from_slice(row);
                d.push(0.0);
            }
            d.resize((n + 1) * (n + 1), 0.0);
        }
        for &[a, b] in given.fixed() {
            d[a * (n + 1) + b] = given.counted(a, b);
            d[b * (n + 1) + a] = given.counted(b, a);
        }
        Self { n, round, d, distances, bonuses: given.bonuses() }
    }

    /// From one stop to another; 0 from and to nowhere.
    #[inline]
    pub fn d(&self, a: Stop, b: Stop) -> f64 {
        // Where distances are computed there is nothing to look up: what the bounds are checked for anyway.
        match self.d.get(a as usize * (self.n + 1) + b as usize) {
            Some(d) => *d,
            None => self.computed(a, b),
        }
    }

    #[cold]
    #[inline(never)]
    fn computed(&self, a: Stop, b: Stop) -> f64 {
        match &self.distances {
            Some(distances) if a.max(b) < self.nowhere() => distances.between(a as usize, b as usize),
            _ => 0.0,
        }
    }

    /// The points of so many stops that distances are computed; empty where they are kept.
    pub(super) fn points(&self) -> &[[f64; 2]] {
        self.distances.as_ref().map_or(&[], |distances| distances.points())
    }

    fn nowhere(&self) -> Stop {
        self.n as Stop
    }

    /// What comes before the row of stops that may be moved.
    pub fn head(&self) -> Stop {
        if self.round == TourEnds::Open { self.nowhere() } else { 0 }
    }

    /// What comes behind it.
    pub fn tail(&self) -> Stop {
        match self.round {
            TourEnds::Closed => 0,
            TourEnds::Open | TourEnds::FromFirst => self.nowhere(),
            TourEnds::FirstToLast => (self.n - 1) as Stop,
        }
    }

    /// The stops that may be moved, by their numbers.
    pub fn movable(&self) -> std::ops::Range<Stop> {
        let n = self.n as Stop;
        match self.round {
            TourEnds::Open => 0..n,
            TourEnds::Closed | TourEnds::FromFirst => 1..n,
            TourEnds::FirstToLast => 1..n - 1,
        }
    }

    /// Whether a tour and its reverse are the same.
    pub fn two_way(&self) -> bool {
        self.head() == self.tail()
    }

    /// The length of a row with its head and tail, [ANTBAT](crate#papers) (6).
    pub fn length(&self, row: &[Stop]) -> f64 {
        row.windows(2).map(|w| self.d(w[0], w[1])).sum::<f64>() + self.bonuses
    }
}

/// A tour: its row of stops with head and tail, and its length.
#[derive(Debug, Clone, PartialEq, State)]
pub struct Tour {
    /// Head, stops, tail.
    pub row: Vec<Stop>,
    /// By [`Tour::settle`]: to the last bit the same for the same tour, however it was found.
    pub length: f64,
}

impl Tour {
    /// Through the stops in the order of their numbers.
    pub fn first(problem: &Problem) -> Self {
        let mut row = vec![problem.head()];
        row.extend(problem.movable());
        row.push(problem.tail());
        let mut tour = Self { row, length: 0.0 };
        tour.settle(problem);
        tour
    }

    /// How many bytes one through so many stops takes at the most: the same number wherever it runs.
    pub(super) fn bytes(stops: usize) -> usize {
        32 + (stops + 2) * size_of::<Stop>()
    }

    /// How many stops may be moved.
    pub fn len(&self) -> usize {
        self.row.len() - 2
    }

    /// Whether none may be moved.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Puts the row into the one direction that counts and adds its length up anew: sums of differences lose digits.
    pub fn settle(&mut self, problem: &Problem) {
        let m = self.len();
        if problem.two_way() && m > 1 && self.row[1] > self.row[m] {
            self.row[1..=m].reverse();
        }
        self.length = problem.length(&self.row);
    }

    /// Takes over another tour without allocating.
    pub fn copy_from(&mut self, other: &Self) {
        self.row.copy_from_slice(&other.row);
        self.length = other.length;
    }

    /// The stops' numbers in order, the fixed ends among them.
    pub fn order(&self, problem: &Problem) -> Vec<usize> {
        let end = if problem.round == TourEnds::Closed { self.row.len() - 1 } else { self.row.len() };
        self.row[..end].iter().map(|&stop| stop as usize).filter(|&stop| stop < problem.n).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_of_tour_is_a_row_between_two_ends() {
        // Stops on a line at 0, 1, 3, 7.
        let at = [0.0_f64, 1.0, 3.0, 7.0];
        let distances = Distances::of(4, |i, j| (at[i] - at[j]).abs());
        let tour = |round| {
            let problem = Problem::new(&distances, round);
            let mut tour = Tour::first(&problem);
            let m = tour.len();
            tour.row[1..=m].reverse();
            tour.settle(&problem);
            (tour.order(&problem), tour.length)
        };
        assert_eq!(tour(TourEnds::Closed), (vec![0, 1, 2, 3], 14.0), "the reverse is the same tour");
        assert_eq!(tour(TourEnds::Open), (vec![0, 1, 2, 3], 7.0));
        assert_eq!(tour(TourEnds::FromFirst), (vec![0, 3, 2, 1], 13.0));
        assert_eq!(tour(TourEnds::FirstToLast), (vec![0, 2, 1, 3], 3.0 + 2.0 + 6.0));
    }

    #[test]
    fn two_stops_are_a_tour_too() {
        let distances = Distances::of(2, |_, _| 5.0);
        for round in TourEnds::ALL {
            let problem = Problem::new(&distances, round);
            let tour = Tour::first(&problem);
            assert_eq!(tour.order(&problem), [0, 1]);
            assert_eq!(tour.length, if round.closes() { 10.0 } else { 5.0 });
        }
    }
}
