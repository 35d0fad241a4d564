//! The drive: what can be said by hand of simple paths, and what must hold on every path.
#![cfg(not(target_arch = "wasm32"))]

use std::sync::Arc;

use forage::{
    Overrides, Run, Scene, Setup, Value,
    describe::Extra,
    follow::drive::{COLUMNS, Drive, DriveOutcome, RESOLUTION, SPEED, parameters, simulate},
    geometry::{self, Oriented, YAxis},
    math,
    scene::{GridScene, LARGEST, Robot, SMALLEST_CELL},
    shipped, standard,
};
use proptest::prelude::*;

const ROBOT: Robot =
    Robot { length: Some(0.4), width: Some(0.3), speed: None, turn_time: None, sensor: None, disc: None, margin: None, look_ahead: None };

fn with_robot(mut scene: GridScene, y_axis: YAxis) -> GridScene {
    scene.robot = Some(ROBOT);
    scene.y_axis = y_axis;
    scene
}

/// Rows from y = 0 upwards.
fn scene(cell: f64, rows: &[&str]) -> GridScene {
    let blocked = rows.iter().flat_map(|row| row.chars().map(|c| c == '#')).collect();
    with_robot(GridScene::new(cell, rows[0].len(), blocked), YAxis::Up)
}

fn given(pairs: &[(&str, f64)]) -> Overrides {
    pairs.iter().map(|&(name, value)| (name, Value::from(value))).collect()
}

fn drive(scene: &GridScene, path: &[[f64; 2]], pairs: &[(&str, f64)]) -> Drive {
    simulate(scene, path, &parameters(scene.robot, &given(pairs)).unwrap()).unwrap()
}

/// A row by the columns' names.
struct Row<'a>(&'a [f64]);

impl Row<'_> {
    fn get(&self, name: &str) -> f64 {
        self.0[COLUMNS.iter().position(|column| column.name == name).unwrap()]
    }

    fn at(&self) -> [f64; 2] {
        [self.get("x"), self.get("y")]
    }
}

fn rows(drive: &Drive) -> Vec<Row<'_>> {
    drive.rows.chunks_exact(COLUMNS.len()).map(Row).collect()
}

/// The outline at many moments of a drive, by Euler's midpoint rule in small steps: nothing of the crate's own arcs.
fn outlines(drive: &Drive, steps: u32) -> Vec<Oriented> {
    let half = drive.outline.map(|side| side / 2.0);
    let mut out = Vec::new();
    for pair in rows(drive).windows(2) {
        let ([mut x, mut y], mut heading) = (pair[0].at(), pair[0].get("heading"));
        let dt = (pair[1].get("time") - pair[0].get("time")) / f64::from(steps);
        let (v, w) = (pair[1].get("speed"), pair[1].get("turn_rate"));
        for _ in 0..steps {
            out.push(Oriented { center: [x, y], direction: [math::cos(heading), math::sin(heading)], half });
            let middle = heading + w * dt / 2.0;
            (x, y, heading) = (x + v * dt * math::cos(middle), y + v * dt * math::sin(middle), heading + w * dt);
        }
        assert!((x - pair[1].get("x")).abs() < 1e-4 && (y - pair[1].get("y")).abs() < 1e-4, "an arc leads from row to row");
    }
    out
}

/// 15 m at 0.24 m/s: 62.5 s, 156 periods of 0.4 s and one of 0.1 s. A metre is 4192 / (2π · 0.068) = 9811.434… counts.
#[test]
fn a_straight_path_is_driven_as_by_hand() {
    let free = scene(1.0, &["....................", "...................."]);
    let drive = drive(&free, &[[1.0, 1.0], [16.0, 1.0]], &[]);
    let rows = rows(&drive);
    assert_eq!(rows.len(), 158);
    assert!(rows.iter().all(|row| row.get("error") == 0.0 && row.get("heading") == 0.0 && row.get("y") == 1.0));
    assert!(rows.iter().all(|row| row.get("clearance") == f64::INFINITY), "there is nothing to be clear of");
    assert_eq!((rows[0].get("speed"), rows[1].get("speed"), rows[1].get("left")), (0.0, 0.24, 0.24 / 0.068));
    // 3.6 m after 15 s is between two rows; after 40 periods it is 3.84 m: 37675.9 counts.
    assert_eq!((rows[40].get("left_count"), rows[40].get("right_count")), (37675.0, 37675.0));
    let outcome = &drive.outcome;
    assert!((outcome.time - 62.5).abs() < 1e-9 && (outcome.distance - 15.0).abs() < 1e-9);
    assert_eq!((outcome.arrived, outcome.touched, outcome.touched_at, outcome.clearance), (true, false, None, None));
    assert_eq!((outcome.max_error, outcome.rms_error, outcome.counts), (0.0, 0.0, [147_171.0, 147_171.0]));
}

