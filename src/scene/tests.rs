//! Scene files of the kinds that ship, and the scenes that ship with them.

use crate::{
    Overrides, Scene, Value,
    kernel::{Border, ReferenceOptimum, Solution, TourEnds, Track},
    scene::{GridScene, Motion, TourScene},
    shipped, standard,
};

const TEXT: &str = r#"{"format": "forage-scene", "version": 1, "kind": "discs", "name": "a", "title": "A",
    "bounds": {"min": [0, 0], "max": [8, 8.5]}, "start": [0, -0.0], "goal": [8, 8], "discs": [{"center": [4, 4], "radius": 1}]}"#;

fn refused(from: &str, to: &str) -> [String; 3] {
    assert!(TEXT.contains(from));
    let error = standard().read_scene(&TEXT.replacen(from, to, 1)).unwrap_err();
    [error.field(), error.value(), &error.allowed()].map(str::to_owned)
}

#[test]
fn kept_numbers_are_those_that_javascript_reads() {
    let text =
        shipped("wcpso-discs").unwrap().to_json().replacen("\"exact\": {", "\"exact\": {\"large\": 144142135623730951, \"small\": 7, ", 1);
    let scene = standard().read_scene(&text).unwrap();
    let kept = scene.header().exact.as_ref().unwrap();
    assert_eq!((&kept["large"], &kept["small"]), (&serde_json::json!(144_142_135_623_730_951_i64 as f64), &serde_json::json!(7)));
    assert_eq!(standard().read_scene(&scene.to_json()).unwrap(), scene);
}

#[test]
fn every_refusal_names_the_field_what_it_holds_and_what_is_allowed() {
    for (from, to, expected) in [
        ("forage-scene", "other", ["format", "\"other\"", "\"forage-scene\""]),
        (": 1,", ": 2,", ["version", "2", "1"]),
        ("\"discs\",", "3,", ["kind", "3", "one of discs, grid, tour, arm, function"]),
        ("\"title\": \"A\",", "", ["title", "nothing", "a text"]),
        ("\"A\"", "true", ["title", "true", "a text"]),
        ("[8, 8]", "[8]", ["goal", "a list of 1", "a point, [x, y]"]),
        ("[8, 8]", "[8, \"8\"]", ["goal[1]", "\"8\"", "a finite number"]),
        ("{\"min\": [0, 0], \"max\": [8, 8.5]}", "7", ["bounds", "7", "an object with min and max"]),
        ("\"max\": [8, 8.5]", "\"max\": {}", ["bounds.max", "an object", "a point, [x, y]"]),
        ("\"radius\": 1", "\"radius\": null", ["discs[0].radius", "nothing", "a finite number"]),
        (", \"radius\": 1", "", ["discs[0].radius", "nothing", "a finite number"]),
        ("\"radius\"", "\"r\": 1, \"radius\"", ["discs[0].r", "this field", "left out, or one of center, radius"]),
    ] {
        assert_eq!(refused(from, to), expected);
    }
    let [field, _, allowed] = refused("\"start\"", "\"walls\": 3, \"start\"");
    assert!(field == "walls" && allowed.contains("bounds") && allowed.contains("note"), "{allowed}");
}

#[test]
fn the_compact_text_is_read_back_as_the_same_scene() {
    let scene = standard().read_scene(TEXT).unwrap();
    let text = scene.to_compact_json();
    assert!(text.contains(r#""start":[0,0],"goal":[8,8]"#) && text.contains("8.5"), "{text}");
    assert_eq!(standard().read_scene(&text).unwrap(), scene);
}

/// Stops are what the command in their source makes, and their optimum is the length of its order.
#[test]
fn random_stops_are_made_again_by_their_source_and_their_optimum_is_a_tour() {
    let tours: Vec<_> = standard().scenes().iter().filter_map(|scene| Some((scene, scene.get::<TourScene>().ok()?))).collect();
    assert_eq!(tours.iter().map(|(_, tour)| tour.len()).collect::<Vec<_>>(), [12, 52, 100, 280]);
    for (scene, tour) in tours {
        let source = scene.header().source.as_deref().unwrap().split(';').next().unwrap();
        let words: Vec<_> = source.strip_prefix("forage generate stops ").unwrap().split(' ').collect();
        let (mut given, mut seed) = (Overrides::new(), 0);
        for pair in words.chunks(2) {
            match (pair[0], pair[1].split_once('=')) {
                ("--seed", _) => seed = pair[1].parse().unwrap(),
                (_, Some((name, value))) => given.insert(name, Value::from(value)),
                _ => panic!("{source}"),
            }
        }
        let made = standard().generate("stops", &given, seed).unwrap();
        let made = made.get::<TourScene>().unwrap();
        assert_eq!((&made.points, made.metric), (&tour.points, tour.metric), "{}", scene.name());
        if let Some(exact) = &scene.header().exact {
            let found = scene.exact_tour(ReferenceOptimum::default(), TourEnds::Closed).unwrap();
            assert_eq!((found.order.len(), Some(found.length)), (tour.len(), exact["length"].as_f64()), "{}", scene.name());
        }
    }
}

#[test]
fn every_file_parses_survives_a_round_trip_and_has_a_name_of_its_own() {
    let texts: Vec<_> = standard().kinds().iter().flat_map(|kind| kind.shipped).collect();
    for text in &texts {
        let scene = standard().read_scene(text).unwrap();
        assert_eq!(standard().read_scene(&scene.to_json()).unwrap(), scene);
    }
    let mut names: Vec<_> = standard().scenes().iter().map(|s| s.name()).collect();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), texts.len());
}

