//! Trees through a space from outside, and by a method from outside.

use std::sync::Arc;

use forage::{
    Status,
    describe::Entry,
    kernel::{Error, Planner, Progress, SceneKindId, Solution, Started, State, rng::Stream},
    params::Parameters,
    tree::{Forest, Method, SampleOutcome, Source, Space, Task, Trees, rrt, rrt_connect, rrt_guided, rrt_star},
};

use crate::support::run_to_end;

/// A box from 0 to 1 in N dimensions, which a wall at x = 0.5 may divide up to a height of y.
struct Room<const N: usize> {
    goals: Vec<[f64; N]>,
    wall: f64,
}

impl<const N: usize> Space<N> for Room<N> {
    fn bounds(&self) -> ([f64; N], [f64; N]) {
        ([0.0; N], [1.0; N])
    }

    fn start(&self) -> [f64; N] {
        [0.2; N]
    }

    fn goals(&self) -> &[[f64; N]] {
        &self.goals
    }

    fn is_free(&self, a: &[f64; N], b: &[f64; N]) -> bool {
        let height = || a[1] + (b[1] - a[1]) * (0.5 - a[0]) / (b[0] - a[0]);
        (a[0] < 0.5) == (b[0] < 0.5) || height() >= self.wall
    }
}

fn empty<const N: usize>() -> Arc<Room<N>> {
    Arc::new(Room { goals: vec![[0.8; N]], wall: 0.0 })
}

fn parameters(entry: &Entry, given: &[(&str, f64)]) -> Parameters {
    entry.configure(SceneKindId("room"), &given.iter().map(|&(name, value)| (name, value.into())).collect()).unwrap()
}

/// From corner to corner of an empty box the finished path is the straight line, in any number of dimensions.
fn check<const N: usize>() {
    type On<const N: usize> = fn(Arc<dyn Space<N>>, &Parameters, u64) -> Result<Started, Error>;
    let trees: [(Entry, On<N>); 4] = [
        (rrt::ENTRY, rrt::on::<N>),
        (rrt_connect::ENTRY, rrt_connect::on::<N>),
        (rrt_guided::ENTRY, rrt_guided::on::<N>),
        (rrt_star::ENTRY, rrt_star::on::<N>),
    ];
    let straight = 0.6 * (N as f64).sqrt();
    for (entry, on) in trees {
        let run = run_to_end(on(empty::<N>(), &parameters(&entry, &[("step_size", 0.1)]), 1).unwrap());
        let best = run.planner.best().unwrap();
        let length = match best.solution {
            Solution::Path(path) => forage::geometry::length(&path),
            Solution::Reach { path, .. } if N == 3 => path.windows(2).map(|w| distance(&w[0], &w[1])).sum(),
            _ => straight,
        };
        assert!((length - straight).abs() < 1e-9, "{} in {N}: {length}", entry.name);
        assert!(best.cost >= straight - 1e-9 && run.status != Status::Infeasible);
    }
}

fn distance<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}

#[test]
fn the_path_through_an_empty_box_is_a_straight_line_in_any_number_of_dimensions() {
    check::<2>();
    check::<3>();
    check::<4>();
}

#[test]
fn rrt_star_approaches_the_shortest_path_round_a_wall() {
    let room = Arc::new(Room { goals: vec![[0.8, 0.2]], wall: 0.6 });
    let run = run_to_end(rrt_star::on(room, &parameters(&rrt_star::ENTRY, &[("step_size", 0.05)]), 1).unwrap());
    let (shortest, cost) = (2.0 * distance(&[0.2, 0.2], &[0.5, 0.6]), run.planner.best().unwrap().cost);
    assert!(shortest - 1e-12 <= cost && cost < 1.02 * shortest, "{cost} {shortest}");
}

/// A tree that tries the goal from its nearest node first, and a random point when that fails.
#[derive(Clone, State)]
struct Greedy {
    blocked: Option<u64>,
}

impl<const N: usize> Method<N> for Greedy {
    fn grow(&mut self, forest: &mut Forest<N>, task: &Task<N>, rng: &mut Stream) {
        let near = forest.nearest_to_goal();
        if self.blocked != Some(near as u64) {
            forest.begin(Source::Goal, 0);
            let (from, goal) = (*forest.tree(0).point(near), task.goal());
            let new = if distance(&from, &goal) <= task.step() { goal } else { task.towards(&from, &goal) };
            let outcome = forest.test(task, 0, near, &new);
            forest.record(goal, outcome);
            if outcome == SampleOutcome::Taken {
                let node = forest.add(task, 0, new, near);
                forest.reach(task, node);
                return;
            }
            self.blocked = Some(near as u64);
            return;
        }
        forest.begin(Source::Uniform, 0);
        if let Some(node) = forest.extend(task, task.uniform(rng), true) {
            forest.reach(task, node);
        }
    }
}

#[test]
fn a_method_from_outside_goes_straight_where_it_can_and_round_where_it_must() {
    let parameters = parameters(&rrt::ENTRY, &[("step_size", 0.1)]);
    let mut trees = Trees::new(empty::<2>(), &parameters, 1, |_| Greedy { blocked: None }).unwrap();
    let steps = (1..100).find(|_| trees.advance() == Progress::Done(Status::Solved)).unwrap();
    let (path, cost) = trees.forest().path().unwrap();
    assert_eq!((steps, trees.evaluations(), trees.forest().tree(1).len()), (8, 9, 0));
    assert!((cost - 0.6 * 2.0_f64.sqrt()).abs() < 1e-12 && path[0] == [0.2; 2] && path[path.len() - 1] == [0.8; 2]);
    let tree = trees.forest().tree(0);
    assert!((1..tree.len()).all(|node| tree.parent(node) == Some(node - 1) && tree.cost(node) > tree.cost(node - 1)));

    let room = Arc::new(Room { goals: vec![[0.8, 0.2]], wall: 0.6 });
    let run = run_to_end(Trees::new(room, &parameters, 1, |_| Greedy { blocked: None }).unwrap().into());
    assert_eq!(run.status, Status::Solved);
    assert!(run.planner.best().unwrap().cost >= 1.0 - 1e-12);
}

#[test]
fn a_space_in_which_nothing_can_grow_is_refused_by_name() {
    let refused = |goals: Vec<[f64; 2]>| {
        let error = rrt::on(Arc::new(Room { goals, wall: 0.0 }), &parameters(&rrt::ENTRY, &[]), 1).map(|_| ()).unwrap_err();
        error.to_string()
    };
    assert_eq!(refused(vec![]), "goals: an empty list is not allowed; it must be one point at least");
    assert_eq!(refused(vec![[0.5, f64::NAN]]), "goals: NaN is not allowed; it must be finite numbers");
}
