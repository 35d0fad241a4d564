//! Tours by a search from outside.

use std::sync::Arc;

use forage::{
    Frame, Status,
    describe::{Entry, Group, Reading, layers},
    kernel::{Candidate, Inspection, Item, Progress, Readings, Solution, State, TourEnds, rng::Stream},
    message,
    tour::{self, LocalSearch, Problem, Search, Tour, held_karp, moves, nearest_neighbour},
};

use crate::support::{run_to_end, scene, start};

const TRIED: Reading = Reading::new("tried", "", "Tried", Group::Count, "Tours that were tried.");

/// Two tours side by side that random 2-opt moves shorten: one from the nearest neighbour's, one from a random one.
#[derive(Clone, State)]
struct Descents {
    #[state(shared)]
    problem: Arc<Problem>,
    tours: [Tour; 2],
    tried: u64,
    rng: Stream,
}

impl Search for Descents {
    fn step(&mut self) {
        for tour in &mut self.tours {
            let (i, j) = moves::two_apart(tour.len(), &mut self.rng);
            self.tried += 1;
            if moves::reversal(&self.problem, &tour.row, i, j) < 0.0 {
                moves::reverse(&mut tour.row, i, j);
                tour.settle(&self.problem);
            }
            let (i, j) = moves::stop_elsewhere(tour.len(), &mut self.rng);
            self.tried += 1;
            if moves::insertion(&self.problem, &tour.row, i, j) < 0.0 {
                moves::insert(&mut tour.row, i, j);
                tour.settle(&self.problem);
            }
        }
    }

    fn evaluations(&self) -> u64 {
        2 + self.tried
    }

    fn best(&self) -> Option<&Tour> {
        moves::shortest(self.tours.iter())
    }

    fn members(&self) -> usize {
        2
    }

    fn member(&self, i: usize) -> Option<&Tour> {
        self.tours.get(i)
    }

    fn read(&self, out: &mut Readings) {
        out.push(TRIED, self.tried as f64);
    }

    fn read_member(&self, i: usize, out: &mut Vec<f64>) {
        out.push(self.tours[i].length);
    }

    fn explain(&self, i: usize, inspection: &mut Inspection) {
        inspection.title = message!("descent", "Descent {i}", i);
    }
}

const MEMBERS: &[Reading] = &[tour::MEAN, tour::DIFFERENT, tour::SETTLED, TRIED];

const DESCENTS: Entry = Entry::new("descents", "Descents", "Croes 1958", "Random 2-opt moves.", |start| {
    tour::start(start, MEMBERS, |problem, _, mut rng| {
        let tours = [nearest_neighbour(problem, &mut rng), moves::random_tour(problem, &mut rng)];
        Box::new(Descents { problem: Arc::clone(problem), tours, tried: 0, rng })
    })
})
.like(&held_karp::ENTRY)
.parameters(&[&[tour::ITERATIONS.default_to(3000).entry()], tour::TOURS])
.calls_at_stops();

/// Eight stops.
const STOPS: [[f64; 2]; 8] = [[0.0, 0.0], [9.0, 1.0], [3.0, 7.0], [8.0, 8.0], [1.0, 5.0], [5.0, 2.0], [6.0, 6.0], [2.0, 2.0]];

