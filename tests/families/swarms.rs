//! Swarms over an objective from outside.

use std::sync::Arc;

use forage::{
    Error, Overrides, Value,
    describe::{Entry, Layer, layers},
    kernel::{Candidate, Frame, Planner, Progress, Readings, SceneKindId, Solution, Started, State, Status, rng::Stream},
    params::Parameters,
    swarm::{
        Flight, Population, Swarm, bat_continuous, cpso, cuckoo_search, ltqpso,
        objective::{Evaluation, Objective, Scratch, SearchBox},
        pso, qpso,
        schedule::{Law, Schedule},
        wcpso, wpso,
    },
};

use crate::support::run_to_end;

const KIND: SceneKindId = SceneKindId("bowl");

/// Σ (x_j − j)²: its minimum is 0, at (0, 1, 2, …).
struct Bowl(SearchBox);

impl Objective for Bowl {
    fn search_box(&self) -> &SearchBox {
        &self.0
    }

    fn evaluate(&self, x: &[f64], _: &mut Scratch) -> Evaluation {
        let off = (0..).zip(x).map(|(j, x)| x - f64::from(j));
        off.map(|off| off * off).sum::<f64>().into()
    }
}

fn bowl() -> Arc<Bowl> {
    Arc::new(Bowl(SearchBox::cube(3, -10.0, 10.0).unwrap()))
}

fn parameters(entry: &Entry, given: &[(&str, f64)]) -> Parameters {
    entry.configure(KIND, &given.iter().map(|&(name, value)| (name, Value::from(value))).collect()).unwrap()
}

#[test]
fn every_swarm_finds_the_minimum_of_an_objective_from_outside() {
    type On = fn(Arc<dyn Objective>, &Parameters, u64) -> Started;
    let swarms: [(Entry, On); 8] = [
        (pso::ENTRY, pso::on),
        (wpso::ENTRY, wpso::on),
        (cpso::ENTRY, cpso::on),
        (wcpso::ENTRY, wcpso::on),
        (qpso::ENTRY, qpso::on),
        (ltqpso::ENTRY, ltqpso::on),
        (bat_continuous::ENTRY, bat_continuous::on),
        (cuckoo_search::ENTRY, cuckoo_search::on),
    ];
    for (entry, on) in swarms {
        let run = run_to_end(on(bowl(), &parameters(&entry, &[("iterations", 1000.0)]), 1));
        let Candidate { cost, solution } = run.planner.best().unwrap();
        let Solution::Position(x) = solution else { panic!("{}: no position", entry.name) };
        let exact = bowl().evaluate(&x, &mut Scratch::default()).cost;
        assert_eq!((run.iteration, run.status, cost), (1000, Status::Exhausted, exact), "{}", entry.name);
        let tolerance = if entry.name == "bat-continuous" { 0.1 } else { 1e-3 };
        assert!((0..).zip(&x).all(|(j, x)| (x - f64::from(j)).abs() < tolerance), "{}: {x:?}", entry.name);
    }
}

#[test]
fn a_swarm_flies_by_a_schedule_from_outside_and_can_be_looked_into() {
    let schedule = Schedule { w: Law::Linear(0.8, 0.2), c1: Law::Constant(1.5), c2: Law::Constant(1.5) };
    let parameters = parameters(&pso::ENTRY, &[("population", 20.0), ("iterations", 200.0)]);
    let mut swarm = Swarm::new(bowl(), &parameters, 2, Flight { schedule, perturbation: None });
    for k in 0..200 {
        swarm.advance();
        assert_eq!(swarm.coefficients(), schedule.at(k, 200));
    }
    let population = swarm.population();
    let (best, cost) = population.global_best();
    assert!(cost < 1e-9 && best.iter().zip([0.0, 1.0, 2.0]).all(|(x, exact)| (x - exact).abs() < 1e-4), "{best:?}");
    assert_eq!((population.size(), population.evaluations(), swarm.velocity(19).len()), (20, 20 * 201, 3));
    let least = (0..20).map(|i| population.personal_best(i).1).fold(f64::INFINITY, f64::min);
    assert_eq!(least, cost);
    assert!((0..20).all(|i| population.cost(i) >= population.personal_best(i).1 && population.position(i).len() == 3));
}

#[test]
fn a_box_without_a_meaning_is_refused_by_name() {
    let refusal = |made: Result<SearchBox, Error>| made.map(|_| ()).unwrap_err().to_string();
    assert_eq!(refusal(SearchBox::new([], [])), "low: an empty list is not allowed; it must be one number at least");
    assert_eq!(refusal(SearchBox::cube(0, 0.0, 1.0)), "low: an empty list is not allowed; it must be one number at least");
    assert_eq!(refusal(SearchBox::new([0.0; 2], [1.0])), "high: a list of 1 is not allowed; it must be as long as low, which has 2");
    assert_eq!(refusal(SearchBox::new([0.0, f64::NAN], [1.0; 2])), "low[1]: NaN is not allowed; it must be a finite number");
    assert_eq!(refusal(SearchBox::cube(1, 2.0, 1.0)), "high[0]: 1 is not allowed; it must be a finite number from 2 on");
    assert!(SearchBox::cube(1, -f64::MAX, f64::MAX).is_err(), "its side is infinite");
    assert_eq!(SearchBox::cube(2, 1.0, 1.0).unwrap().sides().collect::<Vec<_>>(), [0.0; 2]);
}

