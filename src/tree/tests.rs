//! Trees against hand-computed steps, and what must hold for every one.

use std::sync::Arc;

use crate::{
    Overrides, Run, Scene, Setup, Status, Value,
    arm::{ArmScene, Joint, degrees, motion_is_free, tip_path},
    describe::layers,
    kernel::{Item, Progress, State, limits, rng::Stream},
    params::{Domain, Parameters},
    scene::ARM,
    shipped, standard,
};

use super::{
    forest::NONE,
    grow::{Forest, SampleOutcome, Source},
    method::{Method, Trees},
    parameters::{MARGIN, REACHABLE},
    space,
    task::Task,
    vector::distance,
    *,
};

const TREES: [&str; 4] = ["rrt", "rrt-guided", "rrt-connect", "rrt-star"];

fn run(planner: &str, scene: &str, given: &[(&str, Value)], seed: u64) -> Run {
    let params: Overrides = given.iter().map(|(name, value)| (*name, value.clone())).collect();
    Run::new(standard(), Setup { planner: planner.into(), scene: shipped(scene).unwrap(), params, seed }).unwrap()
}

/// A planner with its parts open.
fn trees<M: Method<3>>(scene: &Scene, settings: &Parameters, seed: u64, method: impl FnOnce(&Task<3>) -> M) -> Trees<3, M> {
    Trees::new(space::of_scene(scene, settings[MARGIN], settings[REACHABLE]).unwrap(), settings, seed, method).unwrap()
}

fn guided(scene: &Scene, settings: &Parameters, seed: u64) -> Trees<3, rrt_guided::Guided> {
    trees(scene, settings, seed, |_| rrt_guided::Guided::new(settings))
}

fn number(value: f64) -> Value {
    Value::Number(value)
}

/// A plane, ten by ten, with a disc of radius 1 in the middle.
fn plane() -> Arc<Scene> {
    let text = r#"{"format": "forage-scene", "version": 1, "kind": "discs", "name": "p", "title": "P",
        "bounds": {"min": [0, 0], "max": [10, 10]}, "start": [1, 5], "goal": [9, 5], "discs": [{"center": [5, 5], "radius": 1}]}"#;
    Arc::new(standard().read_scene(text).unwrap())
}

fn task(scene: &Arc<Scene>, planner: &str) -> Task<3> {
    let entry = crate::standard().planner(planner).unwrap();
    let settings = Parameters::new(entry.parameters, scene.kind(), &Overrides::new()).unwrap();
    Task::new(space::of_scene(scene, settings[MARGIN], settings[REACHABLE]).unwrap(), &settings).unwrap()
}

/// Grows towards fixed points, so that steps can be computed by hand.
#[derive(Clone, State)]
struct Towards(Vec<[f64; 3]>, bool);

impl Method<3> for Towards {
    fn grow(&mut self, forest: &mut Forest<3>, task: &Task<3>, _: &mut Stream) {
        forest.begin(Source::Uniform, 0);
        let sample = self.0.remove(0);
        if let Some(new) = forest.extend(task, sample, self.1) {
            forest.reach(task, new);
        }
    }
}

/// (11) with L = 0.5.
#[test]
fn a_node_grows_by_a_step_towards_the_sample() {
    let samples = vec![[4.0, 9.0, 0.0], [1.0, 5.1, 0.0], [9.0, 5.0, 0.0], [-3.0, 5.0, 0.0]];
    let mut tree = Trees::of(task(&plane(), "rrt"), Towards(samples, false), 1);
    tree.extend();
    // From (1, 5) by ½ along (3, 4) / 5.
    let new = tree.forest.trees[0].points[1];
    assert!(distance(&new, &[1.3, 5.4, 0.0]) < 1e-15, "{new:?}");
    assert_eq!((tree.forest.trees[0].parents[1], tree.forest.trees[0].costs[1]), (0, distance(&new, &[1.0, 5.0, 0.0])));
    tree.extend();
    // A whole step beyond a sample that is nearer, as (11) is printed.
    assert_eq!(tree.forest.trees[0].points[2], [1.0, 5.5, 0.0]);
    tree.extend();
    // The nearest to (9, 5) is (1.3, 5.4).
    assert_eq!(tree.forest.trees[0].parents[3], 1);
    tree.extend();
    assert_eq!(tree.forest.last.samples[0].outcome, SampleOutcome::Taken);
    assert!(distance(&tree.forest.trees[0].points[4], &[0.5, 5.0, 0.0]) < 1e-15);

    let mut clipped = Trees::of(task(&plane(), "rrt"), Towards(vec![[1.0, 5.1, 0.0]], true), 1);
    clipped.extend();
    assert_eq!(clipped.forest.trees[0].points[1], [1.0, 5.1, 0.0], "no farther than the sample");
}

