//! Tours with fixed edges.

use super::*;

/// Every tour has the fixed edges, and none is shorter than the exact tour with them.
#[test]
fn fixed_ways_are_in_every_tour() {
    let mut rng = Stream::new(18, 0);
    for case in 0..8 {
        let n = if case < 2 { 5 } else { 6 + rng.below(3) };
        let mut scene = stops(n, &mut rng).get::<TourScene>().unwrap().clone();
        scene.fixed = if case % 2 == 0 { vec![[0, n - 1]] } else { vec![[1, 4], [4, 2]] };
        scene.closed = case < 4;
        let scene = Arc::new(crate::scene::tour::KIND.scene(Header::named("t", "T"), scene).unwrap());
        let ends = scene.get::<TourScene>().unwrap().ends();
        let exact = scene.exact_tour(crate::kernel::ReferenceOptimum::Matrix, ends).unwrap();
        assert!(distances(&scene).has_fixed(&exact.order, ends.closes()));
        for entry in tour_planners() {
            let mut run = run(entry.name, &scene, &[], 1);
            run.step(u64::MAX);
            let outcome = run.outcome();
            assert!(outcome.feasible, "{}: {:?}", entry.name, outcome.order);
            assert!(outcome.length.unwrap() > exact.length - 1e-9, "{}", entry.name);
            assert!((outcome.length.unwrap() - outcome.cost.unwrap()).abs() < 1e-6, "{}", entry.name);
        }
    }
}

/// Ends that the fixed edges do not allow are refused; a part of a tour is as long as its ways that are not fixed.
#[test]
fn ends_that_fixed_edges_do_not_allow_are_refused() {
    let mut scene = stops(7, &mut Stream::new(19, 0)).get::<TourScene>().unwrap().clone();
    scene.fixed = vec![[0, 6], [2, 3]];
    let scene = Arc::new(crate::scene::tour::KIND.scene(Header::named("t", "T"), scene).unwrap());
    for (round, allowed) in ROUNDS.into_iter().zip([true, true, true, false]) {
        for entry in tour_planners() {
            let params: Overrides = [("round", Value::from(round))].into_iter().collect();
            match Run::new(standard(), Setup { planner: entry.name.into(), scene: Arc::clone(&scene), params, seed: 1 }) {
                Ok(_) => assert!(allowed, "{} {round}", entry.name),
                Err(error) => {
                    let expected = "round: first-to-last is not allowed; it must be closed, open, from-first: what tours with the scene’s fixed edges can have";
                    assert!(!allowed && error.to_string() == expected, "{error}");
                }
            }
        }
    }
    let mut run = run("held-karp", &scene, &[], 1);
    while run.step(1) == Status::Running {
        let partial = run.readings().iter().find(|reading| reading.0 == "partial").map(|reading| reading.1);
        assert!(partial.is_some_and(|partial| partial >= 0.0), "{partial:?}");
    }
}
