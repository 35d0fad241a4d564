//! `@NAME@`: not published. TODO: what it does, and where that is from, with equation numbers.
//!
//! TODO: what stands here works, and is to be replaced: it swaps two random stops, and keeps what is shorter. For tours on grids,
//! whose roads other planners build first, see `two_opt.rs`.

use std::sync::Arc;

use crate::{
    describe::{Entry, Group, Reading, Start, layers},
    exact::Distances,
    kernel::{Candidate, Error, Frame, Planner, Progress, Readings, ReferenceOptimum, Shape, Solution, Started, State, TourEnds, rng::Stream},
    params::Param,
    scene::{TOUR, TourScene},
};

const ITERATIONS: Param<u64> =
    Param::integer("iterations", "k_{\\max}", "Iterations", [1, 1_000_000, 1000], "The number of iterations after which it stops.");
/// A parameter of its own. TODO: replace it.
const TRIES: Param<u64> =
    Param::integer("tries", "", "Tries", [1, 10_000, 20], "The number of swaps tried in an iteration. More take longer and find more.");

const BEST: Reading = Reading::new("best", "L", "Shortest", Group::Cost, "The length of the shortest tour so far.");
const SWAPS: Reading = Reading::new("swaps", "", "Swaps", Group::Count, "The number of swaps that made the tour shorter.");

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "@NAME@",
    "@TITLE@",
    "not published",
    "Swaps two random stops of a tour and keeps the tour if it becomes shorter.",
    start,
)
.family("@FAMILY@")
.kinds(&[TOUR])
.calls_at_stops()
.parameters(&[&[ITERATIONS.entry(), TRIES.entry()]])
.readings(&[BEST, SWAPS])
.layers(&[layers::TOUR]);

/// The state: all that the next step depends on. A clone of it is a keyframe, and `State` gives its hash and size.
#[derive(Clone, State)]
struct @TYPE@ {
    /// What follows from the setup is shared.
    #[state(shared)]
    distances: Arc<Distances>,
    #[state(shared)]
    places: Arc<[[f64; 2]]>,
    #[state(shared)]
    ends: TourEnds,
    #[state(shared)]
    tries: u64,
    /// The only source of random numbers.
    rng: Stream,
    order: Vec<usize>,
    length: f64,
    swaps: u64,
    evaluations: u64,
}

fn start(start: &Start) -> Result<Started, Error> {
    let scene = start.scene.get::<TourScene>()?;
    let (distances, ends) = (Arc::clone(scene.distances()), scene.ends());
    let mut rng = Stream::new(start.seed, 0);
    let mut order: Vec<_> = (0..scene.len()).collect();
    rng.shuffle(&mut order);
    let length = distances.length(&order, ends.closes());
    let planner = @TYPE@ {
        distances,
        places: scene.places().into(),
        ends,
        tries: start.parameters[TRIES],
        rng,
        order,
        length,
        swaps: 0,
        evaluations: 1,
    };
    let started = Started::new(planner, start.parameters[ITERATIONS]).measured_by(ReferenceOptimum::Matrix);
    Ok(Started { ends: Some(ends), ..started })
}

impl @TYPE@ {
    fn try_swap(&mut self) {
        let [a, b] = [0, 1].map(|_| self.rng.below(self.order.len()));
        self.order.swap(a, b);
        let length = self.distances.length(&self.order, self.ends.closes());
        self.evaluations += 1;
        if length < self.length {
            self.length = length;
            self.swaps += 1;
        } else {
            self.order.swap(a, b);
        }
    }

    /// The tour's path, back to its first stop if it is closed.
    fn path(&self) -> Vec<[f64; 2]> {
        let back = self.order.first().filter(|_| self.ends.closes());
        self.order.iter().chain(back).map(|&stop| self.places[stop]).collect()
    }
}

impl Planner for @TYPE@ {
    /// One iteration. TODO: the algorithm's steps, each a function with the number of its equation.
    fn advance(&mut self) -> Progress {
        (0..self.tries).for_each(|_| self.try_swap());
        Progress::Continue
    }

    fn evaluations(&self) -> u64 {
        self.evaluations
    }

    fn best(&self) -> Option<Candidate> {
        let solution = Solution::Tour { order: self.order.clone(), ends: self.ends, path: self.path() };
        Some(Candidate { cost: self.length, solution })
    }

    fn read(&self, out: &mut Readings) {
        out.push(BEST, self.length);
        out.push(SWAPS, self.swaps as f64);
    }

    fn draw(&self, frame: &mut Frame) {
        frame.begin(layers::TOUR.key, Shape::Polyline);
        self.path().iter().for_each(|&stop| frame.push(stop, 0.0));
    }
}