/// The robot's drive from corner to corner, before each of which it waits so many seconds: is it free, with its margin?
fn drives(scene: &Scene, corners: &[[f64; 3]], border: Border) -> bool {
    let grid = scene.get::<GridScene>().unwrap();
    let robot = grid.robot.unwrap();
    let (mut path, mut moments) = (vec![grid.start.unwrap()], Vec::new());
    let (mut time, mut heading) = (0.0, None);
    for &[x, y, wait] in corners {
        let from = path[path.len() - 1];
        let way = [x - from[0], y - from[1]];
        let length = (way[0] * way[0] + way[1] * way[1]).sqrt();
        let turned = heading.is_some_and(|before: [f64; 2]| before.iter().zip(way).any(|(b, w)| (b - w / length).abs() > 1e-9));
        moments.push([time, from[0], from[1]]);
        time += wait + if turned { robot.turn_time.unwrap() } else { 0.0 };
        moments.push([time, from[0], from[1]]);
        time += length / robot.speed.unwrap();
        heading = Some(way.map(|w| w / length));
        path.push([x, y]);
    }
    moments.push([time, path[path.len() - 1][0], path[path.len() - 1][1]]);
    let radius = robot.disc.unwrap() + robot.margin.unwrap();
    scene.judge(&Solution::Drive(Track { path, moments, radius, border })).feasible
}

/// What each of the scenes for lectures is for: who does not look meets something, who waits or steps aside in time does not.
#[test]
fn where_something_moves_the_shortest_way_meets_it_and_another_drive_does_not() {
    let drive: [(&str, &[[f64; 3]]); 3] = [
        // Beside the shortest way, with a wait before the first turn and another in front of the second disc.
        ("crossing", &[[2.5, 9.5, 0.0], [6.5, 9.5, 0.5], [15.5, 9.5, 0.5], [16.5, 8.5, 0.0], [22.5, 8.5, 0.0]]),
        // In the doorway until the first guard has gone by; the others are just past.
        ("patrol", &[[4.5, 4.5, 0.0], [4.5, 6.5, 0.0], [4.5, 7.5, 5.8], [16.5, 7.5, 0.0], [16.5, 12.5, 0.0], [18.5, 14.5, 0.0]]),
        // Into the niche, and back when the disc has gone by.
        ("corridor", &[[11.5, 3.5, 0.0], [11.5, 4.5, 1.0], [11.5, 3.5, 1.0], [21.5, 3.5, 0.0]]),
    ];
    for (name, corners) in drive {
        let scene = shipped(name).unwrap();
        let grid = scene.get::<GridScene>().unwrap();
        assert!(grid.robot.unwrap().sensor.is_some() && !grid.corner_cutting);
        let shortest: Vec<_> = scene.exact_by(ReferenceOptimum::Cells).unwrap().path[1..].iter().map(|&[x, y]| [x, y, 0.0]).collect();
        for border in [Border::Leave, Border::Bounce] {
            assert!(!drives(&scene, &shortest, border), "{name} calls for something");
            assert!(drives(&scene, corners, border), "{name} can be done");
        }
    }
    for guard in &shipped("patrol").unwrap().get::<GridScene>().unwrap().moving {
        assert!(matches!(&guard.motion, Motion::Waypoints(points) if points[points.len() - 1][0] >= 120.0), "two minutes");
    }
}
