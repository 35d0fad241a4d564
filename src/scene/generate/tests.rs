//! What every generator promises, over many sizes and seeds.

use crate::{
    Scene, Value,
    kernel::{Digest, ReferenceOptimum, limits, rng::Stream},
    params::{Domain, Overrides},
    scene::{
        DiscsScene, Function, FunctionScene, GRID, GridScene, Motion, Robot,
        reach::{beside, reach},
    },
    standard,
};

use super::*;

fn given(pairs: &[(&str, f64)]) -> Overrides {
    pairs.iter().map(|&(name, value)| (name, Value::from(value))).collect()
}

fn make(name: &str, pairs: &[(&str, f64)], seed: u64) -> Scene {
    standard().generate(name, &given(pairs), seed).unwrap()
}

fn blocked(scene: &Scene) -> usize {
    scene.get::<GridScene>().unwrap().blocked.iter().filter(|&&blocked| blocked).count()
}

/// The cells that can be reached from the start; panics if the goal is not among them.
fn reached(scene: &Scene) -> usize {
    let grid = scene.get::<GridScene>().unwrap();
    let (start, goal) = grid.ends().unwrap();
    let mut seen = vec![false; grid.blocked.len()];
    let region = reach(&grid.blocked, grid.columns, grid.cells().at(start), &mut seen);
    assert!(seen[grid.cells().at(goal)], "{}", scene.name());
    region.len()
}

#[test]
fn start_and_goal_are_connected_whatever_the_size_the_seed_and_the_parameters() {
    for generator in standard().generators_of(GRID) {
        for seed in 0..60 {
            let mut stream = Stream::new(seed, 9);
            let mut values = given(&[("columns", 1.0 + stream.below(40) as f64), ("rows", 1.0 + stream.below(40) as f64)]);
            for parameter in generator.parameters.iter().copied().flatten().skip(2) {
                let value = match parameter.domain {
                    Domain::Number { min, max, .. } => stream.between(min, max),
                    Domain::Integer { min, max, .. } => (min + stream.below(max.min(12) as usize) as u64) as f64,
                    _ => continue,
                };
                values.insert(parameter.name, Value::from(value));
            }
            let scene = standard().generate(generator.name, &values, seed).unwrap();
            reached(&scene);
            let exact = scene.exact_by(ReferenceOptimum::Cells);
            assert!(exact.is_some(), "{:?}", scene.header());
        }
    }
}

#[test]
fn a_share_is_met_to_the_cell_or_as_nearly_as_a_way_allows() {
    for name in ["random", "rubble"] {
        for (share, columns, rows, expected) in [
            (0.0, 10, 10, 0),
            (0.25, 30, 20, 150),
            (0.4, 21, 17, 143),
            (0.6, 40, 30, 720),
            (0.81, 10, 10, 81),
            (0.9, 10, 10, 81),
            (1.0, 40, 30, 1131),
            (1.0, 1, 1, 0),
            (0.5, 1, 9, 0),
            (0.5, 2, 2, 1),
        ] {
            for seed in 0..5 {
                let scene = make(name, &[("share", share), ("columns", f64::from(columns)), ("rows", f64::from(rows))], seed);
                assert_eq!(blocked(&scene), expected, "{name} {share} {columns} {rows}");
                reached(&scene);
                let exact = f64::from(expected as u32) >= (share * f64::from(columns * rows)).round();
                assert_eq!(scene.header().note.is_none(), exact, "{:?}", scene.header().note);
            }
        }
    }
}