/// Costs that are no numbers, and a box that is a point.
#[test]
fn what_cannot_be_minimised_is_kept_in_the_box_and_costs_infinitely_much() {
    struct Nothing(SearchBox);
    impl Objective for Nothing {
        fn search_box(&self) -> &SearchBox {
            &self.0
        }
        fn evaluate(&self, _: &[f64], _: &mut Scratch) -> Evaluation {
            f64::NAN.into()
        }
    }
    for (low, high) in [(3.0, 5.0), (4.0, 4.0)] {
        for on in [pso::on, ltqpso::on, cuckoo_search::on, bat_continuous::on].into_iter().zip([
            pso::ENTRY,
            ltqpso::ENTRY,
            cuckoo_search::ENTRY,
            bat_continuous::ENTRY,
        ]) {
            let (on, entry) = on;
            let nothing = Arc::new(Nothing(SearchBox::cube(2, low, high).unwrap()));
            let run = run_to_end(on(nothing, &parameters(&entry, &[("iterations", 20.0)]), 1));
            let Candidate { cost, solution: Solution::Position(x) } = run.planner.best().unwrap() else { panic!("no position") };
            assert!(cost == f64::INFINITY && x.iter().all(|x| (low..=high).contains(x)), "{} {x:?}", entry.name);
        }
    }
}

/// Differential evolution (Storn and Price 1997), rand/1/bin: a swarm of its own over the shared population.
#[derive(Clone, State)]
struct Evolution {
    population: Population,
    rng: Stream,
}

impl Evolution {
    /// x' = a + F (b − c) in some coordinates; kept if it costs no more.
    fn evolve(&mut self, i: usize) {
        let size = self.population.size();
        let [a, b, c] = [(); 3].map(|()| self.population.position(self.rng.below(size)).to_vec());
        let (before, cost) = (self.population.position(i).to_vec(), self.population.cost(i));
        let search_box = self.population.objective().search_box().clone();
        for (j, x) in self.population.position_mut(i).iter_mut().enumerate() {
            if self.rng.unit() < 0.9 {
                *x = search_box.clamp(j, a[j] + 0.7 * (b[j] - c[j]));
            }
        }
        self.population.evaluate(i);
        if self.population.cost(i) > cost {
            self.population.position_mut(i).copy_from_slice(&before);
            self.population.evaluate(i);
        }
    }
}

impl Planner for Evolution {
    fn advance(&mut self) -> Progress {
        (0..self.population.size()).for_each(|i| self.evolve(i));
        self.population.settle();
        Progress::Continue
    }

    fn evaluations(&self) -> u64 {
        self.population.evaluations()
    }

    fn best(&self) -> Option<Candidate> {
        Some(self.population.best())
    }

    fn read(&self, out: &mut Readings) {
        self.population.read(out);
    }

    fn draw(&self, frame: &mut Frame) {
        self.population.draw_members(frame);
        self.population.draw_result(frame);
    }
}

#[test]
fn a_swarm_from_outside_moves_the_particles_of_a_population() {
    let mut rng = Stream::new(1, 0);
    let population = Population::new(bowl(), 30, &mut rng);
    let run = run_to_end(Started::new(Evolution { population, rng }, 300));
    assert!(run.planner.best().unwrap().cost < 1e-9);
    let mut readings = Readings::default();
    run.planner.read(&mut readings);
    let names: Vec<_> = readings.iter().map(|(name, _)| name).collect();
    assert_eq!(names, ["best", "mean", "spread"]);
    assert!(Population::READINGS.iter().map(|reading| reading.name).take(3).eq(names));
    let mut frame = Frame::default();
    frame.clear(1000, Population::LAYERS.iter().map(|layer| layer.key));
    run.planner.draw(&mut frame);
    assert!(frame.unlisted().is_empty());
    let count = |layer: Layer| frame.spans().filter(|span| span.layer == layer.key).map(|span| span.count).sum::<u32>();
    assert_eq!((count(layers::PARTICLES), count(layers::BEST)), (30, 1));
}

#[test]
fn an_entry_like_another_describes_the_same_under_its_own_name() {
    const MINE: Entry = Entry::new("mine", "Mine", "here", "A bowl.", |start| {
        Ok(wcpso::on(Arc::new(Bowl(SearchBox::cube(3, -10.0, 10.0)?)), start.parameters, start.seed))
    })
    .like(&wcpso::ENTRY)
    .kinds(&[KIND]);
    assert_eq!((MINE.name, MINE.family, MINE.kinds), ("mine", "swarm", &[KIND][..]));
    assert!(MINE.all_parameters().eq(wcpso::ENTRY.all_parameters()));
    let names = |given: &Overrides| MINE.configure(KIND, given).map(|set| set.all().len());
    assert!(names(&Overrides::new()).is_ok());
    let paths = [("waypoints", Value::from(3.0))].into_iter().collect();
    assert_eq!(names(&paths).unwrap_err().value(), "waypoints", "there are no paths in a bowl");
}