#[test]
fn a_step_out_of_the_space_or_into_an_obstacle_adds_nothing() {
    let mut out = Trees::of(task(&plane(), "rrt"), Towards(vec![[-9.0, 5.0, 0.0]; 4], false), 1);
    (0..4).for_each(|_| {
        out.extend();
    });
    // (0.5, 5), (0, 5), and no farther.
    assert_eq!((out.forest.trees[0].len(), out.forest.last.samples[0].outcome, out.forest.rejected), (3, SampleOutcome::Outside, 2));
    let mut blocked = Trees::of(task(&plane(), "rrt"), Towards(vec![[9.0, 5.0, 0.0]; 9], false), 1);
    (0..9).for_each(|_| {
        blocked.extend();
    });
    // From 1 to 4, where the disc begins.
    assert_eq!(
        (blocked.forest.trees[0].len(), blocked.forest.last.samples[0].outcome, blocked.forest.rejected),
        (7, SampleOutcome::Blocked, 3)
    );
    assert_eq!(blocked.forest.nearest, 25.0);
}

/// Whether a node's posture has its tip there, within the limits, and the arm gets to it from its parent's with the tip straight on and
/// without touching anything.
fn goes_along(arm: &ArmScene, task: &Task<3>, tree: &Tree<3>, node: usize) -> bool {
    let parent = tree.parent(node).unwrap_or(node);
    let ([posture, from], [there, here]) = ([&tree.postures.0[node], &tree.postures.0[parent]], [&tree.points[node], &tree.points[parent]]);
    let within = |(joint, angle): (&Joint, f64)| (joint.min - 1e-9..=joint.max + 1e-9).contains(&angle);
    let tips = tip_path(&arm.arm, &[*from, *posture]);
    let way: f64 = tips.windows(2).map(|w| distance(&w[0], &w[1])).sum();
    // What a step of the usual size takes is one motion of the joints; longer ways of neighbours are several.
    let gets_there = if distance(there, here) < 0.035 {
        way - distance(&tips[0], &tips[tips.len() - 1]) < 2e-3 && motion_is_free(arm, from, posture, 0.0, 1e-3)
    } else {
        task.space.posture_at(here, from, there, Some(posture)).is_some_and(|to| distance(&to, posture) < 1e-9)
    };
    distance(&arm.arm.skeleton(posture)[4], there) < 1e-9
        && arm.arm.joints.iter().zip(degrees(posture)).all(within)
        && motion_is_free(arm, posture, posture, 0.0, 1e-3)
        && gets_there
}

/// Runs a planner and looks at the tree after every step.
fn watch<M: Method<3>>(mut grown: Trees<3, M>, steps: usize, scene: &Scene) {
    let task = Arc::clone(&grown.task);
    let mut best = f64::INFINITY;
    let mut progress = Progress::Continue;
    for _ in 0..steps {
        if progress == Progress::Continue {
            progress = grown.extend();
        }
        if let Some(found) = &grown.forest.found {
            assert!(found.cost <= best, "the best cost never rises");
            best = found.cost;
        }
    }
    let forest = &grown.forest;
    assert_eq!(forest.births.len(), forest.trees[0].len() + forest.trees[1].len());
    for tree in &forest.trees {
        let arm = scene.get::<ArmScene>().ok();
        assert_eq!(tree.postures.0.len(), if arm.is_some() { tree.len() } else { 0 });
        for node in 0..tree.len() {
            assert!(task.contains(&tree.points[node]));
            assert!(arm.is_none_or(|arm| goes_along(arm, &task, tree, node)));
            let Some(parent) = Some(tree.parents[node]).filter(|&parent| parent != NONE) else {
                assert_eq!(tree.costs[node], 0.0);
                continue;
            };
            let (a, b) = (tree.points[parent as usize], tree.points[node]);
            assert!(task.space.is_free(&a, &b) && distance(&a, &b) <= 4.0 * task.step + 1e-12);
            assert_eq!(tree.costs[node], tree.costs[parent as usize] + distance(&a, &b));
            // Following parents ends at a root: there is no ring.
            let up = std::iter::successors(Some(node as u32), |&at| Some(tree.parents[at as usize]).filter(|&parent| parent != NONE));
            assert!(up.take(tree.len() + 1).count() <= tree.len());
        }
    }
    if let Some(found) = &forest.found {
        let path = &found.finished(&task).path;
        assert_eq!((path[0], path[path.len() - 1]), (task.start, task.goal()));
        assert!(path.windows(2).all(|w| task.space.is_free(&w[0], &w[1])), "{}", scene.name());
        // The arm gets along all of what was found, from posture to posture.
        assert_eq!(found.postures.0.len(), if scene.kind() == ARM { found.raw.len() } else { 0 });
        for (points, postures) in found.raw.windows(2).zip(found.postures.0.windows(2)) {
            assert!(task.space.posture_at(&points[0], &postures[0], &points[1], Some(&postures[1])).is_some(), "{}", scene.name());
        }
        let lengths = [&found.raw, &found.finished(&task).short].map(|path| vector::length(path));
        assert!(lengths[1] <= lengths[0] * (1.0 + 1e-12), "{lengths:?}");
    }
}

