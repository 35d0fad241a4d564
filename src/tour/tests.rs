//! The pipeline: roads, their distances, and what is explained.

use std::sync::Arc;

use crate::{
    Overrides, Run, Scene, Setup, Status,
    describe::{Entry, layers},
    exact::{Distances, Metric},
    kernel::{Inspection, Item, Stepped, TourEnds, part::with_parts_of, rng::Stream},
    params::{Domain, Value},
    scene::{Header, TourScene},
    shipped, standard,
};

use super::{local, nearest, problem::Problem};

mod fixed;

fn start(planner: &str, scene: &str, params: &[(&'static str, &str)], seed: u64) -> Run {
    let params: Overrides = params.iter().map(|&(name, value)| (name, Value::from(value))).collect();
    Run::new(standard(), Setup { planner: planner.into(), scene: shipped(scene).unwrap(), params, seed }).unwrap()
}

#[test]
fn whoever_can_build_roads_is_in_the_catalogue() {
    for builder in super::parameters::BUILDERS {
        let entry = standard().planner(builder.value).unwrap();
        assert!(!entry.stops && entry.parameter("smooth").is_some(), "{}", builder.value);
    }
}

/// Swarms promise no road: where a run finds none, others lead there.
#[test]
fn roads_of_swarms_give_a_feasible_tour() {
    for roads in ["cuckoo-search", "pso-rrt"] {
        for seed in 1..=3 {
            let mut run = start("bat", "ant-bat-30", &[("roads", roads), ("iterations", "20")], seed);
            run.step(u64::MAX);
            let outcome = run.outcome();
            assert!(outcome.feasible && outcome.gap > Some(0.0), "{roads}, seed {seed}: {:?}", outcome.failure);
        }
    }
}

/// Their first tours may take long to find: the step that builds the last roads is divided.
#[test]
fn members_enter_one_after_another_when_the_roads_stand() {
    for (planner, local) in [("bat", ("polish", Value::Flag(true))), ("tour-pso", ("local_search", Value::from("2-opt")))] {
        let params = [("roads", Value::from("a-star")), ("population", Value::from(7.0)), local];
        let mut run = run(planner, &shipped("ant-bat-30").unwrap(), &params, 1);
        let roads = run.stages()[0].end.unwrap();
        run.step(roads - 1);
        for layer in [layers::TOURS.key, layers::STOPS.key] {
            let inspection = run.inspect(Item { layer, index: 1 }).unwrap();
            assert_eq!((inspection.event, &*inspection.summary.text()), ("waiting", "There is no tour yet."));
        }
        let mut entered = 0;
        while with_parts_of(1, || run.part()) == Stepped::Partly {
            entered += u64::from(run.is_partly());
        }
        // The first one enters when the search begins, the last one ends the step.
        assert_eq!((run.iteration(), entered), (roads, 6), "{planner}");
    }
}

#[test]
fn a_road_that_touches_an_obstacle_is_not_found() {
    // A wall with one gap far away: a path with one corner at the start of the search does not fit through.
    let text = r#"{"format": "forage-scene", "version": 1, "kind": "grid", "name": "w", "title": "W", "cell": 1,
        "rows": [".....", ".....", ".####", "....."], "start": [4.5, 0.5], "goal": [4.5, 3.5]}"#;
    let scene = Arc::new(standard().read_scene(text).unwrap());
    let params: Overrides =
        [("iterations", 1.0), ("population", 1.0)].into_iter().map(|(name, value)| (name, Value::from(value))).collect();
    let setup = Setup { planner: "pso".into(), scene, params, seed: 1 };
    assert!(!{
        let mut run = Run::new(standard(), setup.clone()).unwrap();
        run.step(u64::MAX);
        run.outcome().feasible
    });
    let found = crate::run::run_to_end(standard(), setup).unwrap();
    assert_eq!((found.cost, found.path), (None, Vec::new()));
}

#[test]
fn roads_are_the_same_whoever_builds_them() {
    let params = [("roads", "aco"), ("iterations", "3")];
    let mut alone = start("bat", "ant-bat-30", &params, 4);
    let mut helped = start("bat", "ant-bat-30", &params, 4);
    while helped.status() == Status::Running {
        let jobs = helped.subtasks();
        if !jobs.is_empty() {
            let scene = Arc::clone(helped.scene());
            // Backwards, one by one.
            let mut found: Vec<_> = jobs
                .iter()
                .rev()
                .map(|job| crate::run::run_subtasks(standard(), &scene, std::slice::from_ref(job)).unwrap().remove(0))
                .collect();
            found.reverse();
            helped.provide(found).unwrap();
        }
        helped.step(1);
        alone.step(1);
        assert_eq!(alone.hash(), helped.hash());
    }
    assert_eq!(helped.outcome().iterations, 11 + 3);
}

#[test]
fn with_exact_roads_the_bats_find_the_exact_tour_for_every_round() {
    for (i, round) in ["closed", "open", "from-first", "first-to-last"].into_iter().enumerate() {
        let params = [("roads", "dijkstra"), ("smooth", "false"), ("round", round)];
        let outcomes = (1..=4).map(|seed| {
            let mut run = start("bat", "ant-bat-30", &params, seed);
            run.step(u64::MAX);
            run.outcome()
        });
        let outcomes: Vec<_> = outcomes.collect();
        // Bats promise nothing: some end in an open tour that is 1.6 % longer.
        assert!(outcomes.iter().any(|outcome| outcome.gap == Some(0.0)), "{round}");
        for outcome in outcomes {
            assert!(outcome.feasible && outcome.gap >= Some(0.0), "{round}");
            assert!(TourEnds::ALL[i].allows(&outcome.order.unwrap(), 12));
        }
    }
}

#[test]
fn a_stop_behind_walls_is_named() {
    let text = r#"{"format": "forage-scene", "version": 1, "kind": "grid", "name": "w", "title": "W", "cell": 1,
        "rows": ["..#.", "..#.", "..#."], "stops": [[0.5, 0.5], [1.5, 2.5], [3.5, 0.5]]}"#;
    let scene = Arc::new(standard().read_scene(text).unwrap());
    let setup = Setup { planner: "bat".into(), scene, params: Overrides::new(), seed: 1 };
    let error = Run::new(standard(), setup).err().unwrap();
    assert_eq!((error.field(), error.value()), ("stops[2]", "(3.5, 0.5)"));
}

