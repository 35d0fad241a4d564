//! The swarm's equations by hand, and that a run does not depend on who carries out its jobs.

use std::sync::Arc;

use super::{planner::start, swarm::*, *};
use crate::{
    Run, Setup,
    describe::{Entry, Start},
    kernel::Subtask,
    kernel::{SubtaskResult, rng::Stream},
    math,
    params::{Parameters, Value},
    shipped, standard,
};

fn run(params: &[(&str, &str)]) -> Run {
    let params = [("population", "3"), ("seeds", "2"), ("colony_iterations", "4"), ("iterations", "5")]
        .iter()
        .chain(params)
        .map(|&(name, value)| (name, Value::from(value)))
        .collect();
    Run::new(standard(), Setup { planner: "pso-tuning".into(), scene: shipped("wolf-ant-20").unwrap(), params, seed: 1 }).unwrap()
}

#[test]
fn every_number_of_every_colony_can_be_tuned() {
    let colonies = standard().planners().iter().copied().filter(|entry| entry.family == "ants");
    let numbers = colonies.flat_map(Entry::all_parameters).filter_map(Axis::new).map(|axis| axis.parameter.name);
    let known: Vec<_> = parameters::TUNABLE.iter().map(|option| option.value).collect();
    let mut count = 0;
    for name in numbers.filter(|name| *name != "iterations") {
        assert!(known.contains(&name), "{name} cannot be tuned");
        assert!(ENTRY.readings.iter().any(|reading| reading.name == name), "{name} is no reading");
        count += 1;
    }
    assert!(count > known.len());
}

#[test]
fn an_axis_goes_through_its_slider_s_range_evenly_or_by_magnitudes() {
    let axis = |name| {
        let colony = standard().planner("aco-wolf").unwrap();
        Axis::new(colony.parameter(name).unwrap()).unwrap()
    };
    let q = axis("q");
    assert_eq!((q.low, q.high, q.value(333.25)), (100.0, 1000.0, 333.25));
    let tau = axis("tau_0");
    assert_eq!((tau.low, tau.high), (-2.0, 4.0));
    assert_eq!([tau.value(-2.0), tau.value(0.0), tau.value(4.0)], [0.01, 1.0, 10_000.0]);
    assert_eq!(axis("ants").value(math::log10(17.4)), 17.0);
}

/// Whoever carries the jobs out, in whatever order, the run is the same to the last bit.
#[test]
fn supplied_findings_give_the_same_run() {
    let (mut alone, mut helped) = (run(&[]), run(&[]));
    for _ in 0..5 {
        let jobs = helped.subtasks();
        assert_eq!(jobs.len(), 6);
        let setup = |job: &Subtask| Setup {
            planner: job.planner.into(),
            scene: Arc::clone(helped.scene()),
            params: job.params.clone(),
            seed: job.seed,
        };
        let mut found: Vec<_> = jobs.iter().rev().map(|job| crate::run::run_to_end(standard(), setup(job)).unwrap()).collect();
        found.reverse();
        let refused = |helped: &mut Run, found: Vec<SubtaskResult>| helped.provide(found).unwrap_err().field().to_owned();
        assert_eq!(refused(&mut helped, found[1..].to_vec()), "findings");
        let mut lost = found.clone();
        (lost[1].cost, lost[1].converged) = (Some(1.0), f64::NAN);
        assert_eq!(refused(&mut helped, lost.clone()), "findings[1].converged");
        lost[0].path = vec![[0.5, f64::NAN]];
        assert_eq!(refused(&mut helped, lost), "findings[0].path[0][1]");
        helped.provide(found).unwrap();
        assert!(helped.subtasks().is_empty(), "they are done");
        alone.step(1);
        helped.step(1);
        assert_eq!(alone.hash(), helped.hash());
    }
    assert_eq!(alone.outcome().tuned, helped.outcome().tuned);
    assert!(helped.subtasks().is_empty(), "nothing is left to do");
}