#[test]
fn a_tree_is_a_tree_its_edges_are_free_and_its_path_joins_the_ends() {
    for scene in ["arm-cuboid", "arm-free", "wcpso-discs", "qpso-10m"] {
        let scene = shipped(scene).unwrap();
        for seed in 0..4 {
            for planner in TREES {
                let entry = crate::standard().planner(planner).unwrap();
                let settings = Parameters::new(entry.parameters, scene.kind(), &Overrides::new()).unwrap();
                match planner {
                    "rrt" => watch(trees(&scene, &settings, seed, |_| rrt::Rrt::new(&settings)), 1500, &scene),
                    "rrt-guided" => watch(guided(&scene, &settings, seed), 1500, &scene),
                    "rrt-connect" => watch(trees(&scene, &settings, seed, |_| rrt_connect::Connect::default()), 1500, &scene),
                    _ => watch(trees(&scene, &settings, seed, |task| rrt_star::Star::new(task, &settings)), 1500, &scene),
                }
            }
        }
    }
}

/// A goal inside the workspace that no posture reaches: refused, unless only the tip counts.
#[test]
fn a_goal_out_of_the_arms_reach_is_refused_unless_only_the_tip_counts() {
    let mut json: serde_json::Value = serde_json::from_str(&shipped("arm-cuboid").unwrap().to_json()).unwrap();
    json["goal"] = serde_json::json!([1.19, 1.09, 0.69]);
    let scene = Arc::new(standard().read_scene(&json.to_string()).unwrap());
    for planner in TREES {
        let setup = |reachable: bool| Setup {
            planner: planner.into(),
            scene: Arc::clone(&scene),
            params: [("reachable", Value::Flag(reachable))].into_iter().collect(),
            seed: 1,
        };
        let error = Run::new(standard(), setup(true)).err().unwrap();
        assert_eq!(error.field(), "goal", "{planner}");
        assert!(error.allowed().ends_with("; or `reachable=false`, with which only the tip counts"), "{error}");
        assert!(Run::new(standard(), setup(false)).is_ok(), "{planner}");
    }
}

#[test]
fn without_the_fallback_no_step_is_plain() {
    let scene = shipped("arm-cuboid").unwrap();
    let given = [("fallback", "false".into())].into_iter().collect();
    let settings = Parameters::new(standard().planner("rrt-guided").unwrap().parameters, ARM, &given).unwrap();
    let (mut by_angle, mut nothing) = (0, 0);
    for seed in 0..10 {
        let mut grown = guided(&scene, &settings, seed);
        while grown.extend() == Progress::Continue && grown.forest.trees[0].len() < 60 && by_angle + nothing < 4000 {
            let last = &grown.forest.last;
            assert!(!last.fell_back && last.samples.len() == 20);
            by_angle += usize::from(last.added);
            nothing += usize::from(!last.added);
        }
    }
    assert!(by_angle > 10 && nothing > 100, "{by_angle} {nothing}");
}