const ROUNDS: [&str; 4] = ["closed", "open", "from-first", "first-to-last"];

fn tour_planners() -> impl Iterator<Item = &'static Entry> {
    standard().planners().iter().copied().filter(|entry| entry.family == "tour")
}

/// Stops here and there.
fn stops(n: usize, rng: &mut Stream) -> Arc<Scene> {
    let points: Vec<_> = (0..n).map(|_| [rng.between(0.0, 10.0), rng.between(0.0, 10.0)]).collect();
    let text = format!(r#"{{"format": "forage-scene", "version": 1, "kind": "tour", "name": "t", "title": "T", "points": {points:?}}}"#);
    Arc::new(standard().read_scene(&text).unwrap())
}

fn distances(scene: &Scene) -> &Distances {
    scene.get::<TourScene>().unwrap().distances()
}

fn run(planner: &str, scene: &Arc<Scene>, params: &[(&'static str, Value)], seed: u64) -> Run {
    let params: Overrides = params.iter().cloned().collect();
    Run::new(standard(), Setup { planner: planner.into(), scene: Arc::clone(scene), params, seed }).unwrap()
}

fn names(entry: &Entry, parameter: &str) -> bool {
    entry.parameter(parameter).is_some()
}

/// The tour of every member is a permutation with the ends that it should have and as long as it says.
fn check_members(run: &mut Run, round: TourEnds) {
    let scene = Arc::clone(run.scene());
    let n = scene.stops().len();
    for index in 0.. {
        let Some(inspection) = run.inspect(Item { layer: layers::TOURS.key, index }) else {
            break;
        };
        let order: Vec<_> = inspection.rows.iter().map(|row| row[0] as usize - 1).collect();
        assert!(round.allows(&order, n), "{} {order:?}", run.entry().name);
        let length = inspection.values.iter().find(|value| value.label.name == "length").unwrap().value;
        assert!((distances(&scene).length(&order, round.closes()) - length).abs() < 1e-9);
        assert!(length >= run.readings().get("best").unwrap());
    }
}

#[test]
fn tours_stay_permutations_and_the_best_never_rises_whatever_the_planner_and_the_round() {
    let mut rng = Stream::new(11, 0);
    for entry in tour_planners() {
        for n in 2..=20 {
            let scene = stops(n, &mut rng);
            if entry.check_scene(&scene).is_err() {
                continue;
            }
            for (round, name) in TourEnds::ALL.into_iter().zip(ROUNDS) {
                let mut params = vec![("round", Value::from(name)), ("iterations", Value::from(25.0))];
                if names(entry, "population") {
                    params.push(("population", Value::from((n % 7 + 1) as f64)));
                }
                let mut run = run(entry.name, &scene, &params, n as u64);
                let mut best = f64::INFINITY;
                loop {
                    let outcome = run.outcome();
                    if let Some(order) = &outcome.order {
                        assert!(round.allows(order, n), "{} {order:?}", entry.name);
                        let cost = outcome.cost.unwrap();
                        assert!(cost <= best, "{}: the best rose from {best} to {cost}", entry.name);
                        assert_eq!(cost, distances(&scene).length(order, round.closes()), "{} adds up", entry.name);
                        best = cost;
                        check_members(&mut run, round);
                    }
                    if run.status() != Status::Running {
                        break;
                    }
                    run.step(1);
                }
                assert!(best.is_finite(), "{} finds a tour of {n} stops, {name}", entry.name);
            }
        }
    }
}

#[test]
fn with_few_stops_every_number_runs_at_both_ends_of_its_range() {
    let mut rng = Stream::new(12, 0);
    // With more the suite of all planners does it.
    for n in [2, 3] {
        let scene = stops(n, &mut rng);
        for (entry, parameter) in tour_planners().flat_map(|entry| entry.all_parameters().map(move |parameter| (entry, parameter))) {
            let (min, max) = match parameter.domain {
                Domain::Number { min, max, .. } => (min, max),
                Domain::Integer { min, max, .. } => (min as f64, max as f64),
                _ => continue,
            };
            for value in [min, max] {
                let mut params = vec![(parameter.name, Value::from(value))];
                if names(entry, "population") && parameter.name != "population" {
                    params.push(("population", Value::from(3.0)));
                }
                let mut run = run(entry.name, &scene, &params, 3);
                run.step(if value >= 1000.0 { 2 } else { 12 });
                let found = run.outcome().cost.is_some();
                for (name, value) in run.readings().iter() {
                    let waits = !found || ["partial", "settled"].contains(&name);
                    assert!(value.is_finite() || (value.is_nan() && waits), "{} {}={value}: {name}", entry.name, parameter.name);
                }
            }
        }
    }
}

/// Every order there is, one after another.
fn by_trying(order: &mut Vec<usize>, k: usize, distances: &Distances, round: TourEnds) -> f64 {
    if k == order.len() {
        return if round.allows(order, k) { distances.length(order, round.closes()) } else { f64::INFINITY };
    }
    (k..order.len()).fold(f64::INFINITY, |best, i| {
        order.swap(k, i);
        let length = by_trying(order, k + 1, distances, round);
        order.swap(k, i);
        best.min(length)
    })
}

#[test]
fn held_and_karp_find_the_shortest_of_all_orders() {
    let mut rng = Stream::new(13, 0);
    for n in 2..=12 {
        let scene = stops(n, &mut rng);
        for (round, name) in TourEnds::ALL.into_iter().zip(ROUNDS) {
            let mut run = run("held-karp", &scene, &[("round", Value::from(name))], 1);
            run.step(u64::MAX);
            let outcome = run.outcome();
            assert_eq!(outcome.status, Status::Solved);
            let expected = match n {
                2..=8 => by_trying(&mut (0..n).collect(), 0, distances(&scene), round),
                _ => crate::exact::shortest_tour(distances(&scene), round).unwrap().1,
            };
            assert!((outcome.cost.unwrap() - expected).abs() < 1e-12, "{n} stops, {name}");
            assert!((run.readings().get("partial").unwrap() - expected).abs() < 1e-12);
        }
    }
}

#[test]
fn held_and_karp_take_no_more_stops_than_they_say() {
    let mut rng = Stream::new(14, 0);
    let refused = |n: usize, rng: &mut Stream| {
        let setup = Setup { planner: "held-karp".into(), scene: stops(n, rng), params: Overrides::new(), seed: 1 };
        Run::new(standard(), setup).err().map(|error| (error.field().to_owned(), error.value().to_owned(), error.allowed().into_owned()))
    };
    assert_eq!(refused(15, &mut rng), None);
    let (field, value, allowed) = refused(16, &mut rng).unwrap();
    assert_eq!((field.as_str(), value.as_str()), ("points", "a list of 16"));
    assert!(allowed.contains("15"), "{allowed}");
}

#[test]
fn annealing_cools_from_where_it_would_accept_what_was_asked_for() {
    let mut rng = Stream::new(15, 0);
    let scene = stops(20, &mut rng);
    let mut steady = run("sa", &scene, &[("cooling", Value::from(1.0)), ("moves", Value::from(1000.0))], 1);
    steady.step(5);
    let accepted = steady.readings().get("accepted").unwrap();
    // 0.8 of the moves up and all down, of moves on a random tour; while it is hot tours stay nearly random.
    assert!((0.75..0.95).contains(&accepted), "{accepted}");
    let mut cooled = run("sa", &scene, &[("cooling", Value::from(0.5))], 1);
    cooled.step(1);
    let first = cooled.readings().get("temperature").unwrap();
    cooled.step(3);
    assert_eq!(cooled.readings().get("temperature"), Some(first / 8.0));
    cooled.step(u64::MAX);
    assert_eq!(cooled.outcome().status, Status::Exhausted);
    assert!(cooled.readings().get("temperature").unwrap() >= 0.0);
}

/// Of the one more there is no matrix.
#[test]
fn two_thousand_stops_are_not_too_many() {
    let mut rng = Stream::new(16, 0);
    [2000, 2001].into_iter().for_each(|n| calls_at_all(n, &stops(n, &mut rng)));
}

fn calls_at_all(n: usize, scene: &Arc<Scene>) {
    for entry in tour_planners().filter(|entry| entry.most_stops.is_none()) {
        let mut params = vec![("iterations", Value::from(2.0))];
        if names(entry, "population") {
            params.push(("population", Value::from(5.0)));
        }
        let mut run = run(entry.name, scene, &params, 1);
        let first = run.outcome().cost.unwrap();
        run.step(u64::MAX);
        let outcome = run.outcome();
        assert!(TourEnds::Closed.allows(&outcome.order.unwrap(), n), "{}", entry.name);
        assert!(outcome.cost.unwrap() <= first);
        assert!((outcome.cost.unwrap() - outcome.length.unwrap()).abs() < 1e-9 * first, "{}", entry.name);
    }
}

/// Without the matrix a local search makes the same moves.
#[test]
fn computed_distances_give_tours_as_good_as_a_matrix() {
    let mut rng = Stream::new(17, 0);
    let scene = stops(2001, &mut rng);
    let points = scene.get::<TourScene>().unwrap().points.clone();
    let problem = |distances: &Distances| Arc::new(Problem::new(distances, TourEnds::Closed));
    let kept = problem(&Distances::of(2001, |i, j| Metric::Euclidean.distance(points[i], points[j])));
    let computed = problem(&Distances::through(&points, Metric::Euclidean));
    for (a, b) in local::neighbours(&kept).iter().zip(local::neighbours(&computed).iter()) {
        assert_eq!(a, b);
    }
    let [first, second] = [&kept, &computed].map(|problem| nearest::nearest_neighbour(problem, &mut Stream::new(1, 0)));
    assert_eq!(first.row, second.row);
    assert!((0..=2001).all(|a| computed.d(a, 2001) == 0.0 && kept.d(a, 7) == computed.d(a, 7)));
    let [polished, other] = [&kept, &computed].map(|problem| {
        let mut tour = first.clone();
        local::LocalSearch::new(problem).polish(&mut tour);
        tour
    });
    assert!(polished.row == other.row && polished.length < 0.9 * first.length);
}

#[test]
fn an_optimum_that_is_longer_than_what_is_found_is_none() {
    let text = shipped("random-52").unwrap().to_json();
    let mut file: serde_json::Value = serde_json::from_str(&text).unwrap();
    file["exact"] = serde_json::json!({"length": 100_000});
    let scene = Arc::new(standard().read_scene_value(file).unwrap());
    let mut run = Run::new(standard(), Setup { planner: "two-opt".into(), scene, params: Overrides::new(), seed: 1 }).unwrap();
    run.step(u64::MAX);
    let outcome = run.outcome();
    assert_eq!((outcome.exact, outcome.gap, outcome.exact_by), (None, None, crate::kernel::ReferenceOptimum::Refuted));
}

#[test]
fn ants_that_build_no_road_are_told_of() {
    let text = standard().generate("maze", &[("stops", Value::from(3.0))].into_iter().collect(), 2).unwrap().to_json();
    let scene = Arc::new(standard().read_scene(&text).unwrap());
    let run = |roads: &str| {
        let params: Overrides = [("roads", Value::from(roads)), ("iterations", Value::from(5.0))].into_iter().collect();
        let mut run = Run::new(standard(), Setup { planner: "held-karp".into(), scene: Arc::clone(&scene), params, seed: 1 }).unwrap();
        run.step(u64::MAX);
        run.outcome()
    };
    let (ants, exact) = (run("aco-direction"), run("a-star"));
    assert_eq!((exact.status, exact.failure), (Status::Solved, None));
    match ants.status {
        Status::Infeasible => assert!(ants.failure.unwrap().text().starts_with("aco-direction found no road from stops[0]")),
        status => assert!(status == Status::Solved && ants.failure.is_none()),
    }
}

#[test]
fn the_shortest_tour_by_road_is_what_held_karp_finds_on_those_roads() {
    for (roads, round) in [("a-star", "closed"), ("theta-star", "open"), ("aco", "first-to-last")] {
        let mut run = start("held-karp", "ant-bat-30", &[("roads", roads), ("round", round)], 3);
        assert!(run.readings().get("by_road").unwrap().is_nan(), "there are no roads yet");
        run.step(u64::MAX);
        let (best, by_road) = (run.readings().get("best").unwrap(), run.readings().get("by_road").unwrap());
        assert!((best - by_road).abs() < 1e-9, "{roads}, {round}: {best} and {by_road}");
    }
}

#[test]
fn more_members_than_there_is_memory_for_are_refused() {
    let points: Vec<_> = (0..2000).map(|i| [i % 50, i / 50]).collect();
    let text = serde_json::json!({ "format": "forage-scene", "version": 1, "kind": "tour", "name": "t", "title": "T", "points": points });
    let scene = Arc::new(standard().read_scene(&text.to_string()).unwrap());
    for (planner, allowed) in [
        ("ga", "at most 32864 where each takes 16336 bytes of memory"),
        ("tour-pso", "at most 16561 where each takes 32416 bytes of memory"),
    ] {
        let params = [("population", Value::from(100_000.0))].into_iter().collect();
        let error = Run::new(standard(), Setup { planner: planner.into(), scene: Arc::clone(&scene), params, seed: 1 }).err().unwrap();
        assert_eq!((error.field(), error.value(), &*error.allowed()), ("population", "100000", allowed), "{planner}");
    }
}

/// One thing is otherwise, and the random numbers are the same: what it does not touch stays.
#[test]
fn one_thing_can_be_supposed_of_one_member_with_the_same_random_numbers() {
    let of = |inspection: &Inspection, name: &str| inspection.values.iter().find(|value| value.label.name == name).map(|value| value.value);
    let mut seen = std::collections::BTreeSet::new();
    for planner in ["tour-pso", "ga", "sa", "bat", "hybrid-bat"] {
        let population = [("population", "9")];
        let mut run = start(planner, "random-52", &population[usize::from(planner == "sa")..], 5);
        for _ in 0..12 {
            run.step(1);
            for index in 0..if planner == "sa" { 1 } else { 9 } {
                let item = Item { layer: layers::TOURS.key, index };
                let inspection = run.inspect(item).unwrap();
                let mutated = ["mutation", "both"].contains(&inspection.event);
                assert!(planner != "ga" || inspection.summary.text().contains("mutation reversed") == mutated, "{}", inspection.summary);
                for supposition in inspection.suppositions.iter().map(|label| label.name).filter(|&name| name != "random") {
                    let supposed = run.suppose(item, supposition, 0).unwrap().unwrap();
                    seen.insert((planner, supposition));
                    match (planner, supposition) {
                        ("tour-pso", _) => {
                            let names = ["kept", "own", "swarm"];
                            let k = ["inertia", "own", "best"].iter().position(|&name| name == supposition).unwrap();
                            assert_eq!(of(&supposed, names[k]), Some(0.0), "{supposition}");
                            // What is drawn before is the same; what is drawn after is drawn from the same stream.
                            assert!((0..k).all(|j| of(&supposed, names[j]) == of(&inspection, names[j])), "{supposition}");
                        }
                        ("ga", "crossover") => assert!(["copy", "mutation"].contains(&supposed.event), "{}", supposed.event),
                        ("ga", _) => assert_eq!(of(&supposed, "second"), of(&inspection, "second"), "its parents are the same"),
                        ("sa", _) => assert_eq!(of(&supposed, "longer"), Some(0.0)),
                        ("bat", _) => assert!(supposed.event == "2-opt" && of(&supposed, "tries") == of(&inspection, "tries")),
                        _ => assert!(
                            supposed.event != "flight" && supposed.summary.text().contains("its own tour"),
                            "{}",
                            supposed.summary.text()
                        ),
                    }
                }
            }
        }
    }
    assert_eq!(seen.len(), 8, "{seen:?}");
}

/// Other random numbers give another tour; nothing of the run itself changes, and what draws none has nothing to suppose.
#[test]
fn a_step_can_be_supposed_with_other_random_numbers_wherever_it_draws_some() {
    let [few, many] = [12, 90].map(|count| stops(count, &mut Stream::new(3, 0)));
    'planners: for entry in tour_planners() {
        let scene = if entry.check_scene(&many).is_ok() { &many } else { &few };
        let mut run = run(entry.name, scene, &[], 5);
        let mut others = 0;
        let draws = !run.outcome().deterministic;
        for _ in 0..6 {
            if run.step(1) != Status::Running {
                break;
            }
            let hash = run.hash();
            let item = Item { layer: layers::TOURS.key, index: 0 };
            let Some(inspection) = run.inspect(item) else {
                // It has no tours but its best.
                continue 'planners;
            };
            assert_eq!(!inspection.suppositions.is_empty(), draws, "{}", entry.name);
            if !draws {
                assert!(run.suppose(item, "random", 0).is_err());
                continue;
            }
            let supposed = run.suppose(item, "random", 0).unwrap().unwrap();
            assert!(supposed.marks.iter().all(|mark| mark.layer == layers::SUPPOSED.key) && supposed.marks.len() == 1);
            others += usize::from(supposed.rows != inspection.rows);
            assert_eq!(run.hash(), hash, "{}", entry.name);
        }
        assert_eq!(others > 0, draws, "{}", entry.name);
    }
}
