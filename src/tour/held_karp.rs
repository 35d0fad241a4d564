//! `held-karp`: the shortest tour, by a dynamic programme over sets of stops (Held and Karp 1962; Bellman 1962).
//!
//! The shortest way from the head through all stops of a set to the last of them is the shortest way to the one before
//! it, through the others, and a step. So the sets are gone through by their size, a size an iteration; when all stops are
//! in the set, the tail follows. Nothing is random, and until the end there is no tour. Time and memory double with each
//! stop. What other planners are measured by (`exact::tours`) is computed elsewhere, on its own.

use std::sync::Arc;

use crate::{
    describe::{Case, Entry, Formula, Group, Reading, layers},
    kernel::{Progress, Readings, State, Status, rng::Stream},
    params::{Param, Parameters},
};

use super::{
    parameters::{BEST, BUILT, BY_ROAD, FAILED, FOUND, KINDS, LENGTH, ROADS, ROADS_LAYER, TOURS},
    planner,
    problem::{Problem, Stop, Tour},
    search::Search,
};

/// The most stops: 2¹⁵ sets, 4 MB.
const MOST: usize = 15;

/// The programme, as far as it was carried out.
#[derive(Clone, State)]
struct HeldKarp {
    #[state(shared)]
    problem: Arc<Problem>,
    /// The stops that may be moved; sets are of their places in this list.
    #[state(shared)]
    stops: Vec<Stop>,
    /// The shortest way through a set to a stop of it, at `set` · m + stop. Sets of one size at a time are filled in.
    shortest: Vec<f64>,
    /// How many stops the sets had whose ways were found last.
    size: usize,
    /// For each stop that has one, the shortest of the ways of this size to it: head, stops.
    ways: Vec<Tour>,
    tour: Option<Tour>,
    evaluations: u64,
}

fn begin(problem: &Arc<Problem>, _settings: &Parameters, _rng: Stream) -> HeldKarp {
    let stops: Vec<Stop> = problem.movable().collect();
    let m = stops.len();
    HeldKarp {
        problem: Arc::clone(problem),
        shortest: vec![f64::INFINITY; m << m],
        stops,
        size: 0,
        ways: Vec::new(),
        tour: None,
        evaluations: 0,
    }
}

/// The sets of `size` of `m` things, as bits, in the order of their numbers.
fn sets(m: usize, size: usize) -> impl Iterator<Item = usize> {
    (1..1_usize << m).filter(move |set| set.count_ones() as usize == size)
}

/// The things in a set.
fn within(set: usize) -> impl Iterator<Item = usize> {
    let mut left = set;
    std::iter::from_fn(move || {
        let next = (left != 0).then(|| left.trailing_zeros() as usize);
        left &= left.wrapping_sub(1);
        next
    })
}

impl HeldKarp {
    /// The shortest way through `set`, `last` being none of it, and then to `last`: its length, and the stop before.
    fn onwards(&self, set: usize, last: Stop) -> (f64, usize) {
        let m = self.stops.len();
        within(set).fold((f64::INFINITY, 0), |(least, before), i| {
            let length = self.shortest[set * m + i] + self.problem.d(self.stops[i], last);
            if length < least { (length, i) } else { (least, before) }
        })
    }

    /// The ways through all sets of the next size.
    fn grow(&mut self) {
        self.size += 1;
        let m = self.stops.len();
        for set in sets(m, self.size) {
            for last in within(set) {
                let before = set & !(1 << last);
                let stop = self.stops[last];
                self.shortest[set * m + last] =
                    if before == 0 { self.problem.d(self.problem.head(), stop) } else { self.onwards(before, stop).0 };
                self.evaluations += u64::from(before.count_ones().max(1));
            }
        }
    }

    /// Head and stops of the shortest way through a set to one of it.
    fn way(&self, mut set: usize, mut last: usize) -> Tour {
        let length = self.shortest[set * self.stops.len() + last];
        let mut row = vec![self.stops[last]];
        while set & (set - 1) != 0 {
            set &= !(1 << last);
            last = self.onwards(set, self.stops[last]).1;
            row.push(self.stops[last]);
        }
        row.push(self.problem.head());
        row.reverse();
        Tour { row, length }
    }

    /// For each stop the shortest way of the present size that ends there.
    fn find_ways(&mut self) {
        let m = self.stops.len();
        let to = |last: usize| {
            let here = sets(m, self.size).filter(move |set| set >> last & 1 != 0);
            here.reduce(|least, set| if self.shortest[set * m + last] < self.shortest[least * m + last] { set } else { least })
        };
        self.ways = (0..m).filter_map(|last| Some(self.way(to(last)?, last))).collect();
    }