/// [ARM-RRT](crate#papers) §3.2.1, checked with what the extension itself keeps of its samples.
#[test]
fn the_four_samples_with_the_smallest_angles_are_kept_and_new_nodes_do_not_double_back() {
    let scene = shipped("arm-cuboid").unwrap();
    let entry = crate::standard().planner("rrt-guided").unwrap();
    let settings = Parameters::new(entry.parameters, ARM, &Overrides::new()).unwrap();
    let (mut by_angle, mut fell_back, mut chosen) = (0, 0, [0; 4]);
    for seed in 0..40 {
        let mut grown = guided(&scene, &settings, seed);
        for _ in 0..60 {
            let before = grown.forest.trees[0].clone();
            let near = grown.forest.nearest_node;
            if grown.extend() != Progress::Continue {
                break;
            }
            let last = &grown.forest.last;
            let (samples, plain) = last.samples.split_at(20);
            assert_eq!(plain.len(), usize::from(last.fell_back));
            let from = before.points[near];
            let goal = grown.task.goal();
            for sample in samples {
                let way: [f64; 3] = std::array::from_fn(|i| sample.point[i] - from[i]);
                let ahead: [f64; 3] = std::array::from_fn(|i| goal[i] - from[i]);
                assert_eq!(sample.angle, sample::angle(&way, &ahead));
            }
            let mut order: Vec<_> = (0..20).collect();
            order.sort_by(|&a, &b| samples[a].angle.total_cmp(&samples[b].angle));
            let all: f64 = order[..4].iter().map(|&i| std::f64::consts::PI - samples[i].angle).sum();
            for (rank, &i) in order.iter().enumerate() {
                assert_eq!(samples[i].outcome == SampleOutcome::NotKept, rank >= 4);
                let share = if rank < 4 { (std::f64::consts::PI - samples[i].angle) / all } else { 0.0 };
                assert!((samples[i].share - share).abs() < 1e-12);
                if samples[i].outcome == SampleOutcome::Taken {
                    chosen[rank] += 1;
                }
            }
            let tree = &grown.forest.trees[0];
            if last.added {
                let (new, parent) = (tree.points[tree.len() - 1], tree.parents[tree.len() - 1] as usize);
                let to_parent = distance(&new, &before.points[parent]);
                assert!((0..before.len()).all(|i| distance(&new, &before.points[i]) >= to_parent - 1e-12), "it doubles back");
                assert!((to_parent - grown.task.step).abs() < 1e-12);
                assert!(last.fell_back || parent == near);
            }
            fell_back += usize::from(last.fell_back);
            by_angle += usize::from(!last.fell_back);
        }
    }
    assert!(by_angle > 100 && fell_back > 100 && chosen.iter().all(|&n| n > 20), "{by_angle} {fell_back} {chosen:?}");
}

/// [ARM-RRT](crate#papers) §3.3 step 2 (2): the wheel draws four by their distances to the goal, and the nearest comes first.
#[test]
fn by_distance_the_wheel_keeps_four_and_the_nearest_that_is_free_is_taken() {
    let scene = shipped("arm-cuboid").unwrap();
    let entry = crate::standard().planner("rrt-guided").unwrap();
    let settings = Parameters::new(entry.parameters, ARM, &Overrides::from_iter([("choice", Value::from("distance"))])).unwrap();
    let (mut taken, mut nearest_kept, mut extensions) = (0, 0, 0);
    for seed in 0..40 {
        let mut grown = guided(&scene, &settings, seed);
        for _ in 0..60 {
            if grown.extend() != Progress::Continue {
                break;
            }
            let (samples, goal) = (&grown.forest.last.samples[..20], grown.task.goal());
            let far = |i: usize| distance(&samples[i].point, &goal);
            let all: f64 = (0..20).map(|i| 1.0 / far(i)).sum();
            assert!((0..20).all(|i| (samples[i].share - 1.0 / far(i) / all).abs() < 1e-12));
            let mut kept: Vec<_> = (0..20).filter(|&i| samples[i].outcome != SampleOutcome::NotKept).collect();
            assert_eq!(kept.len(), 4);
            kept.sort_by(|&a, &b| far(a).total_cmp(&far(b)));
            extensions += 1;
            nearest_kept += usize::from((0..20).all(|i| far(i) >= far(kept[0])));
            if let Some(at) = kept.iter().position(|&i| samples[i].outcome == SampleOutcome::Taken) {
                taken += 1;
                assert!(kept[..at].iter().all(|&i| samples[i].outcome != SampleOutcome::NotDrawn));
                assert!(kept[at + 1..].iter().all(|&i| samples[i].outcome == SampleOutcome::NotDrawn));
            }
        }
    }
    // Weighted by 1/d the nearest of twenty is among the four more often than four times in twenty, and not always.
    assert!(taken > 100 && nearest_kept * 4 > extensions && nearest_kept < extensions, "{taken} {nearest_kept} {extensions}");
}

