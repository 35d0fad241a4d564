use std::{collections::BTreeSet, sync::Arc};

use crate::{
    Run, Scene, Setup, Status, Value,
    describe::{Entries, Entry, Start},
    kernel::{Border, Error, Event, Solution, Stepped, Track, part::with_parts_of},
    params::{Overrides, Parameters},
    run::Outcome,
    scene::GridScene,
    shipped, standard,
};

use super::wolf_ant_drive;

const DRIVES: [&str; 3] = ["wolf-ant-drive", "a-star-drive", "d-star-lite-drive"];

pub(super) fn start(planner: &str, scene: &Arc<Scene>, params: &[(&str, Value)], seed: u64) -> Run {
    let params: Overrides = params.iter().map(|(name, value)| (*name, value.clone())).collect();
    Run::new(standard(), Setup { planner: planner.to_owned(), scene: Arc::clone(scene), params, seed }).unwrap()
}

fn run(planner: &str, scene: &Arc<Scene>, params: &[(&str, Value)], seed: u64) -> Outcome {
    let mut run = start(planner, scene, params, seed);
    while run.step(u64::MAX) == Status::Running {}
    run.outcome()
}

/// A grid of cells of side 2 with a robot of radius 1 that goes 2 a second and turns in 1 s, margin 1.
pub(super) fn scene(rows: &[&str], ends: [[f64; 2]; 2], moving: &str) -> Arc<Scene> {
    let text = format!(
        r#"{{"format": "forage-scene", "version": 1, "kind": "grid", "name": "m", "title": "M", "cell": 2, "rows": {rows:?},
            "start": {:?}, "goal": {:?}, "robot": {{"speed": 2, "turn_time": 1, "sensor": 12, "radius": 1, "margin": 1, "look_ahead": 6}},
            "moving": [{moving}]}}"#,
        ends[0], ends[1]
    );
    Arc::new(standard().read_scene(&text).unwrap())
}

fn kinds(outcome: &Outcome) -> Vec<&str> {
    outcome.events.iter().map(|event| event.kind).collect()
}

fn event<'a>(outcome: &'a Outcome, kind: &str) -> &'a Event {
    outcome.events.iter().find(|event| event.kind == kind).unwrap_or_else(|| panic!("no {kind} in {:?}", outcome.events))
}

pub(super) fn reading(outcome: &Outcome, name: &str) -> f64 {
    outcome.readings.iter().find(|(n, _)| *n == name).unwrap().1
}

fn apart(a: [f64; 2], b: [f64; 2]) -> f64 {
    crate::geometry::distance_squared(b, b, a).sqrt()
}

/// The identities that every drive keeps.
fn check(outcome: &Outcome, scene: &Scene, name: &str) {
    let number = |reading_name| reading(outcome, reading_name);
    let parts = number("driving") + number("turning_time") + number("waited");
    assert!((number("time") - parts).abs() < 1e-6, "{name}: {} {parts}", number("time"));
    assert!(outcome.events.windows(2).all(|pair| pair[0].iteration <= pair[1].iteration), "{name}");
    let collisions = outcome.events.iter().filter(|event| event.kind == "collision").count();
    assert_eq!(collisions as f64, number("collisions"), "{name}: each has an event");
    assert_eq!(outcome.failed_at, None, "{name}: no cost is computed at a position");
    if outcome.status == Status::Solved {
        assert_eq!(outcome.events.last().unwrap().kind, "arrived");
        assert!((outcome.length.unwrap() - number("length")).abs() < 1e-6, "{name}");
        assert_eq!(outcome.feasible, collisions == 0, "{name}: what touches nothing is feasible, and nothing else");
        assert!((outcome.cost.unwrap() - number("time")).abs() < 1e-12);
        let (moments, path) = (&outcome.moments, outcome.path.as_ref().unwrap());
        assert!(moments.is_sorted_by(|a, b| a[0] < b[0]) && moments[0] == [0.0, path[0][0], path[0][1]], "{name}");
        assert_eq!(moments.last().map(|&[t, x, y]| (t, [x, y])), Some((number("time"), *path.last().unwrap())), "{name}");
    } else {
        assert!(outcome.failure.is_some() && outcome.path.is_none() && !outcome.feasible, "{name}");
    }
    let moving = !scene.get::<GridScene>().unwrap().moving.is_empty();
    assert_eq!(number("smallest_distance").is_finite(), moving && !outcome.events.is_empty());
}