#[test]
fn a_maze_without_loops_has_one_way_only_and_loops_add_more() {
    for seed in 0..20 {
        for (columns, rows) in [(21, 15), (20, 16), (2, 2), (1, 7), (3, 1)] {
            let side = [("columns", f64::from(columns)), ("rows", f64::from(rows))];
            let scene = make("maze", &side, seed);
            let grid = scene.get::<GridScene>().unwrap();
            let free = grid.blocked.len() - blocked(&scene);
            assert_eq!(reached(&scene), free, "all corridors hang together");
            // A tree: as many cells as joints, and one more.
            let joints: usize = (0..grid.blocked.len())
                .filter(|&cell| !grid.blocked[cell])
                .map(|cell| beside(cell, grid.columns, grid.blocked.len()).filter(|&next| !grid.blocked[next]).count())
                .sum();
            assert_eq!(joints / 2 + 1, free);
            assert!(blocked(&make("maze", &[side[0], side[1], ("loops", 1.0)], seed)) <= blocked(&scene));
        }
    }
}

#[test]
fn every_room_can_be_reached_and_none_is_much_smaller_than_asked_for() {
    for seed in 0..20 {
        let scene = make("rooms", &[("columns", 61.0), ("rows", 45.0), ("room", 8.0), ("loops", 0.0), ("door", 2.0)], seed);
        let grid = scene.get::<GridScene>().unwrap();
        assert_eq!(reached(&scene), grid.blocked.len() - blocked(&scene));
        // Each row of the first room is free up to its wall.
        let room = grid.blocked.iter().position(|&blocked| blocked).unwrap();
        assert!((6..=14).contains(&room), "{room}");
    }
    let hall = make("rooms", &[("columns", 9.0), ("rows", 9.0), ("room", 9.0)], 1);
    assert_eq!(blocked(&hall), 0);
}

#[test]
fn a_seed_gives_the_same_grid_again_and_another_seed_another() {
    for generator in standard().generators_of(GRID) {
        for seed in [1, 2, limits::WHOLE] {
            let scene = make(generator.name, &[], seed);
            assert_eq!(scene, make(generator.name, &[], seed));
            assert_ne!(scene.get::<GridScene>(), make(generator.name, &[], seed - 1).get::<GridScene>());
        }
    }
}

#[test]
fn a_scene_says_how_it_is_made_again() {
    let scene = make("rubble", &[("columns", 12.0), ("share", 0.5), ("size", 3.0)], 5);
    let header = scene.header();
    assert_eq!((header.name.as_str(), header.title.as_str()), ("rubble-12x30-5", "Rubble, 12 × 30, seed 5"));
    let source = "forage generate rubble --set columns=12 --set rows=30 --set cell=1 --set share=0.5 --set size=3 --set stops=0 --seed 5";
    assert_eq!(header.source.as_deref(), Some(source));
}

#[test]
fn what_is_not_allowed_is_refused_by_name() {
    for (name, pairs, seed, field) in [
        ("sand", &[] as &[(&str, f64)], 1, "generator"),
        ("random", &[("share", 1.5)], 1, "share"),
        ("random", &[("share", f64::NAN)], 1, "share"),
        ("rooms", &[("share", 0.5)], 1, "parameter"),
        ("maze", &[("columns", 2049.0)], 1, "columns"),
        ("maze", &[("rows", 0.0)], 1, "rows"),
        ("maze", &[("cell", 0.0)], 1, "cell"),
        ("maze", &[], limits::WHOLE + 1, "seed"),
    ] {
        assert_eq!(standard().generate(name, &given(pairs), seed).unwrap_err().field(), field);
    }
    for generator in standard().generators_of(GRID) {
        let names: Vec<_> = generator.parameters.iter().copied().flatten().map(|p| p.name).collect();
        assert_eq!(names[..3], ["columns", "rows", "cell"]);
        assert_eq!(names[names.len() - 4..], ["stops", "moving", "moving_speed", "moving_radius"]);
        assert_eq!(standard().generator(generator.name).unwrap().name, generator.name);
    }
}

#[test]
fn the_largest_grid_is_made_too() {
    for generator in standard().generators_of(GRID) {
        let scene = make(generator.name, &[("columns", 2048.0), ("rows", 1025.0)], 3);
        assert_eq!(scene.get::<GridScene>().unwrap().rows(), 1025);
    }
}