/// Past a sharp corner the robot cuts it on the inside, by less than the look-ahead, and finds the path again.
#[test]
fn a_sharp_corner_is_cut_by_less_than_the_look_ahead() {
    let free = scene(1.0, &["......", "......", "......", "......"]);
    let path = [[1.0, 1.0], [4.0, 1.0], [4.0, 3.0]];
    let left = drive(&free, &path, &[]);
    let outcome = &left.outcome;
    assert!(outcome.arrived && outcome.max_error > 0.02 && outcome.max_error < 0.35 / 2.0, "{outcome:?}");
    assert!(outcome.distance < 5.0 && outcome.distance > 4.7 && outcome.rms_error < outcome.max_error);
    assert!(outcome.time > 5.0 / 0.24, "it slows down for the corner");
    let most = rows(&left).iter().map(|row| row.get("error")).fold(0.0, f64::max);
    assert_eq!(most, outcome.max_error, "inside the corner is left of the path");
    assert!(outcome.counts[1] > outcome.counts[0], "the outer wheel goes farther");
    assert!((rows(&left).last().unwrap().get("heading") - std::f64::consts::FRAC_PI_2).abs() < 0.02);
    let shorter = drive(&free, &path, &[("look_ahead", 0.2)]).outcome;
    assert!(shorter.arrived && shorter.max_error < outcome.max_error);
    // Back by the way it came: it turns on the spot.
    for back in [[1.0, 1.2], [1.0, 1.0], [2.0, 0.5]] {
        let hairpin = drive(&free, &[[1.0, 1.0], [4.0, 1.0], back], &[]);
        assert!(hairpin.outcome.arrived && rows(&hairpin)[1..].iter().any(|row| row.get("speed") == 0.0));
    }
    // Mirrored by a y axis that points down: what was left is right.
    let down = drive(&with_robot(free, YAxis::Down), &path, &[]);
    for (up, down) in rows(&left).iter().zip(rows(&down)) {
        assert_eq!((up.get("left"), up.get("right"), up.get("x")), (down.get("right"), down.get("left"), down.get("x")));
        assert_eq!(up.get("error"), -down.get("error"));
    }
}

/// A path that crosses itself, and one that ends where it began, are driven to their end.
#[test]
fn a_later_pass_is_not_taken_for_this_one() {
    let free = scene(1.0, &["......", "......", "......", "......", "......"]);
    let crossing = [[0.5, 2.0], [5.5, 2.0], [5.5, 4.0], [3.0, 4.0], [3.0, 0.5]];
    let round = [[1.0, 1.0], [5.0, 1.0], [5.0, 4.0], [1.0, 4.0], [1.0, 1.0]];
    for path in [&crossing[..], &round] {
        let outcome = drive(&free, path, &[]).outcome;
        assert!(outcome.arrived && outcome.distance > geometry::length(path) - 1.0, "{outcome:?}");
    }
    let nowhere = drive(&free, &[[1.0, 1.0], [1.0, 1.0]], &[]);
    assert!(nowhere.outcome.arrived && nowhere.outcome.time == 0.0 && rows(&nowhere).len() == 1);
    assert!(simulate(&free, &[], &parameters(None, &Overrides::new()).unwrap()).is_none());
}