#[test]
fn the_colonies_to_choose_from_are_those_of_the_catalogue() {
    let options = crate::ants::COLONIES;
    let mut colonies: Vec<_> = standard().planners().iter().filter(|entry| entry.family == "ants").map(|entry| entry.name).collect();
    let mut names: Vec<_> = options.iter().map(|option| option.value).collect();
    colonies.sort_unstable();
    names.sort_unstable();
    assert_eq!(names, colonies);
}

/// A list in which each name is this planner's.
struct Only(&'static [Entry]);

impl Entries for Only {
    fn planner(&self, name: &str) -> Result<&'static Entry, Error> {
        self.0.first().ok_or_else(|| Error::unknown("planner", name, []))
    }
}

#[test]
fn a_colony_that_the_list_lacks_or_that_is_none_is_refused() {
    const DRIVE: Entry = wolf_ant_drive::ENTRY;
    let scene = shipped("wolf-ant-20").unwrap();
    let parameters = Parameters::new(DRIVE.parameters, scene.kind(), &Overrides::new()).unwrap();
    let refused = |entries: &dyn Entries| {
        let start = Start { entry: &DRIVE, scene: &scene, parameters: &parameters, seed: 1, entries };
        (DRIVE.start)(&start).err().unwrap()
    };
    let none = refused(&Only(&[]));
    assert_eq!((none.field(), none.value(), &*none.allowed()), ("colony", "aco-wolf", ""));
    let other = refused(&Only(&[crate::search::a_star::ENTRY]));
    assert_eq!((other.field(), other.value()), ("colony", "a-star"));
    assert_eq!(other.allowed(), "an ant colony, e.g. aco-wolf, aco-direction, aco-dijkstra, aco");
}

/// The published case: all arrive on a shortest way, in its length over 20 px/s and a second a turn, and touch nothing.
#[test]
fn the_published_case_is_driven_without_collision() {
    let scene = shipped("wolf-ant-20").unwrap();
    for planner in DRIVES {
        for seed in 1..=if planner == "wolf-ant-drive" { 12 } else { 1 } {
            let outcome = run(planner, &scene, &[], seed);
            let name = format!("{planner}, seed {seed}");
            check(&outcome, &scene, &name);
            assert!(outcome.feasible && outcome.status == Status::Solved, "{name}");
            assert!(reading(&outcome, "smallest_distance") >= 10.0 - 1e-6, "{name}: the margin is kept");
        }
    }
    // D* Lite meets nothing: 16 straight and 10 diagonal… whatever the ties, 562.84 px.
    let outcome = run("d-star-lite-drive", &scene, &[], 1);
    assert!((outcome.length.unwrap() - 562.842_712_474_619).abs() < 1e-9 && outcome.gap == Some(0.0));
    assert!((outcome.cost.unwrap() - outcome.length.unwrap() / 20.0 - reading(&outcome, "turns")).abs() < 1e-9);
}