#[test]
fn stops_are_free_cells_of_their_own_that_can_all_be_reached() {
    for generator in standard().generators_of(GRID) {
        for seed in 0..20 {
            let scene = make(generator.name, &[("stops", 12.0)], seed);
            let grid = scene.get::<GridScene>().unwrap();
            let mut seen = vec![false; grid.blocked.len()];
            reach(&grid.blocked, grid.columns, grid.cells().at(grid.start.unwrap()), &mut seen);
            let mut cells: Vec<_> = grid.stops.iter().map(|&stop| grid.cells().at(stop)).collect();
            assert!(cells.iter().all(|&cell| seen[cell] && Some(grid.cells().centre(cell)) != grid.start));
            cells.sort_unstable();
            cells.dedup();
            assert_eq!(cells.len(), 12);
            let without = make(generator.name, &[], seed);
            assert_eq!(without.get::<GridScene>().unwrap().blocked, grid.blocked, "stops change nothing else");
        }
    }
    let scene = make("maze", &[("columns", 3.0), ("rows", 3.0), ("stops", 20.0)], 1);
    assert_eq!(scene.get::<GridScene>().unwrap().stops.len(), 5);
    assert_eq!(scene.header().note.as_deref(), Some("There are 5 stops, not 20: there is room for no more."));
}

#[test]
fn stops_can_be_put_on_any_grid_where_its_robot_fits() {
    let scene = crate::shipped("qpso-10m").unwrap();
    let with = with_stops(&scene, 6, 3).unwrap();
    assert_eq!((with.name(), with.stops().len()), ("qpso-10m-6-stops", 6));
    assert_eq!(with, with_stops(&scene, 6, 3).unwrap());
    assert_ne!(with.stops(), with_stops(&scene, 6, 4).unwrap().stops());
    let exact = with.exact_tour(ReferenceOptimum::Cells, crate::kernel::TourEnds::Closed);
    assert!(exact.is_some_and(|exact| exact.order.len() == 6));
    // Without a start the largest region counts: the right one.
    let text = r#"{"format": "forage-scene", "version": 1, "kind": "grid", "name": "a", "title": "A", "cell": 1, "rows": [".#..."],
        "stops": [[0.5, 0.5]]}"#;
    let split = standard().read_scene(text).unwrap();
    assert!(with_stops(&split, 3, 1).unwrap().stops().iter().all(|[x, _]| *x > 2.0));
    for (n, field) in [(4, "stops"), (0, "stops")] {
        let error = with_stops(&split, n, 1).unwrap_err();
        assert_eq!((error.field(), error.allowed().starts_with("from 1 to 3")), (field, true));
    }
    assert_eq!(with_stops(&crate::shipped("sphere").unwrap(), 3, 1).unwrap_err().field(), "kind");
}

/// The digest of a scene's file.
fn digest(scene: &Scene) -> String {
    let mut digest = Digest::default();
    digest.bytes(scene.to_json().as_bytes());
    digest.hex()
}

/// The stored digests were written before there were moving obstacles.
#[test]
fn without_moving_obstacles_a_scene_is_what_it_was_before_there_were_any() {
    let stored = ["9db03a78527c7747", "f77f5658f5be08f8", "ff8ec597874781b1", "a807ce8980010fc8"];
    for (generator, stored) in standard().generators_of(GRID).zip(stored) {
        assert_eq!(digest(&make(generator.name, &[("columns", 31.0), ("stops", 3.0)], 7)), stored, "{}", generator.name);
        let fast = make(generator.name, &[("columns", 31.0), ("stops", 3.0), ("moving", 0.0), ("moving_speed", 9.0)], 7);
        assert_eq!(digest(&fast), stored, "of what moves there is nothing");
    }
}

fn length([x, y]: [f64; 2]) -> f64 {
    (x * x + y * y).sqrt()
}