#[test]
fn a_node_says_how_it_came_about_however_long_ago() {
    let mut run = run("rrt-guided", "arm-cuboid", &[], 3);
    run.step(200);
    let nodes = run.readings().get("nodes").unwrap() as usize;
    let mut fallbacks = 0;
    for index in 0..nodes {
        let inspection = run.inspect(Item { layer: layers::NODES.key, index }).unwrap();
        assert_eq!(inspection.title.text(), format!("Node {}", index + 1));
        if index == 0 {
            assert_eq!(inspection.event, "root");
            continue;
        }
        assert_eq!(inspection.rows.len(), 20);
        assert_eq!(
            inspection.labels.iter().filter(|label| label.text().ends_with(": taken")).count(),
            usize::from(inspection.event == "guided")
        );
        assert!(["guided", "random step"].contains(&inspection.event));
        fallbacks += usize::from(inspection.event == "random step");
    }
    assert!(fallbacks > 0 && fallbacks < nodes - 1);
    assert_eq!(run.inspect(Item { layer: layers::NODES.key, index: nodes }), None);
    for index in 0..20 {
        assert!(run.inspect(Item { layer: layers::SAMPLES.key, index }).unwrap().marks.iter().any(|mark| mark.layer == layers::AFTER.key));
    }
}

#[test]
fn the_guided_tree_needs_fewer_nodes_and_without_obstacle_runs_nearly_straight() {
    let runs = |planner: &str, scene: &str| -> Vec<(f64, f64)> {
        let mut runs: Vec<_> = (0..15)
            .map(|seed| {
                let mut run = run(planner, scene, &[], seed);
                assert_eq!(run.step(u64::MAX), Status::Solved, "{planner} {scene} {seed}");
                (run.readings().get("nodes").unwrap(), run.outcome().cost.unwrap())
            })
            .collect();
        runs.sort_by(|a, b| a.0.total_cmp(&b.0));
        runs
    };
    for scene in ["arm-cuboid", "arm-free"] {
        assert!(runs("rrt-guided", scene)[7].0 < runs("rrt", scene)[7].0, "{scene}");
    }
    let straight = distance(&[-0.2, 0.022, 0.05], &[0.9, 0.7, 0.3]);
    let mean = |runs: Vec<(f64, f64)>| runs.iter().map(|(_, cost)| cost).sum::<f64>() / 15.0 / straight;
    let (guided, basic) = (mean(runs("rrt-guided", "arm-free")), mean(runs("rrt", "arm-free")));
    assert!(guided < basic, "{guided} {basic}");
}

#[test]
fn rewiring_makes_ways_shorter_and_informed_samples_stay_where_a_shorter_path_can_lead() {
    let mut informed = run("rrt-star", "arm-cuboid", &[("iterations", number(3000.0))], 5);
    let mut first = None;
    while informed.step(50) == Status::Running {
        first = first.or(informed.outcome().cost);
    }
    let last = informed.outcome();
    assert!(last.cost.unwrap() < first.unwrap() && last.feasible);
    let mut uninformed = run("rrt-star", "arm-cuboid", &[("iterations", number(3000.0)), ("informed", Value::Flag(false))], 5);
    uninformed.step(u64::MAX);
    assert!(last.cost.unwrap() < uninformed.outcome().cost.unwrap());
}

/// An iteration adds a node at most, so the most iterations that are allowed bound the memory that a tree takes: in joints as well, where
/// a node has twice as many numbers.
#[test]
fn the_largest_trees_fit_into_memory() {
    let scene = shipped("arm-cuboid").unwrap();
    let given = [("step_size", Value::from(1e-3))].into_iter().collect();
    let settings = Parameters::new(rrt_star::ENTRY.parameters, ARM, &given).unwrap();
    let mut trees = trees(&scene, &settings, 1, |task| rrt_star::Star::new(task, &settings));
    let steps = 4000;
    (0..steps).for_each(|_| {
        trees.extend();
    });
    let nodes = trees.forest.births.len();
    assert!((steps / 4..=steps + 1).contains(&nodes), "{nodes}");
    let Domain::Integer { max, .. } = parameters::ITERATIONS.entry().domain else { unreachable!() };
    // A point, a parent and a length at least.
    let each = trees.heap_size() / nodes;
    assert!(each >= 36, "{each}");
    assert!(2 * each * max as usize <= limits::MEMBERS_BYTES, "{each}");
}