/// Along y = 5 from x = 1 at 2 a second; from (11, 17) a disc of radius 1 comes down at 2.4 a second and would be at y = 5
/// after 5 s, as the robot is at x = 11. Margin and both radii are 3: foreseen is what comes nearer.
#[test]
fn a_collision_is_foreseen_at_the_exact_time_and_avoided() {
    let rows = [".........."; 5];
    let scene = scene(&rows, [[1.0, 5.0], [19.0, 5.0]], r#"{"center": [11, 17], "radius": 1, "velocity": [0, -2.4]}"#);
    // Apart (10, 12), closing by (−2, −2.4): |d|² = (10 − 2 t)² + (12 − 2.4 t)² = 9, so t = 5 − 3 / √(4 + 5.76).
    let exact = 5.0 - 3.0 / 9.76_f64.sqrt();
    for planner in DRIVES {
        let outcome = run(planner, &scene, &[("border", Value::from("leave"))], 1);
        check(&outcome, &scene, planner);
        assert!(outcome.feasible, "{planner}: {:?}", outcome.events);
        let foreseen = event(&outcome, "foreseen");
        assert!(foreseen.reason.text().contains("obstacle 1"));
        // The event is when the sensor (12) first sees its rim, within 6 s.
        let foreseen_at = foreseen.time;
        let within: f64 = foreseen.reason.text().split(" s").next().unwrap().rsplit(' ').next().unwrap().parse().unwrap();
        assert!((foreseen_at + within - exact).abs() < 0.06, "{planner}: {foreseen_at} + {within}, not {exact}");
        assert!(reading(&outcome, "smallest_distance") >= 1.0 - 1e-6, "{planner}: the margin is kept");
        let way = ["detour", "replan", "wait", "evade"].iter().any(|kind| kinds(&outcome).contains(kind));
        assert!(way, "{planner}: {:?}", kinds(&outcome));
    }
}

/// A corridor one cell wide with a crossing: there is no way round, so the robot waits at it until the disc is past.
#[test]
fn it_waits_where_there_is_no_way_round() {
    let rows = ["#####.####", "#####.####", "..........", "#####.####", "#####.####"];
    let scene = scene(&rows, [[1.0, 5.0], [19.0, 5.0]], r#"{"center": [11, 17], "radius": 0.8, "velocity": [0, -2.2]}"#);
    for planner in DRIVES {
        let outcome = run(planner, &scene, &[], 3);
        check(&outcome, &scene, planner);
        assert!(outcome.feasible && outcome.gap == Some(0.0), "{planner}");
        let waited = reading(&outcome, "waited");
        assert!(kinds(&outcome).contains(&"wait") && kinds(&outcome).contains(&"go-on") && waited > 0.0, "{:?}", kinds(&outcome));
        assert!((outcome.cost.unwrap() - 9.0 - waited).abs() < 1e-9, "18 at 2 a second, no turn");
    }
}

/// In a dead end something wide and fast comes: nothing helps. The collision has an event, counts, and makes the result bad.
#[test]
fn a_collision_that_cannot_be_avoided_is_told() {
    let rows = ["##########", "..........", "##########"];
    let scene = scene(&rows, [[1.0, 3.0], [19.0, 3.0]], r#"{"center": [30, 3], "radius": 2, "velocity": [-8, 0]}"#);
    for planner in DRIVES {
        let outcome = run(planner, &scene, &[], 1);
        check(&outcome, &scene, planner);
        assert!(!outcome.feasible && reading(&outcome, "collisions") == 1.0, "{planner}: {:?}", outcome.events);
        assert!(kinds(&outcome).contains(&"cornered") && reading(&outcome, "smallest_distance") < 0.0);
        // It goes through the robot, and the robot arrives nevertheless: after a collision.
        assert!(event(&outcome, "arrived").reason.text().contains("after a collision"));
        let collision = event(&outcome, "collision");
        let lasted = format!("no safe motion had been found for {:.1} s", collision.time - event(&outcome, "cornered").time);
        assert!(collision.reason.text().contains(&lasted), "{}: {lasted}", collision.reason);
        assert!(event(&outcome, "cornered").reason.text().contains("No safe motion was found"));
        let grid = scene.get::<GridScene>().unwrap();
        let [x, y] = grid.moving[0].at(collision.time, Border::Leave, grid.bounds());
        assert!((apart([x, y], collision.place) - 3.0).abs() < 1e-6, "the event is at the moment of contact");
    }
}

/// Two go through it, one after the other: of both it is said how long no motion had been found, whatever happened meanwhile.
#[test]
fn each_collision_of_a_cornered_robot_has_the_same_cause() {
    let rows = ["##########", "..........", "##########"];
    let moving = r#"{"center": [30, 3], "radius": 2, "velocity": [-8, 0]}, {"center": [36, 3], "radius": 2, "velocity": [-8, 0]}"#;
    let scene = scene(&rows, [[1.0, 3.0], [19.0, 3.0]], moving);
    for planner in DRIVES {
        let outcome = run(planner, &scene, &[], 1);
        let since = event(&outcome, "cornered").time;
        let collisions: Vec<_> = outcome.events.iter().filter(|event| event.kind == "collision").collect();
        assert_eq!(collisions.len(), 2, "{planner}: {:?}", outcome.events);
        for collision in collisions {
            let lasted = format!("no safe motion had been found for {:.1} s", collision.time - since);
            assert!(collision.reason.text().contains(&lasted), "{planner}: {}: {lasted}", collision.reason);
        }
    }
}

/// Where nothing is safe it does not search in every period: twice a second, and not at all while something lies over it.
#[test]
fn a_robot_for_which_nothing_is_safe_searches_now_and_then() {
    let rows = ["##########", "..........", "##########"];
    let scene = scene(&rows, [[1.0, 3.0], [19.0, 3.0]], r#"{"center": [14, 3], "radius": 2, "velocity": [-1, 0]}"#);
    for planner in DRIVES {
        let mut run = start(planner, &scene, &[], 1);
        let mut searched = Vec::new();
        while run.status() == Status::Running {
            let (before, cornered) = (run.evaluations(), run.events().iter().any(|event| event.kind == "cornered"));
            run.step(1);
            if cornered && run.evaluations() > before {
                searched.push(reading(&run.outcome(), "time"));
            }
        }
        let outcome = run.outcome();
        let [touched, past] = ["collision", "go-on"].map(|kind| event(&outcome, kind).time);
        assert!(searched.len() > 5 && searched.windows(2).all(|pair| pair[1] - pair[0] > 0.5 - 1e-9), "{planner}: {searched:?}");
        assert!(past > touched + 2.0 && !searched.iter().any(|&time| touched + 0.1 < time && time < past), "{planner}: {searched:?}");
    }
}

/// In the open a search has many states: one that is cut off says so.
#[test]
fn a_search_that_reaches_its_limit_says_that_it_gave_up() {
    let row = ".".repeat(60);
    let scene = scene(&[&*row; 60], [[61.0, 61.0], [117.0, 61.0]], r#"{"center": [61, 600], "radius": 400, "velocity": [0, -10]}"#);
    let params = [("robot", Value::from("given")), ("look_ahead", Value::from(40.0)), ("sensor", Value::from(1000.0))];
    let outcome = run("a-star-drive", &scene, &params, 1);
    let said = event(&outcome, "cornered").reason.to_string();
    assert!(said.contains("gave up at its limit of 1"), "{said}");
    assert!(event(&outcome, "collision").reason.text().contains("no safe motion had been found for"));
}

/// From a point off its cell's middle to another: each stub is a leg with a heading of its own, and turns into it count.
#[test]
fn ends_off_the_middle_of_their_cells_keep_the_time() {
    let rows = [".........."; 5];
    for (start, goal) in [([0.7, 5.6], [19.0, 5.0]), ([1.0, 5.0], [18.4, 8.7]), ([0.31, 0.47], [19.63, 9.11])] {
        let scene = scene(&rows, [start, goal], "");
        for planner in DRIVES {
            let outcome = run(planner, &scene, &[], 1);
            check(&outcome, &scene, planner);
            let path = outcome.path.as_ref().unwrap();
            assert_eq!((path[0], path[path.len() - 1]), (start, goal), "{planner}");
            assert_eq!(outcome.turns, Some(reading(&outcome, "turns") as usize), "{planner}");
        }
    }
}

/// Where start and goal are one, what stands there touches the robot all the same.
#[test]
fn a_touch_at_the_very_start_is_told() {
    let scene = scene(&[".........."; 5], [[5.0, 5.0], [5.0, 5.0]], r#"{"center": [5.5, 5], "radius": 1, "velocity": [0, 0]}"#);
    for planner in DRIVES {
        let outcome = run(planner, &scene, &[], 1);
        check(&outcome, &scene, planner);
        assert!(!outcome.feasible && reading(&outcome, "collisions") == 1.0, "{planner}");
    }
}

#[test]
fn what_would_bounce_too_often_is_refused_by_name() {
    let start = |speed: f64, border: &str| {
        let moving = format!(r#"{{"center": [5, 5], "radius": 1, "velocity": [0, {speed}]}}"#);
        let scene = scene(&[".........."; 5], [[1.0, 5.0], [19.0, 5.0]], &moving);
        let params = [("border", Value::from(border))].into_iter().collect();
        Run::new(standard(), Setup { planner: "a-star-drive".to_owned(), scene, params, seed: 1 })
    };
    // Between walls 10 apart the middle of a disc of radius 1 has 8: 100 times that a second.
    let refused = start(801.0, "bounce").err().unwrap();
    assert_eq!(refused.field(), "moving[0].velocity[1]");
    assert!(refused.to_string().contains("at most 800 a second"), "{refused}");
    assert!(start(800.0, "bounce").is_ok() && start(900.0, "leave").is_ok());
}

/// What is in nobody's way changes nothing.
#[test]
fn an_obstacle_far_away_is_no_reason_for_anything() {
    let rows = [".........."; 5];
    let scene = scene(&rows, [[1.0, 5.0], [19.0, 5.0]], r#"{"center": [1, 60], "radius": 1, "velocity": [0, 1]}"#);
    for planner in DRIVES {
        let outcome = run(planner, &scene, &[], 1);
        assert_eq!(kinds(&outcome), ["set-out", "arrived"]);
    }
}

/// A blind robot drives its way whatever comes. However long a period is and however fast the obstacle, the smallest
/// distance and the collisions are the same, and those that fine steps find.
#[test]
fn nothing_tunnels_at_any_speed() {
    let rows = ["............"; 6];
    for (k, speed) in [0.3, 3.0, 50.0, 1_000.0, 30_000.0].into_iter().enumerate() {
        for aim in [[11.0, 5.2], [6.0, 4.0], [17.0, 7.0]] {
            let center = [3.0 + 4.0 * k as f64, 11.0];
            let way = apart(aim, center);
            let [vx, vy] = [0, 1].map(|axis| (aim[axis] - center[axis]) / way * speed);
            let moving = format!(r#"{{"center": {center:?}, "radius": 0.6, "velocity": [{vx}, {vy}]}}"#);
            let scene = scene(&rows, [[1.0, 5.0], [23.0, 5.0]], &moving);
            // What is faster bounces too often, and is refused.
            let (name, border) = if speed > 600.0 { ("leave", Border::Leave) } else { ("bounce", Border::Bounce) };
            let drive_with = |period: f64| {
                let params = [("sensor", 0.0), ("period", period)].map(|(name, value)| (name, Value::from(value)));
                let params = [("robot", Value::from("given")), ("border", Value::from(name))].into_iter().chain(params);
                let outcome = run("a-star-drive", &scene, &params.collect::<Vec<_>>(), 1);
                check(&outcome, &scene, "blind");
                (reading(&outcome, "collisions"), reading(&outcome, "smallest_distance"))
            };
            let all = [10.0, 1.0, 0.1, 0.037].map(drive_with);
            for (collisions, gap) in all {
                assert_eq!(collisions, all[0].0, "{speed}: {all:?}");
                assert!((gap - all[0].1).abs() < 1e-6, "{speed}: {all:?}");
            }
            let grid = scene.get::<GridScene>().unwrap();
            let disc = &grid.moving[0];
            let sampled =
                (0..=110_000).map(|i| f64::from(i) * 1e-4).map(|t| apart(disc.at(t, border, grid.bounds()), [1.0 + 2.0 * t, 5.0]) - 1.6);
            let least = sampled.fold(f64::INFINITY, f64::min);
            assert!(all[0].1 <= least + 1e-9, "fine steps come nearer: {least}, {all:?}");
            assert!(speed > 100.0 || all[0].1 > least - 0.01, "{speed}: {least}, {all:?}");
        }
    }
}

/// The verdict on a drive is found anew from scene and track: a track that leads through a disc is refused.
#[test]
fn a_track_through_an_obstacle_is_not_feasible() {
    let rows = [".........."; 5];
    let scene = scene(&rows, [[1.0, 5.0], [19.0, 5.0]], r#"{"center": [11, 15], "radius": 1, "velocity": [0, -2]}"#);
    let track = |moments: &[[f64; 3]], path: &[[f64; 2]]| {
        let track = Track { path: path.to_vec(), moments: moments.to_vec(), radius: 1.0, border: Border::Leave };
        scene.judge(&Solution::Drive(track))
    };
    let straight = [[1.0, 5.0], [19.0, 5.0]];
    let hit = track(&[[0.0, 1.0, 5.0], [9.0, 19.0, 5.0]], &straight);
    assert_eq!((hit.feasible, hit.length, hit.clearance), (false, Some(18.0), Some(-2.0)), "together at (11, 5) after 5 s");
    let late = track(&[[0.0, 1.0, 5.0], [6.0, 1.0, 5.0], [15.0, 19.0, 5.0]], &straight);
    assert!(late.feasible && late.clearance.unwrap() > 0.0);
    assert!(!track(&[[0.0, 1.0, 5.0], [15.0, 19.0, 5.0]], &[[1.0, 5.0], [9.0, 7.0], [19.0, 5.0]]).feasible, "another way than it tells");
}

/// Whatever the scene is: drives end, keep their identities, never tell less than happens, and rewind exactly.
#[test]
fn every_drive_on_random_scenes_keeps_its_promises() {
    let mut rng = crate::kernel::rng::Stream::new(17, 0);
    let (mut arrived, mut collided, mut decided) = (0, 0, 0);
    for k in 0..40 {
        let rows: Vec<String> = (0..9).map(|_| (0..12).map(|_| if rng.unit() < 0.18 { '#' } else { '.' }).collect()).collect();
        let mut rows = rows;
        rows[0].replace_range(0..1, ".");
        rows[8].replace_range(11..12, ".");
        let discs: Vec<String> = (0..=k % 6)
            .map(|_| {
                let mut number = |low: f64, high: f64| rng.between(low, high);
                let (x, y, r) = (number(5.0, 24.0), number(5.0, 18.0), number(0.3, 1.5));
                if k % 3 == 2 {
                    let points: Vec<_> = (1..9).map(|i| [f64::from(i) * 3.0, number(0.0, 24.0), number(0.0, 18.0)]).collect();
                    format!(r#"{{"center": [{x}, {y}], "radius": {r}, "waypoints": {points:?}}}"#)
                } else {
                    format!(r#"{{"center": [{x}, {y}], "radius": {r}, "velocity": [{}, {}]}}"#, number(-3.0, 3.0), number(-3.0, 3.0))
                }
            })
            .collect();
        let rows: Vec<&str> = rows.iter().map(String::as_str).collect();
        let scene = scene(&rows, [[1.0, 1.0], [23.0, 17.0]], &discs.join(", "));
        let planner = DRIVES[k % 3];
        let border = Value::from(if k % 2 == 0 { "bounce" } else { "leave" });
        let params = [("border", border), ("iterations", Value::from(if k % 3 == 0 { 20.0 } else { 1e6 }))];
        let mut run = start(planner, &scene, &params, k as u64);
        while run.step(u64::MAX) == Status::Running {}
        let outcome = run.outcome();
        if outcome.status == Status::Infeasible {
            continue;
        }
        check(&outcome, &scene, &format!("{planner}, {k}"));
        arrived += usize::from(outcome.status == Status::Solved);
        collided += usize::from(reading(&outcome, "collisions") > 0.0);
        // Way-points cannot be foreseen; of what goes straight on, nothing is met that the robot knew how to keep from.
        let mut known = true;
        for event in outcome.events.iter().filter(|_| k % 3 != 2) {
            match event.kind {
                "cornered" => known = false,
                "detour" | "replan" | "wait" | "evade" | "squeeze" | "go-on" => known = true,
                "collision" => assert!(!known, "{planner}, {k}: {:?}", outcome.events),
                _ => {}
            }
        }
        for event in outcome.events.iter().filter(|event| event.kind == "collision") {
            let causes =
                ["no safe motion had been found", "not within sensor range", "velocity had changed", "looks and decides only every"];
            let cause = causes.iter().position(|cause| event.reason.text().contains(cause));
            // What goes straight on has one velocity, and a period is short.
            assert!(cause.is_some_and(|cause| cause < if k % 3 == 2 { 3 } else { 2 }), "{planner}, {k}: {}", event.reason);
        }
        decided += usize::from(kinds(&outcome).contains(&"foreseen"));
        let (end, hash) = (run.iteration(), run.hash());
        run.seek(end / 2);
        run.seek(end);
        assert_eq!((run.hash(), run.end()), (hash, Some(end)));
    }
    assert!(arrived > 20 && decided > 10, "{arrived} {collided} {decided}");
}

#[test]
fn what_the_robot_cannot_be_is_refused_by_name() {
    let rows = ["...", "...", "..."];
    let refused = |robot: &str, params: &[(&str, Value)]| {
        let text = format!(
            r#"{{"format": "forage-scene", "version": 1, "kind": "grid", "name": "m", "title": "M", "cell": 2, "rows": {rows:?},
                "start": [1, 1], "goal": [5, 5], "robot": {robot}}}"#
        );
        let scene = Arc::new(standard().read_scene(&text).unwrap());
        let params: Overrides = params.iter().map(|(name, value)| (*name, value.clone())).collect();
        let error = Run::new(standard(), Setup { planner: "a-star-drive".to_owned(), scene, params, seed: 1 }).err().unwrap();
        (error.field().to_owned(), error.value().to_owned())
    };
    assert_eq!(refused(r#"{"radius": 1.5}"#, &[]), ("robot.radius".to_owned(), "1.5".to_owned()));
    let given = [("robot", Value::from("given")), ("robot_radius", Value::from(0.6))];
    assert_eq!(refused(r#"{"radius": 1}"#, &given), ("robot_radius".to_owned(), "0.6".to_owned()));
}

/// The path that [WOLF-ANT](crate#papers) prints, driven by a point as in the paper: its length, its turns and its time are the
/// printed ones.
#[test]
fn the_printed_path_is_driven_as_printed() {
    let setup = |scene: Arc<Scene>| {
        let point = [("path", "printed"), ("robot", "given"), ("robot_radius", "0"), ("margin", "0")];
        let params = point.map(|(name, value)| (name, Value::from(value))).into_iter().collect();
        Setup { planner: "a-star-drive".into(), scene, params, seed: 1 }
    };
    let mut run = Run::with_keyframes(standard(), setup(crate::shipped("wolf-ant-20").unwrap()), 0).unwrap();
    assert_eq!(run.step(u64::MAX), Status::Solved);
    let outcome = run.outcome();
    assert!((outcome.length.unwrap() - 562.842_712_474_619).abs() < 1e-9 && outcome.turns == Some(10), "{outcome:?}");
    let reading = |name: &str| outcome.readings.iter().find(|(n, _)| *n == name).unwrap().1;
    assert!((reading("time") - 38.142_135_623_731).abs() < 1e-9 && reading("collisions") == 0.0, "{:?}", outcome.readings);
    let refused = Run::with_keyframes(standard(), setup(crate::shipped("crossing").unwrap()), 0).err().unwrap().to_string();
    assert!(refused.contains("path") && refused.contains("published.path_cells"), "{refused}");
}

/// To find a way may take long: the period is divided, and carried out again with what was found.
#[test]
fn a_period_that_looks_for_a_way_is_divided() {
    let sizes: Overrides = [("columns", 15.0), ("rows", 15.0), ("share", 0.1), ("moving", 20.0)]
        .into_iter()
        .map(|(name, value)| (name, Value::from(value)))
        .collect();
    let scene = Arc::new(standard().generate("random", &sizes, 4).unwrap());
    for (planner, looks) in
        [("wolf-ant-drive", &["detour", "evade"][..]), ("a-star-drive", &["replan"]), ("d-star-lite-drive", &["replan", "evade"])]
    {
        let few = [("iterations", Value::from(3.0)), ("ants", Value::from(4.0))];
        let params = if planner == "wolf-ant-drive" { &few[..] } else { &[] };
        let [mut whole, mut run] = [(); 2].map(|()| start(planner, &scene, params, 1));
        let mut divided = BTreeSet::new();
        loop {
            match with_parts_of(1, || run.part()) {
                Stepped::Whole => {}
                Stepped::Partly => drop(divided.insert(run.iteration() + 1)),
                Stepped::Not => break,
            }
        }
        let outcome = run.outcome();
        for &kind in looks {
            let mut looked = outcome.events.iter().filter(|event| event.kind == kind).peekable();
            assert!(looked.peek().is_some(), "{planner}: no {kind}");
            assert!(looked.all(|event| divided.contains(&event.iteration)), "{planner}: {kind} in one piece");
        }
        whole.step(u64::MAX);
        assert_eq!(run.hash(), whole.hash(), "{planner}");
    }
}