    /// All stops are in the set: the tail follows.
    fn close(&mut self) {
        let all = (1 << self.stops.len()) - 1;
        let mut tour = match all {
            0 => Tour::first(&self.problem),
            _ => self.way(all, self.onwards(all, self.problem.tail()).1),
        };
        if all != 0 {
            tour.row.push(self.problem.tail());
        }
        tour.settle(&self.problem);
        self.evaluations += self.stops.len().max(1) as u64;
        self.tour = Some(tour);
    }
}

impl Search for HeldKarp {
    fn step(&mut self) {
        if self.size < self.stops.len() {
            self.grow();
        }
        if self.size == self.stops.len() {
            self.close();
            self.ways.clear();
        } else {
            self.find_ways();
        }
    }

    fn progress(&self) -> Progress {
        if self.tour.is_some() { Progress::Done(Status::Solved) } else { Progress::Continue }
    }

    fn evaluations(&self) -> u64 {
        self.evaluations
    }

    fn best(&self) -> Option<&Tour> {
        self.tour.as_ref()
    }

    fn members(&self) -> usize {
        // Of one stop from nowhere there is nothing to draw.
        if self.size > 1 { self.ways.len() } else { 0 }
    }

    fn member(&self, i: usize) -> Option<&Tour> {
        self.ways.get(i)
    }

    fn read(&self, out: &mut Readings) {
        out.push(SIZE, self.size as f64);
        // Of a way with a fixed part not what it counts, but how long it is.
        let long = |way: &Tour| way.row.windows(2).map(|w| self.problem.d(w[0], w[1]).max(0.0)).sum();
        out.push(PARTIAL, self.ways.iter().chain(&self.tour).map(long).reduce(f64::min).unwrap_or(f64::NAN));
    }
}

const ITERATIONS: Param<u64> = Param::integer(
    "iterations",
    "t_{\\max}",
    "Iterations",
    [1, 1_000_000, MOST as u64],
    "After how many sizes of sets it stops at the latest; building roads comes first. It takes as many as there are stops, less those that stay at the ends; fewer leave no tour.",
)
.slider(1.0, MOST as f64, false);

const RECURSION: Formula = Formula::new(
    "recursion",
    "Held and Karp 1962",
    "The shortest way through a set",
    "C(S, j) = \\min_{i \\in S \\setminus \\{j\\}} C(S \\setminus \\{j\\}, i) + d(i, j)",
    "|S| = @size@",
);

const SIZE: Reading = Reading::new("size", "|S|", "Size", Group::Count, "How many stops the sets of this iteration have.");
const PARTIAL: Reading = Reading::new(
    "partial",
    "C",
    "Shortest part",
    Group::Length,
    "The shortest way through so many stops, of all sets; the tour in the end.",
);

/// See [`planner::start`].
const OWN_READINGS: &[Reading] = &[SIZE, PARTIAL];

/// Runs that show something.
const CASES: &[Case] = &[Case::new(
    "twelve",
    "Twelve stops, exactly",
    "It solves all sets of stops, small ones first; the tour is there with the last step.",
    "open-12",
    &[],
)];
/// What it does, with the numbers of the iteration.
const PSEUDOCODE: &[&str] = &[
    "for sets of stops, from size 1 to all of them (now size @size@):",
    "  for each set $S$ and each last stop $j$ in it:",
    "    $C(S, j) \\leftarrow \\min_i C(S \\setminus \\{j\\}, i) + d(i, j)$",
    "go back through the table from the set of all stops: length @best@",
];

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "held-karp",
    "Held and Karp: exact",
    "Held and Karp 1962",
    "The shortest tour, guaranteed: the shortest paths through all sets of stops, from small sets to the set of all. For 15 stops at most.",
    |start| Ok(planner::start(start, OWN_READINGS, |problem, settings, rng| Box::new(begin(problem, settings, rng)))?.open_ended()),
)
.family("tour")
.evaluating(crate::tour::EVALUATION)
.kinds(KINDS)
.parameters(&[&[ITERATIONS.entry()], TOURS])
.readings(&[BEST, BUILT, FAILED, BY_ROAD, FOUND, SIZE, PARTIAL])
.formulas(&[RECURSION, LENGTH])
.layers(&[
    ROADS_LAYER,
    layers::TOURS.titled("Shortest parts", "The shortest way of the present size to each stop, until there is a tour."),
    layers::TOUR,
    layers::STOPS,
    layers::WAY,
])
.calls_at_most(MOST)
.cases(CASES)
.pseudocode(PSEUDOCODE)
// Over roads it is exact for those that were built; where there are none, the parameter reads as empty.
.exact(|parameters| parameters[ROADS].is_empty());