fn text() -> String {
    format!(r#"{{"format": "forage-scene", "version": 1, "kind": "tour", "name": "t", "title": "T", "points": {STOPS:?}}}"#)
}

fn distance(a: usize, b: usize) -> f64 {
    (0..2).map(|axis| STOPS[a][axis] - STOPS[b][axis]).map(|d| d * d).sum::<f64>().sqrt()
}

/// The shortest way on from a stop through all that are left and, if it is closed, home: by trying every order.
fn shortest(at: usize, left: &[usize], closed: bool) -> f64 {
    let on = |&next: &usize| {
        let rest: Vec<_> = left.iter().copied().filter(|&stop| stop != next).collect();
        distance(at, next) + shortest(next, &rest, closed)
    };
    left.iter().map(on).reduce(f64::min).unwrap_or(if closed { distance(at, 0) } else { 0.0 })
}

#[test]
fn a_search_from_outside_finds_the_optimum_of_eight_stops_whatever_the_ends() {
    let all: Vec<_> = (0..8).collect();
    let from = |first: usize, closed| shortest(first, &all.iter().copied().filter(|&stop| stop != first).collect::<Vec<_>>(), closed);
    let open = (0..8).map(|first| from(first, false)).fold(f64::INFINITY, f64::min);
    for (ends, exact) in [("closed", from(0, true)), ("open", open), ("from-first", from(0, false))] {
        let started = start(&DESCENTS, &scene(&text()), &[("round", ends)], 1).unwrap();
        assert_eq!(started.ends.map(TourEnds::closes), Some(ends == "closed"));
        let run = run_to_end(started);
        let Candidate { cost, solution: Solution::Tour { order, path, .. } } = run.planner.best().unwrap() else { panic!("no tour") };
        assert!((cost - exact).abs() < 1e-9, "{ends}: {cost} {exact}");
        assert_eq!((run.status, order.len(), path.len()), (Status::Exhausted, 8, if ends == "closed" { 9 } else { 8 }));
    }
}

#[test]
fn what_every_tour_has_comes_without_the_search() {
    let run = run_to_end(start(&DESCENTS, &scene(&text()), &[("iterations", "20")], 1).unwrap());
    let mut readings = Readings::default();
    run.planner.read(&mut readings);
    let names: Vec<_> = readings.iter().map(|(name, _)| name).collect();
    let [best, found] = [tour::BEST, tour::FOUND].map(|reading| reading.name);
    assert_eq!(names, [&[best, found][..], &MEMBERS.iter().map(|reading| reading.name).collect::<Vec<_>>()].concat());
    assert_eq!((readings.get("tried"), run.planner.evaluations()), (Some(80.0), 82));
    let facets = run.planner.facets();
    let inspection = facets.explain.unwrap().inspect(Item { layer: layers::TOURS.key, index: 1 }).unwrap();
    assert!(inspection.title.text() == "Descent 1" && inspection.rows.len() == 8 && !inspection.marks.is_empty(), "{inspection:?}");
    let mut lengths = Vec::new();
    facets.members.unwrap().members(&mut lengths);
    assert_eq!(lengths.iter().copied().reduce(f64::min), run.planner.best().map(|best| best.cost));
    let mut frame = Frame::default();
    frame.clear(1000, [layers::TOURS, layers::TOUR, layers::STOPS].map(|layer| layer.key));
    run.planner.draw(&mut frame);
    assert_eq!((frame.spans().count(), frame.unlisted().len()), (4, 0));
}

/// A copy goes the same way on, and a local search leaves nothing that a 2-opt move could shorten.
#[test]
fn a_search_is_copied_whole_and_a_local_search_ends_in_a_local_optimum() {
    let mut run = forage::kernel::Stepper::from(start(&DESCENTS, &scene(&text()), &[], 3).unwrap());
    (0..5).for_each(|_| assert!(run.step(|_| Vec::new())));
    let mut copy = run.clone();
    let state = |run: &forage::kernel::Stepper| forage::kernel::Digest::of(&*run.planner).hex();
    for run in [&mut run, &mut copy] {
        (0..5).for_each(|_| assert!(run.step(|_| Vec::new())));
    }
    assert_eq!(state(&run), state(&copy));

    let problem = Arc::new(Problem::new(&forage::exact::Distances::of(8, distance), TourEnds::Closed));
    let mut tour = moves::random_tour(&problem, &mut Stream::new(1, 0));
    LocalSearch::new(&problem).polish(&mut tour);
    let m = tour.len();
    let gains = (1..=m).flat_map(|i| (i..=m).map(move |j| (i, j))).map(|(i, j)| moves::reversal(&problem, &tour.row, i, j));
    assert!(gains.fold(0.0, f64::min) > -1e-9);
    assert_eq!(Progress::Continue, Descents { problem, tours: [tour.clone(), tour], tried: 0, rng: Stream::new(1, 0) }.progress());
}