/// The path keeps 0.16 m from a wall: the robot, 0.3 m wide, passes with a centimetre. Rounding the wall's corner its
/// rear comes nearer than that: there only the outline, turned as it stands, shows that it scrapes.
#[test]
fn a_robot_that_scrapes_a_corner_says_so() {
    let wall = scene(1.0, &["......", "###...", "......", "......"]);
    let along = drive(&wall, &[[0.5, 0.84], [2.0, 0.84]], &[]).outcome;
    assert!(!along.touched && (along.clearance.unwrap() - 0.01).abs() < 1e-9, "{along:?}");
    let touching = drive(&wall, &[[0.5, 0.85], [2.0, 0.85]], &[]).outcome;
    assert!(!touching.touched && touching.clearance.unwrap().abs() < 1e-9, "touching is allowed: {touching:?}");
    let path = [[0.5, 0.84], [3.2, 0.84], [3.2, 2.6]];
    let round = drive(&wall, &path, &[("look_ahead", 0.5)]);
    assert!(round.outcome.touched && round.outcome.clearance.unwrap() < -0.01, "{:?}", round.outcome);
    let wide = drive(&wall, &[[0.5, 0.7], [3.4, 0.7], [3.4, 2.6]], &[("look_ahead", 0.2)]).outcome;
    assert!(!wide.touched && wide.clearance.unwrap() > 0.0, "{wide:?}");
}

/// However far a period takes it, what lies in between is seen, and the first touch is where it is by hand.
#[test]
fn nothing_is_tunnelled_through() {
    let rows: Vec<String> = (0..40).map(|_| format!("{}#{}", ".".repeat(120), ".".repeat(79))).collect();
    let wall = scene(0.05, &rows.iter().map(String::as_str).collect::<Vec<_>>());
    let path = [[1.0, 1.0], [9.5, 1.0]];
    for speed in [0.24, 3.0, 100.0, 1000.0] {
        let outcome = drive(&wall, &path, &[("speed", speed), ("period", 2.0)]).outcome;
        let [x, y] = outcome.touched_at.unwrap();
        // The front, 0.2 m before the centre, meets the wall at 6 m.
        assert!(y == 1.0 && (x - 5.8).abs() < 2.0 * RESOLUTION * 0.4, "{speed}: {x}");
        assert!((outcome.clearance.unwrap() + 0.15).abs() < 1e-9, "out of the cell beside its centre, sideways: {outcome:?}");
    }
    let beside = drive(&wall, &[[1.0, 1.0], [5.75, 1.0], [5.75, 1.9]], &[("speed", 1000.0), ("look_ahead", 1.0)]).outcome;
    assert!(beside.arrived && beside.touched, "it leaps through the wall and comes back: {beside:?}");
}

/// A robot that overshoots its look-ahead in every period finds the goal in the end; one that would need more periods
/// than there are gives up: 100 000 of 0.01 s at 0.001 m/s are a metre.
#[test]
fn every_drive_ends() {
    let free = scene(1.0, &["......", "......", "......"]);
    let zigzag = [[1.0, 1.0], [2.0, 1.5], [3.0, 1.0], [4.0, 1.5]];
    let wild = drive(&free, &zigzag, &[("speed", 40.0), ("period", 2.0), ("turn_rate", 0.01), ("look_ahead", 0.05)]).outcome;
    assert!(wild.arrived && wild.max_error > 10.0, "{wild:?}");
    let slow = drive(&free, &[[1.0, 1.0], [4.0, 1.0]], &[("speed", 0.001), ("period", 0.01)]).outcome;
    assert!(!slow.arrived && (slow.time - 1000.0).abs() < 1e-6 && (slow.distance - 1.0).abs() < 1e-6, "{slow:?}");
}