#[test]
fn what_it_recommends_gives_what_it_says() {
    let mut tuning = run(&[("tune", "alpha,rho")]);
    tuning.step(5);
    let outcome = tuning.outcome();
    let tuned = outcome.tuned.unwrap();
    assert_eq!(
        (tuned.planner, tuned.params.iter().map(|(name, _)| name).collect::<Vec<_>>()),
        ("aco-wolf", vec!["alpha", "iterations", "rho"])
    );
    // The same seeds, drawn as the tuning drew them.
    let mut rng = Stream::new(1, 0);
    let costs = [(); 2].map(|()| {
        let seed = rng.below(1 << 31) as u64;
        let setup = Setup { planner: tuned.planner.into(), scene: Arc::clone(tuning.scene()), params: tuned.params.clone(), seed };
        crate::run::run_to_end(standard(), setup).unwrap().cost.unwrap()
    });
    assert_eq!(outcome.cost.unwrap(), costs.iter().sum::<f64>() / 2.0);
}

#[test]
fn a_subset_that_the_colony_has_not_is_refused() {
    let params = [("colony", Value::from("aco")), ("tune", Value::from("gamma,epsilon"))].into_iter().collect();
    let refused = Run::new(standard(), Setup { planner: "pso-tuning".into(), scene: shipped("wolf-ant-20").unwrap(), params, seed: 1 });
    assert_eq!(refused.err().unwrap().field(), "tune");
}

/// v and x by hand: w = 0.5, c1 = c2 = 0 halves the velocity and moves by it.
#[test]
fn a_particle_flies_by_the_equation_and_stays_in_its_range() {
    let scene = shipped("wolf-ant-20").unwrap();
    let given = [("w", Value::from(0.5)), ("c1", Value::from(0.0)), ("c2", Value::from(0.0)), ("tune", Value::from("beta"))];
    let settings = Parameters::new(ENTRY.parameters, scene.kind(), &given.into_iter().collect()).unwrap();
    start(&Start { entry: &ENTRY, scene: &scene, parameters: &settings, seed: 1, entries: &**standard() }).unwrap();
    let colony = standard().planner("aco-wolf").unwrap();
    let axes: Vec<_> = colony.parameter("beta").into_iter().filter_map(Axis::new).collect();
    let mut swarm = Tuning {
        scene,
        colony,
        rounds: 1,
        population: 2,
        weights: [0.5, 0.0, 0.0],
        seeds: vec![1],
        shown: vec![4.0, 19.0],
        x: vec![4.0, 19.0],
        v: vec![3.0, 8.0],
        cost: vec![NONE; 2],
        p: vec![0.0, 0.0],
        p_cost: vec![NONE; 2],
        g: vec![10.0],
        g_cost: NONE,
        ways: vec![Vec::new(); 2],
        best: Vec::new(),
        provided: Vec::new(),
        iteration: 0,
        rng: Stream::new(1, 0),
        axes,
    };
    swarm.fly();
    assert_eq!((swarm.x.as_slice(), swarm.v.as_slice()), ([5.5, 20.0].as_slice(), [1.5, 4.0].as_slice()));
    let finding = |cost, converged| SubtaskResult { cost, converged, path: vec![[0.0; 2]; 2] };
    swarm.judge(&[finding(Some(7.0), 9.0), finding(Some(7.0), 3.0)]);
    assert_eq!((swarm.g[0], swarm.g_cost), (20.0, Fitness { length: 7.0, converged: 3.0 }), "equally long: the one that converged earlier");
    swarm.judge(&[finding(None, 0.0), finding(Some(8.0), 1.0)]);
    assert_eq!((swarm.p_cost[0].length, swarm.p_cost[1].length, swarm.cost[0].length), (7.0, 7.0, f64::INFINITY));
}

#[test]
fn more_results_than_there_is_memory_for_are_refused() {
    let row = ".".repeat(2048);
    let text = serde_json::json!({
        "format": "forage-scene", "version": 1, "kind": "grid", "name": "w", "title": "W", "cell": 1, "rows": [row],
        "start": [0.5, 0.5], "goal": [2047.5, 0.5],
    });
    let scene = Arc::new(standard().read_scene(&text.to_string()).unwrap());
    let params = [("population", 200.0), ("seeds", 100.0)].into_iter().map(|(name, value)| (name, Value::from(value))).collect();
    let error = Run::new(standard(), Setup { planner: "pso-tuning".into(), scene, params, seed: 1 }).err().unwrap();
    // Of each of 100 runs: 64 bytes, and 2048 corners of 16.
    let allowed = "at most 163 where each takes 3283200 bytes of memory";
    assert_eq!((error.field(), error.value(), &*error.allowed()), ("population", "200", allowed));
}
