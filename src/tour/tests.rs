//! The pipeline: roads, their distances, and what is told.

use std::sync::Arc;

use crate::{Given, Session, Setup, Status, catalogue, params::Value, planner::Round, shipped};

fn session(planner: &str, scene: &str, params: &[(&'static str, &str)], seed: u64) -> Session {
    let params: Given = params.iter().map(|&(name, value)| (name, Value::from(value))).collect();
    Session::new(Setup { planner: planner.into(), scene: shipped(scene).unwrap(), params, seed }).unwrap()
}

#[test]
fn whoever_can_build_roads_is_in_the_catalogue() {
    for builder in super::parameters::BUILDERS {
        let entry = catalogue::find(builder.value).unwrap();
        assert!(!entry.stops && entry.parameters.iter().any(|p| p.name == "smooth"), "{}", builder.value);
    }
}

#[test]
fn roads_are_the_same_whoever_builds_them() {
    let params = [("roads", "aco"), ("iterations", "3")];
    let mut alone = session("bat", "ant-bat-30", &params, 4);
    let mut helped = session("bat", "ant-bat-30", &params, 4);
    while helped.status() == Status::Running {
        let jobs = helped.jobs();
        if !jobs.is_empty() {
            let scene = Arc::clone(helped.scene());
            // Backwards, one by one.
            let mut found: Vec<_> =
                jobs.iter().rev().map(|job| crate::session::carry_out_all(&scene, std::slice::from_ref(job)).unwrap().remove(0)).collect();
            found.reverse();
            helped.supply(found);
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
            let mut session = session("bat", "ant-bat-30", &params, seed);
            session.step(u64::MAX);
            session.outcome()
        });
        let outcomes: Vec<_> = outcomes.collect();
        // Bats promise nothing: some end in an open tour that is 1.6 % longer.
        assert!(outcomes.iter().any(|outcome| outcome.gap == Some(0.0)), "{round}");
        for outcome in outcomes {
            assert!(outcome.feasible && outcome.gap >= Some(0.0), "{round}");
            assert!(Round::ALL[i].allows(&outcome.order.unwrap(), 12));
        }
    }
}

#[test]
fn a_stop_behind_walls_is_named() {
    let text = r#"{"format": "forage-scene", "version": 1, "kind": "grid", "name": "w", "title": "W", "cell": 1,
        "rows": ["..#.", "..#.", "..#."], "stops": [[0.5, 0.5], [1.5, 2.5], [3.5, 0.5]]}"#;
    let scene = Arc::new(crate::Scene::from_json(text).unwrap());
    let setup = Setup { planner: "bat".into(), scene, params: Given::new(), seed: 1 };
    let error = Session::new(setup).err().unwrap();
    assert_eq!((error.field(), error.value()), ("stops[2]", "(3.5, 0.5)"));
}