/// Stored when they came: the same parameters and seed give the same discs for ever.
#[test]
fn a_seed_s_moving_obstacles_are_the_stored_ones() {
    let scene = make("random", &[("stops", 3.0), ("moving", 5.0), ("moving_speed", 1.5)], 7);
    assert_eq!(digest(&scene), "9491b695fc36df03");
    let source = "forage generate random --set columns=40 --set rows=30 --set cell=1 --set share=0.3 --set stops=3 --set moving=5 \
                  --set moving_speed=1.5 --set moving_radius=0.5 --seed 7";
    assert_eq!(scene.header().source.as_deref(), Some(source));
}

#[test]
fn what_moves_is_clear_of_the_start_as_fast_and_as_large_as_allowed_and_changes_nothing_else() {
    for (generator, cell) in standard().generators_of(GRID).flat_map(|generator| [(generator, 1.0), (generator, 0.05)]) {
        let (mut speeds, mut radii, mut quarters) = (Vec::new(), Vec::new(), [0; 4]);
        for seed in 0..20 {
            let size = [("columns", 12.0), ("rows", 9.0), ("cell", cell), ("stops", 4.0)];
            let discs = [("moving", 20.0), ("moving_speed", 2.0), ("moving_radius", 0.8)];
            let scene = make(generator.name, &[&size[..], &discs].concat(), seed);
            let grid = scene.get::<GridScene>().unwrap();
            assert_eq!((grid.moving.len(), scene.header().note.as_ref()), (20, None));
            let robot = Robot { speed: Some(cell), turn_time: Some(1.0), ..Robot::default() };
            assert_eq!(grid.robot, Some(robot));
            for disc in &grid.moving {
                let (Motion::Velocity([x, y]), start) = (&disc.motion, grid.start.unwrap()) else { panic!("{disc:?}") };
                let apart = length([disc.center[0] - start[0], disc.center[1] - start[1]]);
                assert!(apart > disc.radius + cell, "a robot of half a cell with half a cell around it");
                let max = grid.bounds().max;
                assert!((0..2).all(|axis| (0.0..max[axis]).contains(&disc.center[axis])));
                speeds.push(length([*x, *y]) / cell);
                radii.push(disc.radius / cell);
                quarters[usize::from(*x < 0.0) + 2 * usize::from(*y < 0.0)] += 1;
            }
            let mut without = make(generator.name, &size, seed).get::<GridScene>().unwrap().clone();
            (without.robot, without.moving) = (grid.robot, grid.moving.clone());
            assert_eq!(&without, grid);
            assert_eq!(standard().read_scene(&scene.to_json()).unwrap(), scene);
        }
        for (values, greatest) in [(speeds, 2.0), (radii, 0.8)] {
            let (least, most) = values.iter().fold((f64::INFINITY, 0.0_f64), |(a, b), &v| (a.min(v), b.max(v)));
            assert!(least >= greatest / 4.0 * 0.999_999 && least < greatest * 0.3, "{least} of {greatest}");
            assert!(most <= greatest * 1.000_001 && most > greatest * 0.95, "{most} of {greatest}");
        }
        assert!(quarters.iter().all(|n| (60..140).contains(n)), "all directions: {quarters:?}");
    }
}

#[test]
fn where_there_is_no_room_clear_of_the_start_fewer_discs_move_and_a_note_says_so() {
    let small = [("columns", 2.0), ("rows", 2.0), ("moving", 4.0)];
    // The far corner is 2.12 from the start: discs under 1.12 may begin near it, one of 1.25, the least of up to 5, not.
    let tight = make("random", &[&small[..], &[("moving_radius", 2.0)]].concat(), 1);
    assert_eq!(tight.get::<GridScene>().unwrap().moving.len(), 4, "small ones find room");
    assert!(tight.get::<GridScene>().unwrap().moving.iter().all(|disc| disc.radius < 1.13));
    let none = make("random", &[&small[..], &[("moving_radius", 5.0), ("stops", 9.0), ("share", 0.0)]].concat(), 1);
    assert!(none.get::<GridScene>().unwrap().moving.is_empty());
    let note = "There are 2 stops, not 9: there is room for no more. \
                There are 0 moving obstacles, not 4: there is no room for more clear of the start.";
    assert_eq!(none.header().note.as_deref(), Some(note));
    assert!(none.header().source.as_ref().unwrap().contains("moving=4"));
    for (name, wrong) in [("moving", 101.0), ("moving", 0.5), ("moving_speed", -1.0), ("moving_speed", f64::NAN), ("moving_radius", 0.0)] {
        assert_eq!(standard().generate("maze", &given(&[(name, wrong)]), 1).unwrap_err().field(), name);
    }
}