#[test]
fn a_run_drives_its_best_path_and_refuses_what_is_not_allowed() {
    let stepped = |scene: &Arc<Scene>, planner: &str| {
        let setup = Setup { planner: planner.into(), scene: Arc::clone(scene), params: Overrides::new(), seed: 1 };
        let mut run = Run::new(standard(), setup).unwrap();
        run.step(30);
        run
    };
    let mut run = stepped(&shipped("qpso-10m").unwrap(), "ltqpso");
    let drive = run.follow("drive", &Overrides::new()).unwrap().unwrap();
    let outcome = run.outcome();
    assert_eq!(
        outcome.followed.get::<DriveOutcome>().map(|outcome| outcome.time),
        drive.rows().iter().copied().rev().nth(COLUMNS.len() - 1)
    );
    assert_eq!(outcome.turning, outcome.path.as_deref().map(geometry::turning));
    assert_eq!(drive.parameters()[SPEED], 0.24);
    assert_eq!(drive.extra(), [("outline", Extra::Named(vec![("length", 0.4), ("width", 0.3)]))]);
    for (name, value, allowed) in [
        ("speed", "0", "a number from 0.000000000000001 to 1000000000000000"),
        ("gear", "1.5", "a whole number from 1 to 10000"),
        ("period", "fast", "a number from 0.01 to 2"),
        ("turn_rate", "NaN", "a number from 0.001 to 10"),
    ] {
        let error = run.follow("drive", &Overrides::from_iter([(name, Value::from(value))])).unwrap_err();
        assert_eq!((error.field(), error.value(), &*error.allowed()), (name, value, allowed));
    }
    let unknown = run.follow("drive", &given(&[("mass", 2.3)])).unwrap_err();
    assert!(unknown.field() == "parameter" && unknown.allowed().contains("wheel_radius"));

    let file = shipped("qpso-10m").unwrap().to_json();
    let with = |robot: &str| {
        let mut value: serde_json::Value = serde_json::from_str(&file).unwrap();
        value["robot"] = serde_json::from_str(robot).unwrap();
        stepped(&Arc::new(standard().read_scene(&value.to_string()).unwrap()), "ltqpso")
    };
    let slow = with(r#"{"length": 0.4, "width": 0.3, "speed": 0.1}"#);
    assert_eq!(slow.follow("drive", &Overrides::new()).unwrap().unwrap().parameters()[SPEED], 0.1, "the scene's own speed");
    assert_eq!(slow.follow("drive", &given(&[("speed", 0.2)])).unwrap().unwrap().parameters()[SPEED], 0.2);
    let mut point = with(r#"{"speed": 0.1}"#);
    assert!(
        point.follow("drive", &Overrides::new()).unwrap().is_none()
            && point.outcome().followed.get::<DriveOutcome>().is_none()
            && point.outcome().turning.is_some()
    );
    for (scene, planner) in [("wcpso-discs", "pso"), ("sphere", "pso")] {
        assert!(stepped(&shipped(scene).unwrap(), planner).follow("drive", &Overrides::new()).unwrap().is_none());
    }
}

/// A scene's robot drives as fast as the scene says, whatever the size of its cells, and in the end it stops.
#[test]
fn every_speed_of_a_scene_is_driven() {
    for cell in [SMALLEST_CELL, 1.0, LARGEST] {
        for cells_per_second in Robot::SPEEDS {
            let mut scene = scene(cell, &["......", "......"]);
            let speed = cells_per_second * cell;
            let [length, width] = [0.4, 0.3].map(|side| Some(side * cell));
            scene.robot = Some(Robot { length, width, speed: Some(speed), ..ROBOT });
            let driven = drive(&scene, &[[cell, cell], [5.0 * cell, cell]], &[]);
            assert_eq!(driven.parameters[SPEED], speed);
            assert!(driven.outcome.time.is_finite() && driven.outcome.arrived == (cells_per_second > 1.0), "{:?}", driven.outcome);
        }
    }
}

/// A scene, a path and the drive's parameters.
type Case = (GridScene, Vec<[f64; 2]>, Vec<(&'static str, f64)>);

/// A grid of 8 × 6 cells of 0.5 m with some blocked, and a path through it that heeds nothing.
fn any_drive() -> impl Strategy<Value = Case> {
    let blocked = prop::collection::vec(prop::bool::weighted(0.06), 48);
    let path = prop::collection::vec([0.0..4.0_f64, 0.0..3.0_f64], 2..6);
    let limits = (0.1..2.0_f64, 0.1..3.0_f64, 0.05..0.6_f64, 0.15..0.8_f64);
    (blocked, path, limits, any::<bool>()).prop_map(|(blocked, path, (speed, turn_rate, period, look_ahead), down)| {
        let scene = with_robot(GridScene::new(0.5, 8, blocked), if down { YAxis::Down } else { YAxis::Up });
        (scene, path, vec![("speed", speed), ("turn_rate", turn_rate), ("period", period), ("look_ahead", look_ahead)])
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() })]

    /// Limits, wheels, counts and the distance from the path, row by row.
    #[test]
    fn no_limit_is_ever_exceeded((scene, path, pairs) in any_drive()) {
        let drive = drive(&scene, &path, &pairs);
        let [v_max, w_max, period] = [0, 1, 2].map(|i| pairs[i].1);
        let side = if scene.y_axis == YAxis::Up { 1.0 } else { -1.0 };
        let rows = rows(&drive);
        let (mut angles, mut went) = ([0.0; 2], 0.0);
        for pair in rows.windows(2) {
            let row = &pair[1];
            let seconds = row.get("time") - pair[0].get("time");
            prop_assert!(seconds > 0.0 && seconds <= period + 1e-9);
            let (v, w) = (row.get("speed"), row.get("turn_rate"));
            prop_assert!((0.0..=v_max).contains(&v) && w.abs() <= w_max);
            for (wheel, (name, sign)) in [("left", -side), ("right", side)].into_iter().enumerate() {
                let speed = (v + sign * w * 0.3 / 2.0) / 0.068;
                prop_assert!((row.get(name) - speed).abs() < 1e-9);
                angles[wheel] += speed * seconds;
                let count = row.get(["left_count", "right_count"][wheel]);
                prop_assert!(count.fract() == 0.0 && (count - (angles[wheel] * 4192.0 / std::f64::consts::TAU - 0.5)).abs() < 0.501);
            }
            went += v * seconds;
            let exact = path.windows(2).map(|w| geometry::distance_squared(w[0], w[1], row.at())).fold(f64::INFINITY, f64::min).sqrt();
            prop_assert!(row.get("error").abs() >= exact - 1e-9, "nearer the path than it is");
        }
        prop_assert!((drive.outcome.distance - went).abs() < 1e-9 * (1.0 + went));
        let errors = rows.iter().map(|row| row.get("error").abs());
        prop_assert_eq!(drive.outcome.max_error, errors.clone().fold(0.0, f64::max));
        let mean = errors.map(|e| e * e).sum::<f64>() / rows.len() as f64;
        prop_assert!((drive.outcome.rms_error - mean.sqrt()).abs() < 1e-12);
        // Pure pursuit is sure of itself while a period's way is well within the look-ahead.
        prop_assert!(drive.outcome.arrived || v_max * period > pairs[3].1);
        if drive.outcome.arrived {
            let [x, y] = rows.last().unwrap().at();
            let [gx, gy] = path[path.len() - 1];
            prop_assert!((x - gx).abs().max((y - gy).abs()) <= 0.004);
        }
    }

    /// What is said to be touched is what dense sampling finds, and where it finds it first; so is the clearance.
    #[test]
    fn touches_are_those_of_dense_sampling((scene, path, pairs) in any_drive()) {
        let drive = drive(&scene, &path, &pairs);
        let outcome = &drive.outcome;
        let blocks = scene.field().blocks();
        let distance = |outline: &Oriented| blocks.iter().map(|block| outline.distance(block)).fold(f64::INFINITY, f64::min);
        let outlines = outlines(&drive, 200);
        let sampled: Vec<_> = outlines.iter().map(distance).collect();
        let least = sampled.iter().copied().fold(f64::INFINITY, f64::min);
        if blocks.is_empty() {
            prop_assert_eq!(outcome.clearance, None);
        } else if !sampled.is_empty() {
            let clearance = outcome.clearance.unwrap();
            let slack = 2.0 * RESOLUTION * 0.4 + 0.011 * least.abs();
            // The samples are up to 6 mm apart, so that they may miss a little more.
            prop_assert!(clearance < least + slack && clearance > least - 0.008, "{} {}", clearance, least);
        }
        prop_assert!(outcome.touched || least > -slack_of_samples());
        prop_assert!(!outcome.touched || least < 0.008);
        prop_assert_eq!(outcome.touched, outcome.touched_at.is_some());
        if let (Some([x, y]), Some(first)) = (outcome.touched_at, sampled.iter().position(|&d| d < -slack_of_samples())) {
            let before = &outlines[..=first];
            let near = before.iter().map(|o| ((o.center[0] - x) * (o.center[0] - x) + (o.center[1] - y) * (o.center[1] - y)).sqrt());
            prop_assert!(near.fold(f64::INFINITY, f64::min) < 0.01, "touched before {:?}, not after", outlines[first].center);
        }
    }
}

/// Deeper overlaps than the resolution, and than what rounding of the sampled poses makes, must be found.
fn slack_of_samples() -> f64 {
    2.0 * RESOLUTION * 0.4
}