#[test]
fn random_stops_are_whole_inside_and_apart() {
    for (clusters, seed) in [(0.0, 1), (3.0, 2), (1.0, 3)] {
        let scene = make("stops", &[("stops", 200.0), ("side", 500.0), ("clusters", clusters)], seed);
        let points = scene.stops();
        assert!(points.iter().flatten().all(|c| c.fract() == 0.0 && (0.0..=500.0).contains(c)));
        assert!((0..200).all(|i| !points[..i].contains(&points[i])));
    }
    let crowded = make("stops", &[("stops", 2000.0), ("side", 10.0), ("clusters", 1.0), ("spread", 0.001)], 1);
    assert_eq!(crowded.stops().len(), 2000);
    let scene = make("stops", &[("stops", 5.0)], 7);
    let source = "forage generate stops --set stops=5 --set side=1000 --set clusters=0 --set spread=0.05 --set metric=euc-2d --seed 7";
    assert_eq!((scene.name(), scene.header().source.as_deref()), ("stops-5-7", Some(source)));
    assert_eq!(scene, make("stops", &[("stops", 5.0)], 7));
    assert_ne!(scene.stops(), make("stops", &[("stops", 5.0)], 8).stops());
}

#[test]
fn discs_never_touch_and_always_leave_a_path() {
    for seed in 0..60 {
        let mut stream = Stream::new(seed, 9);
        let scene = make("discs", &[("discs", stream.below(60) as f64), ("radius", stream.between(0.01, 0.5)), ("side", 3.0)], seed);
        let discs = scene.get::<DiscsScene>().unwrap();
        for (i, disc) in discs.discs.iter().enumerate() {
            assert!(discs.discs[..i].iter().all(|other| other.clearance(disc.center) > disc.radius), "{}", scene.name());
        }
        assert!(scene.exact().is_some_and(|exact| exact.length >= 3.0 * 2.0_f64.sqrt() - 1e-12), "{}", scene.name());
    }
    let full = make("discs", &[("discs", 200.0), ("radius", 0.3)], 1);
    assert!(full.header().note.as_ref().is_some_and(|note| note.contains("room for no more")));
}

#[test]
fn a_shifted_function_has_its_minimum_where_the_shift_says() {
    for (seed, name) in Function::ALL.map(Function::name).into_iter().enumerate() {
        let mut values = given(&[("dimension", 2.0)]);
        values.insert("function", Value::from(name));
        let scene = standard().generate("shifted", &values, seed as u64).unwrap();
        let function = scene.get::<FunctionScene>().unwrap();
        let minimiser = function.minimiser().unwrap();
        let centred = FunctionScene::named(function.function().unwrap(), function.dimension(), Vec::new()).minimiser().unwrap();
        assert!(function.value(&minimiser).abs() < 1e-14, "{name}");
        assert!(minimiser.iter().zip(&centred).all(|(moved, centred)| moved != centred), "{name}");
        assert_eq!(standard().read_scene(&scene.to_json()).unwrap(), scene);
    }
    let refused =
        standard().generate("shifted", &Overrides::from_iter([("function", Value::from("matyas")), ("dimension", Value::from(3.0))]), 1);
    assert!(refused.unwrap_err().to_string().contains("dimension"));
}
